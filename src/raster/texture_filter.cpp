#include "raster/texture_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sfumato::raster {
namespace {

typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Int4 __attribute__((vector_size(16)));

constexpr float kCodeValue = 1.0f / 65535;

/// Largest area of a pixel, in texels of the level that is read; a quarter of the texels summed.
constexpr double kLargestFootprint = 16;

/// A texture's coordinate beyond this is as good as it; not a number becomes its negative.
constexpr double kLargestCoordinate = 1e12;

Float4 load(const std::uint16_t* texel) {
  const Int4 value = {texel[0], texel[1], texel[2], texel[3]};
  return __builtin_convertvector(value, Float4);
}

Float4 smaller(Float4 a, Float4 b) {
  return a < b ? a : b;
}

Float4 larger(Float4 a, Float4 b) {
  return a > b ? a : b;
}

/// x brought to [0, period), or near to the texture where it does not repeat.
double reduced(double x, double period, bool repeats) {
  x = x > -kLargestCoordinate ? (x < kLargestCoordinate ? x : kLargestCoordinate)
                              : -kLargestCoordinate;
  if (!repeats) return std::clamp(x, -period - 2, 2 * period + 2);
  if (x >= 0 && x < period) return x;
  x -= period * std::floor(x / period);
  return x >= 0 && x < period ? x : 0;
}

/// One axis of a level: which texel stands at place i of the endless row of texels.
struct Axis {
  int count;
  double period;
  bool repeats;

  int texel(int i) const {
    if (i >= 0 && i < count) return i;
    if (!repeats) return i < 0 ? 0 : count - 1;
    return std::min(static_cast<int>(reduced(i + 0.5, period, true)), count - 1);
  }
};

struct Source {
  const std::uint16_t* texels;
  Axis x, y;
  bool opaque;

  const std::uint16_t* at(int row, int column) const {
    return texels + 4 * (static_cast<std::ptrdiff_t>(row) * x.count + column);
  }
};

Source make_source(const TexturePyramid& pyramid, const TextureLevel& level) {
  return {pyramid.texels(level),
          {level.width, level.period.x, pyramid.repeats()},
          {level.height, level.period.y, pyramid.repeats()},
          pyramid.opaque()};
}

/// Premultiplied 16-bit steps → code values and alpha, not premultiplied.
void write(Float4 color, bool opaque, int i, const ShaderRow& row) {
  const float alpha = opaque ? 1.0f : std::clamp(color[3] * kCodeValue, 0.0f, 1.0f);
  const float scale = opaque ? kCodeValue : color[3] > 0 ? 1 / color[3] : 0;
  float rgba[4];
  for (int c = 0; c < 3; ++c) rgba[c] = std::clamp(color[c] * scale, 0.0f, 1.0f);
  rgba[3] = alpha;
  row.set(i, rgba);
}

/// Keys' weights of the texels at -1, 0, 1, 2 for a sample at f from texel 0; they add up to 1.
struct CubicWeights {
  float weight[4];

  explicit CubicWeights(float f) {
    weight[0] = f * (-0.5f + f * (1.0f - 0.5f * f));
    weight[1] = 1.0f + f * f * (-2.5f + 1.5f * f);
    weight[2] = f * (0.5f + f * (2.0f - 1.5f * f));
    weight[3] = f * f * (-0.5f + 0.5f * f);
  }
};

/// Cubic convolution, kept within the range of the four texels around the sample.
Float4 cubic(const Source& source, Vec2 p) {
  const double x = reduced(p.x, source.x.period, source.x.repeats) - 0.5;
  const double y = reduced(p.y, source.y.period, source.y.repeats) - 0.5;
  const int i = static_cast<int>(x + 4.0 * source.x.count + 8) - 4 * source.x.count - 8;
  const int j = static_cast<int>(y + 4.0 * source.y.count + 8) - 4 * source.y.count - 8;
  const CubicWeights across(static_cast<float>(x - i)), down(static_cast<float>(y - j));
  const bool inside = i >= 1 && i + 2 < source.x.count && j >= 1 && j + 2 < source.y.count;
  Float4 sum{}, low{}, high{};
  for (int k = 0; k < 4; ++k) {
    Float4 texel[4];
    if (inside) {
      const std::uint16_t* in = source.at(j - 1 + k, i - 1);
      for (int n = 0; n < 4; ++n) texel[n] = load(in + 4 * n);
    } else {
      const int row = source.y.texel(j - 1 + k);
      for (int n = 0; n < 4; ++n) texel[n] = load(source.at(row, source.x.texel(i - 1 + n)));
    }
    sum += down.weight[k] * (across.weight[0] * texel[0] + across.weight[1] * texel[1] +
                             across.weight[2] * texel[2] + across.weight[3] * texel[3]);
    if (k == 1) {
      low = smaller(texel[1], texel[2]);
      high = larger(texel[1], texel[2]);
    } else if (k == 2) {
      low = smaller(low, smaller(texel[1], texel[2]));
      high = larger(high, larger(texel[1], texel[2]));
    }
  }
  return smaller(larger(sum, low), high);
}

/// The derivative of a map as U diag(scale) Vᵀ, scale[0] the larger.
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

/// A tent of two pixels' width about a sample, seen from a level: |across · d| < 1 and
/// |down · d| < 1, weight (1 - |across · d|) (1 - |down · d|), at distance d in texels.
struct Tent {
  Vec2 across, down;
  Vec2 reach;  ///< half of its bounds, texels
  double area;

  explicit Tent(const Affine& level_from_image) {
    const Stretch s = stretch_of(level_from_image);
    // Thinner than a texel it would fall between them.
    const double large = std::max(s.scale[0], 1.0), small = std::max(s.scale[1], 1.0);
    const auto row = [&](double v0, double v1) {
      return s.target[0] * (v0 / large) + s.target[1] * (v1 / small);
    };
    across = row(s.source[0].x, s.source[1].x);
    down = row(s.source[0].y, s.source[1].y);
    area = large * small;
    reach = {area * (std::fabs(across.y) + std::fabs(down.y)),
             area * (std::fabs(across.x) + std::fabs(down.x))};
  }
};

/// The places i with |low + step i| < 1, cut from [begin, end).
void narrow(double low, double step, int& begin, int& end) {
  if (std::fabs(step) < 1e-12) return;
  const double a = (-1 - low) / step, b = (1 - low) / step;
  const double from = std::min(a, b), to = std::max(a, b);
  if (from > begin) begin = from < end ? static_cast<int>(from) : end;
  if (to < end - 1) end = to > begin ? static_cast<int>(to) + 1 : begin;
}

/// Precondition: the tent's area is at most kLargestFootprint.
Float4 tent_mean(const Source& source, const Tent& tent, Vec2 p) {
  const double x = reduced(p.x, source.x.period, source.x.repeats);
  const double y = reduced(p.y, source.y.period, source.y.repeats);
  const int top = static_cast<int>(std::floor(y - 0.5 - tent.reach.y));
  const int bottom = static_cast<int>(std::ceil(y - 0.5 + tent.reach.y));
  const int left = static_cast<int>(std::floor(x - 0.5 - tent.reach.x));
  const int right = static_cast<int>(std::ceil(x - 0.5 + tent.reach.x)) + 1;
  Float4 sum{};
  float total = 0;
  for (int j = top; j <= bottom; ++j) {
    const double dy = j + 0.5 - y, dx = left + 0.5 - x;
    const double u0 = tent.across.x * dx + tent.across.y * dy;
    const double v0 = tent.down.x * dx + tent.down.y * dy;
    int begin = 0, end = right - left;
    narrow(u0, tent.across.x, begin, end);
    narrow(v0, tent.down.x, begin, end);
    if (begin >= end) continue;
    const int row = source.y.texel(j);
    for (int i = begin; i < end; ++i) {
      const float u = static_cast<float>(std::fabs(u0 + tent.across.x * i));
      const float v = static_cast<float>(std::fabs(v0 + tent.down.x * i));
      const float weight = std::max(1 - u, 0.0f) * std::max(1 - v, 0.0f);
      sum += weight * load(source.at(row, source.x.texel(left + i)));
      total += weight;
    }
  }
  return total > 0 ? sum / total : Float4{};
}

Affine level_from_image(const TextureLevel& level, const Affine& texture_from_image) {
  const Vec2 k = level.level_from_texture;
  return Affine{k.x, 0, 0, k.y, 0, 0} * texture_from_image;
}

void evaluate_cubic(const Source& source, const Affine& level_from_image, Vec2 first, int count,
                    const ShaderRow& row) {
  for (int i = 0; i < count; ++i) {
    const Vec2 p = level_from_image({first.x + i, first.y});
    write(cubic(source, p), source.opaque, i, row);
  }
}

}  // namespace

void evaluate_texture(const TexturePyramid& pyramid, const Affine& layer_from_image, Vec2 first,
                      int count, const ShaderRow& row) {
  const Affine texture_from_image = pyramid.texture_from_layer() * layer_from_image;
  const TextureLevel* level = &pyramid.levels().front();
  constexpr double kNoScale = 1 + 1e-6;
  if (!(stretch_of(texture_from_image).scale[0] > kNoScale)) {
    evaluate_cubic(make_source(pyramid, *level), texture_from_image, first, count, row);
    return;
  }
  const TextureLevel* last = &pyramid.levels().back();
  Affine map = level_from_image(*level, texture_from_image);
  Tent tent(map);
  while (level != last && !(tent.area <= kLargestFootprint)) {
    map = level_from_image(*++level, texture_from_image);
    tent = Tent(map);
  }
  const Source source = make_source(pyramid, *level);
  for (int i = 0; i < count; ++i) {
    // The last level is one texel.
    const Float4 color =
        level == last ? load(source.texels) : tent_mean(source, tent, map({first.x + i, first.y}));
    write(color, source.opaque, i, row);
  }
}

}  // namespace sfumato::raster
