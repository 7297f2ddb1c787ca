#include "trace/stack_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "raster/local_stroke.hpp"
#include "raster/shader_set.hpp"
#include "trace/plane.hpp"

namespace sfumato::tracing {
namespace {

/// What shows less than this is not seen.
constexpr float kUnseen = 1.0f / 1024;
/// Terms of rows below this share of a point's weight are left out.
constexpr float kNegligible = 2e-4f;
/// Points, and rows of pixels, that one task looks at.
constexpr std::size_t kPoints = 1024;
constexpr std::size_t kPixelRows = 64;

class StackWalk {
 public:
  StackWalk(Context& context, const Document& drawing,
            std::span<const std::optional<DrawnLayer>> layers, const LaidPicture& picture,
            const SamplePixels& pixels)
      : context_(context), drawing_(drawing), layers_(layers), picture_(picture), pixels_(pixels) {}

  Result<StackPoints> run(const Rgb& backdrop);

 private:
  /// A group whose items are being followed.
  struct Level {
    std::vector<float> outside;  ///< per point: what passes all that is above the group
    float opacity = 1;
    bool is_mixed = false;  ///< it or a group around it has another mode than normal
    TableMemory memory{"what a drawing shows"};
  };

  Status begin();
  Status add(const LayerInstance& instance);
  Status add(const LocalStroke& stroke);
  Status enter(const GroupBegin& group);
  Status leave();
  Status find_seen(const std::vector<Vec2>& place, const DrawnLayer& layer,
                   const LayerInstance& instance, ShownInstance& shown);
  Status find_opacities(const DrawnLayer& layer, std::span<const Vec2> points,
                        const Affine& layer_from_pixel, std::span<float> opacity);
  Status prepare_shaders(std::span<const std::uint32_t> named, InterpolationSpace space,
                         ImageShaders& shaders);
  void take(const LayerInstance& instance, const ShownInstance& shown);
  bool is_mixed() const { return !levels_.empty() && levels_.back().is_mixed; }
  void leave_out(std::size_t point) { out_.is_left_out[pixel_of_[point]] = 1; }

  Context& context_;
  const Document& drawing_;
  std::span<const std::optional<DrawnLayer>> layers_;
  const LaidPicture& picture_;
  const SamplePixels& pixels_;
  StackPoints out_;
  std::vector<std::uint32_t> pixel_of_;  ///< per point: index into SamplePixels::pixel
  std::vector<float> through_;           ///< per point: what passes all that was met, 0 to 1
  std::vector<Level> levels_;
  ImageShaders opacity_shaders_;
  std::array<Plane, 4> stroke_;  ///< a stroke painted onto nothing, premultiplied
  TableMemory memory_{"what a drawing shows"};
};

Status StackWalk::begin() {
  const std::size_t points = pixels_.point.size(), pixels = pixels_.pixel.size();
  Status status = memory_.resize(context_, through_, points, 1.0f);
  if (status) status = memory_.resize(context_, pixel_of_, points);
  if (status) status = out_.memory.resize(context_, out_.fixed, points);
  if (status) status = out_.memory.resize(context_, out_.is_left_out, pixels);
  if (!status) return status;
  for (std::uint32_t i = 0; i < pixels; ++i) {
    for (std::uint32_t p = pixels_.point_begin[i]; p < pixels_.point_begin[i + 1]; ++p) {
      pixel_of_[p] = i;
    }
  }
  out_.color_shaders.resize(drawing_.shaders.size());
  opacity_shaders_.resize(drawing_.shaders.size());
  return ok_status();
}

Result<StackPoints> StackWalk::run(const Rgb& backdrop) {
  Status status = begin();
  std::vector<const GroupBegin*> open, begin_of;
  if (status) status = memory_.resize(context_, begin_of, drawing_.stack.size());
  if (!status) return status;
  for (std::size_t i = 0; i < drawing_.stack.size(); ++i) {
    if (const auto* group = std::get_if<GroupBegin>(&drawing_.stack[i])) open.push_back(group);
    if (!std::holds_alternative<GroupEnd>(drawing_.stack[i])) continue;
    begin_of[i] = open.back();
    open.pop_back();
  }
  for (std::size_t i = drawing_.stack.size(); i-- > 0 && status;) {
    if (context_.cancelled()) return context_.cancel_status();
    const StackItem& item = drawing_.stack[i];
    if (const auto* instance = std::get_if<LayerInstance>(&item)) status = add(*instance);
    if (const auto* stroke = std::get_if<LocalStroke>(&item)) status = add(*stroke);
    if (begin_of[i]) status = enter(*begin_of[i]);
    if (std::holds_alternative<GroupBegin>(item)) status = leave();
  }
  if (!status) return status;
  for (std::size_t p = 0; p < through_.size(); ++p) {
    const float share = through_[p];
    out_.fixed[p][0] += share * backdrop.r;
    out_.fixed[p][1] += share * backdrop.g;
    out_.fixed[p][2] += share * backdrop.b;
  }
  for (ShownInstance& shown : out_.shown) {
    for (std::size_t i = 0; i < shown.point.size(); ++i) {
      if (out_.is_left_out[pixel_of_[shown.point[i]]]) shown.coefficient[i] = 0;
    }
  }
  return std::move(out_);
}

Status StackWalk::enter(const GroupBegin& group) {
  Level level;
  level.opacity = group.opacity;
  level.is_mixed = is_mixed() || group.blend != BlendMode::normal;
  Status status = level.memory.assign(context_, through_, level.outside);
  if (!status) return status;
  for (float& through : through_) through *= group.opacity;
  levels_.push_back(std::move(level));
  return ok_status();
}

/// A group of opacity g, of which P passes its items, lets 1 - g + g P pass.
Status StackWalk::leave() {
  const Level& level = levels_.back();
  for (std::size_t p = 0; p < through_.size(); ++p) {
    through_[p] += level.outside[p] * (1 - level.opacity);
  }
  levels_.pop_back();
  return ok_status();
}

Status StackWalk::prepare_shaders(std::span<const std::uint32_t> named, InterpolationSpace space,
                                  ImageShaders& shaders) {
  for (const std::uint32_t index : named) {
    if (shaders[index]) continue;
    Result<raster::ImageShader> made =
        raster::ImageShader::create(context_, drawing_.shaders[index], space);
    if (!made) return made.status();
    shaders[index].emplace(std::move(*made));
  }
  return ok_status();
}

/// The opacities of a layer at points of its frame.
Status StackWalk::find_opacities(const DrawnLayer& layer, std::span<const Vec2> points,
                                 const Affine& layer_from_pixel, std::span<float> opacity) {
  const curves::SegmentAttributes& places = *layer.opacity_places;
  Status status = prepare_shaders(places.shader, InterpolationSpace::srgb, opacity_shaders_);
  if (!status) return status;
  const Result<gather::Rows> rows =
      gather::gather_rows(context_, layer.mesh, places, points, {.negligible = kNegligible});
  if (!rows) return rows.status();
  const Affine pixel_from_layer = inverse(layer_from_pixel);
  return parallel_for(context_, points.size(), kPoints, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      double sum = 0;
      for (std::uint32_t k = rows->begin[i]; k < rows->begin[i + 1]; ++k) {
        const gather::RowTerm& term = rows->term[k];
        const gather::RowSource& source = rows->source[term.source];
        const double radius = gather::radius_at(source, term.moment);
        gather::for_each_entry(source, term, radius, [&](std::uint32_t column, double weight) {
          sum += weight * layer.opacity[column];
        });
        gather::for_each_side(source, term, radius, [&](const gather::RowSide& side, double w) {
          if (side.shader < 0) return;
          const std::uint32_t shader = places.shader[static_cast<std::size_t>(side.shader)];
          const auto [color, alpha] =
              opacity_shaders_[shader]->at(layer_from_pixel, pixel_from_layer(points[i]));
          sum += w * raster::opacity_of(color.r, color.g, color.b, alpha);
        });
      }
      opacity[i] = static_cast<float>(std::clamp(sum, 0.0, 1.0));
    }
  });
}

/// Lists the points that show an instance, with its rows there.
/// place  per point of the picture: where it lies in the layer's frame
Status StackWalk::find_seen(const std::vector<Vec2>& place, const DrawnLayer& layer,
                            const LayerInstance& instance, ShownInstance& shown) {
  TableMemory memory("what a drawing shows");
  std::vector<Vec2> points;
  Status status;
  for (std::uint32_t p = 0; p < place.size() && status; ++p) {
    if (instance.opacity * through_[p] < kUnseen) continue;
    status = shown.memory.push_back(context_, shown.point, p);
    if (status) {
      status = shown.memory.push_back(context_, shown.coefficient, instance.opacity * through_[p]);
    }
    if (status) status = memory.push_back(context_, points, place[p]);
  }
  if (status && layer.opacity_places) {
    std::vector<float> opacity;
    status = memory.resize(context_, opacity, points.size());
    if (status) status = find_opacities(layer, points, shown.layer_from_pixel, opacity);
    if (!status) return status;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float coefficient = shown.coefficient[i] * opacity[i];
      if (coefficient < kUnseen) continue;
      shown.point[kept] = shown.point[i];
      shown.coefficient[kept] = coefficient;
      points[kept] = points[i];
      ++kept;
    }
    shown.point.resize(kept);
    shown.coefficient.resize(kept);
    points.resize(kept);
  }
  if (!status) return status;
  Result<gather::Rows> rows = gather::gather_rows(context_, layer.mesh, layer.color_places, points,
                                                  {.negligible = kNegligible});
  if (!rows) return rows.status();
  shown.rows = std::move(*rows);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (shown.rows.begin[i] == shown.rows.begin[i + 1]) shown.coefficient[i] = 0;
  }
  return ok_status();
}

void StackWalk::take(const LayerInstance& instance, const ShownInstance& shown) {
  const bool is_left_out = is_mixed() || instance.blend != BlendMode::normal;
  for (std::size_t i = 0; i < shown.point.size(); ++i) {
    const std::uint32_t p = shown.point[i];
    through_[p] = std::max(through_[p] - shown.coefficient[i], 0.0f);
    if (is_left_out && shown.coefficient[i] > 0) leave_out(p);
  }
}

Status StackWalk::add(const LayerInstance& instance) {
  const std::optional<DrawnLayer>& layer = layers_[instance.layer];
  const Affine pixel_from_layer =
      inverse(picture_.artboard_from_pixel) * instance.artboard_from_layer;
  // A map onto a line paints nothing.
  if (!layer || instance.opacity == 0 || !std::isfinite(1 / pixel_from_layer.determinant())) {
    return ok_status();
  }
  ShownInstance shown;
  shown.layer = instance.layer;
  shown.layer_from_pixel = inverse(pixel_from_layer);
  Status status =
      prepare_shaders(layer->color_places.shader, drawing_.interpolation, out_.color_shaders);
  TableMemory memory("what a drawing shows");
  std::vector<Vec2> place;
  if (status) status = memory.reserve(context_, place, pixels_.point.size());
  if (!status) return status;
  for (const Vec2 p : pixels_.point) place.push_back(shown.layer_from_pixel(p));
  status = find_seen(place, *layer, instance, shown);
  if (!status) return status;
  take(instance, shown);
  const bool is_fitted = !is_mixed() && instance.blend == BlendMode::normal;
  if (is_fitted && !shown.point.empty()) out_.shown.push_back(std::move(shown));
  return ok_status();
}

Status StackWalk::add(const LocalStroke& stroke) {
  Result<raster::StrokePainter> painter = raster::StrokePainter::create(
      context_, stroke, inverse(picture_.artboard_from_pixel), drawing_.interpolation);
  if (!painter) return painter.status();
  const Box box = painter->bounds_px();
  if (box.empty()) return ok_status();
  const auto within = [](double at, int most) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(most)));
  };
  const int x0 = within(std::floor(box.min.x), picture_.width);
  const int x1 = within(std::ceil(box.max.x), picture_.width);
  const int y0 = within(std::floor(box.min.y), picture_.height);
  const int y1 = within(std::ceil(box.max.y), picture_.height);
  Status status;
  for (Plane& plane : stroke_) {
    if (status && plane.value.empty()) {
      status = make_plane(context_, picture_.width, picture_.height, memory_, plane);
    }
  }
  if (!status || x0 >= x1 || y0 >= y1) return status;
  const auto rows = static_cast<std::size_t>(y1 - y0);
  status = try_parallel_for(context_, rows, kPixelRows, [&](std::size_t begin, std::size_t end) {
    const int top = y0 + static_cast<int>(begin), height = static_cast<int>(end - begin);
    for (Plane& plane : stroke_) {
      for (int y = top; y < top + height; ++y) std::fill(plane.row(y) + x0, plane.row(y) + x1, 0.f);
    }
    const auto at = [&](std::size_t i) { return stroke_[i].row(top) + x0; };
    return painter->paint(x0, top, x1 - x0, height, at(0), at(1), at(2), at(3),
                          static_cast<std::size_t>(picture_.width));
  });
  if (!status) return status;
  for (std::size_t p = 0; p < through_.size(); ++p) {
    const std::uint32_t pixel = pixels_.pixel[pixel_of_[p]];
    const int x = static_cast<int>(pixel) % picture_.width;
    const int y = static_cast<int>(pixel) / picture_.width;
    if (x < x0 || x >= x1 || y < y0 || y >= y1) continue;
    const float alpha = stroke_[3].value[pixel];
    if (is_mixed() && alpha * through_[p] > kUnseen) leave_out(p);
    for (std::size_t c = 0; c < 3; ++c) {
      out_.fixed[p][c] += through_[p] * stroke_[c].value[pixel];
    }
    through_[p] *= 1 - alpha;
  }
  return ok_status();
}

}  // namespace

Result<StackPoints> look_through(Context& context, const Document& drawing,
                                 std::span<const std::optional<DrawnLayer>> layers,
                                 const LaidPicture& picture, const SamplePixels& pixels,
                                 const Rgb& backdrop) {
  return StackWalk(context, drawing, layers, picture, pixels).run(backdrop);
}

}  // namespace sfumato::tracing
