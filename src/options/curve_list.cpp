#include "options/curve_list.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "options/values.hpp"

namespace sfumato::options {
namespace {

std::optional<std::uint32_t> parse_index(std::string_view text) {
  const auto value = parse_whole(text, 0, std::numeric_limits<std::uint32_t>::max());
  return value ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

}  // namespace

std::size_t most_curves(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count(text, ',')) + 1;
}

bool parse_curves(std::string_view text, std::vector<CurveOfLayer>& curves) {
  while (true) {
    const std::string_view one = text.substr(0, text.find(','));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) return false;
    const auto layer = parse_index(one.substr(0, colon));
    const auto curve = parse_index(one.substr(colon + 1));
    if (!layer || !curve) return false;
    curves.push_back({*layer, *curve});
    if (one.size() == text.size()) return true;
    text.remove_prefix(one.size() + 1);
  }
}

}  // namespace sfumato::options
