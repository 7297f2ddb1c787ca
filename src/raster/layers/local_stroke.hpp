#pragma once

#include <cstddef>

#include "curves/stroke_segments.hpp"
#include "raster/kernels/local_stroke_kernels.hpp"
#include "raster/layers/local_stroke_tree.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::raster {

/// A local curve cut into segments for one image.
struct PreparedStroke {
  curves::StrokeSegments segments;  ///< empty if the stroke is not visible
  StrokeFrame frame;
  Affine image_from_frame;  ///< the frame is that of the segments
  Box bounds_px;            ///< every pixel that the stroke can touch lies inside
};

/// Contains every image that is painted as a whole.
inline constexpr Box kLargestImage{{0, 0}, {limits::kImageSide, limits::kImageSide}};

/// Does the first step of StrokePainter::create; the same parameters, errors and cost.
Result<PreparedStroke> prepare_stroke(Context& context, const LocalStroke& stroke,
                                      const Affine& image_from_artboard, InterpolationSpace space,
                                      const Box& image = kLargestImage);

/// A local curve prepared for one image (paper eq. 12–16; docs/mathematics.md, "Local curves").
class StrokePainter {
 public:
  /// Prepares a stroke.
  ///
  /// image_from_artboard  image coordinates are pixels.
  /// image                the part that may be painted; the last bit of a pixel may depend on it.
  ///
  /// Precondition: the document of `stroke` was validated. No reference to `stroke` is kept; the
  /// context's Budget must outlive the painter.
  /// Errors: limit (segments, memory), cancelled.
  /// Cost: O(length within reach of the image / influence radius).
  static Result<StrokePainter> create(Context& context, const LocalStroke& stroke,
                                      const Affine& image_from_artboard, InterpolationSpace space,
                                      const Box& image = kLargestImage);

  /// Returns a box that contains every pixel that the stroke can touch; empty if there is none.
  Box bounds_px() const { return bounds_; }

  /// Composites the stroke onto the pixels [x0, x0 + width) × [y0, y0 + height), source over.
  ///
  /// r, g, b, alpha  premultiplied sRGB code values; pixel (x0 + i, y0 + j) at i + j * stride.
  ///
  /// Errors: cancelled, by this context; the stroke is then partly painted. Thread-safe; a pixel's
  /// value does not depend on the rectangle that it is painted in.
  /// Cost: O(pixels touched · nodes in reach of each) + O(log segments) per 128 pixels.
  Status paint(const Context& context, int x0, int y0, int width, int height, float* r, float* g,
               float* b, float* alpha, std::size_t stride) const;

 private:
  StrokePainter() = default;

  Result<bool> add_block(const Context& context, int block_x, int block_y, StrokeSums& sums) const;

  curves::StrokeSegments segments_;
  StrokeTree tree_;
  Box bounds_;
  StrokeFrame frame_;
  Affine frame_from_image_;
  const StrokeKernels* kernels_ = nullptr;
};

}  // namespace sfumato::raster
