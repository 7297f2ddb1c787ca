#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// Pixels to which a drawing is fitted, and the points in them at which it is looked at: the
/// middle, or in pixels that sharp curves cross the middles of its quarters, since there a pixel's
/// colour is the mean over it.
struct SamplePixels {
  std::vector<std::uint32_t> pixel;        ///< y · width + x, in an order of neighbours
  std::vector<std::uint32_t> point_begin;  ///< per pixel, and one more: into `point`
  std::vector<Vec2> point;
  std::vector<float> stands_for;  ///< per pixel: how many pixels it stands for in a mean over all
  TableMemory memory{"the pixels to fit to"};
};

/// How pixels are chosen.
struct PixelChoice {
  double one_in = 1;  ///< of so many one is taken, by chance; at sharp curves with double chance
  std::uint64_t seed = 0;  ///< of that
  int first_row = 0;       ///< rows [first_row, end_row) of the picture
  int end_row = 0;
};

/// What sharp curves do to each pixel of a picture.
class SharpPixels {
 public:
  /// Errors: limit (memory), cancelled.
  static Result<SharpPixels> mark(Context& context, int width, int height,
                                  std::span<const TracedCurve> curves);

  /// Errors: limit (memory), cancelled.
  Result<SamplePixels> choose(Context& context, const PixelChoice& choice) const;

 private:
  enum Mark : std::uint8_t { far_away, beside, crossed };

  void mark_around(Vec2 p);
  std::uint8_t& at(int x, int y) {
    return mark_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)];
  }

  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> mark_;
  TableMemory memory_{"the pixels to fit to"};
};

}  // namespace sfumato::tracing
