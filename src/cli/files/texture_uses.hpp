#pragma once

#include <string>

#include "cli/options/arguments.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::cli {

/// Returns a message if a call with --out-dir or for a film would overwrite a texture that one of
/// its drawings names; empty if none would be overwritten. Such a drawing would be refused when its
/// turn comes, but another drawing may have overwritten its texture by then. Reads every drawing as
/// XML, without its textures, each within the call's limits and time. Drawings that cannot be read,
/// and pipes, which can be read only once, are skipped.
std::string complaint_about_textures(Context& context, const DocumentArguments& arguments,
                                     const JobArguments& jobs);

}  // namespace sfumato::cli
