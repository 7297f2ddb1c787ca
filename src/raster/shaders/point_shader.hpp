#pragma once

#include <cstdint>
#include <vector>

#include "raster/kernels/color_space_kernel.hpp"
#include "raster/kernels/patch_polynomial.hpp"
#include "raster/shaders/shader_set.hpp"

namespace sfumato::raster {

/// The input for the shading of an instance's layer besides its patches.
struct ShadingInput {
  InterpolationSpace space = InterpolationSpace::srgb;
  const ShaderSet* shaders = nullptr;
  Affine layer_from_image;
};

/// Returns whether any of the four weights from channel `first_channel` on is not 0 at some node.
bool has_weight(const FieldView& field, int first_channel, std::uint32_t triangle);

/// Computes a layer's colour and opacity at single points: Z_C + sum of W_s z_s(p) (paper eq. 6) as
/// premultiplied code values and alpha, all in [0, 1].
class PointShader {
 public:
  /// Makes a shader. Both arguments must outlive it.
  PointShader(const LayerView& layer, const ShadingInput& input) : layer_(layer), input_(input) {}

  const LayerView& layer() const { return layer_; }

  void begin_triangle(std::uint32_t triangle, const TriangleFrame& frame);

  /// Returns whether a triangle's value at its centroid is that of its centre node.
  bool has_centers() const {
    return layer_.order == PatchOrder::cubic && layer_.color.shader_count == 0 &&
           layer_.opacity.shader_count == 0;
  }
  /// Returns the value at the centroid of a triangle; no call of `begin` is necessary.
  /// Precondition: has_centers().
  Color4 at_center(std::uint32_t triangle) const;

  /// Returns the value at a point of the triangle that represents a part of a pixel. Image-domain
  /// shaders are evaluated for the pixel at pixel_center, in pixels of the image.
  Color4 at(const PatchPoint& point, Vec2 pixel_center) const {
    return shown(value(point, pixel_center));
  }

  /// Returns the colour in the interpolation space and the opacity, for mixing by a blur.
  Color4 value(const PatchPoint& point, Vec2 pixel_center) const {
    Color4 patch = patch_color(patch_, point);
    if (layer_.opacity.channel_count == 0) patch.part[0][3] = 1;
    return weights_.empty() ? patch : with_shaders(patch, point, pixel_center);
  }
  /// Returns the same for exact values of the layer's fields; opacity: null for an opaque layer.
  Color4 exact_value(const float* color, const float* opacity, Vec2 pixel_center) const;
  Color4 shown(const Color4& value) const {
    return input_.space == InterpolationSpace::srgb ? premultiplied(clamped_unit(value))
                                                    : shown_from(value);
  }

 private:
  /// Four weights over the triangle.
  struct WeightPatch {
    PatchPolynomial patch;
    const FieldView* field;
    int first_channel;
  };

  static Color4 premultiplied(Color4 color) {
    const Color4 alpha(color.part[0][3]);
    color.part[0][3] = 1;
    return alpha * color;
  }
  /// Converts a colour in a space other than sRGB.
  Color4 shown_from(const Color4& value) const;
  Color4 with_shaders(const Color4& patch, const PatchPoint& point, Vec2 pixel_center) const;
  void add_weights(const FieldView& field, std::uint32_t triangle, const TriangleFrame& frame);
  void add_shaders(const FieldView& field, const float* value, Vec2 pixel_center,
                   float (&sum)[4]) const;
  void add_shader(const FieldView& field, int channel, float weight, Vec2 pixel_center,
                  float (&value)[4]) const;

  const LayerView& layer_;
  const ShadingInput& input_;
  PatchPolynomial patch_;
  std::vector<WeightPatch> weights_;
};

}  // namespace sfumato::raster
