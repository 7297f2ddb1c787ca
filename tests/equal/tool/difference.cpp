#include "equal/tool/difference.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstring>

namespace sfumato::test {
namespace {

template <class Number>
Number number_at(const TraceArray& array, std::size_t index) {
  Number number;
  std::memcpy(&number, array.bytes.data() + index * sizeof number, sizeof number);
  return number;
}

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[96];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string number_text(const TraceArray& array, std::size_t index) {
  if (index >= array.number_count()) return "nothing";
  switch (array.type) {
    case NumberType::u8:
      return formatted("0x%02x = %d", array.bytes[index], array.bytes[index]);
    case NumberType::u16: {
      const auto number = number_at<std::uint16_t>(array, index);
      return formatted("0x%04x = %d", number, number);
    }
    case NumberType::u32: {
      const auto number = number_at<std::uint32_t>(array, index);
      return formatted("0x%08" PRIx32 " = %" PRIu32, number, number);
    }
    case NumberType::i32: {
      const auto number = number_at<std::int32_t>(array, index);
      return formatted("0x%08" PRIx32 " = %" PRId32, static_cast<std::uint32_t>(number), number);
    }
    case NumberType::f32:
      return formatted("0x%08" PRIx32 " = %.9g", number_at<std::uint32_t>(array, index),
                       static_cast<double>(number_at<float>(array, index)));
    case NumberType::f64:
      return formatted("0x%016" PRIx64 " = %.17g", number_at<std::uint64_t>(array, index),
                       number_at<double>(array, index));
  }
  return "?";
}

bool same_number(const TraceArray& a, const TraceArray& b, std::size_t index) {
  const std::size_t size = size_of(a.type), at = index * size;
  return std::memcmp(a.bytes.data() + at, b.bytes.data() + at, size) == 0;
}

/// Returns the first number that differs between two arrays of one stage and type; the end of the
/// shorter one.
Difference difference_within(const TraceArray& a, const TraceArray& b) {
  Difference difference;
  difference.stage = a.stage;
  difference.count[0] = a.number_count();
  difference.count[1] = b.number_count();
  const auto [common, all] = std::minmax(difference.count[0], difference.count[1]);
  std::size_t first = common;
  for (std::size_t i = common; i-- > 0;) {
    if (same_number(a, b, i)) continue;
    first = i;
    ++difference.differing;
  }
  difference.differing += all - common;
  difference.item = first / a.width;
  difference.channel = first % a.width;
  const TraceArray& longer = a.number_count() < b.number_count() ? b : a;
  if (difference.item < longer.position.size()) {
    difference.position = longer.position[difference.item];
  }
  difference.value[0] = number_text(a, first);
  difference.value[1] = number_text(b, first);
  return difference;
}

std::string kind_text(const TraceArray* array) {
  if (!array) return "nothing";
  constexpr const char* kNames[] = {"u8", "u16", "u32", "i32", "f32", "f64"};
  return array->stage + ", " + kNames[static_cast<std::size_t>(array->type)] + " by " +
         std::to_string(array->width);
}

/// Returns the difference between two arrays at one place of their traces that are not the same
/// step; null: missing.
Difference difference_of_steps(const TraceArray* a, const TraceArray* b) {
  Difference difference;
  difference.stage = "the steps themselves";
  difference.value[0] = kind_text(a);
  difference.value[1] = kind_text(b);
  return difference;
}

}  // namespace

std::optional<Difference> first_difference(const Trace& a, const Trace& b) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const TraceArray* const left = i < a.size() ? &a[i] : nullptr;
    const TraceArray* const right = i < b.size() ? &b[i] : nullptr;
    if (!left || !right || left->stage != right->stage || left->type != right->type ||
        left->width != right->width) {
      return difference_of_steps(left, right);
    }
    if (left->bytes != right->bytes) return difference_within(*left, *right);
  }
  return std::nullopt;
}

std::string to_string(const Difference& difference) {
  std::string text = "first differing stage: " + difference.stage + '\n';
  if (difference.differing > 0) {
    text += "  item " + std::to_string(difference.item) + ", number " +
            std::to_string(difference.channel);
    if (difference.position) {
      text += formatted(", at (%.17g, %.17g)", difference.position->x, difference.position->y);
    }
    text += '\n';
  }
  text += "  a: " + difference.value[0] + "\n  b: " + difference.value[1] + '\n';
  if (difference.differing > 0) {
    text += "  numbers that differ: " + std::to_string(difference.differing) + " of " +
            std::to_string(difference.count[0]);
    if (difference.count[0] != difference.count[1]) {
      text += " and " + std::to_string(difference.count[1]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace sfumato::test
