#pragma once

#include <string_view>

namespace sfumato::display {

/// Returns the text of a file of web/viewer, compiled into the library (cmake/SfumatoEmbed.cmake);
/// empty if the name is unknown. The name is relative to web/viewer: "shaders/patch.vert".
std::string_view embedded_file(std::string_view name);

}  // namespace sfumato::display
