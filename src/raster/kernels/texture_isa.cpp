#include "base/lanes.hpp"
#include "raster/kernels/texture_kernels.hpp"

/// Filters over texels, four texels (sixteen numbers) at a time. Compiled for every instruction
/// set.
namespace sfumato::raster::inline SFUMATO_ISA {

/// Four texels side by side, W lanes to a register.
template <int W>
using FourTexels = Lanes<W, 16 / W>;
/// Red, green, blue and alpha.
using OneTexel = Lanes<4>;

/// The longest row of texels under a tent whose area and height are within the bounds.
inline constexpr int kLongestRow = 2 * static_cast<int>(kLargestFootprint) + 4;

template <int W>
SFUMATO_INLINE FourTexels<W> load_texels(const std::uint16_t* texels) {
  FourTexels<W> result;
  for (int i = 0; i < 16 / W; ++i) {
    typedef std::uint16_t Words __attribute__((vector_size(2 * W)));
    Words words;
    __builtin_memcpy(&words, texels + W * i, sizeof(words));
    result.part[i] = lane::to_float<W>(__builtin_convertvector(words, lane::Int<W>));
  }
  return result;
}

/// Splits texels: 0 to 3 apart.
template <int W>
SFUMATO_INLINE void split(const FourTexels<W>& all, OneTexel (&one)[4]) {
  float value[16];
  all.store(value);
  for (int i = 0; i < 4; ++i) one[i] = OneTexel::load(value + 4 * i);
}

/// Converts premultiplied 16-bit steps, four to a point, to code values and alpha, not
/// premultiplied.
SFUMATO_INLINE void write_texels(const float* colors, bool opaque, int begin, int count,
                                 const ShaderRow& out) {
  constexpr float kCodeValue = 1.0f / 65535;
  for (int i = 0; i < count; ++i) {
    const float* color = colors + 4 * i;
    const float scale = opaque ? kCodeValue : color[3] > 0 ? 1 / color[3] : 0;
    const float r = color[0] * scale, g = color[1] * scale, b = color[2] * scale;
    out.r[begin + i] = r < 1 ? r : 1;
    out.g[begin + i] = g < 1 ? g : 1;
    out.b[begin + i] = b < 1 ? b : 1;
    out.alpha[begin + i] = opaque ? 1 : color[3] * kCodeValue;
  }
}

/// Returns texels [column, column + 4) of any row of the endless texture; copied if they are not
/// contiguous.
SFUMATO_INLINE const std::uint16_t* four_texels(const TextureSource& source, int row, int column,
                                                std::uint16_t* copy) {
  for (int n = 0; n < 4; ++n) {
    __builtin_memcpy(copy + 4 * n, source.at(row, source.x.texel(column + n)), 8);
  }
  return copy;
}

/// The number of points processed together.
inline constexpr int kPoints = 16;

/// Keys' weights (a = -1/2) of the texels at -1, 0, 1, 2 for points past texel 0 by `past`.
struct CubicWeights {
  alignas(64) float past[kPoints];
  alignas(64) float weight[4][kPoints];

  template <int W>
  SFUMATO_INLINE void compute() {
    using F = Lanes<W>;
    for (int i = 0; i < kPoints; i += W) {
      const F f = F::load(past + i), square = f * f;
      (f * (F(-0.5f) + f * (F(1) - F(0.5f) * f))).store(weight[0] + i);
      (F(1) + square * (F(-2.5f) + F(1.5f) * f)).store(weight[1] + i);
      (f * (F(0.5f) + f * (F(2) - F(1.5f) * f))).store(weight[2] + i);
      (square * (F(-0.5f) + F(0.5f) * f)).store(weight[3] + i);
    }
  }
};

SFUMATO_INLINE double reduced(const TextureAxis& axis, double x) {
  return x >= 0 && x < axis.period ? x : axis.reduced(x);
}

/// Returns floor(x) for x above -4 count - 8 and within 32 bits.
SFUMATO_INLINE int floor_above(double x, int count) {
  const int shift = 4 * count + 8;
  return static_cast<int>(x + shift) - shift;
}

/// Positions of points: the texel before each, and the distance past its centre.
struct CubicPoints {
  int column[kPoints], row[kPoints];
  CubicWeights across, down;

  template <int W>
  SFUMATO_INLINE void place(const TextureSource& source, const TextureRow& points, int begin,
                            int count) {
    for (int i = 0; i < kPoints; ++i) {
      const int k = begin + (i < count ? i : 0);
      const Vec2 p = points.map({points.first.x + k, points.first.y});
      const double x = reduced(source.x, p.x) - 0.5, y = reduced(source.y, p.y) - 0.5;
      column[i] = floor_above(x, source.x.count);
      row[i] = floor_above(y, source.y.count);
      across.past[i] = static_cast<float>(x - column[i]);
      down.past[i] = static_cast<float>(y - row[i]);
    }
    across.compute<W>();
    down.compute<W>();
  }
};

template <int W>
SFUMATO_INLINE OneTexel cubic(const TextureSource& source, const CubicPoints& points, int n) {
  using F = FourTexels<W>;
  const int i = points.column[n], j = points.row[n];
  F row[4];
  if (i >= 1 && i + 2 < source.x.count && j >= 1 && j + 2 < source.y.count) {
    const std::uint16_t* texels = source.at(j - 1, i - 1);
    const std::ptrdiff_t row_size = 4 * static_cast<std::ptrdiff_t>(source.x.count);
    for (int k = 0; k < 4; ++k) row[k] = load_texels<W>(texels + k * row_size);
  } else {
    std::uint16_t copy[16];
    for (int k = 0; k < 4; ++k) {
      row[k] = load_texels<W>(four_texels(source, source.y.texel(j - 1 + k), i - 1, copy));
    }
  }
  const auto& down = points.down.weight;
  const auto& across = points.across.weight;
  OneTexel column[4], low[4], high[4];
  split<W>((F(down[0][n]) * row[0] + F(down[1][n]) * row[1]) +
               (F(down[2][n]) * row[2] + F(down[3][n]) * row[3]),
           column);
  split<W>(min(row[1], row[2]), low);
  split<W>(max(row[1], row[2]), high);
  const OneTexel sum = (OneTexel(across[0][n]) * column[0] + OneTexel(across[1][n]) * column[1]) +
                       (OneTexel(across[2][n]) * column[2] + OneTexel(across[3][n]) * column[3]);
  return min(max(sum, min(low[1], low[2])), max(high[1], high[2]));
}

template <int W>
void magnify_texture(const TextureSource& source, const TextureRow& points, const ShaderRow& out) {
  CubicPoints placed;
  for (int begin = 0; begin < points.count; begin += kPoints) {
    const int count = points.count - begin < kPoints ? points.count - begin : kPoints;
    placed.place<W>(source, points, begin, count);
    float colors[4 * kPoints];
    for (int n = 0; n < count; ++n) cubic<W>(source, placed, n).store(colors + 4 * n);
    write_texels(colors, source.opaque, begin, count, out);
  }
}

/// Finds the places i of [begin, end) with |low + i / run| < 1; run is 0 where all places are the
/// same.
SFUMATO_INLINE void narrow(double low, double run, int& begin, int& end) {
  if (run == 0) return;
  const double a = (-1 - low) * run, b = (1 - low) * run;
  const double from = a < b ? a : b, to = a < b ? b : a;
  if (from > begin) begin = from < end ? static_cast<int>(from) : end;
  if (to < end - 1) end = to > begin ? static_cast<int>(to) + 1 : begin;
}

/// Returns texels [column, column + count) of any row of the endless texture; kTexelsReadPast more
/// may be read.
SFUMATO_INLINE const std::uint16_t* row_of_texels(const TextureSource& source, int row, int column,
                                                  int count, std::uint16_t* copy) {
  if (column >= 0 && column + count <= source.x.count) return source.at(row, column);
  for (int i = 0; i < count; ++i) {
    __builtin_memcpy(copy + 4 * i, source.at(row, source.x.texel(column + i)), 8);
  }
  __builtin_memset(copy + 4 * static_cast<std::ptrdiff_t>(count), 0, 8 * kTexelsReadPast);
  return copy;
}

/// Sums over the texels of one tent; each lane of `weight` is the weight of that lane's texel.
template <int W>
struct TentSum {
  using F = FourTexels<W>;
  F color = F(0);
  F weight = F(0);

  /// Adds texels 0 to count - 1; at texel i the tent's coordinates are (u + i du, v + i dv).
  SFUMATO_INLINE void add_row(const std::uint16_t* texels, int count, float u, float du, float v,
                              float dv) {
    float steps[16];
    for (int i = 0; i < 16; ++i) steps[i] = static_cast<float>(i / 4);
    for (int i = 0; i < count; i += 4) {
      const F place = F::load(steps) + F(static_cast<float>(i));
      const F x = F(1) - abs(F(u) + F(du) * place), y = F(1) - abs(F(v) + F(dv) * place);
      const F w = max(x, F(0)) * max(y, F(0));
      color = color + w * load_texels<W>(texels + 4 * i);
      weight = weight + w;
    }
  }

  SFUMATO_INLINE OneTexel mean() const {
    OneTexel colors[4], weights[4];
    split<W>(color, colors);
    split<W>(weight, weights);
    const OneTexel total = (weights[0] + weights[1]) + (weights[2] + weights[3]);
    return ((colors[0] + colors[1]) + (colors[2] + colors[3])) / max(total, OneTexel(1e-20f));
  }
};

template <int W>
SFUMATO_INLINE OneTexel tent_mean(const TextureSource& source, const TextureTent& tent, Vec2 p,
                                  std::uint16_t* copy) {
  const double x = reduced(source.x, p.x) - 0.5, y = reduced(source.y, p.y) - 0.5;
  TentSum<W> sum;
  const int left = floor_above(x - tent.reach.x, source.x.count + kLongestRow);
  const int right = floor_above(x + tent.reach.x, source.x.count + kLongestRow) + 2;
  const int first = floor_above(y - tent.reach.y, source.y.count + kLongestRow);
  for (int j = first; j < y + tent.reach.y; ++j) {
    const double dx = left - x, dy = j - y;
    const double u = tent.across.x * dx + tent.across.y * dy;
    const double v = tent.down.x * dx + tent.down.y * dy;
    int begin = 0, end = right - left;
    narrow(u, tent.run[0], begin, end);
    narrow(v, tent.run[1], begin, end);
    if (begin >= end) continue;
    const std::uint16_t* texels =
        row_of_texels(source, source.y.texel(j), left + begin, end - begin, copy);
    sum.add_row(texels, end - begin, static_cast<float>(u + tent.across.x * begin),
                static_cast<float>(tent.across.x), static_cast<float>(v + tent.down.x * begin),
                static_cast<float>(tent.down.x));
  }
  return sum.mean();
}

template <int W>
void minify_texture(const TextureSource& source, const TextureTent& tent, const TextureRow& points,
                    const ShaderRow& out) {
  std::uint16_t copy[4 * (kLongestRow + kTexelsReadPast)];
  for (int i = 0; i < points.count; ++i) {
    const Vec2 p = points.map({points.first.x + i, points.first.y});
    float color[4];
    tent_mean<W>(source, tent, p, copy).store(color);
    write_texels(color, source.opaque, i, 1, out);
  }
}

}  // namespace sfumato::raster::inline SFUMATO_ISA

namespace sfumato::raster {

const TextureKernels& texture_kernels(LaneCount<SFUMATO_ISA_LANES>) {
  static constexpr TextureKernels kKernels{magnify_texture<SFUMATO_ISA_LANES>,
                                           minify_texture<SFUMATO_ISA_LANES>};
  return kKernels;
}

}  // namespace sfumato::raster
