#include "raster/layers/exact_painter.hpp"

#include <bit>

#include "base/try.hpp"

namespace sfumato::raster {

/// Returns the pixels in triangles that are not mixed.
PixelMask ExactPainter::usable_pixels(const LayerView& layer, const TriangleList& triangles,
                                      const Tile& tile, const PixelMask* mixed) const {
  PixelMask usable{};
  kernels_.cover_triangles(layer, triangles, tile, &usable);
  for (int row = 0; mixed && row < tile.height; ++row)
    for (int i = 0; i < PixelMask::kWords; ++i) usable.word[row][i] &= ~mixed->word[row][i];
  return usable;
}

void ExactPainter::list_all(const PixelMask& usable, const Tile& tile) {
  pixel_.clear();
  for (int row = 0; row < tile.height; ++row) {
    for (int i = 0; i < PixelMask::kWords; ++i) {
      for (std::uint64_t left = usable.word[row][i]; left != 0; left &= left - 1) {
        const int column = 64 * i + std::countr_zero(left);
        pixel_.push_back(static_cast<std::uint32_t>(row * kTileStride + column));
      }
    }
  }
}

void ExactPainter::add_pixels(std::span<const std::uint32_t> pixels, const Tile& tile,
                              ExactPoints* points) {
  for (const std::uint32_t pixel : pixels) {
    const int x = tile.x0 + static_cast<int>(pixel % kTileStride);
    const int y = tile.y0 + static_cast<int>(pixel / kTileStride);
    points->add({x + 0.5, y + 0.5}, x, y);
  }
}

Status ExactPainter::paint_fields(Context& context, const LayerView& layer,
                                  const Affine& layer_from_image, const TriangleList& triangles,
                                  const Tile& tile, MixedPixels* mixed) {
  points_.start(layer, layer_from_image);
  if (antialias_) mixed->mark(layer, triangles, tile);
  const PixelMask* const cut = antialias_ ? &mixed->marked() : nullptr;
  const PixelMask usable = usable_pixels(layer, triangles, tile, cut);
  const bool in_rounds = is_in_rounds(layer);
  if (in_rounds) {
    blocks_.start(tile, usable, cut, layer.exact->max_miss());
    blocks_.next_round();
    pixel_ = blocks_.pixels();
  } else {
    list_all(usable, tile);
  }
  add_pixels(pixel_, tile, &points_);
  if (antialias_) SFUMATO_TRY(mixed->collect(context, layer, triangles, tile, &points_));
  SFUMATO_TRY(read(context, &points_));
  write_colors(layer, points_, tile);
  return in_rounds ? gather_later_rounds(context, layer, layer_from_image, tile) : ok_status();
}

/// Returns whether ExactBlocks chooses the pixels. It interpolates pixels of a layer with
/// max_miss() > 0, and finds clear blocks of a layer with an opacity. Clear blocks need
/// antialiasing, which marks the pixels that curves cut. Shaders are added to the first round of
/// pixels only, so a layer with shaders has a single round.
bool ExactPainter::is_in_rounds(const LayerView& layer) const {
  if (layer.exact->max_miss() > 0) return true;
  const bool has_shaders = layer.color.shader_count + layer.opacity.shader_count > 0;
  return antialias_ && layer.opacity.channel_count > 0 && !has_shaders;
}

/// Charges the lists and reads the points.
Status ExactPainter::read(Context& context, ExactPoints* points) {
  SFUMATO_TRY(memory_.settle(context, capacity_bytes(pixel_) + blocks_.bytes(), charged_));
  SFUMATO_TRY(points->settle(context));
  return points->read(context);
}

/// Ends the first round, and gathers the pixels of the later rounds.
Status ExactPainter::gather_later_rounds(Context& context, const LayerView& layer,
                                         const Affine& layer_from_image, const Tile& tile) {
  blocks_.end_round(tile);
  while (blocks_.next_round()) {
    pixel_ = blocks_.pixels();
    more_points_.start(layer, layer_from_image);
    add_pixels(pixel_, tile, &more_points_);
    SFUMATO_TRY(read(context, &more_points_));
    write_colors(layer, more_points_, tile);
    blocks_.end_round(tile);
  }
  return ok_status();
}

/// Writes the values of the first points into the pixels of pixel_. Pixels that see no colour
/// become clear.
void ExactPainter::write_colors(const LayerView& layer, const ExactPoints& points,
                                const Tile& tile) {
  for (std::uint32_t i = 0; i < pixel_.size(); ++i) {
    const std::uint32_t pixel = pixel_[i];
    const float* const color = points.color(i);
    for (int c = 0; c < 3; ++c) tile.color[c][pixel] = color[c];
    if (!tile.alpha) continue;
    const float alpha = layer.opacity.channel_count > 0 ? points.opacity(i)[0] : 1;
    tile.alpha[pixel] = points.is_hit(i) ? alpha : 0;
  }
}

void ExactPainter::write_channels(const FieldView& field, int first, const Tile& tile) const {
  float* const plane[4] = {tile.color[0], tile.color[1], tile.color[2], tile.alpha};
  const int count = std::min(4, field.channel_count - first);
  for (std::uint32_t i = 0; i < pixel_.size(); ++i) {
    const float* const value = field.is_opacity() ? points_.opacity(i) : points_.color(i);
    for (int c = 0; c < count; ++c) plane[c][pixel_[i]] = value[first + c];
  }
}

void ExactPainter::clear_unseen(const Tile& tile) const {
  for (std::uint32_t i = 0; i < pixel_.size(); ++i)
    if (!points_.is_hit(i)) tile.alpha[pixel_[i]] = 0;
}

Status ExactPainter::paint_straight(Context& context, const LayerView& layer,
                                    const Affine& layer_from_image, const TriangleList& triangles,
                                    const Tile& tile, MixedPixels* mixed) {
  SFUMATO_TRY(paint_fields(context, layer, layer_from_image, triangles, tile, mixed));
  if (!antialias_) return ok_status();
  mixed->keep_below(tile);  // these pixels are still as they were
  mixed->paint(shader(layer, nullptr), tile, true);
  return ok_status();
}

}  // namespace sfumato::raster
