#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/context.hpp"

namespace sfumato {

/// Makes room for `count` items and sets them, part by part: to touch memory for the first time
/// takes 0.3 s a GiB. Charged before by who calls. Errors: cancelled; `items` is shorter then.
template <class Item>
Status resize_large(const Context& context, std::vector<Item>& items, std::size_t count) {
  constexpr std::size_t kItems = (std::size_t{8} << 20) / sizeof(Item);
  items.reserve(count);
  while (items.size() < count) {
    if (context.cancelled()) return context.stop_status();
    items.resize(std::min(count, items.size() + kItems));
  }
  return ok_status();
}

/// Appends a copy of `from` in the same way.
template <class Item>
Status copy_large(const Context& context, const std::vector<Item>& from, std::vector<Item>& to) {
  constexpr std::size_t kItems = (std::size_t{8} << 20) / sizeof(Item);
  to.reserve(to.size() + from.size());
  for (std::size_t i = 0; i < from.size(); i += kItems) {
    if (context.cancelled()) return context.stop_status();
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(i);
    const std::size_t count = std::min(kItems, from.size() - i);
    to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
  }
  return ok_status();
}

}  // namespace sfumato
