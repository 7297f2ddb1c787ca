#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "trace/curves/traced_curve.hpp"

namespace sfumato::tracing {

/// About how many pixels colours are fitted to.
inline constexpr double kFittedPixels = 60000;

/// Holds the pixels to which a drawing is fitted, and their sample points: the middle or, in pixels
/// that sharp curves cross, four points of a rotated grid, since there a pixel's colour is the mean
/// over its area.
struct SamplePixels {
  std::vector<std::uint32_t> pixel;        ///< y · width + x, in an order of neighbours
  std::vector<std::uint32_t> point_begin;  ///< per pixel, and one more: into `point`
  std::vector<Vec2> point;
  std::vector<float> stands_for;  ///< per pixel: how many pixels it stands for in a mean over all
  TableMemory memory{"the pixels to fit to"};
};

/// Which pixels of a picture sharp curves cross.
class PixelMarks {
 public:
  /// Makes the pixels of a picture that no curve crosses. Errors: limit (memory), cancelled.
  static Result<PixelMarks> create(Context& context, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// A curve passes here; outside of the picture it counts for the nearest pixel.
  void cross(Vec2 p);

  bool is_crossed(std::size_t pixel) const { return mark_[pixel] == crossed; }
  /// Crossed, or beside a pixel that is.
  bool is_near(std::size_t pixel) const { return mark_[pixel] != far_away; }

 private:
  enum Mark : std::uint8_t { far_away, beside, crossed };

  void raise(int x, int y, Mark mark);

  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> mark_;
  TableMemory memory_{"the pixels to fit to"};
};

/// Blurred more than this, in pixels, a curve is smooth within a pixel.
inline constexpr double kSharpRadiusPx = 1.5;

/// How pixels are chosen.
struct PixelChoice {
  double one_in = 1;  ///< one pixel of this many is chosen at random; at sharp curves with twice
                      ///< the probability
  std::uint64_t seed = 0;  ///< of that
  int first_row = 0;       ///< rows [first_row, end_row) of the picture
  int end_row = 0;
};

/// Errors: limit (memory), cancelled.
Result<SamplePixels> choose_pixels(Context& context, const PixelMarks& marks,
                                   const PixelChoice& choice);

/// Marks the pixels that sharp curves of the list cross. Errors: limit (memory), cancelled.
Result<PixelMarks> mark_curves(Context& context, int width, int height,
                               std::span<const TracedCurve> curves);

}  // namespace sfumato::tracing
