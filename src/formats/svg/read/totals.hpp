#pragma once

#include <cstddef>

#include "formats/svg/read/input.hpp"

namespace sfumato::svg {

/// Counts the document's parts and checks them against the limits before they are allocated.
class Totals {
 public:
  explicit Totals(Input& input) : input_(input) {}

  /// Errors: limit; nothing may be allocated then. Curves that are read and then left out count
  /// too, because reading them took time.
  Status count_curves(Element element, std::size_t curves, std::size_t control_points);
  Status count_stops(Element element, std::size_t count);
  Status count_texture(Element element, std::size_t texels);
  Status count_stack_item(Element element);

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
