#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/limit_error.hpp"
#include "base/table_memory.hpp"
#include "picture/picture_parts.hpp"
#include "picture/picture_writer.hpp"

namespace sfumato::picture {

/// The fewest bytes of an item in a file: room is made only for as many items as the file can hold.
template <class Item>
inline constexpr std::size_t kLeastBytes = sizeof(Item);
template <>
inline constexpr std::size_t kLeastBytes<Stop<Rgb>> = sizeof(double) + 3 * sizeof(float);
template <>
inline constexpr std::size_t kLeastBytes<Stop<float>> = sizeof(double) + sizeof(float);
template <>
inline constexpr std::size_t kLeastBytes<GradientStop> = sizeof(double) + 4 * sizeof(float);
template <>
inline constexpr std::size_t kLeastBytes<SoftEdge> = 3 * sizeof(float) + 4 * sizeof(double);
template <>
inline constexpr std::size_t kLeastBytes<Shader> = sizeof(std::uint64_t);
template <>
inline constexpr std::size_t kLeastBytes<PatchLayer> = 10 * sizeof(std::uint64_t);
template <>
inline constexpr std::size_t kLeastBytes<PictureItem> = sizeof(std::uint8_t);

/// An Archive of picture_parts.hpp that reads untrusted bytes. After the first failure it changes
/// nothing more.
class PartReader {
 public:
  /// begun    where the parts begin in the bytes of the file
  /// memory   for the tables that are read
  PartReader(const Context& context, std::span<const std::uint8_t> file, std::size_t begun,
             TableMemory& memory)
      : context_(context), file_(file), position_(begun), memory_(memory) {}

  void number(Number auto& number) { take(&number, sizeof number); }
  void flag(bool& is_set) {
    std::uint8_t byte = 0;
    number(byte);
    if (byte > 1) return fail("neither yes nor no");
    is_set = byte == 1;
  }
  template <class Item>
  void table(std::vector<Item>& items);
  void text(std::string& text) {
    if (resize(text)) take(text.data(), text.size());
  }
  template <class Items>
  bool resize(Items& items) {
    using Item = typename Items::value_type;
    const std::size_t count = read_count(kLeastBytes<Item>);
    if (ok()) check_limit<Item>(count);
    if (ok()) status_ = memory_.resize(context_, items, count);
    return ok();
  }
  template <class... Part>
  bool alternative(std::variant<Part...>& variant);

  bool ok() const { return status_.ok(); }
  /// Returns ok, or bad_input, limit (memory), cancelled.
  const Status& status() const { return status_; }
  bool at_end() const { return position_ == file_.size(); }

 private:
  void fail(const char* what) {
    if (ok()) status_ = make_error(StatusCode::bad_input, std::string("damaged: ") + what);
  }
  std::size_t left() const { return file_.size() - position_; }
  void take(void* to, std::size_t size) {
    if (size > left()) fail("it ends within a part");
    if (!ok() || size == 0) return;
    std::memcpy(to, file_.data() + position_, size);
    position_ += size;
  }
  /// Returns the length of a table; 0 where it exceeds the remaining bytes.
  std::size_t read_count(std::size_t least_bytes) {
    std::uint64_t count = 0;
    number(count);
    if (count > left() / least_bytes) fail("a table is longer than the file");
    return ok() ? static_cast<std::size_t>(count) : 0;
  }
  void skip_padding();
  /// Items that take much more room than in the file are counted before room is made for them.
  template <class Item>
  void check_limit(std::size_t count) {
    const Limits& limits = context_.limits;
    if constexpr (std::is_same_v<Item, PictureItem>) {
      if (count > limits.stack_items) {
        status_ = limit_error(limits, &Limits::stack_items, "items in the stack");
      }
    } else if constexpr (std::is_same_v<Item, PatchLayer>) {
      if (count > limits.layers) status_ = limit_error(limits, &Limits::layers, "layers");
    }
  }

  const Context& context_;
  std::span<const std::uint8_t> file_;
  std::size_t position_;
  TableMemory& memory_;
  Status status_;
};

inline void PartReader::skip_padding() {
  std::array<std::uint8_t, kTableAlignment> padding{};
  take(padding.data(), padding_at(position_));
  if (std::ranges::any_of(padding, [](std::uint8_t byte) { return byte != 0; })) {
    fail("there is something before a table");
  }
}

/// Goes through a small array: the bytes may lie at any address.
template <class Item>
void PartReader::table(std::vector<Item>& items) {
  const std::size_t count = read_count(sizeof(Item));
  skip_padding();
  if (ok() && count > left() / sizeof(Item)) fail("a table is longer than the file");
  if (ok()) status_ = memory_.reserve(context_, items, count);
  std::array<Item, 16384 / sizeof(Item)> part;
  for (std::size_t rest = count; ok() && rest > 0;) {
    const std::size_t some = std::min(rest, part.size());
    take(part.data(), some * sizeof(Item));
    status_ = memory_.append(context_, {part.data(), some}, items);
    rest -= some;
  }
}

template <class... Part>
bool PartReader::alternative(std::variant<Part...>& variant) {
  std::uint8_t index = 0;
  number(index);
  if (index >= sizeof...(Part)) fail("a part of no known kind");
  if (!ok()) return false;
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    ((index == kIndex ? static_cast<void>(variant.template emplace<kIndex>()) : void()), ...);
  }
  (std::index_sequence_for<Part...>{});
  return true;
}

}  // namespace sfumato::picture
