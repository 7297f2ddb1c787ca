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

/// Adds the shaders of an exact field.
void LayerPainter::add_exact_shaders(const FieldView& field, const ShadingInput& input,
                                     const Tile& tile, const ExactPainter& exact) {
  for (int first = field.first_weight(); first < field.channel_count; first += 4) {
    const Tile weights = weights_.tile(tile.rect());
    clear(weights);
    exact.write_channels(field, first, weights);
    const int end = std::min(first + 4, field.channel_count);
    for (int channel = first; channel < end; ++channel)
      add_shader(field, channel, input, weights, tile);
  }
}

Status LayerPainter::draw_exact(Context& context, const LayerView& layer, const ShadingInput& input,
                                const TriangleList& triangles, const Tile& tile,
                                ExactPainter* exact) {
  SFUMATO_TRY(
      exact->paint_fields(context, layer, input.layer_from_image, triangles, tile, &mixed_));
  add_exact_shaders(layer.color, input, tile, *exact);
  add_exact_shaders(layer.opacity, input, tile, *exact);
  if (layer.opacity.shader_count > 0) exact->clear_unseen(tile);
  kernels_.finish_shading(input.space, tile);
  if (!antialias_) return ok_status();
  const PointShader shading(layer, input);
  mixed_.paint(exact->shader(layer, &shading), tile, false);
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

Result<Tile> LayerPainter::paint(Context& context, const LayerView& layer,
                                 const ShadingInput& input, const TriangleList& triangles,
                                 const PixelRect& rect, ExactPainter* exact) {
  const Tile tile = shaded_.tile(rect);
  clear(tile);
  if (layer.exact) {
    SFUMATO_TRY(draw_exact(context, layer, input, triangles, tile, exact));
    return tile;
  }
  if (antialias_) mixed_.mark(layer, triangles, tile);
  draw_patches(layer, input, triangles, tile);
  kernels_.finish_shading(input.space, tile);
  if (antialias_) {
    PointShader shader(layer, input);
    mixed_.paint(&shader, triangles, tile);
  }
  return tile;
}

}  // namespace sfumato::raster
