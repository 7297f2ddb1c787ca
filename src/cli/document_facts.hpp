#pragma once

#include <cstddef>

#include "base/box.hpp"
#include "document/document.hpp"

namespace sfumato::cli {

/// What `sfumato info` counts, over all layers.
struct DocumentFacts {
  std::size_t layers = 0;
  std::size_t curves = 0;
  std::size_t closed_curves = 0;  ///< that end where they begin
  std::size_t bezier_pieces = 0;
  std::size_t control_points = 0;
  std::size_t color_stops = 0;
  std::size_t blurred_curves = 0;  ///< with a blur radius above 0 somewhere
  std::size_t leaving_curves = 0;  ///< with a point outside the artboard
};

DocumentFacts count_facts(const Document& document);

/// Whether any point of the curve lies outside the box. Exact but for rounding.
bool leaves(const Curve& curve, const Box& box);

}  // namespace sfumato::cli
