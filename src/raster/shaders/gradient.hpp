#pragma once

#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "raster/kernels/image_shader_row.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::raster {

/// The colours of a gradient between offsets `begin` and `end`, linear in the offset.
struct GradientSegment {
  double begin = 0;
  double end = 1;
  double value[4] = {};   ///< at `begin`: r, g, b in code values and alpha, not premultiplied
  double slope[4] = {};   ///< per unit of offset
  double before[4] = {};  ///< integral from 0 to `begin` of the premultiplied colour and of alpha
};

/// A gradient of SVG as a function of the plane: sRGB code values, not premultiplied.
///
/// A sample is the mean over the pixel along the gradient's own direction. Hence steps between
/// stops and the seams of a repeating gradient are smooth, and repeats finer than a pixel give
/// their mean colour, not noise. Away from stops the mean is the value itself.
class Gradient {
 public:
  /// Makes a gradient. Errors: limit (memory).
  static Result<Gradient> create(Context& context, const GradientFill& fill);

  /// Computes values at first + (i, 0), 0 ≤ i < count, image coordinates in pixels.
  void evaluate(const Affine& layer_from_image, Vec2 first, int count, const ShaderRow& row) const;

  const std::vector<GradientSegment>& segments() const { return segments_; }
  std::span<const double, 4> first() const { return first_; }  ///< before 0, not premultiplied
  std::span<const double, 4> last() const { return last_; }    ///< after 1
  std::span<const double, 4> total() const { return total_; }  ///< integral, premultiplied
  SpreadMethod spread() const { return spread_; }
  bool is_radial() const { return is_radial_; }
  /// Returns the frame. Linear: the offset is its x coordinate. Radial: its origin is the focus,
  /// its unit the radius.
  const Affine& frame_from_layer() const { return frame_from_layer_; }
  Vec2 center_from_focus() const { return center_from_focus_; }  ///< radial, in radii
  double focal_radius() const { return focal_radius_; }          ///< radial, in radii
  /// Returns whether the focus is a circle, or outside of the circle: the gradient may leave parts
  /// of the plane without colour.
  bool is_cone() const { return is_cone_; }

 private:
  /// The position of a sample along the gradient, and half of the pixel's width there.
  struct Offset {
    double t = 0;
    double half_width = 0;
    double coverage = 1;  ///< share of the pixel that the gradient covers, 0 to 1
  };

  Gradient() = default;

  void add_segments(const GradientFill& fill);
  void set_shape(const LinearGradient& shape);
  void set_shape(const RadialGradient& shape);
  Offset offset_at(const Affine& frame_from_image, Vec2 point) const;
  Offset cone_offset(const Affine& frame_from_image, Vec2 point) const;
  double folded(double t) const;
  std::size_t segment_at(double t, std::size_t hint) const;
  void integral(double t, double (&sum)[4]) const;
  void unit_integral(double t, double (&sum)[4]) const;
  void mean(double low, double high, float (&rgba)[4]) const;
  std::size_t sample(Offset offset, std::size_t hint, float (&rgba)[4]) const;

  std::vector<GradientSegment> segments_;
  double first_[4] = {};
  double last_[4] = {};
  double total_[4] = {};
  SpreadMethod spread_ = SpreadMethod::pad;
  bool is_radial_ = false;
  Affine frame_from_layer_;
  Vec2 center_from_focus_;
  double focal_radius_ = 0;
  bool is_cone_ = false;
  TableMemory memory_{"a gradient"};
};

}  // namespace sfumato::raster
