#include "cli/options/command_syntax.hpp"

#include <utility>

#include "formats/css/names.hpp"

namespace sfumato::cli {
namespace {

/// In the order of options::ValueKind.
constexpr const char* kKindNames[] = {"flag", "number", "whole", "fraction", "choice",
                                      "box",  "pixels", "color", "text"};
static_assert(std::size(kKindNames) == static_cast<std::size_t>(options::ValueKind::text) + 1);

void set_range(const options::OptionInfo& option, ValueForm& form) {
  if (option.kind == options::ValueKind::whole) {
    form.lowest = static_cast<double>(option.wholes.lowest);
    if (option.wholes.highest != options::WholeRange{}.highest) {
      form.highest = static_cast<double>(option.wholes.highest);
    }
  } else if (option.kind == options::ValueKind::number) {
    form.lowest = option.numbers.lowest;
    form.is_above = option.numbers.is_above;
    if (option.numbers.highest < options::NumberRange{}.highest) {
      form.highest = option.numbers.highest;
    }
  } else if (option.kind == options::ValueKind::fraction) {
    form.lowest = 0;
    form.is_above = true;
    form.highest = 1;
  }
}

/// Writes the usages of a CommandSyntax.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override {
    std::string text;
    for (const char* usage : static_cast<const CommandSyntax*>(app)->texts().usages) {
      text += (text.empty() ? "Usage: " : "       ") + name + ' ' + usage + '\n';
    }
    return text;
  }
};

std::string footer_of(const CommandTexts& texts) {
  std::string text = "Examples:";
  for (const char* example : texts.examples) text.append("\n  ").append(example);
  return text + (*texts.notes ? "\n\n" : "") + texts.notes;
}

}  // namespace

ValueForm form_of(const options::OptionInfo& option) {
  ValueForm form{.kind = kKindNames[static_cast<std::size_t>(option.kind)],
                 .expected = options::expected_value(option),
                 .choices = {option.words.begin(), option.words.end()}};
  if (option.instead) form.choices.emplace_back(option.instead);
  if (option.kind == options::ValueKind::color) {
    form.choices = {"none", "transparent"};
    for (const css::NamedColor& color : css::kNamedColors) form.choices.push_back(color.name);
  }
  set_range(option, form);
  return form;
}

ValueForm form_of_input(std::span<const std::string_view> extensions) {
  return {.kind = "file", .extensions = {extensions.begin(), extensions.end()}};
}

ValueForm form_of_output(std::span<const std::string_view> extensions) {
  ValueForm form = form_of_input(extensions);
  form.is_output = true;
  return form;
}

CommandSyntax::CommandSyntax(const CommandTexts& texts, CommandSyntax* root)
    : CLI::App(texts.summary, texts.name, root), texts_(texts) {
  footer(footer_of(texts));
  if (root) return;
  auto help = std::make_shared<HelpFormatter>();
  help->column_width(28);
  help->label("REQUIRED", "");
  formatter(std::move(help));
}

CommandSyntax& CommandSyntax::add_command(const CommandTexts& texts) {
  const auto command = std::make_shared<CommandSyntax>(texts, this);
  add_subcommand(command);
  return *commands_.emplace_back(command.get());
}

CLI::Option* CommandSyntax::describe(CLI::Option* option, ValueForm form) {
  forms_[option] = std::move(form);
  return option;
}

ValueForm CommandSyntax::form(const CLI::Option* option) const {
  const auto known = forms_.find(option);
  if (known != forms_.end()) return known->second;
  return {.kind = option->get_items_expected_max() == 0 ? "flag" : "text"};
}

}  // namespace sfumato::cli
