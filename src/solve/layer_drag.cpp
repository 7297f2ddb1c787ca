#include "solve/layer_drag.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "solve/layer_units.hpp"

namespace sfumato::solve {
namespace {

/// The curve may be dragged this far beyond what is shown, in widths and heights of it.
constexpr double kRoom = 1;

Box with_room_around(const Box& box) {
  const Vec2 more{kRoom * box.width(), kRoom * box.height()};
  return {box.min - more, box.max + more};
}

/// Puts the polyline of one more curve after those of others.
void append(const curves::FlatCurves& one, curves::FlatCurves& all) {
  const std::uint32_t curve = all.curve_count();
  all.vertex.insert(all.vertex.end(), one.vertex.begin(), one.vertex.end());
  all.parameter.insert(all.parameter.end(), one.parameter.begin(), one.parameter.end());
  all.arc_length.insert(all.arc_length.end(), one.arc_length.begin(), one.arc_length.end());
  all.vertex_curve.resize(all.vertex.size(), curve);
  all.curve_begin.push_back(static_cast<std::uint32_t>(all.vertex.size()));
}

/// Per vertex: 1 for those in [begin, end).
Result<std::vector<std::uint8_t>> marked(const Context& context, std::size_t count,
                                         std::uint32_t begin, std::uint32_t end,
                                         TableMemory& memory) {
  std::vector<std::uint8_t> marks;
  Status status = memory.resize(context, marks, count);
  if (!status) return status;
  std::fill(marks.begin() + begin, marks.begin() + end, std::uint8_t{1});
  return marks;
}

/// The layer's curves with the one that moves where it is now, after all others.
struct Placed {
  curves::FlatCurves flat;
  std::vector<Curve> curves;
  std::uint32_t first = 0;  ///< the first vertex of its polyline
  ScopedCharge charge;
};

}  // namespace

struct LayerDrag::State {
  State(const Box& of_document, InterpolationSpace space, std::vector<Curve> of_layer,
        std::uint32_t curve, const LayerSight& layer_sight, const DiffuseOptions& diffuse_options)
      : options(diffuse_options),
        sight(layer_sight),
        artboard(of_document),
        interpolation(space),
        curves(std::move(of_layer)),
        moving(curve),
        is_joint(curves::opacity_goes_with_color(curves)),
        units(artboard, sight, options) {}

  Status begin(Context& context, std::optional<RefinedLayer>& refined);
  bool has_fields_with(const Curve& curve) const;
  Result<PatchLayer> frame(Context& context, const Curve& curve, DiffuseStats* stats,
                           std::optional<RoundWatch> watch) const;

  DiffuseOptions options;
  LayerSight sight;
  Box artboard;
  InterpolationSpace interpolation;
  std::vector<Curve> curves;  ///< with the one that moves as it was
  std::uint32_t moving;       ///< which of them it is
  bool is_joint;              ///< as FlatLayer
  bool has_room = false;      ///< of the meshes
  LayerUnits units;
  ScopedCharge charge;                     ///< of the polylines and curves
  curves::FlatCurves flat;                 ///< of `curves`
  std::optional<mesh::Mesher> visibility;  ///< without the curve that moves, not refined
  std::optional<LayerSolver> base;         ///< the layer without it

 private:
  std::size_t bytes_of_curves() const {
    std::size_t bytes = 0;
    for (const Curve& curve : curves) bytes += bytes_of(curve);
    return bytes;
  }
  /// Errors: as LayerDrag::frame.
  Result<Placed> place(Context& context, const Curve& curve) const;
  /// The layer on a mesh, ready to be solved or continued. `patches` is moved from on success only.
  Result<LayerSolver> solver(Context& context, const curves::FlatCurves& polylines,
                             std::span<const Curve> of, mesh::Mesher& seen, mesh::Mesher&& patches,
                             const FieldEdits& edits, DiffuseStats* stats = nullptr,
                             std::optional<RoundWatch> watch = {}) const;
  Status mesh_layer(Context& context);
  Status take_off(Context& context, const LayerSolver& whole,
                  std::span<const std::uint8_t> is_removed);
};

Result<LayerSolver> LayerDrag::State::solver(Context& context, const curves::FlatCurves& polylines,
                                             std::span<const Curve> of, mesh::Mesher& seen,
                                             mesh::Mesher&& patches, const FieldEdits& edits,
                                             DiffuseStats* stats,
                                             std::optional<RoundWatch> watch) const {
  const Result<mesh::TriangleMesh> mesh = seen.visibility_mesh(context);
  if (!mesh) return mesh.status();
  Result<SampledFields> sampled = sample_fields(context, {polylines, of, interpolation, is_joint},
                                                options, units.smallest_radius());
  if (!sampled) return sampled.status();
  Result<PreparedFields> fields =
      prepare_fields(context, seen, *mesh, std::move(*sampled), options.ends, edits);
  if (!fields) return fields.status();
  return LayerSolver(
      context,
      PreparedLayer{std::move(patches), std::move(fields->color), std::move(fields->opacity),
                    units.mesh_options().frame, units.smallest_edge()},
      options, stats, watch);
}

Status LayerDrag::State::begin(Context& context, std::optional<RefinedLayer>& refined) {
  has_room = !refined;
  Status status = mesh_layer(context);
  if (!status) return status;
  TableMemory memory("a drag");
  const Result<std::vector<std::uint8_t>> moves = marked(
      context, flat.vertex.size(), flat.curve_begin[moving], flat.curve_begin[moving + 1], memory);
  if (!moves) return moves.status();
  std::optional<mesh::Mesher> unrefined;
  if (!refined) {
    Result<mesh::Mesher> copy = visibility->copy(context);
    if (!copy) return copy.status();
    unrefined.emplace(std::move(*copy));
  }
  mesh::Mesher& patches = refined ? refined->mesher : *unrefined;
  Result<LayerSolver> whole =
      solver(context, flat, curves, *visibility, std::move(patches), {.use = {*moves}});
  if (!whole) return whole.status();
  if (!refined) {
    status = whole->refine();
    return status ? take_off(context, *whole, *moves) : status;
  }
  whole->resume(std::move(refined->nodes));
  status = take_off(context, *whole, *moves);
  *refined = whole->release();
  return status;
}

/// Makes the polylines of all curves and their mesh.
Status LayerDrag::State::mesh_layer(Context& context) {
  Result<curves::FlatCurves> polylines = curves::flatten(context, curves, units.flatten_options());
  if (!polylines) return polylines.status();
  flat = std::move(*polylines);
  Status status = charge.add(context, curves::bytes_of(flat) + bytes_of_curves(), "a drag");
  if (!status) return status;
  mesh::MeshOptions meshing = units.mesh_options();
  if (has_room) meshing.room = with_room_around(meshing.frame);
  Result<mesh::Mesher> built = mesh::Mesher::build(context, flat, meshing);
  if (!built) return built.status();
  visibility.emplace(std::move(*built));
  return status;
}

Status LayerDrag::State::take_off(Context& context, const LayerSolver& whole,
                                  std::span<const std::uint8_t> is_removed) {
  const mesh::MeshEdit edit{is_removed, static_cast<std::uint32_t>(flat.vertex.size())};
  Status status = visibility->edit(context, flat, edit, false);
  if (!status) return status;
  Result<mesh::Mesher> patches = whole.mesher().copy(context);
  if (!patches) return patches.status();
  status = patches->edit(context, flat, edit, true);
  if (status) status = patches->bake(context);
  if (!status) return status;
  Result<LayerSolver> rest = solver(context, flat, curves, *visibility, std::move(*patches),
                                    {.use = {.will_be_extended = true}});
  if (!rest) return rest.status();
  base.emplace(std::move(*rest));
  status = base->continue_from(whole);
  return status ? base->prepare_to_be_edited() : status;
}

/// Whether the layer has the same fields with the curve in its place.
bool LayerDrag::State::has_fields_with(const Curve& curve) const {
  return is_joint ==
         (curves::opacity_goes_with_color(curves) && curves::opacity_goes_with_color({&curve, 1}));
}

Result<Placed> LayerDrag::State::place(Context& context, const Curve& curve) const {
  const Result<curves::FlatCurves> moved =
      curves::flatten(context, {&curve, 1}, units.flatten_options());
  if (!moved) return moved.status();
  Placed placed;
  Status status = placed.charge.add(
      context,
      curves::bytes_of(flat) + curves::bytes_of(*moved) + bytes_of_curves() + bytes_of(curve),
      "a drag");
  if (!status) return status;
  placed.first = static_cast<std::uint32_t>(flat.vertex.size());
  placed.flat = flat;
  append(*moved, placed.flat);
  placed.curves = curves;
  placed.curves.push_back(curve);
  if (!visibility->holds(placed.flat, placed.first)) {
    return make_error(StatusCode::bad_input, "the curve is dragged too far beyond the picture");
  }
  if (!has_fields_with(curve)) {
    return make_error(StatusCode::bad_input, "the dragged curve changes the layer's fields");
  }
  return placed;
}

Result<PatchLayer> LayerDrag::State::frame(Context& context, const Curve& curve,
                                           DiffuseStats* stats,
                                           std::optional<RoundWatch> watch) const {
  const Result<Placed> placed = place(context, curve);
  if (!placed) return placed.status();
  const mesh::MeshEdit edit{{}, placed->first};
  TableMemory memory("a drag");
  const auto vertices = static_cast<std::uint32_t>(placed->flat.vertex.size());
  const Result<std::vector<std::uint8_t>> moves =
      marked(context, vertices, placed->first, vertices, memory);
  if (!moves) return moves.status();
  Result<mesh::Mesher> seen = visibility->copy(context);
  if (!seen) return seen.status();
  Status status = seen->edit(context, placed->flat, edit, false);
  if (!status) return status;
  Result<mesh::Mesher> patches = base->mesher().copy(context);
  if (!patches) return patches.status();
  status = patches->edit(context, placed->flat, edit, true);
  if (!status) return status;
  const Result<std::vector<std::uint8_t>> is_same =
      seen->same_triangles(context, *visibility, memory);
  if (!is_same) return is_same.status();
  const FieldEdits edits{{*moves}, &base->color(), base->opacity(), *is_same};
  Result<LayerSolver> now = solver(context, placed->flat, placed->curves, *seen,
                                   std::move(*patches), edits, stats, watch);
  if (!now) return now.status();
  status = now->continue_inserted(*base, *moves, *is_same);
  if (!status) return status;
  return now->take();
}

LayerDrag::LayerDrag(std::unique_ptr<State> state) : state_(std::move(state)) {}
LayerDrag::LayerDrag(LayerDrag&&) noexcept = default;
LayerDrag& LayerDrag::operator=(LayerDrag&&) noexcept = default;
LayerDrag::~LayerDrag() = default;

Result<LayerDrag> LayerDrag::begin(Context& context, const Document& document, std::uint32_t layer,
                                   std::uint32_t curve, const LayerSight& sight,
                                   const DiffuseOptions& options,
                                   std::optional<RefinedLayer>& refined) {
  auto state = std::make_unique<State>(document.artboard, document.interpolation,
                                       document.layers[layer].curves, curve, sight, options);
  Status status = state->begin(context, refined);
  if (!status) return status;
  return LayerDrag(std::move(state));
}

bool LayerDrag::has_room() const {
  return state_->has_room;
}

bool LayerDrag::needs_room(const Curve& curve) const {
  const Box roomy = with_room_around(state_->units.mesh_options().frame);
  const auto is_in_it = [&](Vec2 p) { return roomy.contains(p); };
  return !has_room() && state_->has_fields_with(curve) &&
         std::ranges::all_of(curve.control_points, is_in_it);
}

Result<LayerDrag> LayerDrag::with_room(Context& context) const {
  const State& now = *state_;
  auto state = std::make_unique<State>(now.artboard, now.interpolation, now.curves, now.moving,
                                       now.sight, now.options);
  std::optional<RefinedLayer> none;
  Status status = state->begin(context, none);
  if (!status) return status;
  return LayerDrag(std::move(state));
}

Result<PatchLayer> LayerDrag::frame(Context& context, const Curve& curve, DiffuseStats* stats,
                                    std::optional<RoundWatch> watch) const {
  return state_->frame(context, curve, stats, watch);
}

}  // namespace sfumato::solve
