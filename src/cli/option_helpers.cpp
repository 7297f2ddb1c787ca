#include "cli/option_helpers.hpp"

#include <filesystem>
#include <string_view>
#include <system_error>

#include "cli/paths.hpp"
#include "formats/suggestion.hpp"

namespace sfumato::cli {
namespace {

/// What is wrong with the name of a folder; empty: nothing.
std::string complaint_about_folder(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return {};
  return "\"" + path + "\" given, expected a folder that exists";
}

}  // namespace

std::string word_hint(const std::string& text, const std::vector<std::string>& words) {
  const std::vector<std::string_view> candidates(words.begin(), words.end());
  return did_you_mean(text, candidates);
}

CLI::Option* add_png_output(CLI::App& app, std::string& output, const std::string& help) {
  return add_value(app, "-o,--output", {"a file name that ends in .png, or -", "OUT.png"}, help,
                   [&output](const std::string& text) {
                     output = text;
                     return text == "-" || output_kind(text) == OutputKind::png;
                   });
}

void add_document(CLI::App& app, DocumentArguments& arguments) {
  app.add_option("IN", arguments.input, "Diffusion curves (SVG or Orzan XML); '-': from stdin")
      ->required()
      ->type_name("");
  add_allowed_folders(app, arguments);
}

void add_allowed_folders(CLI::App& app, DocumentArguments& arguments) {
  app.add_option("--allow-files", arguments.allowed_folders,
                 "Read textures from this folder too, and below;\nmay be given several times "
                 "[only beside IN]")
      ->type_name("DIR")
      ->allow_extra_args(false)
      ->check(CLI::Validator(complaint_about_folder, ""));
}

}  // namespace sfumato::cli
