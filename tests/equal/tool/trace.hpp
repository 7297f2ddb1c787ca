#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::test {

enum class NumberType : std::uint8_t { u8, u16, u32, i32, f32, f64 };

std::size_t size_of(NumberType type);

/// An array of numbers, the result of one step of a computation.
struct TraceArray {
  std::string stage;                  ///< "layer 0, round 2: node values"
  NumberType type = NumberType::u8;   ///< of each number
  std::uint32_t width = 1;            ///< numbers of one item
  std::vector<std::uint8_t> bytes{};  ///< the numbers, in the machine's byte order
  std::vector<Vec2> position{};       ///< per item: its place; empty: none

  std::size_t number_count() const { return bytes.size() / size_of(type); }
};

/// All steps of a computation, in order.
using Trace = std::vector<TraceArray>;

/// Writes or reads one file. Errors: io; bad_input for a file of another kind.
Status save_trace(const std::string& path, const Trace& trace);
Result<Trace> load_trace(const std::string& path);

/// Returns the same as bytes.
std::string trace_bytes(const Trace& trace);
Result<Trace> parse_trace(std::string_view bytes);

template <class Number>
constexpr NumberType number_type() {
  static_assert(std::is_arithmetic_v<Number>);
  if constexpr (std::is_same_v<Number, float>) return NumberType::f32;
  if constexpr (std::is_same_v<Number, double>) return NumberType::f64;
  if constexpr (std::is_same_v<Number, std::int32_t>) return NumberType::i32;
  if constexpr (std::is_same_v<Number, std::uint32_t>) return NumberType::u32;
  if constexpr (std::is_same_v<Number, std::uint16_t>) return NumberType::u16;
  return NumberType::u8;
}

/// Returns an array of `width` numbers per item.
template <class Number>
TraceArray numbers(std::string stage, const std::vector<Number>& values, std::uint32_t width,
                   std::vector<Vec2> position = {}) {
  const auto* const first = reinterpret_cast<const std::uint8_t*>(values.data());
  return {std::move(stage),
          number_type<Number>(),
          width,
          {first, first + values.size() * sizeof(Number)},
          std::move(position)};
}

/// Returns points, each with itself as its place.
TraceArray points(std::string stage, const std::vector<Vec2>& values);

}  // namespace sfumato::test
