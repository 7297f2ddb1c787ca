#include "trace/fit/stack_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/parallel.hpp"
#include "base/pixel_rect.hpp"
#include "base/try.hpp"
#include "raster/layers/local_stroke.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {
namespace {

/// Rows of pixels that one task paints.
constexpr std::size_t kPixelRows = 64;

float largest(const FourFloats& channels) {
  return std::max({channels[0], channels[1], channels[2]});
}

/// The contribution of an unfitted item to a point: premultiplied code values and alpha.
using Source = FourFloats;

class StackWalk {
 public:
  StackWalk(Context& context, const Document& drawing,
            std::span<const std::optional<DrawnLayer>> layers, const LaidPicture& picture,
            const SamplePixels& pixels)
      : context_(context),
        drawing_(drawing),
        layers_(layers),
        picture_(picture),
        pixels_(pixels),
        looker_(context, drawing, layers, pixels) {}

  Result<StackPoints> run(const Rgb& backdrop);

 private:
  /// A group whose items are being followed.
  struct Level {
    GroupBegin group;
    bool is_source = false;           ///< it is followed separately, since it has a mode
    std::vector<FourFloats> through;  ///< of the stack above it
    std::vector<FourFloats> fixed;    ///< if it is a source: of the stack above it
    TableMemory memory{"what a drawing shows"};
  };

  Status begin();
  Status find_kept_layers();
  Status follow();
  Status add(const LayerInstance& instance);
  Status add(const LocalStroke& stroke);
  Status enter(const GroupBegin& group);
  Status leave();
  Status add_kept(const LayerInstance& instance, const InstanceSight& sight);
  Status add_fitted(const LayerInstance& instance, InstanceSight sight);
  void mix(std::size_t point, const Source& source, BlendMode mode);
  Result<PixelRect> paint(const LocalStroke& stroke);
  void leave_out(std::size_t point) { out_.is_left_out[out_.pixel_of[point]] = 1; }

  Context& context_;
  const Document& drawing_;
  std::span<const std::optional<DrawnLayer>> layers_;
  const LaidPicture& picture_;
  const SamplePixels& pixels_;
  LayerLooker looker_;
  StackPoints out_;
  std::vector<std::uint8_t> is_kept_;        ///< per layer: whether its colours are not fitted
  std::vector<const GroupBegin*> begin_of_;  ///< per item: of the group that ends there
  std::vector<FourFloats> through_;  ///< per point: the light that passes all items so far, 0 to 1
  std::vector<Level> levels_;
  std::array<Plane, 4> stroke_;  ///< a stroke painted onto nothing, premultiplied
  TableMemory memory_{"what a drawing shows"};
};

Status StackWalk::begin() {
  const std::size_t points = pixels_.point.size(), pixels = pixels_.pixel.size();
  SFUMATO_TRY(memory_.resize(context_, through_, points, {1, 1, 1, 0}));
  SFUMATO_TRY(out_.memory.resize(context_, out_.pixel_of, points));
  SFUMATO_TRY(out_.memory.resize(context_, out_.fixed, points));
  SFUMATO_TRY(out_.memory.resize(context_, out_.is_left_out, pixels));
  for (std::uint32_t i = 0; i < pixels; ++i) {
    for (std::uint32_t p = pixels_.point_begin[i]; p < pixels_.point_begin[i + 1]; ++p) {
      out_.pixel_of[p] = i;
    }
  }
  return find_kept_layers();
}

Status StackWalk::find_kept_layers() {
  is_kept_.resize(drawing_.layers.size());
  SFUMATO_TRY(memory_.resize(context_, begin_of_, drawing_.stack.size()));
  std::vector<const GroupBegin*> open;
  std::size_t mixed = 0;
  for (std::size_t i = 0; i < drawing_.stack.size(); ++i) {
    const StackItem& item = drawing_.stack[i];
    if (const auto* group = std::get_if<GroupBegin>(&item)) {
      open.push_back(group);
      mixed += group->blend != BlendMode::normal;
    } else if (std::holds_alternative<GroupEnd>(item)) {
      begin_of_[i] = open.back();
      mixed -= open.back()->blend != BlendMode::normal;
      open.pop_back();
    } else if (const auto* instance = std::get_if<LayerInstance>(&item)) {
      if (mixed > 0 || instance->blend != BlendMode::normal) is_kept_[instance->layer] = 1;
    }
  }
  return ok_status();
}

Status StackWalk::follow() {
  for (std::size_t i = drawing_.stack.size(); i-- > 0;) {
    SFUMATO_TRY(context_.check());
    const StackItem& item = drawing_.stack[i];
    if (const auto* instance = std::get_if<LayerInstance>(&item)) SFUMATO_TRY(add(*instance));
    if (const auto* stroke = std::get_if<LocalStroke>(&item)) SFUMATO_TRY(add(*stroke));
    if (begin_of_[i]) SFUMATO_TRY(enter(*begin_of_[i]));
    if (std::holds_alternative<GroupBegin>(item)) SFUMATO_TRY(leave());
  }
  return ok_status();
}

Result<StackPoints> StackWalk::run(const Rgb& backdrop) {
  SFUMATO_TRY(begin());
  SFUMATO_TRY(follow());
  for (std::size_t p = 0; p < through_.size(); ++p) {
    mix(p, {backdrop.r, backdrop.g, backdrop.b, 1}, BlendMode::normal);
  }
  for (ShownInstance& shown : out_.shown) {
    for (std::size_t i = 0; i < shown.coefficient.size(); ++i) {
      if (out_.is_left_out[out_.pixel_of[shown.sight.point[i]]]) shown.coefficient[i] = {};
    }
  }
  out_.color_shaders = looker_.take_color_shaders();
  return std::move(out_);
}

/// Composites fixed items under all items so far.
void StackWalk::mix(std::size_t point, const Source& source, BlendMode mode) {
  const auto& [r, g, b, alpha] = source;
  FourFloats& through = through_[point];
  const bool is_known =
      mode == BlendMode::normal ||
      (levels_.empty() && (mode == BlendMode::multiply || mode == BlendMode::screen));
  if (!is_known && alpha * largest(through) > kUnseen) leave_out(point);
  for (std::size_t c = 0; c < 3; ++c) {
    // Premultiplied, over an opaque colour C: s C + (1 - a) C, and s + (1 - s) C.
    if (mode != BlendMode::multiply) out_.fixed[point][c] += through[c] * source[c];
    const float passes = mode == BlendMode::multiply ? source[c] + 1 - alpha
                         : mode == BlendMode::screen ? 1 - source[c]
                                                     : 1 - alpha;
    through[c] *= std::max(passes, 0.0f);
  }
}

/// A group with a mode is followed separately where it may show.
Status StackWalk::enter(const GroupBegin& group) {
  Level level;
  level.group = group;
  level.is_source = group.blend != BlendMode::normal;
  SFUMATO_TRY(level.memory.assign(context_, through_, level.through));
  if (level.is_source) {
    SFUMATO_TRY(level.memory.assign(context_, out_.fixed, level.fixed));
    std::ranges::fill(out_.fixed, FourFloats{});
  }
  for (FourFloats& through : through_) {
    for (std::size_t c = 0; c < 3; ++c) {
      through[c] =
          level.is_source ? (largest(through) > kUnseen ? 1.0f : 0.0f) : through[c] * group.opacity;
    }
  }
  levels_.push_back(std::move(level));
  return ok_status();
}

/// A group of opacity g whose items let P pass lets 1 - g + g P pass.
Status StackWalk::leave() {
  const Level level = std::move(levels_.back());
  levels_.pop_back();
  if (!level.is_source) {
    for (std::size_t p = 0; p < through_.size(); ++p) {
      for (std::size_t c = 0; c < 3; ++c) {
        through_[p][c] += level.through[p][c] * (1 - level.group.opacity);
      }
    }
    return context_.check();
  }
  for (std::size_t p = 0; p < through_.size(); ++p) {
    const float opacity = level.group.opacity;
    const FourFloats& own = out_.fixed[p];
    const float alpha = largest(level.through[p]) > kUnseen ? 1 - through_[p][0] : 0.0f;
    const Source source{opacity * own[0], opacity * own[1], opacity * own[2], opacity * alpha};
    through_[p] = level.through[p];
    out_.fixed[p] = level.fixed[p];
    mix(p, source, level.group.blend);
  }
  return context_.check();
}

Status StackWalk::add(const LayerInstance& instance) {
  const Affine pixel_from_layer =
      inverse(picture_.artboard_from_pixel) * instance.artboard_from_layer;
  // A map onto a line paints nothing.
  const bool is_shown = layers_[instance.layer] && instance.opacity > 0 &&
                        std::isfinite(1 / pixel_from_layer.determinant());
  if (!is_shown) return ok_status();
  SFUMATO_TRY_ASSIGN(
      auto&& sight,
      looker_.look(instance.layer, inverse(pixel_from_layer), [&](std::uint32_t point) {
        return instance.opacity * largest(through_[point]) > kUnseen;
      }));
  if (sight.point.empty()) return ok_status();
  return is_kept_[instance.layer] ? add_kept(instance, sight)
                                  : add_fitted(instance, std::move(sight));
}

Status StackWalk::add_kept(const LayerInstance& instance, const InstanceSight& sight) {
  TableMemory memory("what a drawing shows");
  std::vector<Rgb> code;
  SFUMATO_TRY(memory.resize(context_, code, sight.point.size()));
  SFUMATO_TRY(looker_.find_colors(instance.layer, sight, code));
  for (std::size_t i = 0; i < code.size(); ++i) {
    const float alpha = instance.opacity * sight.opacity[i];
    mix(sight.point[i], {alpha * code[i].r, alpha * code[i].g, alpha * code[i].b, alpha},
        instance.blend);
  }
  return ok_status();
}

Status StackWalk::add_fitted(const LayerInstance& instance, InstanceSight sight) {
  ShownInstance shown;
  shown.layer = instance.layer;
  SFUMATO_TRY(sight.memory.resize(context_, shown.coefficient, sight.point.size()));
  for (std::size_t i = 0; i < sight.point.size(); ++i) {
    FourFloats& through = through_[sight.point[i]];
    FourFloats& coefficient = shown.coefficient[i];
    const float alpha = instance.opacity * sight.opacity[i];
    for (std::size_t c = 0; c < 3; ++c) {
      coefficient[c] = alpha * through[c];
      through[c] *= 1 - alpha;
    }
    coefficient[3] = std::min({coefficient[0], coefficient[1], coefficient[2]});
  }
  shown.sight = std::move(sight);
  out_.shown.push_back(std::move(shown));
  return ok_status();
}

/// Paints a local curve into `stroke_`. Returns the pixels that it may touch.
Result<PixelRect> StackWalk::paint(const LocalStroke& stroke) {
  SFUMATO_TRY_ASSIGN(
      const raster::StrokePainter& painter,
      raster::StrokePainter::create(context_, stroke, inverse(picture_.artboard_from_pixel),
                                    drawing_.interpolation));
  const Box box = painter.bounds_px();
  if (box.empty()) return PixelRect{};
  const auto within = [](double at, int most) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(most)));
  };
  const PixelRect rect{
      within(std::floor(box.min.x), picture_.width), within(std::floor(box.min.y), picture_.height),
      within(std::ceil(box.max.x), picture_.width), within(std::ceil(box.max.y), picture_.height)};
  for (Plane& plane : stroke_) {
    if (!plane.value.empty()) continue;
    SFUMATO_TRY(make_plane(context_, picture_.width, picture_.height, memory_, plane));
  }
  if (rect.empty()) return rect;
  const auto rows = static_cast<std::size_t>(rect.y1 - rect.y0);
  SFUMATO_TRY(try_parallel_for(context_, rows, kPixelRows, [&](std::size_t begin, std::size_t end) {
    const int top = rect.y0 + static_cast<int>(begin), height = static_cast<int>(end - begin);
    for (Plane& plane : stroke_) {
      for (int y = top; y < top + height; ++y) {
        std::fill(plane.row(y) + rect.x0, plane.row(y) + rect.x1, 0.0f);
      }
    }
    const auto at = [&](std::size_t i) { return stroke_[i].row(top) + rect.x0; };
    return painter.paint(context_, rect.x0, top, rect.x1 - rect.x0, height, at(0), at(1), at(2),
                         at(3), static_cast<std::size_t>(picture_.width));
  }));
  return rect;
}

Status StackWalk::add(const LocalStroke& stroke) {
  SFUMATO_TRY_ASSIGN(const PixelRect& rect, paint(stroke));
  if (rect.empty()) return ok_status();
  for (std::size_t p = 0; p < through_.size(); ++p) {
    const std::uint32_t pixel = pixels_.pixel[out_.pixel_of[p]];
    const int x = static_cast<int>(pixel) % picture_.width;
    const int y = static_cast<int>(pixel) / picture_.width;
    if (x < rect.x0 || x >= rect.x1 || y < rect.y0 || y >= rect.y1) continue;
    const Source source{stroke_[0].value[pixel], stroke_[1].value[pixel], stroke_[2].value[pixel],
                        stroke_[3].value[pixel]};
    mix(p, source, BlendMode::normal);
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
