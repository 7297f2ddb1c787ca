#include "trace/curves/drawing_layers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/boxes.hpp"
#include "base/largest_scale.hpp"
#include "base/poll.hpp"
#include "base/segment.hpp"
#include "base/try.hpp"
#include "curves/attributes.hpp"
#include "mesh/mesher.hpp"
#include "solve/layers/layer_units.hpp"
#include "trace/curves/drawing_stops.hpp"

namespace sfumato::tracing {
namespace {

/// Chords may be so far from curves, pixels.
constexpr double kFlatnessPx = 0.1;
/// The largest pixel for the mesher, as a share of the artboard's longer side.
constexpr double kNominalSidePx = 1024;
/// Between the places at which a curve marks pixels, pixels.
constexpr double kMarkStepPx = 0.4;

/// Holds how instances show a layer.
struct Sight {
  Box box;                 ///< layer frame
  double px_per_unit = 0;  ///< of the instance that enlarges it most
};

Sight sight_of(const Document& drawing, std::uint32_t layer, const LaidPicture& picture) {
  Sight sight;
  for (const StackItem& item : drawing.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance || instance->layer != layer) continue;
    const Affine pixel_from_layer =
        inverse(picture.artboard_from_pixel) * instance->artboard_from_layer;
    const double scale = largest_scale(pixel_from_layer);
    if (!(scale > 0) || !std::isfinite(1 / pixel_from_layer.determinant())) continue;
    const Affine layer_from_pixel = inverse(pixel_from_layer);
    for (const double x : {0.0, static_cast<double>(picture.width)}) {
      for (const double y : {0.0, static_cast<double>(picture.height)}) {
        sight.box.extend(layer_from_pixel({x, y}));
      }
    }
    sight.px_per_unit = std::max(sight.px_per_unit, scale);
  }
  return sight;
}

Status mesh_layer(Context& context, const Sight& sight, const LaidPicture& picture,
                  DrawnLayer& layer) {
  mesh::MeshOptions meshing;
  const double longer = std::max(picture.width, picture.height);
  meshing.unit_size = std::min(longer / kNominalSidePx, 1.0) / sight.px_per_unit;
  const Box shown = united(sight.box, layer.opacity_box);
  meshing.frame = solve::within_coordinates(shown.grown_by(2 * meshing.unit_size));
  SFUMATO_TRY_ASSIGN(auto&& mesher, mesh::Mesher::build(context, layer.flat, meshing));
  SFUMATO_TRY_ASSIGN(layer.mesh, mesher.visibility_mesh(context));
  layer.frame = meshing.frame;
  layer.memory.take(mesher.release_extracted());
  return ok_status();
}

Status prepare_opacities(Context& context, const std::vector<Curve>& curves, DrawnLayer& layer) {
  SFUMATO_TRY_ASSIGN(layer.opacities,
                     curves::sample_opacities(context, layer.flat, curves, layer.memory));
  SFUMATO_TRY_ASSIGN(
      auto&& gatherer,
      gather::Gatherer::create(context, layer.mesh, *layer.opacities, gather::Ends::soft));
  layer.opacity_gatherer.emplace(std::move(gatherer));
  return ok_status();
}

/// Returns the box around all curves with opacity, including their blur.
Box box_of_opacity(const std::vector<Curve>& curves) {
  Box box;
  for (const Curve& curve : curves) {
    if (!curves::bears_opacity(curve)) continue;
    const Box around = box_of_points(curve.control_points);
    box = united(box, around.grown_by(double{largest_radius(curve)}));
  }
  return box.empty() ? box : box.grown_by(1e-3 * (box.width() + box.height()));
}

Status list_colors(const Context& context, const Document& drawing, std::uint32_t index,
                   DrawnLayer& layer) {
  for (const Curve& curve : drawing.layers[index].curves) {
    for (const Side* side : {&curve.left, &curve.right}) {
      if (side->color.kind != ShaderKind::curve_domain) continue;
      for (const Stop<Rgb>& stop : side->color.stops.stops) {
        const Rgb color = from_srgb(drawing.interpolation, stop.value);
        SFUMATO_TRY(layer.memory.push_back(context, layer.color, {color.r, color.g, color.b, 0}));
      }
    }
  }
  return ok_status();
}

/// Returns the smallest radius of a side.
double least_radius(const Side& side) {
  if (side.blur_radius.empty()) return 0;
  return std::ranges::min(side.blur_radius.stops, {}, &Stop<float>::value).value;
}

}  // namespace

Result<std::optional<DrawnLayer>> prepare_layer(Context& context, const Document& drawing,
                                                std::uint32_t layer, const LaidPicture& picture) {
  const std::vector<Curve>& curves = drawing.layers[layer].curves;
  const Sight sight = sight_of(drawing, layer, picture);
  if (curves.empty() || sight.box.empty()) return std::optional<DrawnLayer>();
  std::optional<DrawnLayer> out(std::in_place);
  out->px_per_unit = sight.px_per_unit;
  out->opacity_box = box_of_opacity(curves);
  const double tolerance = kFlatnessPx / sight.px_per_unit;
  curves::FlattenOptions flattening;
  flattening.focuses.push_back({sight.box, tolerance, tolerance});
  SFUMATO_TRY_ASSIGN(out->flat, curves::flatten(context, curves, flattening));
  SFUMATO_TRY(out->flat_charge.add(context, curves::bytes_of(out->flat), "flattening"));
  SFUMATO_TRY(mesh_layer(context, sight, picture, *out));
  SFUMATO_TRY_ASSIGN(
      out->color_places,
      curves::sample_stop_places(context, out->flat, curves, StopAttribute::color, out->memory));
  SFUMATO_TRY(list_colors(context, drawing, layer, *out));
  if (!out->opacity_box.empty()) SFUMATO_TRY(prepare_opacities(context, curves, *out));
  return out;
}

Status mark_sharp_curves(const Context& context, const std::vector<Curve>& curves,
                         const curves::FlatCurves& flat, const Affine& pixel_from_layer,
                         PixelMarks& marks) {
  const Box picture{{0, 0},
                    {static_cast<double>(marks.width()), static_cast<double>(marks.height())}};
  const double scale = largest_scale(pixel_from_layer);
  RarePoll<1024> poll(context);
  for (std::uint32_t v = 0; v + 1 < flat.vertex.size(); ++v) {
    if (poll.cancelled()) return context.cancel_status();
    if (!flat.begins_segment(v)) continue;
    const Curve& curve = curves[flat.vertex_curve[v]];
    if (scale * std::min(least_radius(curve.left), least_radius(curve.right)) > kSharpRadiusPx) {
      continue;
    }
    const Vec2 a = pixel_from_layer(flat.vertex[v]), b = pixel_from_layer(flat.vertex[v + 1]);
    const auto [from, to] = part_within(picture, a, b);
    if (!(from <= to)) continue;
    const double way = (to - from) * length(b - a);
    const int steps = 1 + static_cast<int>(way / kMarkStepPx);
    for (int i = 0; i <= steps; ++i) marks.cross(lerp(a, b, from + (to - from) * i / steps));
  }
  return ok_status();
}

}  // namespace sfumato::tracing
