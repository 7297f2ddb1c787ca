#include "formats/svg/style/style_levels.hpp"

#include <algorithm>
#include <utility>

namespace sfumato::svg {

void StyleLevels::set(std::vector<Element> around) {
  const auto [kept_end, _] = std::ranges::mismatch(around_, around);
  const auto kept = static_cast<std::size_t>(kept_end - around_.begin());
  if (values_.size() > kept) values_.resize(kept);
  around_ = std::move(around);
}

/// Nothing if the value is that of the element around.
StyleLevels::Known StyleLevels::own_value(std::size_t level, css::Property property) {
  const StyleScope scope(around_[level], std::span(around_).first(level));
  const Input::Cascaded own = input_.cascaded(scope, property);
  if (own.value) return Known(own.value);
  const bool goes_up = own.keyword == css::WideKeyword::inherit ||
                       (own.keyword != css::WideKeyword::initial && css::is_inherited(property));
  if (goes_up && level > 0) return std::nullopt;
  return Known(std::optional<std::string_view>());
}

std::optional<std::string_view> StyleLevels::value(css::Property property) {
  if (around_.empty()) return std::nullopt;
  values_.resize(around_.size());
  const auto index = static_cast<std::size_t>(property);
  std::size_t level = around_.size() - 1;
  Known known;
  for (;; --level) {
    known = values_[level][index];
    if (!known) known = own_value(level, property);
    if (known) break;
  }
  for (; level < around_.size(); ++level) values_[level][index] = known;
  return *known;
}

}  // namespace sfumato::svg
