#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "base/output_buffer.hpp"
#include "picture/picture_parts.hpp"

namespace sfumato::picture {

/// Tables begin at a multiple of this in the file, so that they can be used in place.
inline constexpr std::size_t kTableAlignment = 16;

/// Returns the bytes from a position in the file to the next place where a table may begin.
constexpr std::size_t padding_at(std::size_t position) {
  return (kTableAlignment - position % kTableAlignment) % kTableAlignment;
}

/// An Archive of picture_parts.hpp over a Sink, which has append(data, size) and position().
template <class Sink>
class PartWriter {
 public:
  explicit PartWriter(Sink& sink) : sink_(sink) {}

  void number(const Number auto& number) { sink_.append(&number, sizeof number); }
  void flag(bool is_set) { number(std::uint8_t{is_set}); }
  template <class Item>
  void table(const std::vector<Item>& items) {
    static_assert(std::has_unique_object_representations_v<Item> || std::is_same_v<Item, float> ||
                  (std::is_same_v<Item, Vec2> && sizeof(Vec2) == 2 * sizeof(double)));
    static constexpr std::uint8_t kZeros[kTableAlignment] = {};
    resize(items);
    sink_.append(kZeros, padding_at(sink_.position()));
    sink_.append(items.data(), items.size() * sizeof(Item));
  }
  void text(const std::string& text) {
    resize(text);
    sink_.append(text.data(), text.size());
  }
  bool resize(const auto& items) {
    number(std::uint64_t{items.size()});
    return true;
  }
  template <class... Part>
  bool alternative(const std::variant<Part...>& variant) {
    number(static_cast<std::uint8_t>(variant.index()));
    return true;
  }
  bool ok() const { return true; }

 private:
  Sink& sink_;
};

/// A Sink that counts.
class ByteCount {
 public:
  explicit ByteCount(std::size_t begun) : bytes_(begun) {}
  void append(const void*, std::size_t size) { bytes_ += size; }
  std::size_t position() const { return bytes_; }

 private:
  std::size_t bytes_;
};

/// A Sink that writes.
class BufferSink {
 public:
  explicit BufferSink(OutputBuffer& buffer) : buffer_(buffer) {}
  void append(const void* data, std::size_t size) {
    buffer_.append({static_cast<const std::uint8_t*>(data), size});
  }
  std::size_t position() const { return buffer_.size(); }

 private:
  OutputBuffer& buffer_;
};

}  // namespace sfumato::picture
