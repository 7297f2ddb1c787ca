#pragma once

#include <cstddef>

#include "formats/svg/input.hpp"

namespace sfumato::svg {

/// What the document holds so far: held against the limits and charged before it is allocated.
class Totals {
 public:
  explicit Totals(Input& input) : input_(input) {}

  /// Counts curves that are read and left out: reading them took time. Errors: limit.
  Status count_curves(Element element, std::size_t curves, std::size_t control_points);

  /// Errors: limit; nothing is to be allocated then.
  Status add_curve(Element element, std::size_t control_points, std::size_t curve_bytes);
  Status add_stops(Element element, std::size_t count, std::size_t stop_bytes);
  Status add_texture(Element element, std::size_t texels);
  Status add_stack_item(Element element);

 private:
  Input& input_;
  std::size_t curves_ = 0;
  std::size_t control_points_ = 0;
  std::size_t stops_ = 0;
  std::size_t textures_ = 0;
  std::size_t texels_ = 0;
  std::size_t stack_items_ = 0;
};

}  // namespace sfumato::svg
