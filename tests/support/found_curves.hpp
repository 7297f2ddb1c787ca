#pragma once

#include "sfumato/document/document.hpp"
#include "support/planes.hpp"

namespace sfumato::test {

/// How well the curves of a drawing match another's; lengths in pixels of a picture.
struct FoundCurves {
  double true_length_px = 0;    ///< of the true curves within the picture
  double visible_share = 0;     ///< share of that length where the picture shows an edge
  double found_share = 0;       ///< share of the visible length near a curve of the trace
  double true_share = 0;        ///< share of the trace's length near a true curve
  double mean_distance_px = 0;  ///< mean distance of the found visible length from the trace
};

/// Compares the curves of all painted layers of `trace` with those of `truth`, both laid over the
/// picture by their artboards. `picture` shows `truth`: its curves count as visible where colours
/// change by more than 0.02 a pixel (Gaussian of 1 pixel). Near means within `near_px`. Parts less
/// than a pixel from the picture's border, such as the frame of a trace, do not count.
FoundCurves find_curves(const Document& truth, const Document& trace, const Planes& picture,
                        double near_px = 2);

}  // namespace sfumato::test
