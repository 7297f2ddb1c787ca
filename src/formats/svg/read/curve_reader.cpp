#include "formats/svg/read/curve_reader.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "document/rules.hpp"
#include "formats/svg/read/curve_attributes.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

bool has_no_length(const Subpath& subpath) {
  const Vec2 first = subpath.control_points.front();
  return std::ranges::all_of(subpath.control_points, [first](Vec2 p) { return p == first; });
}

std::string numbered(std::string_view id, std::size_t index) {
  std::string name(id);
  if (!name.empty() && index > 0) name += "-" + std::to_string(index + 1);
  return name;
}

/// Puts the stops of a shape on one of its subpaths.
class StopPlacer {
 public:
  /// scale: of radii
  StopPlacer(Input& input, Element shape, const Subpath& subpath, double scale)
      : input_(input), shape_(shape), subpath_(subpath), scale_(scale) {}

  Status place_side(const WrittenSide& written, Side& side) {
    Status status = place_shader(written.color, side.color);
    if (status) status = place_shader(written.opacity, side.opacity);
    return status ? place_radii(written.blur_radius, side.blur_radius) : status;
  }

  /// No list where all are 0.
  Status place_radii(const std::vector<WrittenStop<float>>& written, ScalarStops& list) {
    const auto is_zero = [](const WrittenStop<float>& stop) { return stop.value == 0; };
    if (std::ranges::all_of(written, is_zero)) return ok_status();
    Status status = place(written, list);
    for (Stop<float>& stop : list.stops) {
      const double radius = std::min(stop.value * scale_, limits::kCoordinate);
      stop.value = static_cast<float>(radius);
    }
    return status;
  }

  template <class Value>
  Status place(const std::vector<WrittenStop<Value>>& written, StopList<Value>& list) {
    Status status = input_.memory().stops.reserve(input_.context(), list.stops, written.size());
    if (!status) return input_.placed(shape_, std::move(status));
    place_stops<Value>(written, subpath_.segment_begin, list, beyond_end_);
    return status;
  }

  /// Returns whether a stop was moved to the end.
  bool beyond_end() const { return beyond_end_; }

 private:
  template <class Value>
  Status place_shader(const WrittenShader<Value>& written, SideShader<Value>& shader) {
    shader.kind = written.kind;
    shader.shader = written.shader;
    return written.kind == ShaderKind::curve_domain ? place(written.stops, shader.stops)
                                                    : ok_status();
  }

  Input& input_;
  Element shape_;
  const Subpath& subpath_;
  double scale_;
  bool beyond_end_ = false;
};

void warn_of_end(Input& input, Element shape, bool beyond_end) {
  if (!beyond_end) return;
  input.warn("/beyond end", shape,
             "a stop of " + tag(shape) + " lies beyond the last segment; it is moved to the end");
}

/// Maps points into a table that is as long as they are.
Status map_points(Input& input, Element shape, const Affine& map, std::span<const Vec2> points,
                  std::vector<Vec2>& mapped) {
  Status status = input.memory().curves.reserve(input.context(), mapped, points.size());
  if (!status) return input.placed(shape, std::move(status));
  RarePoll<16384> poll(input.context());
  for (const Vec2& point : points) {
    if (poll.cancelled()) return input.context().cancel_status();
    if (rules::is_coordinate(mapped.emplace_back(map(point)))) continue;
    return input.error(shape, tag(shape) + " reaches farther than " +
                                  std::to_string(static_cast<long>(limits::kCoordinate)) +
                                  " from the origin; keep coordinates within that");
  }
  return ok_status();
}

}  // namespace

Result<std::vector<Subpath>> CurveReader::read_subpaths(Element shape, TableMemory& memory) {
  SFUMATO_TRY_ASSIGN(auto&& subpaths, read_shape(input_, shape, viewport_, memory));
  std::size_t removed_points = 0;
  const std::size_t removed = std::erase_if(subpaths, [&](const Subpath& subpath) {
    const bool is_removed = has_no_length(subpath);
    if (is_removed) removed_points += subpath.control_points.size();
    return is_removed;
  });
  SFUMATO_TRY(totals_.count_curves(shape, removed, removed_points));
  if (removed > 0 || subpaths.empty()) {
    input_.warn("/no length", shape,
                tag(shape) + " has a part of no length, or draws nothing; that is left out");
  }
  return std::move(subpaths);
}

Status CurveReader::read_curves(Element shape, const Affine& layer_from_user, std::string_view id,
                                std::vector<Curve>& curves, std::vector<CurveSource>& sources) {
  TableMemory point_memory("control points"), stop_memory("stops");
  SFUMATO_TRY_ASSIGN(const std::vector<Subpath>& subpaths, read_subpaths(shape, point_memory));
  if (subpaths.empty()) return ok_status();
  SFUMATO_TRY_ASSIGN(const Box& box, bounds(input_.context(), subpaths));
  SFUMATO_TRY_ASSIGN(const CurveAttributes& attributes,
                     read_curve_attributes(input_, paints_,
                                           {shape, layer_from_user, box, viewport_}, stop_memory));
  const double determinant = layer_from_user.determinant();
  const double scale = std::sqrt(std::abs(determinant));
  bool beyond_end = false;
  for (std::size_t i = 0; i < subpaths.size(); ++i) {
    const Subpath& subpath = subpaths[i];
    StopPlacer placer(input_, shape, subpath, scale);
    SFUMATO_TRY(begin_curve(shape, subpath, attributes.stop_count(), curves));
    Curve& curve = curves.back();
    curve.id = numbered(id, i);
    curve.weight = attributes.weight;
    SFUMATO_TRY(
        map_points(input_, shape, layer_from_user, subpath.control_points, curve.control_points));
    SFUMATO_TRY(placer.place_side(attributes.left, curve.left));
    SFUMATO_TRY(placer.place_side(attributes.right, curve.right));
    if (determinant < 0) std::swap(curve.left, curve.right);
    const std::size_t offset = input_.offset(shape);
    SFUMATO_TRY(input_.push_back(shape, input_.memory().curves, sources,
                                 offset > 0 ? CurveSource{offset, subpath.index} : CurveSource{}));
    beyond_end |= placer.beyond_end();
  }
  warn_of_end(input_, shape, beyond_end);
  return ok_status();
}

template <class AnyCurve>
Status CurveReader::begin_curve(Element shape, const Subpath& subpath, std::size_t stop_count,
                                std::vector<AnyCurve>& curves) {
  Status status = totals_.count_curves(shape, 1, subpath.control_points.size());
  if (status) status = totals_.count_stops(shape, stop_count);
  return status ? input_.push_back(shape, input_.memory().curves, curves, {}) : status;
}

Status CurveReader::read_local_curves(Element shape, std::string_view id,
                                      std::vector<LocalCurve>& curves) {
  TableMemory point_memory("control points"), stop_memory("stops");
  SFUMATO_TRY_ASSIGN(const std::vector<Subpath>& subpaths, read_subpaths(shape, point_memory));
  SFUMATO_TRY_ASSIGN(const LocalAttributes& attributes,
                     read_local_attributes(input_, shape, stop_memory));
  bool beyond_end = false;
  for (std::size_t i = 0; i < subpaths.size(); ++i) {
    const Subpath& subpath = subpaths[i];
    StopPlacer placer(input_, shape, subpath, 1);
    SFUMATO_TRY(begin_curve(shape, subpath, attributes.stop_count(), curves));
    LocalCurve& curve = curves.back();
    curve.id = numbered(id, i);
    curve.alpha = attributes.alpha;
    SFUMATO_TRY(map_points(input_, shape, {}, subpath.control_points, curve.control_points));
    SFUMATO_TRY(placer.place(attributes.left_color, curve.left_color));
    SFUMATO_TRY(placer.place(attributes.right_color, curve.right_color));
    SFUMATO_TRY(placer.place_radii(attributes.blur_radius, curve.blur_radius));
    SFUMATO_TRY(placer.place_radii(attributes.influence_radius, curve.influence_radius));
    beyond_end |= placer.beyond_end();
  }
  warn_of_end(input_, shape, beyond_end);
  return ok_status();
}

}  // namespace sfumato::svg
