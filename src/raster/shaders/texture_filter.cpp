#include "raster/shaders/texture_filter.hpp"

#include <algorithm>
#include <cmath>

#include "raster/kernels/texture_kernels.hpp"

namespace sfumato::raster {
namespace {

/// The linear part of a map as U diag(scale) Vᵀ, scale[0] the larger.
struct Stretch {
  Vec2 source[2];  ///< columns of V: directions in the image
  Vec2 target[2];  ///< columns of U: where they go in the texture
  double scale[2];
};

Stretch stretch_of(const Affine& m) {
  const double e = m.a * m.a + m.c * m.c, g = m.b * m.b + m.d * m.d, f = m.a * m.b + m.c * m.d;
  const double half = 0.5 * (e - g), root = std::sqrt(half * half + f * f);
  const double large = std::sqrt(0.5 * (e + g) + root);
  // The eigenvector of the larger eigenvalue, from the row that does not cancel.
  Vec2 major = e >= g ? Vec2{half + root, f} : Vec2{f, root - half};
  const double norm = length(major);
  major = norm > 0 ? major / norm : Vec2{1, 0};
  Vec2 source{m.a * major.x + m.b * major.y, m.c * major.x + m.d * major.y};
  source = large > 0 ? source / large : Vec2{1, 0};
  const double small = large > 0 ? std::fabs(m.determinant()) / large : 0;
  return {{source, {-source.y, source.x}}, {major, {-major.y, major.x}}, {large, small}};
}

TextureTent make_tent(const Affine& level_from_image) {
  const Stretch s = stretch_of(level_from_image);
  // A thinner tent would fall between texels.
  const double large = std::max(s.scale[0], 1.0), small = std::max(s.scale[1], 1.0);
  const auto row = [&](double v0, double v1) {
    return s.target[0] * (v0 / large) + s.target[1] * (v1 / small);
  };
  TextureTent tent;
  tent.across = row(s.source[0].x, s.source[1].x);
  tent.down = row(s.source[0].y, s.source[1].y);
  const auto inverse_of = [](double x) { return std::fabs(x) < 1e-12 ? 0 : 1 / x; };
  tent.run[0] = inverse_of(tent.across.x);
  tent.run[1] = inverse_of(tent.down.x);
  tent.area = large * small;
  tent.shorter_side = small;
  tent.reach = {tent.area * (std::fabs(tent.across.y) + std::fabs(tent.down.y)),
                tent.area * (std::fabs(tent.across.x) + std::fabs(tent.down.x))};
  return tent;
}

TextureSource make_source(const TexturePyramid& pyramid, const TextureLevel& level) {
  return {pyramid.texels(level),
          {level.width, level.period.x, pyramid.repeats()},
          {level.height, level.period.y, pyramid.repeats()},
          pyramid.opaque()};
}

Affine level_from_image(const TextureLevel& level, const Affine& texture_from_image) {
  const Vec2 k = level.level_from_texture;
  return Affine{k.x, 0, 0, k.y, 0, 0} * texture_from_image;
}

}  // namespace

void evaluate_texture(const TexturePyramid& pyramid, const Affine& layer_from_image, Vec2 first,
                      int count, const ShaderRow& row) {
  const Affine texture_from_image = pyramid.texture_from_layer() * layer_from_image;
  const TextureKernels& kernels = texture_kernels(pyramid.simd());
  const TextureLevel* level = &pyramid.levels().front();
  // More than the rounding of a map that keeps the size.
  constexpr double kKeepsSize = 1 + 1e-6;
  if (stretch_of(texture_from_image).scale[0] <= kKeepsSize) {
    kernels.magnify(make_source(pyramid, *level), {texture_from_image, first, count}, row);
    return;
  }
  const TextureLevel* last = &pyramid.levels().back();
  Affine map = texture_from_image;
  TextureTent tent = make_tent(map);
  while (level != last &&
         !(tent.area <= kLargestFootprint && tent.shorter_side <= kMostTexelsAcross)) {
    map = level_from_image(*++level, texture_from_image);
    tent = make_tent(map);
  }
  // The last level is one texel, and all of it is visible.
  if (level == last) tent = TextureTent{{1, 0}, {0, 1}, {1, 1}, {1, 0}, 1, 1};
  kernels.minify(make_source(pyramid, *level), tent, {map, first, count}, row);
}

}  // namespace sfumato::raster
