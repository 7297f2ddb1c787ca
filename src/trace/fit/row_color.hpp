#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gather/rows/rows.hpp"
#include "raster/shaders/image_shader.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/color.hpp"
#include "trace/fit/sparse.hpp"

namespace sfumato::tracing {

/// The image-domain shaders that sides name, as indices of Document::shaders.
using ImageShaders = std::vector<std::optional<raster::ImageShader>>;

/// Evaluates image-domain shaders at a point of a layer.
struct ShadersAt {
  const ImageShaders& shaders;
  std::span<const std::uint32_t> named;  ///< SegmentAttributes::shader
  const Affine& layer_from_pixel;
  Vec2 pixel_point;

  raster::ImageShader::Sample sample(std::size_t slot) const {
    return shaders[named[slot]]->at(layer_from_pixel, pixel_point);
  }
};

/// Returns the colour that a row gives, in the space of the stops' values.
/// values     per column
/// radius_of  (source, term): the radius of blur
template <class RadiusOf>
Rgb row_color(const gather::Rows& rows, std::size_t row, std::span<const FourFloats> values,
              RadiusOf&& radius_of, const ShadersAt& shaders) {
  double sum[3] = {};
  const auto add = [&](double weight, float r, float g, float b) {
    sum[0] += weight * r;
    sum[1] += weight * g;
    sum[2] += weight * b;
  };
  for (std::uint32_t k = rows.begin[row]; k < rows.begin[row + 1]; ++k) {
    const gather::RowTerm& term = rows.term[k];
    const gather::RowSource& source = rows.source[term.source];
    const double radius = radius_of(source, term);
    gather::for_each_entry(source, term, radius, [&](std::uint32_t column, double weight) {
      add(weight, values[column][0], values[column][1], values[column][2]);
    });
    if (shaders.named.empty()) continue;
    gather::for_each_side(source, term, radius, [&](const gather::RowSide& side, double weight) {
      if (side.shader < 0) return;
      const Rgb color = shaders.sample(static_cast<std::size_t>(side.shader)).color;
      add(weight, color.r, color.g, color.b);
    });
  }
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

inline Rgb clamped_color(const Rgb& code) {
  const auto clamped = [](float value) { return value < 0 ? 0.0f : value > 1 ? 1.0f : value; };
  return {clamped(code.r), clamped(code.g), clamped(code.b)};
}

}  // namespace sfumato::tracing
