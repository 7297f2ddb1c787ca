#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/poll.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato {

template <class Item>
Status reserve_large(const Context& context, std::vector<Item>& items, std::size_t count);

/// Makes room for `count` items and sets them, part by part: to touch memory for the first time
/// takes 0.3 s a GiB. Charged before by who calls. Errors: cancelled; `items` is shorter then.
template <class Item>
Status resize_large(const Context& context, std::vector<Item>& items, std::size_t count,
                    const Item& value = Item()) {
  constexpr std::size_t kItems = (std::size_t{8} << 20) / sizeof(Item);
  if (Status status = reserve_large(context, items, count); !status) return status;
  while (items.size() < count) {
    if (context.cancelled()) return context.cancel_status();
    items.resize(std::min(count, items.size() + kItems), value);
  }
  return ok_status();
}

/// Appends a copy of `from` in the same way. Where room is lacking it doubles at least.
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

template <class Item>
Status copy_large(const Context& context, const std::vector<Item>& from, std::vector<Item>& to) {
  return append_large(context, std::span<const Item>(from), to);
}

/// items.reserve(count), which copies what is there, in the same way. Errors: cancelled; nothing
/// changes then.
template <class Item>
Status reserve_large(const Context& context, std::vector<Item>& items, std::size_t count) {
  if (count <= items.capacity()) return ok_status();
  std::vector<Item> moved;
  moved.reserve(count);
  if (Status status = copy_large(context, items, moved); !status) return status;
  items = std::move(moved);
  return ok_status();
}

/// resize_large for what grows again and again: where room is lacking there is room for `most`
/// then.
template <class Item>
Status grow_large(const Context& context, std::vector<Item>& items, std::size_t count,
                  std::size_t most, const Item& value = Item()) {
  if (count > items.capacity()) {
    Status status = reserve_large(context, items, std::max(count, most));
    if (!status) return status;
  }
  return resize_large(context, items, count, value);
}

/// Sorts by `less`, not stably: runs, and then these merged by twos into a second vector, which is
/// charged. Errors: limit (memory), cancelled; the order is unspecified then.
template <class Item, class Less>
Status sort_large(Context& context, std::vector<Item>& items, Less less) {
  constexpr std::size_t kRun = std::size_t{1} << 15;
  const std::size_t count = items.size();
  for (std::size_t begin = 0; begin < count; begin += kRun) {
    if (context.cancelled()) return context.cancel_status();
    const auto first = items.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, first + static_cast<std::ptrdiff_t>(std::min(kRun, count - begin)), less);
  }
  if (count <= kRun) return ok_status();
  ScopedCharge charge;
  Status status = charge.add(context, count * sizeof(Item), "sorting");
  std::vector<Item> merged;
  if (status) status = resize_large(context, merged, count);
  if (!status) return status;
  RarePoll<kRun> poll(context);
  for (std::size_t run = kRun; run < count; run *= 2) {
    std::size_t out = 0;
    for (std::size_t begin = 0; begin < count; begin += 2 * run) {
      std::size_t a = begin, b = std::min(begin + run, count);
      const std::size_t a_end = b, b_end = std::min(b + run, count);
      while (out < b_end) {
        if (poll.cancelled()) return context.cancel_status();
        const bool takes_b = a == a_end || (b < b_end && less(items[b], items[a]));
        merged[out++] = items[takes_b ? b++ : a++];
      }
    }
    items.swap(merged);
  }
  return ok_status();
}

}  // namespace sfumato
