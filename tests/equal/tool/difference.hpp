#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "equal/tool/trace.hpp"

namespace sfumato::test {

/// The first number in which two computations of one scene differ.
struct Difference {
  std::string stage;             ///< the first stage that differs
  std::size_t item = 0;          ///< index of the number's item
  std::size_t channel = 0;       ///< index of the number in the item
  std::optional<Vec2> position;  ///< place of the item
  std::string value[2];          ///< the bits in hexadecimal, and their value; "nothing"
  std::size_t differing = 0;     ///< numbers of this stage that differ
  std::size_t count[2] = {};     ///< numbers of this stage
};

/// Compares bits: two zeros of different sign differ, two NaN with the same bits do not. Arrays are
/// compared in order. If one trace has another stage or type than the other one, or no more arrays,
/// that is the difference.
std::optional<Difference> first_difference(const Trace& a, const Trace& b);

/// Several lines, each ended.
std::string to_string(const Difference& difference);

}  // namespace sfumato::test
