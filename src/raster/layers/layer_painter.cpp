#include "raster/layers/layer_painter.hpp"

#include <algorithm>

#include "base/try.hpp"
#include "raster/coverage/triangle_blocks.hpp"

namespace sfumato::raster {

Tile TilePlanes::tile(const PixelRect& rect) const {
  float* plane = values_.get();
  return {rect.x0,
          rect.y0,
          rect.x1 - rect.x0,
          rect.y1 - rect.y0,
          {plane, plane + kTileFloats, plane + 2 * kTileFloats},
          plane + 3 * kTileFloats};
}

void clear(const Tile& tile) {
  for (int row = 0; row < tile.height; ++row) {
    const std::size_t begin = static_cast<std::size_t>(row) * kTileStride;
    for (float* plane : tile.color) std::fill_n(plane + begin, tile.width, 0.0f);
    std::fill_n(tile.alpha + begin, tile.width, 0.0f);
  }
}

/// Adds `count` weighted values of a shader from pixel (x, y) of the image on.
void LayerPainter::add_run(const FieldView& field, int channel, const ShadingInput& input, int x,
                           int y, const float* weight, int count, const Tile& tile) {
  const std::uint32_t index = field.shader[channel - field.first_weight()];
  const ImageShader& shader =
      field.is_opacity() ? input.shaders->of_opacity(index) : input.shaders->of_color(index);
  float r[kTileWidth], g[kTileWidth], b[kTileWidth], alpha[kTileWidth];
  shader.evaluate(input.layer_from_image, x, y, count, r, g, b, alpha);
  const std::ptrdiff_t at = std::ptrdiff_t{y - tile.y0} * kTileStride + (x - tile.x0);
  if (field.is_opacity()) {
    float* target = tile.alpha + at;
    for (int i = 0; i < count; ++i) target[i] += weight[i] * opacity_of(r[i], g[i], b[i], alpha[i]);
    return;
  }
  float* target[3] = {tile.color[0] + at, tile.color[1] + at, tile.color[2] + at};
  for (int i = 0; i < count; ++i) {
    target[0][i] += weight[i] * r[i];
    target[1][i] += weight[i] * g[i];
    target[2][i] += weight[i] * b[i];
  }
}

/// Adds one shader where its weight is not 0; `weights` is a part of `tile`.
void LayerPainter::add_shader(const FieldView& field, int channel, const ShadingInput& input,
                              const Tile& weights, const Tile& tile) {
  const int lane = (channel - field.first_weight()) % 4;
  const float* plane = lane < 3 ? weights.color[lane] : weights.alpha;
  for (int row = 0; row < weights.height; ++row) {
    const float* weight = plane + std::ptrdiff_t{row} * kTileStride;
    const float* const end = weight + weights.width;
    const float* const first = weight;
    while (true) {
      weight = std::find_if(weight, end, [](float w) { return w != 0; });
      if (weight == end) break;
      const float* const run_end = std::find(weight, end, 0.0f);
      add_run(field, channel, input, weights.x0 + static_cast<int>(weight - first),
              weights.y0 + row, weight, static_cast<int>(run_end - weight), tile);
      weight = run_end;
    }
  }
}

void LayerPainter::add_shaders(const LayerView& layer, const FieldView& field,
                               const ShadingInput& input, const TriangleList& triangles,
                               const Tile& tile) {
  for (int first = field.first_weight(); first < field.channel_count; first += 4) {
    weighted_.clear();
    std::copy_if(triangles.triangle, triangles.triangle + triangles.count,
                 std::back_inserter(weighted_),
                 [&](std::uint32_t t) { return has_weight(field, first, t); });
    const TriangleList weighted{weighted_.data(), weighted_.size()};
    const PixelRect rect = pixels_in(kernels_.box_of_triangles(layer, weighted), tile.rect());
    if (rect.empty()) continue;
    const Tile weights = weights_.tile(rect);
    clear(weights);
    kernels_.draw_weights(layer, field, first, weighted, weights);
    const int end = std::min(first + 4, field.channel_count);
    for (int channel = first; channel < end; ++channel)
      add_shader(field, channel, input, weights, tile);
  }
}

/// Adds the shaders of a field that was read, row by row.
void LayerPainter::add_read_shaders(const FieldView& field, const std::vector<float>& value,
                                    const ShadingInput& input, const Tile& tile) {
  const auto channels = static_cast<std::size_t>(field.channel_count);
  float weight[kTileWidth];
  for (int channel = field.first_weight(); channel < field.channel_count; ++channel) {
    for (int row = 0; row < tile.height; ++row) {
      const float* first =
          value.data() + channel + channels * static_cast<std::size_t>(row) * tile.width;
      for (int x = 0; x < tile.width; ++x) weight[x] = first[channels * x];
      add_run(field, channel, input, tile.x0, tile.y0 + row, weight, tile.width, tile);
    }
  }
}

Status LayerPainter::read_source(const LayerView& layer, const ShadingInput& input,
                                 const Tile& tile) {
  SFUMATO_TRY(source_->read(layer.index, input.layer_from_image, tile.rect(), &pixels_));
  const auto channels = static_cast<std::size_t>(layer.color.channel_count);
  const auto opacity_channels = static_cast<std::size_t>(layer.opacity.channel_count);
  const bool has_opacity = !pixels_.opacity.empty();
  const auto pixel_count = static_cast<std::size_t>(tile.height) * tile.width;
  if (pixels_.color.size() != channels * pixel_count || pixels_.hit.size() != pixel_count ||
      (has_opacity && pixels_.opacity.size() != opacity_channels * pixel_count)) {
    return make_error(StatusCode::bad_input, "a source of fields gave other tables than asked for");
  }
  const auto for_each_pixel = [&](auto body) {
    for (int row = 0; row < tile.height; ++row) {
      for (int x = 0; x < tile.width; ++x) {
        body(static_cast<std::size_t>(row) * tile.width + x,
             static_cast<std::size_t>(row) * kTileStride + x);
      }
    }
  };
  for_each_pixel([&](std::size_t i, std::size_t at) {
    for (std::size_t c = 0; c < 3; ++c) tile.color[c][at] = pixels_.color[channels * i + c];
    tile.alpha[at] = has_opacity ? pixels_.opacity[opacity_channels * i] : 1;
  });
  add_read_shaders(layer.color, pixels_.color, input, tile);
  if (has_opacity) add_read_shaders(layer.opacity, pixels_.opacity, input, tile);
  for_each_pixel([&](std::size_t i, std::size_t at) {
    if (!pixels_.hit[i]) tile.alpha[at] = 0;
  });
  return ok_status();
}

void LayerPainter::draw_patches(const LayerView& layer, const ShadingInput& input,
                                const TriangleList& triangles, const Tile& tile) {
  const bool has_opacity = layer.opacity.channel_count > 0;
  const auto draw = has_opacity ? kernels_.draw_color_opacity : kernels_.draw_triangles;
  draw(layer, triangles, tile, antialias_ && has_opacity ? &mixed_.marked() : nullptr);
  add_shaders(layer, layer.color, input, triangles, tile);
  add_shaders(layer, layer.opacity, input, triangles, tile);
}

Result<Tile> LayerPainter::paint(const LayerView& layer, const ShadingInput& input,
                                 const TriangleList& triangles, const PixelRect& rect) {
  const Tile tile = shaded_.tile(rect);
  clear(tile);
  if (source_) {
    SFUMATO_TRY(read_source(layer, input, tile));
  } else {
    if (antialias_) mixed_.mark(layer, triangles, tile);
    draw_patches(layer, input, triangles, tile);
  }
  kernels_.finish_shading(input.space, tile);
  if (antialias_ && !source_) {
    PointShader shader(layer, input);
    mixed_.paint(&shader, triangles, tile);
  }
  return tile;
}

}  // namespace sfumato::raster
