#pragma once

#include <string>

#include "cli/arguments.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::cli {

/// A message if what a call with --out-dir or for a film writes would replace a texture that one of
/// its drawings names; empty: none would. Such a drawing would be refused when its turn comes, but
/// another drawing may have overwritten its texture by then. Reads every drawing as XML, without
/// its textures, each within the call's limits and time. Drawings that cannot be read, and pipes,
/// which can be read only once, are skipped.
std::string complaint_about_textures(Context& context, const DocumentArguments& arguments,
                                     const JobArguments& jobs);

}  // namespace sfumato::cli
