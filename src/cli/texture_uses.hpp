#pragma once

#include <string>

#include "cli/arguments.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::cli {

/// What is wrong where the pictures or the figures of a call with --out-dir would replace a texture
/// that one of its drawings names; empty: nothing. Such a drawing would be refused when its turn
/// comes, but a drawing before or after it may have been written over its texture by then.
/// Reads every drawing as XML, no texture, each within the call's limits and time. What cannot be
/// read, and a pipe, which can be read only once, is passed over.
std::string complaint_about_textures(Context& context, const RenderArguments& arguments);

}  // namespace sfumato::cli
