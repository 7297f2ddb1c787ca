#include "solve/layers/layer_units.hpp"

#include <algorithm>
#include <limits>

#include "base/boxes.hpp"
#include "sfumato/base/limits.hpp"
#include "solve/layers/rough.hpp"

namespace sfumato::solve {
namespace {

struct Tolerance {
  /// Chords deviate from their curve by at most this, as a fraction of the artboard's longer side…
  double per_side;
  /// …and inside the viewport by at most this many pixels, so that no facet shows at any zoom.
  double px;
};

/// One pixel of a thousand shows that chords are not the curve.
constexpr Tolerance kTolerance{0.05 / 512, 0.04};

/// The tolerance of the paper's mesh, which has no bound on the error.
constexpr Tolerance kPaperTolerance{0.1 / 512, 0.2};

/// The tolerance for a pixel grid, where pixels correct what chords miss.
constexpr double kGridTolerancePx = 0.2;

/// The tolerance of a layer that is solved roughly.
constexpr Tolerance kRoughTolerance{kRoughness * kTolerance.per_side, kRoughness* kTolerance.px};

/// A mesh as fine as a smaller radius would consist of triangles only: antialiasing shows those
/// blurs.
constexpr double kSmallestRadiusPx = 0.75;
/// The same for a pixel grid, whose blurs show at no other size.
constexpr double kGridRadiusPx = 1.5;

/// A curve with a smaller blur radius than this gets the chords of an edge.
constexpr double kEdgeRadiusPx = 0.25;

/// Lengths of the mesher are counted in pixels of an artboard that is this many pixels long.
constexpr double kNominalSidePx = 1024;

/// Below this weld, in nominal pixels, nearly coincident curves make slivers without end.
constexpr double kFinestWeldPx = 1.0 / 128;

/// Refinement stops where a triangle's longest edge falls below this many pixels…
constexpr double kSmallestEdgePx = 1.0;
/// …and below this many no triangle is made smaller for its angles, or n curves within a pixel
/// would take n times n triangles. With triangles of a whole pixel it would show where colours
/// change within a tenth of one.
constexpr double kSmallAnglesEdgePx = 0.5;
/// Both bounds for a rough layer: on edges of this many pixels nodes are a third of it apart, which
/// is near enough for any blur that a mesh has to show.
constexpr double kRoughEdgePx = 4;
/// Both bounds for a pixel grid: smaller triangles cost more than their pixels.
constexpr double kGridEdgePx = 3.5;

/// Curves that move may reach this far beyond the visible part, in its widths and heights.
constexpr double kRoom = 1;

const Tolerance& tolerance_of(const DiffuseOptions& options) {
  if (is_rough(options)) return kRoughTolerance;
  return options.max_error > 0 ? kTolerance : kPaperTolerance;
}

double small_angles_edge_px(const DiffuseOptions& options) {
  if (is_rough(options)) return kRoughEdgePx;
  return is_for_pixel_grid(options) ? kGridEdgePx : kSmallAnglesEdgePx;
}

}  // namespace

Box within_coordinates(const Box& box) {
  const auto clamped = [](Vec2 p) {
    return Vec2{std::clamp(p.x, -limits::kCoordinate, limits::kCoordinate),
                std::clamp(p.y, -limits::kCoordinate, limits::kCoordinate)};
  };
  return {clamped(box.min), clamped(box.max)};
}

LayerUnits::LayerUnits(const Box& artboard, const LayerSight& sight, const DiffuseOptions& options)
    : sight_(sight), options_(options), artboard_side_(longer_side(artboard) / sight.scale) {
  const Box whole = united(artboard, options.viewport.value_or(artboard));
  // A small instance shows far more of the layer than the artboard's size. A part thinner than a
  // pixel is drawn on a frame of some pixels: a share of its area would be out of proportion.
  const auto side = [&](double length) { return std::max(length / sight.scale, pixel()); };
  whole_area_ = std::max(side(whole.width()) * side(whole.height()),
                         sight.viewport.width() * sight.viewport.height());
}

double LayerUnits::smallest_radius() const {
  return (is_for_pixel_grid(options_) ? kGridRadiusPx : kSmallestRadiusPx) * pixel();
}

SmallestEdges LayerUnits::smallest_edges() const {
  const double blurred = (is_rough(options_) ? kRoughEdgePx : kSmallestEdgePx) * pixel();
  return {is_for_pixel_grid(options_) ? kGridEdgePx * pixel() : blurred, blurred};
}

curves::FlattenOptions LayerUnits::flatten_options() const {
  const mesh::MeshOptions meshing = mesh_options();
  curves::FlattenOptions flatten;
  flatten.reach = meshing.weld_px * meshing.unit_size;
  flatten.sharp_radius =
      options_.ignore_blur ? std::numeric_limits<double>::infinity() : kEdgeRadiusPx * pixel();
  flatten.split_radius = smallest_radius();
  if (options_.tolerance) {
    flatten.tolerance = *options_.tolerance / sight_.scale;
    return flatten;
  }
  const Tolerance& tolerance = tolerance_of(options_);
  const bool for_grid = is_for_pixel_grid(options_);
  for (const LayerView& view : sight_.views) {
    const double view_pixel = 1 / (options_.pixels_per_unit * view.scale);
    const double outside = tolerance.per_side * artboard_side_ * (sight_.scale / view.scale);
    const double inside =
        for_grid ? kGridTolerancePx * view_pixel : std::min(outside, tolerance.px * view_pixel);
    flatten.focuses.push_back({view.window, inside, std::max(inside, outside)});
  }
  flatten.keeps_bows = for_grid;
  return flatten;
}

mesh::MeshOptions LayerUnits::mesh_options() const {
  mesh::MeshOptions mesh;
  mesh.unit_size = std::min(artboard_side_ / kNominalSidePx, pixel());
  // Extends beyond the viewport by more than the weld can move the frame, within the range of
  // coordinates.
  mesh.frame = within_coordinates(sight_.viewport.grown_by(2 * mesh.unit_size));
  // The weld moves curves: it must not undo a finer tolerance of the options.
  if (options_.tolerance) {
    const double tolerance = *options_.tolerance / sight_.scale;
    mesh.weld_px = std::clamp(0.5 * tolerance / mesh.unit_size, kFinestWeldPx, mesh.weld_px);
  }
  mesh.min_angle_deg = options_.min_angle_deg;
  mesh.max_area = options_.max_area_fraction * whole_area_;
  // Without a bound on the error the mesh is the paper's.
  if (options_.max_error > 0) {
    mesh.small_edge = small_angles_edge_px(options_) * pixel();
  }
  return mesh;
}

Box LayerUnits::roomy_frame() const {
  const Box frame = mesh_options().frame;
  const Vec2 more{kRoom * frame.width(), kRoom * frame.height()};
  return {frame.min - more, frame.max + more};
}

}  // namespace sfumato::solve
