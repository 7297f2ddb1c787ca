#include "solve/layer_drag.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "solve/layer_units.hpp"
#include "solve/placed_curves.hpp"

namespace sfumato::solve {
namespace {

/// The curve may be dragged this far beyond what is shown, in widths and heights of it.
constexpr double kRoom = 1;

Box with_room_around(const Box& box) {
  const Vec2 more{kRoom * box.width(), kRoom * box.height()};
  return {box.min - more, box.max + more};
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

/// What a frame leaves for the next one, which uses its tables again.
struct LastFrame {
  std::optional<PlacedCurves> placed{};
  std::optional<mesh::Mesher> seen{};         ///< the visibility mesh with the curve
  mesh::TriangleMesh seen_mesh{};             ///< handed out by it
  std::vector<std::uint32_t> seen_changed{};  ///< triangles of it that the frame changed
  FrameTables tables{};
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

  Status begin(Context& context, const std::optional<RefinedLayer>& refined);
  bool has_fields_with(const Curve& curve) const;
  Result<FramePatches> frame(Context& context, const Curve& curve, bool keeps, FramePatches spare,
                             const FrameOptions& how);

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
  mesh::TriangleMesh visibility_mesh;      ///< handed out by it
  std::optional<LayerSolver> base;         ///< the layer without it
  const Budget* budget = nullptr;          ///< that all this is charged to
  LastFrame last;

 private:
  std::size_t bytes_of_curves() const {
    std::size_t bytes = 0;
    for (const Curve& curve : curves) bytes += bytes_of(curve);
    return bytes;
  }
  Status place(Context& context, const Curve& curve, LastFrame& frame) const;
  Result<std::vector<std::uint8_t>> insert_curve(const Context& context, LastFrame& frame,
                                                 TableMemory& memory) const;
  Result<mesh::Mesher> patches_with(const Context& context, LastFrame& frame) const;
  Result<SampledFields> sample(const Context& context, const curves::FlatCurves& polylines,
                               std::span<const Curve> of, bool has_opacity = false) const;
  Result<SampledFields> sample_frame(const Context& context, LastFrame& frame) const;
  LayerSolver solver(Context& context, PreparedFields fields, mesh::Mesher&& patches,
                     DiffuseStats* stats = nullptr, std::optional<RoundWatch> watch = {}) const;
  Result<PreparedFields> fields(Context& context, const mesh::Mesher& mesher,
                                const mesh::TriangleMesh& mesh, const FieldEdits& edits) const;
  Status mesh_layer(Context& context);
  Result<RefinedLayer> solve(Context& context) const;
  Status take_off(Context& context, const RefinedLayer& refined);
};

/// has_opacity   as FlatLayer's
Result<SampledFields> LayerDrag::State::sample(const Context& context,
                                               const curves::FlatCurves& polylines,
                                               std::span<const Curve> of, bool has_opacity) const {
  return sample_fields(context, {polylines, of, interpolation, is_joint, has_opacity}, options,
                       units.smallest_radius());
}

/// The layer on a mesh, ready to be solved or continued.
LayerSolver LayerDrag::State::solver(Context& context, PreparedFields fields,
                                     mesh::Mesher&& patches, DiffuseStats* stats,
                                     std::optional<RoundWatch> watch) const {
  return LayerSolver(
      context,
      PreparedLayer{std::move(patches), std::move(fields.color), std::move(fields.opacity),
                    units.mesh_options().frame, units.smallest_edge()},
      options, stats, watch);
}

/// Of the layer's own curves.
/// mesh   mesher.visibility_mesh()
Result<PreparedFields> LayerDrag::State::fields(Context& context, const mesh::Mesher& mesher,
                                                const mesh::TriangleMesh& mesh,
                                                const FieldEdits& edits) const {
  Result<SampledFields> sampled = sample(context, flat, curves);
  if (!sampled) return sampled.status();
  return prepare_fields(context, mesher, mesh, std::move(*sampled), options.ends, edits);
}

Status LayerDrag::State::begin(Context& context, const std::optional<RefinedLayer>& refined) {
  has_room = !refined;
  budget = &context.budget;
  Status status = mesh_layer(context);
  if (!status || refined) return status ? take_off(context, *refined) : status;
  Result<RefinedLayer> solved = solve(context);
  return solved ? take_off(context, *solved) : solved.status();
}

/// The layer as it is.
Result<RefinedLayer> LayerDrag::State::solve(Context& context) const {
  Result<mesh::Mesher> whole = visibility->copy(context);
  if (!whole) return whole.status();
  const Result<mesh::TriangleMesh> mesh = whole->visibility_mesh(context);
  if (!mesh) return mesh.status();
  Result<PreparedFields> prepared = fields(context, *whole, *mesh, {});
  if (!prepared) return prepared.status();
  return solver(context, std::move(*prepared), std::move(*whole)).refine_only();
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

/// refined   of the layer as it is
Status LayerDrag::State::take_off(Context& context, const RefinedLayer& refined) {
  TableMemory memory("a drag");
  const Result<std::vector<std::uint8_t>> moves = marked(
      context, flat.vertex.size(), flat.curve_begin[moving], flat.curve_begin[moving + 1], memory);
  if (!moves) return moves.status();
  const mesh::MeshEdit edit{*moves, static_cast<std::uint32_t>(flat.vertex.size())};
  Result<mesh::Mesher> whole = visibility->copy(context);
  if (!whole) return whole.status();
  Status status = visibility->edit(context, flat, edit, false);
  if (!status) return status;
  Result<mesh::TriangleMesh> mesh = visibility->visibility_mesh(context);
  if (!mesh) return mesh.status();
  visibility_mesh = std::move(*mesh);
  Result<PreparedFields> rest =
      fields(context, *visibility, visibility_mesh, {.use = {.will_be_extended = true}});
  if (!rest) return rest.status();
  const Result<std::vector<std::uint8_t>> is_same =
      visibility->same_triangles(context, *whole, memory);
  if (!is_same) return is_same.status();
  const Result<mesh::TriangleMesh> whole_mesh = whole->visibility_mesh(context);
  if (!whole_mesh) return whole_mesh.status();
  const Result<PreparedFields> with =
      fields(context, *whole, *whole_mesh,
             {.use = {*moves},
              .color_before = &rest->color,
              .opacity_before = rest->opacity ? &*rest->opacity : nullptr,
              .is_same = *is_same});
  if (!with) return with.status();
  Result<mesh::Mesher> patches = refined.mesher.copy(context);
  if (!patches) return patches.status();
  status = patches->edit(context, flat, edit, true);
  if (!status) return status;
  base.emplace(solver(context, std::move(*rest), std::move(*patches)));
  return base->continue_without(
      {refined.nodes, with->color, with->opacity ? &*with->opacity : nullptr, *is_same});
}

/// Whether the layer has the same fields with the curve in its place.
bool LayerDrag::State::has_fields_with(const Curve& curve) const {
  return is_joint ==
         (curves::opacity_goes_with_color(curves) && curves::opacity_goes_with_color({&curve, 1}));
}

/// Errors: as LayerDrag::frame.
Status LayerDrag::State::place(Context& context, const Curve& curve, LastFrame& frame) const {
  Result<PlacedCurves> placed = place_curve(context, flat, curves, curve, units.flatten_options(),
                                            std::exchange(frame.placed, std::nullopt));
  if (!placed) return placed.status();
  if (!visibility->holds(placed->flat, placed->first)) {
    return make_error(StatusCode::bad_input, "the curve is dragged too far beyond the picture");
  }
  if (!has_fields_with(curve)) {
    return make_error(StatusCode::bad_input, "the dragged curve changes the layer's fields");
  }
  frame.placed.emplace(std::move(*placed));
  return ok_status();
}

/// Makes the frame's visibility mesh, and says which triangles it has in common with that without
/// the curve: Mesher::same_triangles.
Result<std::vector<std::uint8_t>> LayerDrag::State::insert_curve(const Context& context,
                                                                 LastFrame& frame,
                                                                 TableMemory& memory) const {
  const bool is_first = !frame.seen;
  if (is_first) {
    Result<mesh::Mesher> copy = visibility->copy(context);
    if (!copy) return copy.status();
    frame.seen.emplace(std::move(*copy));
  } else if (Status status = frame.seen->copy_from(context, *visibility); !status) {
    return status;
  }
  mesh::Mesher& seen = *frame.seen;
  Status status = seen.edit(context, frame.placed->flat, {{}, frame.placed->first}, false);
  if (!status) return status;
  Result<std::vector<std::uint8_t>> is_same = seen.same_triangles(context, *visibility, memory);
  if (!is_same) return is_same;
  if (is_first) {
    Result<mesh::TriangleMesh> copy = seen.copy_mesh(context, visibility_mesh);
    if (!copy) return copy.status();
    frame.seen_mesh = std::move(*copy);
  } else {
    mesh::Mesher::take_back(visibility_mesh, frame.seen_changed, frame.seen_mesh);
  }
  status = seen.update_visibility_mesh(context, *is_same, frame.seen_mesh, frame.seen_changed);
  if (!status) return status;
  return is_same;
}

/// The base's patch mesh with the curve.
Result<mesh::Mesher> LayerDrag::State::patches_with(const Context& context,
                                                    LastFrame& frame) const {
  std::optional<mesh::Mesher> patches = std::exchange(frame.tables.mesher, std::nullopt);
  Status status;
  if (patches) {
    status = patches->copy_from(context, base->mesher());
  } else {
    Result<mesh::Mesher> copy = base->mesher().copy(context);
    if (!copy) return copy;
    patches.emplace(std::move(*copy));
  }
  if (status) {
    status = patches->edit(context, frame.placed->flat, {{}, frame.placed->first}, true);
  }
  if (!status) return status;
  return std::move(*patches);
}

/// What the curve's sides bear, put after what those of the others do, where the last frame knows
/// that and there are no shaders to be found among theirs.
Result<SampledFields> LayerDrag::State::sample_frame(const Context& context,
                                                     LastFrame& frame) const {
  const PlacedCurves& placed = *frame.placed;
  FrameTables& tables = frame.tables;
  if (!tables.color.field) return sample(context, placed.flat, placed.curves);
  const bool has_opacity = tables.opacity.has_value();
  const auto moved = std::span(placed.curves).last(1);
  Result<SampledFields> tail = sample(context, placed.moved, moved, has_opacity);
  if (!tail) return tail;
  const bool has_shaders = !tail->color.attributes.shader.empty() ||
                           (tail->opacity && !tail->opacity->attributes.shader.empty());
  if (has_shaders || tail->opacity.has_value() != has_opacity) {
    return sample(context, placed.flat, placed.curves);
  }
  const auto curve = static_cast<std::uint32_t>(curves.size());
  const auto extend = [&](PreparedField& used, SampledField& one) {
    SampledField all{std::move(used.attributes), std::move(used.memory)};
    Status status = curves::replace_tail(context, placed.first, curve, one.attributes, all.memory,
                                         all.attributes);
    if (status) one = std::move(all);
    return status;
  };
  Status status = extend(*tables.color.field, tail->color);
  if (status && has_opacity) status = extend(*tables.opacity->field, *tail->opacity);
  if (!status) return status;
  return tail;
}

/// keeps   leaves its tables for the next frame, and uses those of the last
Result<FramePatches> LayerDrag::State::frame(Context& context, const Curve& curve, bool keeps,
                                             FramePatches spare, const FrameOptions& how) {
  LastFrame now;
  if (keeps) now = std::exchange(last, {});
  TableMemory memory("a drag");
  Status status = place(context, curve, now);
  if (!status) return status;
  const auto vertices = static_cast<std::uint32_t>(now.placed->flat.vertex.size());
  const Result<std::vector<std::uint8_t>> moves =
      marked(context, vertices, now.placed->first, vertices, memory);
  if (!moves) return moves.status();
  const Result<std::vector<std::uint8_t>> is_same = insert_curve(context, now, memory);
  if (!is_same) return is_same.status();
  Result<mesh::Mesher> patches = patches_with(context, now);
  if (!patches) return patches.status();
  Result<SampledFields> sampled = sample_frame(context, now);
  if (!sampled) return sampled.status();
  FrameTables& tables = now.tables;
  const FieldEdits edits{
      {*moves}, &base->color(),      base->opacity(),
      *is_same, &tables.color.field, tables.opacity ? &tables.opacity->field : nullptr};
  Result<PreparedFields> fields =
      prepare_fields(context, *now.seen, now.seen_mesh, std::move(*sampled), options.ends, edits);
  if (!fields) return fields.status();
  LayerSolver layer =
      solver(context, std::move(*fields), std::move(*patches), how.stats, how.watch);
  const Result<gather::ShareBound> bound =
      gather::ShareBound::create(context, now.placed->moved.vertex, curve.weight, how.most_missed);
  if (!bound) return bound.status();
  status = layer.continue_inserted(
      *base, {*moves, *is_same, how.most_missed > 0 ? &*bound : nullptr, &tables});
  if (!status) return status;
  if (!keeps) {
    Result<PatchLayer> whole = layer.take();
    if (!whole) return whole.status();
    return FramePatches{std::move(*whole), {}};
  }
  std::optional<FrameTables> kept;
  Result<FramePatches> result = layer.take_frame(std::move(spare), kept);
  if (!result) return result;
  tables = kept ? std::move(*kept) : FrameTables();
  last = std::move(now);
  return result;
}

LayerDrag::LayerDrag(std::unique_ptr<State> state) : state_(std::move(state)) {}
LayerDrag::LayerDrag(LayerDrag&&) noexcept = default;
LayerDrag& LayerDrag::operator=(LayerDrag&&) noexcept = default;
LayerDrag::~LayerDrag() = default;

Result<LayerDrag> LayerDrag::begin(Context& context, const Document& document, std::uint32_t layer,
                                   std::uint32_t curve, const LayerSight& sight,
                                   const DiffuseOptions& options,
                                   const std::optional<RefinedLayer>& refined) {
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
  Status status = state->begin(context, std::nullopt);
  if (!status) return status;
  return LayerDrag(std::move(state));
}

Result<FramePatches> LayerDrag::frame(Context& context, const Curve& curve, FramePatches spare,
                                      const FrameOptions& options) {
  // What is kept is charged to the Budget of the drag.
  if (&context.budget == state_->budget) {
    Result<FramePatches> patches =
        no_throw([&] { return state_->frame(context, curve, true, std::move(spare), options); });
    if (patches || !is_lack_of_memory(patches.status())) return patches;
  }
  return state_->frame(context, curve, false, {}, options);
}

bool LayerDrag::forget_frame() {
  const bool any = state_->last.placed.has_value();
  state_->last = {};
  return any;
}

}  // namespace sfumato::solve
