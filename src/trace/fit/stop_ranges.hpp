#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// Finds the squares of a picture where a layer shows with nothing mixed into its colours.
class SolidBlocks {
 public:
  /// Errors: limit (memory), cancelled.
  static Result<SolidBlocks> create(Context& context, int width, int height);

  void clear() { std::ranges::fill(state_, unknown); }
  /// Adds a pixel of the picture that shows the layer alone, or does not.
  void add(std::uint32_t pixel, bool is_solid);
  /// Returns whether there were pixels in the pixel's square, all of them solid.
  bool is_solid(int x, int y) const { return state_[index(x, y)] == solid; }

 private:
  enum State : std::uint8_t { unknown, solid, mixed };
  static constexpr int kSide = 4;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y / kSide) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x / kSide);
  }

  int width_ = 0, columns_ = 0;
  std::vector<State> state_;
  TableMemory memory_{"the colours of a fit"};
};

/// Between which values the colours of a layer's stops are kept.
///
/// pixel_from_layer  of its instances
/// color             the picture, in the drawing's interpolation space
/// weight            per stop of the layer: the number of pixels that it colours
/// low, high         per stop of the layer: narrowed to the range of the picture near the stop, a
///                   little widened, at pixels that show the layer. A stop of which few pixels tell
///                   would else take any value, which shows as a spot
/// Errors            limit (memory), cancelled
Status find_stop_ranges(Context& context, const std::vector<Curve>& curves,
                        std::span<const Affine> pixel_from_layer, const Channels& color,
                        const SolidBlocks& blocks, std::span<const float> weight,
                        std::span<FourFloats> low, std::span<FourFloats> high);

}  // namespace sfumato::tracing
