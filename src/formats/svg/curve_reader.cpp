#include "formats/svg/curve_reader.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "formats/svg/curve_attributes.hpp"
#include "formats/svg/shapes.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// A vector of curves while it grows holds them twice.
constexpr std::size_t kGrowth = 2;

bool has_no_length(const Subpath& subpath) {
  const Vec2 first = subpath.control_points.front();
  return std::ranges::all_of(subpath.control_points, [first](Vec2 p) { return p == first; });
}

std::string numbered(std::string_view id, std::size_t index) {
  std::string name(id);
  if (!name.empty() && index > 0) name += "-" + std::to_string(index + 1);
  return name;
}

template <class Value>
SideShader<Value> placed_shader(const WrittenShader<Value>& written, const Subpath& subpath,
                                bool& beyond_end) {
  SideShader<Value> shader{written.kind, {}, written.shader};
  if (written.kind == ShaderKind::curve_domain) {
    shader.stops = place_stops(written.stops, subpath.segment_begin, beyond_end);
  }
  return shader;
}

/// Radii times `scale`; no list where all are 0.
ScalarStops placed_radii(const std::vector<WrittenStop<float>>& written, const Subpath& subpath,
                         double scale, bool& beyond_end) {
  const auto is_zero = [](const WrittenStop<float>& stop) { return stop.value == 0; };
  if (std::ranges::all_of(written, is_zero)) return {};
  ScalarStops stops = place_stops(written, subpath.segment_begin, beyond_end);
  for (Stop<float>& stop : stops.stops) {
    const double radius = std::min(stop.value * scale, limits::kCoordinate);
    stop.value = static_cast<float>(radius);
  }
  return stops;
}

Side placed_side(const WrittenSide& written, const Subpath& subpath, double scale,
                 bool& beyond_end) {
  return {placed_shader(written.color, subpath, beyond_end),
          placed_shader(written.opacity, subpath, beyond_end),
          placed_radii(written.blur_radius, subpath, scale, beyond_end)};
}

void warn_of_end(Input& input, Element shape, bool beyond_end) {
  if (!beyond_end) return;
  input.warn("/beyond end", shape,
             "a stop of " + tag(shape) + " lies beyond the last segment; it is moved to the end");
}

bool is_coordinate(Vec2 p) {
  return std::abs(p.x) <= limits::kCoordinate && std::abs(p.y) <= limits::kCoordinate;
}

Status map_points(Input& input, Element shape, const Affine& map, std::vector<Vec2>& points) {
  for (Vec2& point : points) {
    point = map(point);
    if (is_coordinate(point)) continue;
    return input.error(shape, tag(shape) + " reaches farther than " +
                                  std::to_string(static_cast<long>(limits::kCoordinate)) +
                                  " from the origin; expected coordinates within that");
  }
  return ok_status();
}

}  // namespace

Result<std::vector<Subpath>> CurveReader::read_subpaths(Element shape) {
  Result<std::vector<Subpath>> subpaths = read_shape(input_, shape, viewport_);
  if (!subpaths) return subpaths;
  std::size_t removed_points = 0;
  const std::size_t removed = std::erase_if(*subpaths, [&](const Subpath& subpath) {
    const bool is_removed = has_no_length(subpath);
    if (is_removed) removed_points += subpath.control_points.size();
    return is_removed;
  });
  if (Status status = totals_.count_curves(shape, removed, removed_points); !status) return status;
  if (removed > 0 || subpaths->empty()) {
    input_.warn("/no length", shape,
                tag(shape) + " has a part of no length, or draws nothing; that is left out");
  }
  return subpaths;
}

Status CurveReader::read_curves(Element shape, const Affine& layer_from_user, std::string_view id,
                                std::vector<Curve>& curves) {
  Result<std::vector<Subpath>> subpaths = read_subpaths(shape);
  if (!subpaths) return subpaths.status();
  if (subpaths->empty()) return ok_status();
  const Result<CurveAttributes> attributes =
      read_curve_attributes(input_, paints_, {shape, layer_from_user, bounds(*subpaths)});
  if (!attributes) return attributes.status();
  const double determinant = layer_from_user.determinant();
  const double scale = std::sqrt(std::abs(determinant));
  bool beyond_end = false;
  for (std::size_t i = 0; i < subpaths->size(); ++i) {
    Subpath& subpath = (*subpaths)[i];
    Status status =
        totals_.add_curve(shape, subpath.control_points.size(), kGrowth * sizeof(Curve));
    if (status) status = totals_.add_stops(shape, attributes->stop_count(), sizeof(Stop<Rgb>));
    if (status) status = map_points(input_, shape, layer_from_user, subpath.control_points);
    if (!status) return status;
    Curve& curve = curves.emplace_back();
    curve.id = numbered(id, i);
    curve.weight = attributes->weight;
    curve.left = placed_side(attributes->left, subpath, scale, beyond_end);
    curve.right = placed_side(attributes->right, subpath, scale, beyond_end);
    if (determinant < 0) std::swap(curve.left, curve.right);
    curve.control_points = std::move(subpath.control_points);
  }
  warn_of_end(input_, shape, beyond_end);
  return ok_status();
}

Status CurveReader::read_local_curves(Element shape, std::string_view id,
                                      std::vector<LocalCurve>& curves) {
  Result<std::vector<Subpath>> subpaths = read_subpaths(shape);
  if (!subpaths) return subpaths.status();
  const Result<LocalAttributes> attributes = read_local_attributes(input_, shape);
  if (!attributes) return attributes.status();
  bool beyond_end = false;
  for (std::size_t i = 0; i < subpaths->size(); ++i) {
    Subpath& subpath = (*subpaths)[i];
    Status status =
        totals_.add_curve(shape, subpath.control_points.size(), kGrowth * sizeof(LocalCurve));
    if (status) status = totals_.add_stops(shape, attributes->stop_count(), sizeof(Stop<Rgb>));
    if (status) status = map_points(input_, shape, {}, subpath.control_points);
    if (!status) return status;
    const auto& segments = subpath.segment_begin;
    LocalCurve& curve = curves.emplace_back();
    curve.id = numbered(id, i);
    curve.left_color = place_stops(attributes->left_color, segments, beyond_end);
    curve.right_color = place_stops(attributes->right_color, segments, beyond_end);
    curve.blur_radius = placed_radii(attributes->blur_radius, subpath, 1, beyond_end);
    curve.influence_radius = placed_radii(attributes->influence_radius, subpath, 1, beyond_end);
    curve.alpha = attributes->alpha;
    curve.control_points = std::move(subpath.control_points);
  }
  warn_of_end(input_, shape, beyond_end);
  return ok_status();
}

}  // namespace sfumato::svg
