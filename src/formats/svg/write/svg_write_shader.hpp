#pragma once

#include <string>

#include "formats/svg/write/svg_write_text.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::svg {

/// Writes a shader as <linearGradient>, <radialGradient> or <pattern>. Its frame is the user space
/// of the element that refers to it; a texture's own frame has one texel per unit.
/// Errors: limit, cancelled.
Status write_shader(Context& context, ElementWriter& writer, const Shader& shader,
                    const std::string& id);

/// Returns the base of the id of a shader without one: "gradient" or "texture".
std::string_view kind_of(const Shader& shader);

}  // namespace sfumato::svg
