#pragma once

#include <vector>

#include "base/affine.hpp"
#include "base/context.hpp"
#include "base/status.hpp"
#include "document/shader.hpp"
#include "raster/image_shader_row.hpp"

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
/// A sample is the mean over the pixel, taken along the gradient's own direction: steps between
/// stops and the seams of a repeating gradient are smooth, and repeats finer than a pixel are grey
/// and not noise. Away from stops the mean is the value itself.
class Gradient {
 public:
  /// Errors: limit (memory).
  static Result<Gradient> create(Context& context, const GradientFill& fill);

  /// Values at first + (i, 0), 0 ≤ i < count, image coordinates in pixels.
  void evaluate(const Affine& layer_from_image, Vec2 first, int count, const ShaderRow& row) const;

 private:
  /// Where a sample lies along the gradient, and half of the pixel's width there.
  struct Offset {
    double t = 0;
    double half_width = 0;
  };

  Gradient() = default;

  void add_segments(const GradientFill& fill);
  void set_shape(const LinearGradient& shape);
  void set_shape(const RadialGradient& shape);
  Offset offset_at(const Affine& frame_from_image, Vec2 point) const;
  double folded(double t) const;
  std::size_t segment_at(double t, std::size_t hint) const;
  void integral(double t, double (&sum)[4]) const;
  void unit_integral(double t, double (&sum)[4]) const;
  void mean(double low, double high, float (&rgba)[4]) const;
  std::size_t sample(Offset offset, std::size_t hint, float (&rgba)[4]) const;

  std::vector<GradientSegment> segments_;
  double first_[4] = {};  ///< before offset 0, not premultiplied
  double last_[4] = {};
  double total_[4] = {};  ///< integral from 0 to 1, premultiplied
  SpreadMethod spread_ = SpreadMethod::pad;
  bool is_radial_ = false;
  /// Linear: the offset is the x of the frame. Radial: the focus is the origin of the frame.
  Affine frame_from_layer_;
  Vec2 center_from_focus_;  ///< radial, in radii
  ScopedCharge charge_;
};

}  // namespace sfumato::raster
