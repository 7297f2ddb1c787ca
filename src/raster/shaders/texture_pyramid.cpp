#include "raster/shaders/texture_pyramid.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "raster/kernels/texture_kernels.hpp"

namespace sfumato::raster {
namespace {

/// A level below the first has at most as many texels as the texture, or this many: a period may be
/// much larger than the repeated texture.
constexpr double kSmallLevelTexels = 65536;

/// Texels of the rows that a thread gets at once.
constexpr std::size_t kTexelsPerTask = 32;

/// Parts of the texels of the level before that one texel of a level covers, along one axis.
struct Overlap {
  int first = 0;
  std::vector<float> share;  ///< of texels first, first + 1, …; adds up to 1
};

/// Returns the borders of `count` texels that cover [0, extent]: at whole numbers (level 0) or
/// evenly.
double border(int i, int count, double extent, bool even) {
  if (i == count) return extent;
  return even ? extent * i / count : i;
}

std::vector<Overlap> overlaps(int source_count, bool source_even, int count, double extent) {
  std::vector<Overlap> all(static_cast<std::size_t>(count));
  int first = 0;
  for (int i = 0; i < count; ++i) {
    const double low = border(i, count, extent, true), high = border(i + 1, count, extent, true);
    while (first + 1 < source_count &&
           border(first + 1, source_count, extent, source_even) <= low) {
      ++first;
    }
    Overlap& overlap = all[static_cast<std::size_t>(i)];
    overlap.first = first;
    for (int k = first; k < source_count; ++k) {
      const double from = std::max(low, border(k, source_count, extent, source_even));
      const double to = std::min(high, border(k + 1, source_count, extent, source_even));
      if (k > first && !(to > from)) break;
      overlap.share.push_back(static_cast<float>((to - from) / (high - low)));
    }
  }
  return all;
}

int half_of(double extent) {
  return static_cast<int>(std::max(1.0, std::ceil(extent / 2)));
}

/// Premultiplies a 16-bit channel: c a / 255 in steps of 1/65535, rounded.
std::uint16_t premultiplied(unsigned color, unsigned alpha) {
  return static_cast<std::uint16_t>((2 * 257 * color * alpha + 255) / 510);
}

}  // namespace

Result<TexturePyramid> TexturePyramid::create(Context& context, const Texture& texture) {
  TexturePyramid pyramid;
  pyramid.texture_from_layer_ = inverse(texture.layer_from_texture);
  pyramid.repeats_ = texture.repeats;
  pyramid.simd_ = context.simd;
  pyramid.lay_out(texture);
  const TextureLevel& last = pyramid.levels_.back();
  const std::size_t values = 4 * (last.offset + 1 + kTexelsReadPast);
  SFUMATO_TRY(pyramid.memory_.resize(context, pyramid.texels_, values));
  SFUMATO_TRY(pyramid.fill_base(context, texture));
  for (std::size_t i = 1; i < pyramid.levels_.size(); ++i) {
    SFUMATO_TRY(pyramid.fill_level(context, i));
  }
  return pyramid;
}

void TexturePyramid::lay_out(const Texture& texture) {
  const Vec2 size{static_cast<double>(texture.width), static_cast<double>(texture.height)};
  const bool has_period = texture.repeats && texture.period.x > 0;
  const Vec2 extent = has_period ? texture.period : size;
  TextureLevel level;
  level.width = static_cast<int>(std::min(size.x, std::ceil(extent.x)));
  level.height = static_cast<int>(std::min(size.y, std::ceil(extent.y)));
  level.level_from_texture = {1, 1};
  level.period = extent;
  levels_.push_back(level);
  const double most = std::max(size.x * size.y, kSmallLevelTexels);
  Vec2 next = extent;
  while (level.width > 1 || level.height > 1) {
    level.offset += static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
    do {
      level.width = half_of(next.x);
      level.height = half_of(next.y);
      next = {static_cast<double>(level.width), static_cast<double>(level.height)};
    } while (next.x * next.y > most);
    level.period = next;
    level.level_from_texture = {next.x / extent.x, next.y / extent.y};
    levels_.push_back(level);
  }
}

Status TexturePyramid::fill_base(Context& context, const Texture& texture) {
  const TextureLevel& level = levels_.front();
  const std::uint8_t* bytes = texture.rgba.data();
  opaque_ = true;
  for (std::size_t i = 3; i < texture.rgba.size(); i += 4) opaque_ &= bytes[i] == 255;
  if (context.cancelled()) return context.cancel_status();
  const std::size_t width = static_cast<std::size_t>(level.width);
  return parallel_for(context, static_cast<std::size_t>(level.height), kTexelsPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t y = begin; y < end; ++y) {
                          const std::uint8_t* in = bytes + 4 * y * texture.width;
                          std::uint16_t* out = texels_.data() + 4 * y * width;
                          for (std::size_t x = 0; x < 4 * width; x += 4) {
                            const unsigned alpha = in[x + 3];
                            for (std::size_t c = 0; c < 3; ++c) {
                              out[x + c] = premultiplied(in[x + c], alpha);
                            }
                            out[x + 3] = static_cast<std::uint16_t>(257 * alpha);
                          }
                        }
                      });
}

Status TexturePyramid::fill_level(Context& context, std::size_t index) {
  const TextureLevel& source = levels_[index - 1];
  const TextureLevel& level = levels_[index];
  const bool even = index > 1;
  const Vec2 extent = levels_.front().period;
  const std::vector<Overlap> columns = overlaps(source.width, even, level.width, extent.x);
  const std::vector<Overlap> rows = overlaps(source.height, even, level.height, extent.y);
  const auto mean = [&](const Overlap& row, const Overlap& column, std::uint16_t* out) {
    float sum[4] = {0.5f, 0.5f, 0.5f, 0.5f};
    for (std::size_t j = 0; j < row.share.size(); ++j) {
      const std::size_t y = static_cast<std::size_t>(row.first) + j;
      const std::uint16_t* in = texels(source) + 4 * (y * static_cast<std::size_t>(source.width) +
                                                      static_cast<std::size_t>(column.first));
      for (float share : column.share) {
        for (int c = 0; c < 4; ++c) sum[c] += row.share[j] * share * static_cast<float>(in[c]);
        in += 4;
      }
    }
    for (int c = 0; c < 4; ++c) out[c] = static_cast<std::uint16_t>(std::min(sum[c], 65535.5f));
  };
  return parallel_for(
      context, rows.size(), kTexelsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          std::uint16_t* out = texels_.data() + 4 * (level.offset + y * columns.size());
          for (const Overlap& column : columns) {
            mean(rows[y], column, out);
            out += 4;
          }
        }
      });
}

}  // namespace sfumato::raster
