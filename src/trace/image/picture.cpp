#include "trace/image/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::tracing {
namespace {

constexpr std::size_t kPictureRows = 16;

/// The least share of pixels in a drawn picture that are even to within the rounding to 16 bits.
/// More than half of a photo may be white.
constexpr double kDrawnShare = 0.75;
constexpr double kDrawnRoughness = 1e-4;

/// Alpha below which a pixel's colour has no meaning.
constexpr float kTransparent = 1.0f / 512;

/// A pixel of an image: code values times alpha, and alpha.
struct Premultiplied {
  double channel[4] = {};

  void add(const Premultiplied& other, double weight) {
    for (int c = 0; c < 4; ++c) channel[c] += weight * other.channel[c];
  }
};

class PixelReader {
 public:
  explicit PixelReader(const Image& image)
      : image_(image),
        channels_(static_cast<std::size_t>(channel_count(image.format))),
        is_wide_(bytes_per_channel(image.format) == 2) {}

  Premultiplied at(std::size_t x, std::size_t y) const {
    const std::size_t first = (y * static_cast<std::size_t>(image_.width) + x) * channels_;
    Premultiplied pixel;
    pixel.channel[3] = channels_ == 4 ? number(first + 3) : 1.0;
    for (std::size_t c = 0; c < 3; ++c) pixel.channel[c] = number(first + c) * pixel.channel[3];
    return pixel;
  }

 private:
  double number(std::size_t i) const {
    if (!is_wide_) return image_.bytes[i] / 255.0;
    std::uint16_t wide;
    __builtin_memcpy(&wide, image_.bytes.data() + 2 * i, 2);
    return wide / 65535.0;
  }

  const Image& image_;
  std::size_t channels_;
  bool is_wide_;
};

/// The pixels that a smaller pixel covers on one axis, each with its share.
struct Cover {
  std::size_t first = 0;
  std::vector<double> share;
};

Cover cover_of(std::size_t small, std::size_t small_count, std::size_t count) {
  const double ratio = static_cast<double>(count) / static_cast<double>(small_count);
  const double from = static_cast<double>(small) * ratio, to = from + ratio;
  Cover cover{std::min(static_cast<std::size_t>(from), count - 1), {}};
  const std::size_t end = std::min(count, static_cast<std::size_t>(std::ceil(to - 1e-9)));
  for (std::size_t i = cover.first; i < std::max(end, cover.first + 1); ++i) {
    const double at = static_cast<double>(i);
    cover.share.push_back((std::min(at + 1, to) - std::max(at, from)) / ratio);
  }
  return cover;
}

Status scale_down(Context& context, const Image& image, bool keeps_opacity, Picture& picture) {
  const PixelReader reader(image);
  const auto width = static_cast<std::size_t>(picture.width());
  const auto height = static_cast<std::size_t>(picture.height());
  return try_parallel_for(context, height, kPictureRows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      const Cover rows = cover_of(y, height, static_cast<std::size_t>(image.height));
      for (std::size_t x = 0; x < width; ++x) {
        if (context.cancelled()) return context.cancel_status();
        const Cover columns = cover_of(x, width, static_cast<std::size_t>(image.width));
        Premultiplied mean;
        for (std::size_t j = 0; j < rows.share.size(); ++j) {
          for (std::size_t i = 0; i < columns.share.size(); ++i) {
            mean.add(reader.at(columns.first + i, rows.first + j),
                     rows.share[j] * columns.share[i]);
          }
        }
        const double alpha = mean.channel[3];
        const std::size_t at = y * width + x;
        if (picture.opacity) picture.opacity->value[at] = static_cast<float>(alpha);
        for (std::size_t c = 0; c < 3; ++c) {
          const double code =
              keeps_opacity && alpha > 0 ? mean.channel[c] / alpha : mean.channel[c] + 1 - alpha;
          picture.code[c].value[at] = static_cast<float>(code);
        }
      }
    }
    return ok_status();
  });
}

/// Gives invisible pixels the colours of the nearest visible pixels, row by row and then column by
/// column, so that there is no edge of colour where only opacity has an edge.
void spread_colors(Picture& picture) {
  const Plane& opacity = *picture.opacity;
  const auto is_seen = [&](std::size_t i) { return opacity.value[i] > kTransparent; };
  std::vector<std::int32_t> from(opacity.value.size(), -1);
  const auto width = static_cast<std::size_t>(opacity.width);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (is_seen(i)) from[i] = static_cast<std::int32_t>(i);
  }
  // Two sweeps take the nearest by steps to one of eight neighbours, which is near enough.
  const auto take = [&](std::size_t i, std::size_t neighbour, const auto& distance) {
    if (from[neighbour] < 0) return;
    if (from[i] < 0 || distance(i, from[neighbour]) < distance(i, from[i])) {
      from[i] = from[neighbour];
    }
  };
  const auto distance = [&](std::size_t i, std::int32_t j) {
    const auto of = static_cast<std::size_t>(j);
    const double dx = static_cast<double>(i % width) - static_cast<double>(of % width);
    const double dy = static_cast<double>(i / width) - static_cast<double>(of / width);
    return dx * dx + dy * dy;
  };
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (i % width > 0) take(i, i - 1, distance);
    if (i >= width) take(i, i - width, distance);
  }
  for (std::size_t i = from.size(); i-- > 0;) {
    if (i % width + 1 < width) take(i, i + 1, distance);
    if (i + width < from.size()) take(i, i + width, distance);
  }
  for (Plane& plane : picture.code) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i] >= 0) plane.value[i] = plane.value[static_cast<std::size_t>(from[i])];
    }
  }
}

bool is_transparent_somewhere(const Plane& opacity) {
  return std::ranges::any_of(opacity.value, [](float alpha) { return alpha < 1 - kTransparent; });
}

}  // namespace

Result<Picture> look_at(Context& context, const Image& image, int max_side, bool keeps_opacity) {
  Picture picture;
  const int longer = std::max(image.width, image.height);
  picture.scale = std::min(1.0, static_cast<double>(max_side) / longer);
  const auto scaled = [&](int side) {
    return std::max(1, static_cast<int>(std::lround(side * picture.scale)));
  };
  const int width = scaled(image.width), height = scaled(image.height);
  for (Plane& plane : picture.code) {
    SFUMATO_TRY(make_plane(context, width, height, picture.memory, plane));
  }
  const bool has_alpha = keeps_opacity && channel_count(image.format) == 4;
  if (has_alpha) {
    SFUMATO_TRY(make_plane(context, width, height, picture.memory, picture.opacity.emplace()));
  }
  SFUMATO_TRY(scale_down(context, image, has_alpha, picture));
  if (has_alpha && !is_transparent_somewhere(*picture.opacity)) picture.opacity.reset();
  if (picture.opacity) spread_colors(picture);
  return picture;
}

Status to_oklab(Context& context, const Channels& code, TableMemory& memory, Channels& oklab) {
  for (Plane& plane : oklab) {
    SFUMATO_TRY(make_plane(context, code[0].width, code[0].height, memory, plane));
  }
  constexpr std::size_t kPixels = 4096;
  return parallel_for(context, code[0].value.size(), kPixels, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      const Rgb lab = from_srgb(InterpolationSpace::oklab,
                                {code[0].value[i], code[1].value[i], code[2].value[i]});
      oklab[0].value[i] = lab.r;
      oklab[1].value[i] = lab.g;
      oklab[2].value[i] = lab.b;
    }
  });
}

Result<Noise> estimate_noise(Context& context, const Plane& channel) {
  TableMemory memory("the picture to trace");
  Plane rough;
  SFUMATO_TRY(make_plane(context, channel.width, channel.height, memory, rough));
  const auto height = static_cast<std::size_t>(channel.height);
  SFUMATO_TRY(parallel_for(context, height, kPictureRows, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      const float* rows[3] = {channel.row(std::max(y - 1, 0)), channel.row(y),
                              channel.row(std::min(y + 1, channel.height - 1))};
      for (int x = 0; x < channel.width; ++x) {
        const int left = std::max(x - 1, 0), right = std::min(x + 1, channel.width - 1);
        const auto across = [&](const float* row) { return row[left] - 2 * row[x] + row[right]; };
        rough.row(y)[x] = std::fabs(across(rows[0]) - 2 * across(rows[1]) + across(rows[2])) / 6;
      }
    }
  }));
  const auto quantile = [&](double share) {
    const auto at = rough.value.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(rough.value.size()));
    std::nth_element(rough.value.begin(), at, rough.value.end());
    return double{*at};
  };
  return Noise{1.4826 * quantile(0.5), quantile(kDrawnShare) < kDrawnRoughness};
}

}  // namespace sfumato::tracing
