#pragma once

#include <cstddef>
#include <vector>

#include "sfumato/base/box.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::cli {

/// Holds the counts of `sfumato info`. Curves are diffusion curves. Each counts once, however often
/// its layer is painted.
struct DocumentFacts {
  std::size_t layers = 0;
  std::size_t instances = 0;  ///< places where a layer is painted
  std::size_t groups = 0;
  std::size_t curves = 0;
  std::size_t closed_curves = 0;   ///< with equal end points
  std::size_t color_curves = 0;    ///< with a colour on a side and no opacity
  std::size_t opacity_curves = 0;  ///< with an opacity on a side and no colour
  std::size_t both_curves = 0;     ///< with both
  std::size_t barrier_curves = 0;  ///< with neither, but a barrier on a side
  std::size_t bare_curves = 0;     ///< with no attribute at all
  std::size_t local_curves = 0;
  std::size_t bezier_pieces = 0;   ///< of curves and local curves
  std::size_t control_points = 0;  ///< of both
  std::size_t color_stops = 0;     ///< of both
  std::size_t opacity_stops = 0;
  std::size_t blurred_curves = 0;   ///< with a blur radius above 0 somewhere
  std::size_t weighted_curves = 0;  ///< with a weight that is not 1
  std::size_t leaving_curves = 0;   ///< with a point outside the artboard, where first painted
  std::size_t linear_gradients = 0;
  std::size_t radial_gradients = 0;
  std::vector<const Texture*> textures{};  ///< of the document, which must outlive this
};

DocumentFacts count_facts(const Document& document);

/// Returns whether any point of the curve lies outside the box. Exact up to rounding.
bool leaves(const Curve& curve, const Box& box);

}  // namespace sfumato::cli
