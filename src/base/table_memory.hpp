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
#include "base/try.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato {

/// Returns the bytes that tables (vectors, strings) have allocated; a short string is stored in the
/// object itself.
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

/// A memory resource for tables (vectors, strings) that charges a Context's Budget. A table's
/// capacity is charged as it is allocated, to the byte; while a table moves to a larger allocation
/// both are charged. All charges are released at the end of this object's scope, so keep it beside
/// its tables and move it with them. A table may grow through a TableMemory other than the one that
/// made it, if both belong to the same Budget; the other one is then charged the difference.
///
/// Every function that returns a Status may fail with limit (memory) or cancelled; the content of
/// the table is then unspecified. New memory is first touched in parts, and the cancel flag is
/// polled between them, since touching takes 0.3 s per GiB, and up to 4 s in a virtual machine. If
/// the system has no memory, std::bad_alloc is thrown; see no_throw.
///
/// Belongs to one Budget, like ScopedCharge. Not thread-safe.
class TableMemory {
 public:
  /// purpose   the use of the tables, for the error's message: "textures"; a literal
  explicit TableMemory(std::string_view purpose) : purpose_(purpose) {}
  /// Belongs to this Budget from the start.
  TableMemory(std::string_view purpose, Budget& budget) : charge_(budget), purpose_(purpose) {}

  /// Reserves room for `count` items in all; a new allocation has exactly that size.
  template <class Table>
  Status reserve(const Context& context, Table& table, std::size_t count);

  /// Reserves room for `more` items after the present ones; a new allocation is at least twice as
  /// large.
  template <class Table>
  Status make_room(const Context& context, Table& table, std::size_t more = 1) {
    if (more <= table.capacity() - table.size()) return ok_status();
    return reserve(context, table, std::max(table.size() + more, 2 * table.size()));
  }

  /// Does table.push_back(item).
  template <class Table>
  Status push_back(const Context& context, Table& table, typename Table::value_type item) {
    SFUMATO_TRY(make_room(context, table));
    table.push_back(std::move(item));
    return ok_status();
  }

  /// Does table.resize(count, value).
  template <class Table>
  Status resize(const Context& context, Table& table, std::size_t count,
                const typename Table::value_type& value = {}) {
    Status status = reserve(context, table, count);
    return status ? fill(context, table, count, value) : status;
  }

  /// Does resize() for several tables with the same count.
  template <class... Table>
  Status resize_all(const Context& context, std::size_t count, Table&... tables) {
    Status status;
    ((status = resize(context, tables, count)).ok() && ...);
    return status;
  }

  /// Does resize() for a table that grows repeatedly: a new allocation has room for `most` items.
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

  /// Does table = from, in the table's own memory where that is large enough; otherwise with room
  /// for `more` items after them.
  template <class Table>
  Status assign(const Context& context, std::span<const typename Table::value_type> from,
                Table& table, std::size_t more = 0) {
    table.clear();
    Status status = from.size() + more <= table.capacity()
                        ? ok_status()
                        : reserve(context, table, from.size() + more);
    return status ? append(context, from, table) : status;
  }

  /// Appends the bytes of a text.
  Status append(const Context& context, std::string_view text, std::vector<std::uint8_t>& bytes) {
    const auto* data = reinterpret_cast<const std::uint8_t*>(text.data());
    return append(context, std::span(data, text.size()), bytes);
  }

  /// Sorts by `less`, not stably: sorts runs, then merges them in pairs into a second table, which
  /// is charged meanwhile. After an error the order is unspecified.
  template <class Item, class Less>
  static Status sort(const Context& context, std::vector<Item>& items, Less less);

  /// Charges the growth of tables that grew without this object, in inner loops that cannot return
  /// a Status. They occupy `bytes` now and occupied `known` before; `known` is updated. Error:
  /// limit (memory).
  Status settle(const Context& context, std::size_t bytes, std::size_t& known) {
    if (bytes <= known) return ok_status();
    SFUMATO_TRY(charge_.add(context, bytes - known, purpose_));
    known = bytes;
    return ok_status();
  }

  /// Empties the table and releases its memory.
  template <class Table>
  void free(Table& table) {
    charge_.release(capacity_bytes(table));
    Table().swap(table);
  }

  /// Ends the charges of tables that live on, so that the Budget need not outlive them. Returns the
  /// bytes that were charged.
  std::size_t leave_budget() { return charge_.leave(); }

  /// Takes over the charges of `other`, whose tables move too.
  void take(TableMemory&& other) { charge_.take(std::move(other.charge_)); }

 private:
  template <class Table>
  static constexpr std::size_t kPart = (std::size_t{2} << 20) / sizeof(typename Table::value_type);

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
  SFUMATO_TRY(charge_.add(context, sizeof(Item) * std::min(count, kMostItems), purpose_));
  Table moved;
  moved.reserve(count);
  Status status;
  if (const std::size_t bytes = capacity_bytes(moved); bytes > count * sizeof(Item)) {
    status = charge_.add(context, bytes - count * sizeof(Item), purpose_);  // strings round up
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
    Item* const first = table.data() + i;
    Item* const last = first + std::min(kPart<Table>, table.size() - i);
    if constexpr (std::is_trivially_copyable_v<Item>) {
      moved.insert(moved.end(), first, last);  // a string would take a moved range byte by byte
    } else {
      moved.insert(moved.end(), std::make_move_iterator(first), std::make_move_iterator(last));
    }
  }
  charge_.release(capacity_bytes(table));
  table = std::move(moved);
  return ok_status();
}

template <class Table>
Status TableMemory::append(const Context& context, std::span<const typename Table::value_type> from,
                           Table& table) {
  SFUMATO_TRY(make_room(context, table, from.size()));
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
  // The same capacity, since the two tables may be swapped.
  SFUMATO_TRY(memory.reserve(context, merged, items.capacity()));
  SFUMATO_TRY(memory.resize(context, merged, count));
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
