#pragma once

#include <string_view>

namespace sfumato::display {

// Files compiled into the library (cmake/SfumatoEmbed.cmake); empty if the name is unknown.

/// Returns a shader of web/viewer/shaders or of gather: "patch.vert".
std::string_view shader_text(std::string_view name);

/// Returns a file of web/viewer/dist: "page.html" is the page with marks such as {{payload}}.
std::string_view page_text(std::string_view name);

}  // namespace sfumato::display
