#pragma once

#include <string_view>

namespace sfumato::display {

/// The text of a file of web/viewer, compiled into the library (cmake/SfumatoEmbed.cmake); empty
/// where the name is not known. Name: relative to web/viewer, "shaders/patch.vert".
std::string_view embedded_file(std::string_view name);

}  // namespace sfumato::display
