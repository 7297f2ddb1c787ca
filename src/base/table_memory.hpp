#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/poll.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato {

/// Bytes that tables (vectors, strings) have allocated; a short string lies in the object itself.
template <class... Table>
std::size_t capacity_bytes(const Table&... tables) {
  const auto bytes = [](const auto& table) {
    using Kind = std::remove_cvref_t<decltype(table)>;
    return table.capacity() > Kind().capacity()
               ? table.capacity() * sizeof(typename Kind::value_type)
               : std::size_t{0};
  };
  return (std::size_t{0} + ... + bytes(tables));
}

/// A Context's Budget as a resource of memory for tables (vectors, strings). A table's room is
/// charged as it is allocated, to the byte; a table that moves to a larger room is charged twice
/// while both exist. Everything is given back at the end of this object's scope: it stands beside
/// the tables, and moves with them. A table may grow through another TableMemory than the one that
/// made it, of the same Budget: that one pays for the difference.
///
/// Every verb may fail with limit (memory) or cancelled; what the table holds is unspecified then.
/// Memory is touched for the first time in parts, with a look at the cancel flag between them,
/// since that takes 0.3 s a GiB. An allocation of the machine that fails throws std::bad_alloc, see
/// no_throw.
///
/// Belongs to one Budget, as ScopedCharge does. Not thread-safe.
class TableMemory {
 public:
  /// purpose   what the tables are for, in the error's message: "textures"; a literal
  explicit TableMemory(std::string_view purpose) : purpose_(purpose) {}
  /// Of this Budget, whichever Context comes first.
  TableMemory(std::string_view purpose, Budget& budget) : charge_(budget), purpose_(purpose) {}

  /// Room for `count` items in all, and no more than that where it has to be made.
  template <class Table>
  Status reserve(const Context& context, Table& table, std::size_t count);

  /// Room for `more` items behind those that are there; where it has to be made the room doubles at
  /// least.
  template <class Table>
  Status make_room(const Context& context, Table& table, std::size_t more = 1) {
    if (more <= table.capacity() - table.size()) return ok_status();
    return reserve(context, table, std::max(table.size() + more, 2 * table.size()));
  }

  /// table.push_back(item).
  template <class Table>
  Status push_back(const Context& context, Table& table, typename Table::value_type item) {
    Status status = make_room(context, table);
    if (status) table.push_back(std::move(item));
    return status;
  }

  /// table.resize(count, value).
  template <class Table>
  Status resize(const Context& context, Table& table, std::size_t count,
                const typename Table::value_type& value = {}) {
    Status status = reserve(context, table, count);
    return status ? fill(context, table, count, value) : status;
  }

  /// resize() of several tables to the same count.
  template <class... Table>
  Status resize_all(const Context& context, std::size_t count, Table&... tables) {
    Status status;
    ((status = resize(context, tables, count)).ok() && ...);
    return status;
  }

  /// resize() for what grows again and again: where room has to be made there is room for `most`.
  template <class Table>
  Status grow(const Context& context, Table& table, std::size_t count, std::size_t most,
              const typename Table::value_type& value = {}) {
    Status status;
    if (count > table.capacity()) status = reserve(context, table, std::max(count, most));
    return status ? fill(context, table, count, value) : status;
  }

  /// Appends copies of `from`.
  template <class Table>
  Status append(const Context& context, std::span<const typename Table::value_type> from,
                Table& table);

  /// Appends the bytes of a text.
  Status append(const Context& context, std::string_view text, std::vector<std::uint8_t>& bytes) {
    const auto* data = reinterpret_cast<const std::uint8_t*>(text.data());
    return append(context, std::span(data, text.size()), bytes);
  }

  /// Sorts by `less`, not stably: runs, and then these merged by twos into a second table, which is
  /// charged meanwhile. On failure the order is unspecified.
  template <class Item, class Less>
  static Status sort(const Context& context, std::vector<Item>& items, Less less);

  /// Charges what tables have grown by themselves, in loops too deep for a status. They take
  /// `bytes` now, and took `known` before, which follows. Error: limit (memory).
  Status settle(const Context& context, std::size_t bytes, std::size_t& known) {
    if (bytes <= known) return ok_status();
    Status status = charge_.add(context, bytes - known, purpose_);
    if (status) known = bytes;
    return status;
  }

  /// Empties the table and gives its room back.
  template <class Table>
  void free(Table& table) {
    charge_.release(capacity_bytes(table));
    Table().swap(table);
  }

  /// Takes over what `other` holds, together with its tables.
  void take(TableMemory&& other) { charge_.take(std::move(other.charge_)); }

 private:
  template <class Table>
  static constexpr std::size_t kPart = (std::size_t{8} << 20) / sizeof(typename Table::value_type);

  template <class Table>
  Status fill(const Context& context, Table& table, std::size_t count,
              const typename Table::value_type& value) {
    if (count < table.size()) table.resize(count, value);
    while (table.size() < count) {
      if (context.cancelled()) return context.cancel_status();
      table.resize(std::min(count, table.size() + kPart<Table>), value);
    }
    return ok_status();
  }

  ScopedCharge charge_;
  std::string_view purpose_;
};

template <class Table>
Status TableMemory::reserve(const Context& context, Table& table, std::size_t count) {
  using Item = typename Table::value_type;
  if (count <= table.capacity()) return ok_status();
  constexpr std::size_t kMostItems = std::numeric_limits<std::size_t>::max() / sizeof(Item);
  Status status = charge_.add(context, sizeof(Item) * std::min(count, kMostItems), purpose_);
  if (!status) return status;
  Table moved;
  moved.reserve(count);
  if (const std::size_t bytes = capacity_bytes(moved); bytes > count * sizeof(Item)) {
    status = charge_.add(context, bytes - count * sizeof(Item), purpose_);  // as strings round up
    if (!status) {
      charge_.release(count * sizeof(Item));
      return status;
    }
  }
  for (std::size_t i = 0; i < table.size(); i += kPart<Table>) {
    if (context.cancelled()) {
      charge_.release(capacity_bytes(moved));
      return context.cancel_status();
    }
    const auto first = table.begin() + static_cast<std::ptrdiff_t>(i);
    const auto items = static_cast<std::ptrdiff_t>(std::min(kPart<Table>, table.size() - i));
    moved.insert(moved.end(), std::make_move_iterator(first),
                 std::make_move_iterator(first + items));
  }
  charge_.release(capacity_bytes(table));
  table = std::move(moved);
  return ok_status();
}

template <class Table>
Status TableMemory::append(const Context& context, std::span<const typename Table::value_type> from,
                           Table& table) {
  if (Status status = make_room(context, table, from.size()); !status) return status;
  for (std::size_t i = 0; i < from.size(); i += kPart<Table>) {
    if (context.cancelled()) return context.cancel_status();
    const auto part = from.subspan(i, std::min(kPart<Table>, from.size() - i));
    table.insert(table.end(), part.begin(), part.end());
  }
  return ok_status();
}

template <class Item, class Less>
Status TableMemory::sort(const Context& context, std::vector<Item>& items, Less less) {
  constexpr std::size_t kRun = std::size_t{1} << 15;
  const std::size_t count = items.size();
  for (std::size_t begin = 0; begin < count; begin += kRun) {
    if (context.cancelled()) return context.cancel_status();
    const auto first = items.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, first + static_cast<std::ptrdiff_t>(std::min(kRun, count - begin)), less);
  }
  if (count <= kRun) return ok_status();
  TableMemory memory("sorting");
  std::vector<Item> merged;
  // Of the same room, since the two tables may change places.
  Status status = memory.reserve(context, merged, items.capacity());
  if (status) status = memory.resize(context, merged, count);
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
