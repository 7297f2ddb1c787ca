#include "patches/layer_scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.hpp"

namespace sfumato::patches {
namespace {

/// Chords stray from their curve by at most this, as a fraction of the artboard's longer side…
constexpr double kTolerancePerSide = 0.1 / 512;
/// …and inside the viewport by at most this many pixels, so that no facet shows at any zoom.
constexpr double kTolerancePx = 0.2;

/// Lengths of the mesher are counted in pixels of an artboard that is this many pixels long.
constexpr double kNominalSidePx = 1024;

/// Below this weld, in nominal pixels, nearly coincident curves make slivers without end.
constexpr double kFinestWeldPx = 1.0 / 128;

/// Refinement stops where a triangle's longest edge falls below this many pixels.
constexpr double kSmallestEdgePx = 1.0;

double longer_side(const Box& box) {
  return std::max(box.width(), box.height());
}

curves::FlattenOptions flatten_options(const Box& artboard, const Box& viewport,
                                       const DiffuseOptions& options) {
  curves::FlattenOptions flatten;
  if (options.tolerance) {
    flatten.tolerance = *options.tolerance;
    flatten.outside_tolerance = *options.tolerance;
    return flatten;
  }
  flatten.outside_tolerance = kTolerancePerSide * longer_side(artboard);
  flatten.tolerance = std::min(flatten.outside_tolerance, kTolerancePx / options.pixels_per_unit);
  flatten.focus = viewport;
  return flatten;
}

mesh::MeshOptions mesh_options(const Box& artboard, const Box& viewport,
                               const DiffuseOptions& options) {
  mesh::MeshOptions mesh;
  mesh.unit_size = std::min(longer_side(artboard) / kNominalSidePx, 1 / options.pixels_per_unit);
  // Beyond the viewport by more than the weld can move the frame.
  mesh.frame = viewport.grown_by(2 * mesh.unit_size);
  // The weld moves curves: it must not undo a finer tolerance that was asked for.
  if (options.tolerance) {
    mesh.weld_px =
        std::clamp(0.5 * *options.tolerance / mesh.unit_size, kFinestWeldPx, mesh.weld_px);
  }
  mesh.min_angle_deg = options.min_angle_deg;
  const Box whole = united(artboard, viewport);
  mesh.max_area = options.max_area_fraction * whole.width() * whole.height();
  return mesh;
}

}  // namespace

Status validate(const DiffuseOptions& options) {
  const auto wrong = [](const char* what) { return make_error(StatusCode::bad_input, what); };
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  if (!positive(options.pixels_per_unit)) return wrong("pixels per unit must be above 0");
  if (options.tolerance && !positive(*options.tolerance)) {
    return wrong("the flattening tolerance must be above 0");
  }
  if (!(options.min_angle_deg >= 0 && options.min_angle_deg <= 33)) {
    return wrong("the minimum angle must be from 0 to 33 degrees");
  }
  if (!(options.max_area_fraction > 0 && options.max_area_fraction <= 1)) {
    return wrong("the maximum area must be above 0 and at most 1 (100%) of the artboard");
  }
  if (!(std::isfinite(options.max_error) && options.max_error >= 0)) {
    return wrong("the maximum error must be 0 (off) or more code values");
  }
  if (options.gather.rays_per_node < 1 || options.gather.rays_per_node > limits::kRays) {
    return wrong("the number of rays must be from 1 to 4096");
  }
  if (options.viewport) {
    const Box& box = *options.viewport;
    if (!is_finite(box.min) || !is_finite(box.max) || !(box.width() > 0 && box.height() > 0)) {
      return wrong("the viewport must have a width and a height above 0");
    }
  }
  return ok_status();
}

Result<LayerScene> prepare_layer(Context& context, const Layer& layer, const Box& artboard,
                                 const Box& viewport, const DiffuseOptions& options,
                                 DiffuseStats* stats) {
  const Stopwatch geometry_watch;
  const mesh::MeshOptions meshing = mesh_options(artboard, viewport, options);
  Result<curves::FlatCurves> flat =
      curves::flatten(context, layer.curves, flatten_options(artboard, viewport, options));
  if (!flat) return flat.status();
  curves::SegmentAttributes attributes = curves::sample_colors(*flat, layer.curves);
  const double geometry_seconds = geometry_watch.seconds();

  const Stopwatch mesh_watch;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, meshing);
  if (!mesher) return mesher.status();
  const mesh::TriangleMesh visibility = mesher->visibility_mesh();
  const double mesh_seconds = mesh_watch.seconds();

  const Stopwatch gather_watch;
  Result<gather::Gatherer> gatherer = gather::Gatherer::create(context, visibility, attributes);
  if (!gatherer) return gatherer.status();
  if (stats) {
    stats->curves += layer.curves.size();
    stats->segments += flat->segment_count();
    stats->geometry_seconds += geometry_seconds;
    stats->triangulation_seconds += mesh_seconds;
    stats->gather_seconds += gather_watch.seconds();
  }
  return LayerScene{std::move(*flat),   std::move(attributes),
                    std::move(*mesher), std::move(*gatherer),
                    meshing.frame,      kSmallestEdgePx / options.pixels_per_unit};
}

}  // namespace sfumato::patches
