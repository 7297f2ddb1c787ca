#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::picture {

/// A layer's fields at points. Channels as in PatchLayer.
struct PointValues {
  std::vector<float> color;       ///< color.channel_count floats a point
  std::vector<float> opacity;     ///< opacity.channel_count floats a point; empty: opaque
  std::vector<std::uint8_t> hit;  ///< 0: no colour is seen, the point is transparent
};

/// The exact fields of a layer. Counts its references: a new object has one, for a PointFieldsRef.
class PointFields {
 public:
  virtual ~PointFields() = default;

  void add_reference() const { ++references_; }
  void release() const {
    if (--references_ == 0) delete this;
  }

  /// Computes the fields at points of the layer frame, not on a curve.
  ///
  /// group_end   the ends of groups of neighbours, one after another. The values of a group depend
  ///             on no other group, to the bit
  /// Errors      limit, cancelled
  virtual Status read(Context& context, std::span<const Vec2> points,
                      std::span<const std::uint32_t> group_end, PointValues* values) const = 0;

  /// Returns how far pixels that are interpolated may be from the exact fields, in units of a
  /// channel; 0: every pixel is exact.
  virtual float max_miss() const = 0;

  /// Returns the number of points that were read so far, by all threads.
  virtual std::uint64_t read_count() const = 0;

  /// Returns roughly the bytes of memory of this object.
  virtual std::size_t bytes() const = 0;

 private:
  mutable std::atomic<std::uint32_t> references_{1};
};

}  // namespace sfumato::picture
