#include "solve/prepare_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/charge.hpp"
#include "base/poll.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "curves/flatten.hpp"
#include "sfumato/base/limits.hpp"
#include "solve/layer_view.hpp"

namespace sfumato::solve {
namespace {

struct Tolerance {
  /// Chords stray from their curve by at most this, as a fraction of the artboard's longer side…
  double per_side;
  /// …and inside the viewport by at most this many pixels, so that no facet shows at any zoom.
  double px;
};

/// One pixel of a thousand shows that chords are not the curve.
constexpr Tolerance kTolerance{0.05 / 512, 0.04};

/// Of the paper's mesh, which is the one without a bound on the error.
constexpr Tolerance kPaperTolerance{0.1 / 512, 0.2};

/// A mesh as fine as a smaller radius would be all triangles: antialiasing shows those blurs.
constexpr double kSmallestRadiusPx = 0.75;

/// Chords of a curve that is blurred by less than this are those of an edge.
constexpr double kEdgeRadiusPx = 0.25;

/// Lengths of the mesher are counted in pixels of an artboard that is this many pixels long.
constexpr double kNominalSidePx = 1024;

/// Below this weld, in nominal pixels, nearly coincident curves make slivers without end.
constexpr double kFinestWeldPx = 1.0 / 128;

/// Refinement stops where a triangle's longest edge falls below this many pixels…
constexpr double kSmallestEdgePx = 1.0;
/// …and below this many no triangle is made smaller for its angles, or n curves within a pixel
/// would take n times n triangles. Those of a whole pixel show where colours change within a tenth
/// of one.
constexpr double kSmallAnglesEdgePx = 0.5;

double longer_side(const Box& box) {
  return std::max(box.width(), box.height());
}

Box within_coordinates(const Box& box) {
  const auto clamped = [](Vec2 p) {
    return Vec2{std::clamp(p.x, -limits::kCoordinate, limits::kCoordinate),
                std::clamp(p.y, -limits::kCoordinate, limits::kCoordinate)};
  };
  return {clamped(box.min), clamped(box.max)};
}

/// Lengths and areas of the artboard as they are in a layer's frame.
class LayerUnits {
 public:
  LayerUnits(const Box& artboard, const LayerSight& sight, const DiffuseOptions& options)
      : sight_(sight), options_(options), artboard_side_(longer_side(artboard) / sight.scale) {
    const Box whole = united(artboard, options.viewport.value_or(artboard));
    // A small instance shows far more of the layer than the artboard's size. What is thinner than
    // a pixel is drawn on a frame of some pixels: a share of its area would be out of proportion.
    const auto side = [&](double length) { return std::max(length / sight.scale, pixel()); };
    whole_area_ = std::max(side(whole.width()) * side(whole.height()),
                           sight.viewport.width() * sight.viewport.height());
  }

  double pixel() const { return 1 / (options_.pixels_per_unit * sight_.scale); }

  /// Of the blurs that a mesh shows.
  double smallest_radius() const { return kSmallestRadiusPx * pixel(); }

  curves::FlattenOptions flatten_options() const {
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
    const Tolerance& tolerance = options_.max_error > 0 ? kTolerance : kPaperTolerance;
    for (const LayerView& view : sight_.views) {
      const double outside = tolerance.per_side * artboard_side_ * (sight_.scale / view.scale);
      const double inside = tolerance.px / (options_.pixels_per_unit * view.scale);
      flatten.focuses.push_back({view.window, std::min(outside, inside), outside});
    }
    return flatten;
  }

  mesh::MeshOptions mesh_options() const {
    mesh::MeshOptions mesh;
    mesh.unit_size = std::min(artboard_side_ / kNominalSidePx, pixel());
    // Beyond the viewport by more than the weld can move the frame, where there are coordinates.
    mesh.frame = within_coordinates(sight_.viewport.grown_by(2 * mesh.unit_size));
    // The weld moves curves: it must not undo a finer tolerance that was asked for.
    if (options_.tolerance) {
      const double tolerance = *options_.tolerance / sight_.scale;
      mesh.weld_px = std::clamp(0.5 * tolerance / mesh.unit_size, kFinestWeldPx, mesh.weld_px);
    }
    mesh.min_angle_deg = options_.min_angle_deg;
    mesh.max_area = options_.max_area_fraction * whole_area_;
    // Without a bound on the error the mesh is the paper's.
    if (options_.max_error > 0) mesh.small_edge = kSmallAnglesEdgePx * pixel();
    return mesh;
  }

 private:
  const LayerSight& sight_;
  const DiffuseOptions& options_;
  double artboard_side_;
  double whole_area_;
};

/// The longest image of a unit vector.
double largest_scale(const Affine& m) {
  const double squares = m.a * m.a + m.b * m.b + m.c * m.c + m.d * m.d;
  const double determinant = m.determinant();
  const double rest = std::sqrt(std::max(0.0, squares * squares - 4 * determinant * determinant));
  return std::sqrt(0.5 * (squares + rest));
}

/// Unites the view with those of about its scale.
void add_view(const LayerView& view, std::vector<LayerView>& views) {
  const auto same = std::ranges::find(views, std::ilogb(view.scale),
                                      [](const LayerView& v) { return std::ilogb(v.scale); });
  if (same == views.end()) return views.push_back(view);
  same->window = united(same->window, view.window);
  same->scale = std::max(same->scale, view.scale);
}

bool bears_opacity(const Curve& curve) {
  return curve.left.opacity.kind != ShaderKind::open ||
         curve.right.opacity.kind != ShaderKind::open;
}

/// Per constraint: 1 where a curve on it bears the attribute, on either side.
Result<std::vector<std::uint8_t>> bearing_constraints(const Context& context,
                                                      const mesh::TriangleMesh& mesh,
                                                      const curves::SegmentAttributes& attributes,
                                                      TableMemory& memory) {
  std::vector<std::uint8_t> bears;
  Status status = memory.resize(context, bears, mesh.constraint.size());
  if (!status) return status;
  for (std::size_t c = 0; c < bears.size(); ++c) {
    for (const mesh::SegmentPiece& piece : mesh.pieces(mesh.constraint[c])) {
      bears[c] |= attributes.left[piece.segment].kind != ShaderKind::open ||
                  attributes.right[piece.segment].kind != ShaderKind::open;
    }
  }
  return bears;
}

/// Whether any curve, of which the frame is none, lies where the attribute is not borne.
bool is_thin(const mesh::TriangleMesh& mesh, const std::vector<std::uint8_t>& bears) {
  for (std::size_t c = 0; c < bears.size(); ++c) {
    if (!bears[c] && !mesh.pieces(mesh.constraint[c]).empty()) return true;
  }
  return false;
}

Result<PreparedField> prepare_field(Context& context, const mesh::Mesher& mesher,
                                    const mesh::TriangleMesh& visibility,
                                    curves::SegmentAttributes attributes, TableMemory memory,
                                    gather::Ends ends) {
  TableMemory scratch("the visibility mesh");
  const Result<std::vector<std::uint8_t>> bears =
      bearing_constraints(context, visibility, attributes, scratch);
  if (!bears) return bears.status();
  mesh::TriangleMesh thinned;
  const bool is_thinned = is_thin(visibility, *bears);
  if (is_thinned) {
    Result<mesh::TriangleMesh> mesh = mesher.thinned_mesh(context, visibility, *bears, scratch);
    if (!mesh) return mesh.status();
    thinned = std::move(*mesh);
  }
  Result<gather::Gatherer> gatherer =
      gather::Gatherer::create(context, is_thinned ? thinned : visibility, attributes, ends);
  if (!gatherer) return gatherer.status();
  return PreparedField{std::move(attributes), std::move(memory), std::move(*gatherer)};
}

/// What may be looked at: the triangles' vertices are coordinates like any others.
Status check_sight(const LayerSight& sight, const Layer& layer) {
  const Box& seen = sight.viewport;
  const double reach = std::max({-seen.min.x, -seen.min.y, seen.max.x, seen.max.y});
  if (reach <= limits::kCoordinate) return ok_status();
  const std::string name = layer.id.empty() ? "a layer" : "layer \"" + layer.id + '"';
  return make_error(StatusCode::limit,
                    "the picture shows coordinates of " + name + " beyond the limit of " +
                        std::to_string(static_cast<std::int64_t>(limits::kCoordinate)) +
                        ": a transform or the viewport reaches too far");
}

void add_instance(const LayerInstance& instance, const Box& viewport, LayerSight& sight) {
  const Affine& map = instance.artboard_from_layer;
  const LayerView view{bounds_of_mapped(inverse(map), viewport), largest_scale(map)};
  sight.viewport = united(sight.viewport, view.window);
  if (!(view.scale > 0)) return;
  sight.scale = sight.views.empty() ? view.scale : std::max(sight.scale, view.scale);
  add_view(view, sight.views);
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
  if (options.order > PatchOrder::cubic) return wrong("an unknown order of patches");
  if (options.gather.method > gather::Method::rays) return wrong("an unknown method to gather by");
  if (options.ends > gather::Ends::paper) return wrong("ends must be soft or paper");
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

LayerSight sight_of_layer(const Document& document, std::uint32_t layer, const Box& viewport) {
  LayerSight sight;
  for (const StackItem& item : document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (instance && instance->layer == layer) add_instance(*instance, viewport, sight);
  }
  return sight;
}

Result<std::vector<LayerSight>> sights_of_layers(const Context& context, const Document& document,
                                                 const Box& viewport) {
  std::vector<LayerSight> sights;
  TableMemory memory("layers");
  Status status = memory.resize(context, sights, document.layers.size());
  if (!status) return status;
  RarePoll<1024> poll(context);
  for (const StackItem& item : document.stack) {
    if (poll.cancelled()) return context.cancel_status();
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (instance) add_instance(*instance, viewport, sights[instance->layer]);
  }
  return sights;
}

Result<PreparedLayer> prepare_layer(Context& context, const Document& document, std::uint32_t layer,
                                    const LayerSight& sight, const DiffuseOptions& options,
                                    DiffuseStats* stats, LayerUse use) {
  const Stopwatch geometry_watch;
  const std::vector<Curve>& curves = document.layers[layer].curves;
  const LayerUnits units(document.artboard, sight, options);
  const mesh::MeshOptions meshing = units.mesh_options();
  if (Status status = check_sight(sight, document.layers[layer]); !status) return status;
  Result<curves::FlatCurves> flat = curves::flatten(context, curves, units.flatten_options());
  if (!flat) return flat.status();
  const bool is_joint = use == LayerUse::patches && curves::opacity_goes_with_color(curves);
  ScopedCharge flat_charge;
  Status status = flat_charge.add(context, curves::bytes_of(*flat), "flattening");
  if (!status) return status;
  const auto sample = is_joint ? curves::sample_colors_and_opacities : curves::sample_colors;
  TableMemory color_memory("attributes");
  Result<curves::SegmentAttributes> colors =
      sample(context, *flat, curves, document.interpolation, color_memory);
  if (!colors) return colors.status();
  const double geometry_seconds = geometry_watch.seconds();

  const Stopwatch mesh_watch;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, meshing);
  if (!mesher) return mesher.status();
  const Result<mesh::TriangleMesh> visible = mesher->visibility_mesh(context);
  if (!visible) return visible.status();
  const mesh::TriangleMesh& visibility = *visible;
  const double mesh_seconds = mesh_watch.seconds();

  const Stopwatch gather_watch;
  const auto drop_blur = [&](curves::SegmentAttributes& attributes) {
    if (options.ignore_blur) curves::remove_blur(attributes);
    if (use == LayerUse::patches) curves::set_fine_blur(attributes, units.smallest_radius());
  };
  drop_blur(*colors);
  Result<PreparedField> color = prepare_field(context, *mesher, visibility, std::move(*colors),
                                              std::move(color_memory), options.ends);
  if (!color) return color.status();
  std::optional<PreparedField> opacity;
  if (!is_joint && std::ranges::any_of(curves, bears_opacity)) {
    TableMemory memory("attributes");
    Result<curves::SegmentAttributes> opacities =
        curves::sample_opacities(context, *flat, curves, memory);
    if (!opacities) return opacities.status();
    drop_blur(*opacities);
    Result<PreparedField> field = prepare_field(context, *mesher, visibility, std::move(*opacities),
                                                std::move(memory), options.ends);
    if (!field) return field.status();
    opacity.emplace(std::move(*field));
  }
  if (stats) {
    stats->curves += curves.size();
    stats->segments += flat->segment_count();
    stats->geometry_seconds += geometry_seconds;
    stats->triangulation_seconds += mesh_seconds;
    stats->gather_seconds += gather_watch.seconds();
  }
  return PreparedLayer{std::move(*mesher), std::move(*color), std::move(opacity), meshing.frame,
                       kSmallestEdgePx * units.pixel()};
}

}  // namespace sfumato::solve
