#pragma once

#include <string>

#include "formats/svg/svg_write_text.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::svg {

/// Writes a shader as <linearGradient>, <radialGradient> or <pattern>. Its frame is the user space
/// of what refers to it, the texture's own with one texel per unit. Errors: bad_input (a texture
/// that does not repeat), limit, cancelled.
Status write_shader(Context& context, ElementWriter& writer, const Shader& shader,
                    const std::string& id);

/// What an id is made from where the shader has none: "gradient" or "texture".
std::string_view kind_of(const Shader& shader);

}  // namespace sfumato::svg
