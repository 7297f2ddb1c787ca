#include "export/pixel_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "export/picture_copy.hpp"
#include "export/poll_interval.hpp"
#include "raster/layers/local_stroke.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::outputs {
namespace {

/// Pixels for a box; fewer to a unit where they would be too many.
struct Size {
  int width, height;
};

Size size_of(const Box& box, double pixels_per_unit) {
  const double longer = std::max(box.width(), box.height());
  const double scale = std::min({pixels_per_unit, limits::kImageSide / longer,
                                 std::sqrt(kMostPartPixels / (box.width() * box.height()))});
  const auto side = [&](double length) {
    return static_cast<int>(std::clamp<double>(std::ceil(length * scale), 1, limits::kImageSide));
  };
  return {side(box.width()), side(box.height())};
}

Result<PixelPart> painted(Context& context, const Picture& picture, const Box& box,
                          const Size& size, PixelFormat format) {
  PixelPart part;
  part.box = box;
  RasterOptions options;
  options.width = size.width;
  options.height = size.height;
  options.viewport = box;
  options.format = format;
  SFUMATO_TRY_ASSIGN(part.image, rasterize(context, picture, options));
  SFUMATO_TRY(part.charge.add(context, capacity_bytes(part.image.bytes), "pixels"));
  return part;
}

/// Two triangles over a box; every node has the first value of its field.
PatchLayer box_layer(const Box& box) {
  PatchLayer layer;
  layer.frame = box;
  layer.order = PatchOrder::linear;
  layer.vertex_position = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  layer.triangle_vertex = {0, 1, 2, 0, 2, 3};
  layer.edge_is_curve.assign(6, 0);
  layer.color.triangle_node.assign(20, 0);
  return layer;
}

/// Returns the means of three or four channels, 0 to 1; the fourth is 0 where there is none.
Result<std::array<float, 4>> channel_means(const Context& context, const Image& image) {
  const auto stride = static_cast<std::size_t>(channel_count(image.format));
  const std::size_t pixels = image.bytes.size() / stride;
  RarePoll<kTurnsPerPoll> poll(context);
  std::array<std::uint64_t, 4> sum{};
  for (std::size_t i = 0; i < pixels; ++i) {
    if (poll.cancelled()) return context.cancel_status();
    for (std::size_t c = 0; c < stride; ++c) sum[c] += image.bytes[stride * i + c];
  }
  const double full = 255.0 * static_cast<double>(std::max(pixels, std::size_t{1}));
  std::array<float, 4> means{};
  for (std::size_t c = 0; c < 4; ++c)
    means[c] = static_cast<float>(static_cast<double>(sum[c]) / full);
  return means;
}

}  // namespace

Status bleed(const Context& context, Image* image) {
  const int width = image->width, height = image->height;
  const auto pixel = [&](int x, int y) {
    return image->bytes.data() +
           4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x));
  };
  for (int y = 0; y < height; ++y) {
    if (context.cancelled()) return context.cancel_status();
    for (int x = 0; x < width; ++x) {
      std::uint8_t* here = pixel(x, y);
      if (here[3] != 0) continue;
      int count = 0;
      std::array<int, 3> sum{};
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i) {
          const std::uint8_t* other = pixel(i, j);
          if (other[3] == 0) continue;
          ++count;
          for (std::size_t c = 0; c < 3; ++c) sum[c] += other[c];
        }
      }
      for (std::size_t c = 0; count > 0 && c < 3; ++c)
        here[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    }
  }
  return ok_status();
}

Result<PixelPart> shader_pixels(Context& context, const Shader& shader, bool as_opacity,
                                const Box& box, double pixels_per_unit) {
  TableMemory copy("a texture");
  Picture picture;
  picture.artboard = picture.viewport = box;
  SFUMATO_TRY(copy_shaders(context, {&shader, 1}, copy, &picture.shaders));
  PatchLayer layer = box_layer(box);
  if (as_opacity) {
    layer.color.node_value = {1, 1, 1};
    layer.opacity = {2, layer.color.triangle_node, {0, 1}, {0}};
  } else {
    layer.color = {4, std::move(layer.color.triangle_node), {0, 0, 0, 1}, {0}};
  }
  picture.layers.push_back(std::move(layer));
  picture.stack.push_back(PatchInstance{});
  return painted(context, picture, box, size_of(box, pixels_per_unit),
                 as_opacity ? PixelFormat::rgba8 : PixelFormat::rgb8);
}

Result<Rgb> mean_color(const Context& context, const PixelPart& part) {
  SFUMATO_TRY_ASSIGN(const auto& means, channel_means(context, part.image));
  return Rgb{means[0], means[1], means[2]};
}

Result<Rgb> mean_opacity(const Context& context, const PixelPart& part) {
  SFUMATO_TRY_ASSIGN(const auto& means, channel_means(context, part.image));
  const float mean = means[3];
  return Rgb{mean, mean, mean};
}

Result<PixelPart> layer_pixels(Context& context, const Picture& picture, std::uint32_t layer,
                               const Box& box, double pixels_per_unit) {
  TableMemory copy("a layer to be painted");
  Picture alone;
  alone.artboard = alone.viewport = box;
  alone.interpolation = picture.interpolation;
  SFUMATO_TRY(copy_shaders(context, picture.shaders, copy, &alone.shaders));
  SFUMATO_TRY(copy_layer(context, picture.layers[layer], copy, &alone.layers));
  alone.stack.push_back(PatchInstance{});
  return painted(context, alone, box, size_of(box, pixels_per_unit), PixelFormat::rgba8);
}

Result<PixelPart> picture_pixels(Context& context, const Picture& picture, double pixels_per_unit) {
  const Box& box = picture.viewport;
  return painted(context, picture, box, size_of(box, pixels_per_unit), PixelFormat::rgb8);
}

namespace {

std::size_t stroke_bytes(std::span<const PictureItem> strokes) {
  std::size_t bytes = 0;
  for (const PictureItem& item : strokes) {
    bytes += sizeof(item) + bytes_of(std::get<LocalStroke>(item).curve);
  }
  return bytes;
}

}  // namespace

Result<PixelPart> stroke_pixels(Context& context, std::span<const PictureItem> strokes,
                                InterpolationSpace space, const Box& viewport,
                                double pixels_per_unit) {
  const Size size = size_of(viewport, pixels_per_unit);
  const Vec2 scale{size.width / viewport.width(), size.height / viewport.height()};
  const Affine pixels_from_artboard{
      scale.x, 0, 0, scale.y, -viewport.min.x * scale.x, -viewport.min.y * scale.y};
  Box bounds;
  Picture picture;
  picture.interpolation = space;
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, stroke_bytes(strokes), "local curves"));
  picture.stack.reserve(strokes.size());
  for (const PictureItem& item : strokes) {
    const auto& stroke = std::get<LocalStroke>(item);
    SFUMATO_TRY_ASSIGN(const raster::StrokePainter& painter,
                       raster::StrokePainter::create(context, stroke, pixels_from_artboard, space));
    if (!painter.bounds_px().empty()) bounds = united(bounds, painter.bounds_px());
    picture.stack.push_back(stroke);
  }
  // Whole pixels of the viewport's own grid.
  const Box pixels{
      {std::max(std::floor(bounds.min.x), 0.0), std::max(std::floor(bounds.min.y), 0.0)},
      {std::min<double>(std::ceil(bounds.max.x), size.width),
       std::min<double>(std::ceil(bounds.max.y), size.height)}};
  if (!(pixels.width() >= 1 && pixels.height() >= 1)) return PixelPart{};
  const Affine artboard_from_pixels = inverse(pixels_from_artboard);
  const Box box{artboard_from_pixels(pixels.min), artboard_from_pixels(pixels.max)};
  picture.artboard = picture.viewport = box;
  SFUMATO_TRY_ASSIGN(auto&& part,
                     painted(context, picture, box,
                             {static_cast<int>(pixels.width()), static_cast<int>(pixels.height())},
                             PixelFormat::rgba8));
  SFUMATO_TRY(bleed(context, &part.image));
  return std::move(part);
}

}  // namespace sfumato::outputs
