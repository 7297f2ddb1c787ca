#include "solve/render_pixels.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/no_throw.hpp"
#include "base/public_verb.hpp"
#include "base/stopwatch.hpp"
#include "raster/paint_picture.hpp"
#include "solve/layer_scene.hpp"
#include "solve/point_evaluator.hpp"

namespace sfumato {
namespace {

/// Points are taken in squares of this side, so that the 16 of a packet lie close together.
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

/// The gather itself, at every pixel that is asked for.
class ExactFields final : public picture::FieldSource {
 public:
  /// Both must outlive this.
  ExactFields(Context& context, const PointEvaluator& evaluator)
      : context_(context), evaluator_(evaluator) {}

  void read(std::uint32_t layer, const Affine& layer_from_image, const PixelRect& rect,
            picture::FieldPixels* out) const override {
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
    evaluate(layer, points, color, hit, opacity);
    put_in_rows(color, channels, pixel, out->color);
    put_in_rows(opacity, opacity_channels, pixel, out->opacity);
    put_in_rows(hit, 1, pixel, out->hit);
  }

  /// Of all that was read.
  Status status() const {
    if (context_.cancelled()) return context_.stop_status();
    switch (failure_.load()) {
      case StatusCode::ok:
        return ok_status();
      case StatusCode::out_of_memory:
        return out_of_memory();
      default:
        return make_error(StatusCode::limit, "memory limit reached: the gather at every pixel");
    }
  }

 private:
  void evaluate(std::uint32_t layer, std::span<const Vec2> points, std::span<float> color,
                std::span<std::uint8_t> hit, std::span<float> opacity) const {
    if (context_.cancelled()) return;
    // Tiles run side by side already; what one point needs besides is little.
    const Budget& budget = context_.budget;
    Context serial{.budget = Budget(budget.limit() - std::min(budget.limit(), budget.used())),
                   .limits = context_.limits,
                   .simd = context_.simd,
                   .outer = &context_};
    const Status status = evaluator_.evaluate(serial, layer, points, color, hit, opacity);
    if (!status) failure_.store(status.code);
  }

  template <class Value>
  static void put_in_rows(const std::vector<Value>& value, std::size_t channels,
                          const std::vector<std::size_t>& pixel, std::vector<Value>& out) {
    out.resize(value.size());
    for (std::size_t i = 0; channels > 0 && i < pixel.size(); ++i) {
      std::copy_n(value.data() + channels * i, channels, out.data() + channels * pixel[i]);
    }
  }

  Context& context_;
  const PointEvaluator& evaluator_;
  mutable std::atomic<StatusCode> failure_{StatusCode::ok};
};

PatchField field_without_values(int channel_count, std::span<const std::uint32_t> shaders) {
  return {channel_count,
          std::vector<std::uint32_t>(20, 0),
          std::vector<float>(static_cast<std::size_t>(channel_count), 0.0f),
          {shaders.begin(), shaders.end()}};
}

/// Two triangles over what is seen of a layer.
PatchLayer layer_without_patches(const PointEvaluator& evaluator, std::uint32_t index,
                                 const Box& seen) {
  PatchLayer layer;
  layer.frame = seen;
  layer.vertex_position = {seen.min, {seen.max.x, seen.min.y}, seen.max, {seen.min.x, seen.max.y}};
  layer.triangle_vertex = {0, 1, 2, 0, 2, 3};
  layer.edge_is_curve.assign(6, 0);
  layer.color =
      field_without_values(evaluator.color_channels(index), evaluator.color_shaders(index));
  // Where there is no opacity field this one says that pixels may be transparent.
  layer.opacity = field_without_values(std::max(evaluator.opacity_channels(index), 1),
                                       evaluator.opacity_shaders(index));
  return layer;
}

Result<Picture> picture_without_patches(Context& context, const Document& document,
                                        const PointEvaluator& evaluator, const Box& viewport) {
  Result<Picture> picture = picture_frame(context, document, viewport);
  if (!picture) return picture;
  for (std::uint32_t i = 0; i < document.layers.size(); ++i) {
    const Box seen = solve::sight_of_layer(document, i, viewport).viewport;
    const bool is_seen = evaluator.color_channels(i) > 0;
    picture->layers.push_back(is_seen ? layer_without_patches(evaluator, i, seen) : PatchLayer{});
  }
  return picture;
}

Result<Image> render(Context& context, const Document& document,
                     const DiffuseOptions& diffuse_options, const RasterOptions& raster_options,
                     DiffuseStats* stats) {
  const Box viewport =
      raster_options.viewport.value_or(diffuse_options.viewport.value_or(document.artboard));
  DiffuseOptions options = diffuse_options;
  options.viewport = viewport;
  Result<PointEvaluator> evaluator = PointEvaluator::create(context, document, options, stats);
  if (!evaluator) return evaluator.status();
  const Stopwatch watch;
  const ExactFields fields(context, *evaluator);
  const Result<Picture> picture = picture_without_patches(context, document, *evaluator, viewport);
  if (!picture) return picture.status();
  ScopedCharge charge;
  Status status = charge.add(context, bytes_of(*picture), "the picture");
  if (!status) return status;
  RasterOptions shown = raster_options;
  shown.viewport = viewport;
  shown.antialias = shown.mesh_overlay = false;
  Result<Image> image = raster::paint_picture(context, *picture, shown, &fields);
  if (!fields.status()) return fields.status();
  if (stats) {
    stats->nodes +=
        static_cast<std::uint64_t>(shown.width) * static_cast<std::uint64_t>(shown.height);
    stats->gather_seconds += watch.seconds();
  }
  return image;
}

}  // namespace

Result<Image> render_pixels(Context& context, const Document& document,
                            const DiffuseOptions& diffuse_options,
                            const RasterOptions& raster_options, DiffuseStats* stats) {
  return public_verb(
      context, [&] { return render(context, document, diffuse_options, raster_options, stats); });
}

}  // namespace sfumato
