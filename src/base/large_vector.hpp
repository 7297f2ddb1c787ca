#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "sfumato/base/context.hpp"

namespace sfumato {

template <class Item>
Status reserve_large(const Context& context, std::vector<Item>& items, std::size_t count);

/// Appends a copy of `from`, part by part, since that takes long; where room is lacking it doubles
/// at least. Who calls has charged for it. Errors: cancelled; `to` is shorter then.
template <class Item>
Status append_large(const Context& context, std::span<const Item> from, std::vector<Item>& to) {
  constexpr std::size_t kItems = (std::size_t{8} << 20) / sizeof(Item);
  const std::size_t size = to.size() + from.size();
  if (size > to.capacity()) {
    Status status = reserve_large(context, to, std::max(size, 2 * to.size()));
    if (!status) return status;
  }
  for (std::size_t i = 0; i < from.size(); i += kItems) {
    if (context.cancelled()) return context.cancel_status();
    const std::span<const Item> part = from.subspan(i, std::min(kItems, from.size() - i));
    to.insert(to.end(), part.begin(), part.end());
  }
  return ok_status();
}

/// Appends the bytes of a text in the same way.
inline Status append_text(const Context& context, std::string_view text,
                          std::vector<std::uint8_t>& to) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  return append_large(context, std::span(bytes, text.size()), to);
}

/// items.reserve(count), which copies what is there, in the same way. Errors: cancelled; nothing
/// changes then.
template <class Item>
Status reserve_large(const Context& context, std::vector<Item>& items, std::size_t count) {
  if (count <= items.capacity()) return ok_status();
  std::vector<Item> moved;
  moved.reserve(count);
  Status status = append_large(context, std::span<const Item>(items), moved);
  if (!status) return status;
  items = std::move(moved);
  return ok_status();
}

}  // namespace sfumato
