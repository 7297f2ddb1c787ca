#pragma once

#include "sfumato/document/document.hpp"
#include "support/planes.hpp"

namespace sfumato::test {

/// How well the curves of a drawing lie on those of another, lengths in pixels of a picture.
struct FoundCurves {
  double true_length_px = 0;    ///< of the true curves within the picture
  double visible_share = 0;     ///< of that length: where the picture shows an edge
  double found_share = 0;       ///< of the visible length: near a curve of the trace
  double true_share = 0;        ///< of the length of the trace: near a true curve
  double mean_distance_px = 0;  ///< of the visible length that was found, from the trace
};

/// Compares the curves of all painted layers of `trace` with those of `truth`, both laid over the
/// picture by their artboards. `picture` is what `truth` looks like: its curves count as visible
/// where colours change by more than 0.02 a pixel (Gaussian of 1 pixel). Near is within `near_px`;
/// what lies less than a pixel from the picture's border, as the frame of a trace, does not count.
FoundCurves find_curves(const Document& truth, const Document& trace, const Planes& picture,
                        double near_px = 2);

}  // namespace sfumato::test
