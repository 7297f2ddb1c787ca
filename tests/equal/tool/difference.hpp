#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "equal/tool/trace.hpp"

namespace sfumato::test {

/// The first number in which two computations of one scene differ.
struct Difference {
  std::string stage;             ///< the first that differs
  std::size_t item = 0;          ///< index of the item that the number is of
  std::size_t channel = 0;       ///< which of the item's numbers
  std::optional<Vec2> position;  ///< where the item lies
  std::string value[2];          ///< the bits in hexadecimal, and what they say; "nothing"
  std::size_t differing = 0;     ///< numbers of this stage that differ
  std::size_t count[2] = {};     ///< numbers of this stage
};

/// Compares bits: two zeros of different sign differ, two NaN of the same bits do not. Arrays are
/// compared in their order; where one trace names another stage or type than the other, or has
/// none, that is the difference.
std::optional<Difference> first_difference(const Trace& a, const Trace& b);

/// Several lines, each ended.
std::string to_string(const Difference& difference);

}  // namespace sfumato::test
