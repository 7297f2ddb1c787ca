#include "solve/points/exact_picture.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/try.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {
namespace {

/// Points are processed in squares of this side, so that the 16 points of a packet lie close
/// together.
constexpr int kSquare = 4;

/// Calls visit(x, y) for the pixels of a rectangle, square by square.
template <class Visit>
void for_each_in_squares(const PixelRect& rect, Visit visit) {
  for (int square_y = rect.y0; square_y < rect.y1; square_y += kSquare) {
    for (int square_x = rect.x0; square_x < rect.x1; square_x += kSquare) {
      for (int y = square_y; y < std::min(square_y + kSquare, rect.y1); ++y) {
        for (int x = square_x; x < std::min(square_x + kSquare, rect.x1); ++x) visit(x, y);
      }
    }
  }
}

template <class Value>
void put_in_rows(const std::vector<Value>& value, std::size_t channels,
                 const std::vector<std::size_t>& pixel, std::vector<Value>& out) {
  out.resize(value.size());
  for (std::size_t i = 0; channels > 0 && i < pixel.size(); ++i) {
    std::copy_n(value.data() + channels * i, channels, out.data() + channels * pixel[i]);
  }
}

PatchField field_without_values(int channel_count, std::span<const std::uint32_t> shaders) {
  return {channel_count,
          std::vector<std::uint32_t>(20, 0),
          std::vector<float>(static_cast<std::size_t>(channel_count), 0.0f),
          {shaders.begin(), shaders.end()}};
}

/// Returns two triangles over the visible part of a layer.
PatchLayer layer_without_patches(const PointEvaluator& evaluator, std::uint32_t index,
                                 const Box& seen) {
  PatchLayer layer;
  layer.frame = seen;
  layer.vertex_position = {seen.min, {seen.max.x, seen.min.y}, seen.max, {seen.min.x, seen.max.y}};
  layer.triangle_vertex = {0, 1, 2, 0, 2, 3};
  layer.edge_is_curve.assign(6, 0);
  layer.color =
      field_without_values(evaluator.color_channels(index), evaluator.color_shaders(index));
  // If there is no opacity field, this one makes pixels that may be transparent.
  layer.opacity = field_without_values(std::max(evaluator.opacity_channels(index), 1),
                                       evaluator.opacity_shaders(index));
  return layer;
}

Result<Picture> picture_without_patches(Context& context, const Document& document,
                                        const PointEvaluator& evaluator, const Box& viewport) {
  SFUMATO_TRY_ASSIGN(auto&& picture, picture_frame(context, document, viewport));
  for (std::uint32_t i = 0; i < document.layers.size(); ++i) {
    const Box seen = sight_of_layer(document, i, viewport).viewport;
    const bool is_seen = evaluator.color_channels(i) > 0;
    picture.layers.push_back(is_seen ? layer_without_patches(evaluator, i, seen) : PatchLayer{});
  }
  return std::move(picture);
}

}  // namespace

Result<ExactPicture> ExactPicture::create(Context& context, const Document& document,
                                          const DiffuseOptions& options, DiffuseStats* stats) {
  const Box viewport = options.viewport.value_or(document.artboard);
  DiffuseOptions seen = options;
  seen.viewport = viewport;
  SFUMATO_TRY_ASSIGN(auto&& evaluator, PointEvaluator::create(context, document, seen, stats));
  SFUMATO_TRY_ASSIGN(auto&& picture,
                     picture_without_patches(context, document, evaluator, viewport));
  ExactPicture result(context, std::move(evaluator));
  result.picture_ = std::move(picture);
  SFUMATO_TRY(result.charge_.add(context, bytes_of(result.picture_), "the picture"));
  return result;
}

Status ExactPicture::read(std::uint32_t layer, const Affine& layer_from_image,
                          const PixelRect& rect, picture::FieldPixels* out) const {
  if (context_->cancelled()) return context_->cancel_status();
  std::vector<Vec2> points;
  std::vector<std::size_t> pixel;  // per point: its index in `out`
  for_each_in_squares(rect, [&](int x, int y) {
    points.push_back(layer_from_image({x + 0.5, y + 0.5}));
    pixel.push_back(static_cast<std::size_t>(y - rect.y0) * (rect.x1 - rect.x0) + (x - rect.x0));
  });
  const auto channels = static_cast<std::size_t>(evaluator_.color_channels(layer));
  const auto opacity_channels = static_cast<std::size_t>(evaluator_.opacity_channels(layer));
  std::vector<float> color(channels * points.size()), opacity(opacity_channels * points.size());
  std::vector<std::uint8_t> hit(points.size());
  // Tiles already run in parallel; a single point needs little memory besides.
  const Budget& budget = context_->budget;
  Context serial{.budget = Budget(budget.limit() - std::min(budget.limit(), budget.used())),
                 .limits = context_->limits,
                 .simd = context_->simd,
                 .point_source = context_->point_source,
                 .outer = context_};
  SFUMATO_TRY(evaluator_.gather(serial, layer, points, color, hit, opacity));
  put_in_rows(color, channels, pixel, out->color);
  put_in_rows(opacity, opacity_channels, pixel, out->opacity);
  put_in_rows(hit, 1, pixel, out->hit);
  return ok_status();
}

}  // namespace sfumato::solve
