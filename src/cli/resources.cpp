#include "cli/resources.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/heap.hpp"
#include "cli/options/option_helpers.hpp"
#include "options/limit_option.hpp"
#include "options/tables.hpp"

namespace sfumato::cli {
namespace {

/// Sets the limit of "NAME=VALUE". Returns what is wrong with the text; empty if the limit is set.
std::string complaint_about(std::string_view text, Limits& limits) {
  const std::size_t equals = std::min(text.find('='), text.size());
  return options::set_limit(text.substr(0, equals), text.substr(std::min(equals + 1, text.size())),
                            limits);
}

void set_limits(const std::vector<std::string>& texts, Limits& limits) {
  for (const std::string& text : texts) {
    const std::string expected = complaint_about(text, limits);
    if (expected.empty()) continue;
    throw CLI::ValidationError("--limit", "invalid value \"" + text + "\"; use " + expected);
  }
}

}  // namespace

void add_resources(CommandSyntax& command, options::Resources& resources) {
  for (const options::Option<options::Resources>& option : options::resource_options()) {
    add_option(command, option, resources);
  }
  command.get_option("--max-memory")->each([](const std::string&) { return_freed_memory(); });
  CLI::Option* const limit = command.add_option_function<std::vector<std::string>>(
      "--limit",
      [&resources](const std::vector<std::string>& texts) { set_limits(texts, resources.limits); },
      "Change a limit on the input, such as curves=300k; may be\nrepeated");
  limit->type_name("NAME=VALUE")->allow_extra_args(false);
  ValueForm form{.kind = "limit"};
  for (const LimitName& known : limit_names()) form.choices.push_back(known.name);
  command.describe(limit->group(heading(options::Group::resources)), std::move(form));
}

}  // namespace sfumato::cli
