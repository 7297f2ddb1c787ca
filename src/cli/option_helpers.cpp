#include "cli/option_helpers.hpp"

#include "cli/paths.hpp"

namespace sfumato::cli {

CLI::Option* add_output(CLI::App& app, std::string& output, const std::string& help) {
  const std::string expected = "a file name that ends in " + known_extensions() + ", or -";
  return add_value(app, "-o,--output", {expected, "OUT.png"}, help,
                   [&output](const std::string& text) {
                     output = text;
                     return output_kind(text).has_value();
                   });
}

}  // namespace sfumato::cli
