#include "options/limit_option.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "formats/text/suggestion.hpp"
#include "options/values.hpp"

namespace sfumato::options {

std::string expected_limits(std::string_view given) {
  std::string list;
  std::vector<std::string_view> names;
  for (const LimitName& known : limit_names()) {
    list += (list.empty() ? "" : ", ") + std::string(known.name);
    names.push_back(known.name);
  }
  return list + text::did_you_mean(given, names);
}

std::string set_limit(std::string_view name, std::string_view digits, Limits& limits) {
  const auto known = std::ranges::find(limit_names(), name, &LimitName::name);
  if (known == limit_names().end()) return "NAME=VALUE, NAME one of " + expected_limits(name);
  const std::optional<std::uint64_t> value = parse_count(digits, known->highest);
  if (!value) {
    return std::string(name) + "= and a whole number from 0 to " + std::to_string(known->highest) +
           ", perhaps with k, M, KiB or MiB behind it";
  }
  limits.*(known->value) = static_cast<std::size_t>(*value);
  return {};
}

}  // namespace sfumato::options
