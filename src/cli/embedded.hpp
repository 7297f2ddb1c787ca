#pragma once

#include <string_view>

namespace sfumato::cli {

/// Returns the text of a file of web/watch or src/cli/templates, compiled into the command
/// (cmake/SfumatoEmbed.cmake); empty if the name is unknown. Without folder: "watch.css".
std::string_view embedded_file(std::string_view name);

}  // namespace sfumato::cli
