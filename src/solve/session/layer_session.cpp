#include "solve/session/layer_session.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "solve/layers/layer_units.hpp"
#include "solve/layers/placed_curves.hpp"
#include "solve/session/moving_curves.hpp"

namespace sfumato::solve {
namespace {

/// The most runs of the bound that orders nodes. Few runs keep its cost per node low.
constexpr std::size_t kMostRuns = 16;

/// Curves are costly to move if they have more half-edges than this number, and than this share of
/// the triangles. A frame computes about six triangles for each half-edge. In a large layer these
/// are few, and even solving it roughly would take longer.
constexpr std::size_t kManyHalfEdges = 100;
constexpr double kManyPerTriangle = 0.01;

/// The fields of a solved layer while they watch some of its curves.
class WatchedFields {
 public:
  explicit WatchedFields(PreparedFields& fields) : fields_(&fields) {}
  WatchedFields(const WatchedFields&) = delete;
  WatchedFields& operator=(const WatchedFields&) = delete;
  ~WatchedFields() {
    fields_->color.gatherer.forget_watched();
    if (fields_->opacity) fields_->opacity->gatherer.forget_watched();
  }

  const PreparedFields& get() const { return *fields_; }

  /// Returns whether a field is thinned. Such a field cannot watch(): its mesh was not kept.
  bool are_thinned() const {
    return fields_->color.is_thinned || (fields_->opacity && fields_->opacity->is_thinned);
  }

  Status watch(const Context& context, const mesh::TriangleMesh& mesh,
               std::span<const std::uint8_t> segments) {
    Status status = fields_->color.gatherer.watch(context, mesh, segments);
    if (!status || !fields_->opacity) return status;
    return fields_->opacity->gatherer.watch(context, mesh, segments);
  }

  /// Uses `fields`, which watch the curves, instead of the layer's own.
  void take_instead(PreparedFields fields) { fields_ = &own_.emplace(std::move(fields)); }

 private:
  std::optional<PreparedFields> own_;
  PreparedFields* fields_;
};

/// The state that a frame leaves for the next one, which reuses its tables.
struct LastFrame {
  std::optional<PlacedCurves> placed{};
  std::optional<mesh::Mesher> seen{};         ///< the visibility mesh with the curves
  mesh::TriangleMesh seen_mesh{};             ///< returned by `seen`
  std::vector<std::uint32_t> seen_changed{};  ///< its triangles that the frame changed
  TableMemory memory{"a drag"};               ///< of `seen_changed`
  FrameTables tables{};
};

}  // namespace

struct LayerSession::State {
  State(LayerInput layer, std::vector<std::uint32_t> which, const FrameAccuracy& frame_accuracy)
      : input(std::move(layer)),
        moving(std::move(which)),
        is_joint(curves::opacity_goes_with_color(input.curves)),
        accuracy(frame_accuracy),
        units(input.artboard, input.sight, input.options) {}

  Status begin(Context& context, std::optional<RefinedLayer>& refined);
  Result<PreparedLayer> prepare_with_room(Context& context, DiffuseStats* stats) const;
  bool has_fields_with(std::span<const Curve> now) const;
  Result<std::optional<FramePatches>> frame(Context& context, std::span<const Curve> now,
                                            bool keeps, const FramePolicy& how);
  Result<FramePatches> go_on(Context& context, const FramePolicy& how);
  FrameSource shown() const;

  LayerInput input;                   ///< with the moving curves at their first places
  std::vector<std::uint32_t> moving;  ///< indices of the moving curves, ascending
  bool is_joint;                      ///< as in FlatLayer
  FrameAccuracy accuracy;
  bool has_room = false;  ///< whether the meshes have room beyond the picture
  LayerUnits units;
  ScopedCharge charge;                      ///< of the polylines and curves
  curves::FlatCurves flat;                  ///< the polylines of the layer
  std::optional<mesh::Mesher> visibility;   ///< without the moving curves, not refined
  mesh::TriangleMesh visibility_mesh;       ///< returned by `visibility`
  std::optional<LayerSolver> base;          ///< the layer without the moving curves
  std::optional<FrameRows> rows_of_solved;  ///< for LayerSession::take_rows_of_solved()
  const Budget* budget = nullptr;           ///< the Budget that all this is charged to
  LastFrame last;

 private:
  Result<bool> place(Context& context, std::span<const Curve> now, LastFrame& frame) const;
  Result<bool> is_in_order(const Context& context, const LastFrame& frame) const;
  Result<std::vector<std::uint8_t>> insert_curves(const Context& context, LastFrame& frame,
                                                  TableMemory& memory) const;
  Result<mesh::Mesher> patches_with(const Context& context, LastFrame& frame) const;
  Result<SampledFields> sample(const Context& context, const curves::FlatCurves& polylines,
                               std::span<const Curve> of, bool has_opacity = false) const;
  Result<SampledFields> sample_frame(const Context& context, LastFrame& frame) const;
  PreparedLayer prepared_layer(PreparedFields fields, mesh::Mesher&& patches) const;
  Result<PreparedFields> fields(Context& context, const FlatMesh& whole, const mesh::Mesher& mesher,
                                const mesh::TriangleMesh& mesh, const FieldEdits& edits) const;
  Result<PreparedFields> fields_without(Context& context, const RefinedLayer& refined,
                                        std::span<const std::uint8_t> moves,
                                        std::span<const std::uint8_t> is_same) const;
  Status take_off(Context& context, RefinedLayer& refined);
  Result<std::vector<std::uint8_t>> mesh_rest(const Context& context, const mesh::Mesher& whole,
                                              const mesh::MeshEdit& edit, TableMemory& memory);
  Status watch(Context& context, const FlatMesh& whole, std::span<const std::uint8_t> moves,
               WatchedFields& with) const;
  Status insert(Context& context, const LastFrame& now, bool keeps, const FramePolicy& how,
                CurveInsertion insertion, LayerSolver& layer) const;
  Result<FramePatches> take(LayerSolver& layer, LastFrame now, bool wants_rows);
};

/// Samples the fields of some curves.
/// has_opacity   as in FlatLayer
Result<SampledFields> LayerSession::State::sample(const Context& context,
                                                  const curves::FlatCurves& polylines,
                                                  std::span<const Curve> of,
                                                  bool has_opacity) const {
  return sample_fields(context, {polylines, of, input.interpolation, is_joint, has_opacity},
                       input.options, units.smallest_radius());
}

/// Returns the layer on a mesh, ready to be solved or continued.
PreparedLayer LayerSession::State::prepared_layer(PreparedFields fields,
                                                  mesh::Mesher&& patches) const {
  return {std::move(patches), std::move(fields.color), std::move(fields.opacity),
          units.mesh_options().frame, units.smallest_edges()};
}

/// Prepares the fields of all curves of the layer.
/// mesh   mesher.visibility_mesh()
Result<PreparedFields> LayerSession::State::fields(Context& context, const FlatMesh& whole,
                                                   const mesh::Mesher& mesher,
                                                   const mesh::TriangleMesh& mesh,
                                                   const FieldEdits& edits) const {
  SFUMATO_TRY_ASSIGN(auto&& sampled, sample(context, whole.flat, input.curves));
  return prepare_fields(context, mesher, mesh, std::move(sampled), input.options.ends, edits);
}

Status LayerSession::State::begin(Context& context, std::optional<RefinedLayer>& refined) {
  has_room = !refined;
  budget = &context.budget;
  if (refined) return take_off(context, *refined);
  SFUMATO_TRY_ASSIGN(auto&& prepared, prepare_with_room(context, nullptr));
  SFUMATO_TRY_ASSIGN(
      auto&& solved,
      LayerSolver(context, std::move(prepared), input.options, nullptr).refine_only());
  return take_off(context, solved);
}

/// Prepares the layer with the curves at their first places, on a mesh with room beyond the
/// picture.
Result<PreparedLayer> LayerSession::State::prepare_with_room(Context& context,
                                                             DiffuseStats* stats) const {
  SFUMATO_TRY_ASSIGN(auto&& polylines,
                     curves::flatten(context, input.curves, units.flatten_options()));
  if (stats) stats->curves += input.curves.size();
  if (stats) stats->segments += polylines.segment_count();
  ScopedCharge polyline_charge;
  SFUMATO_TRY(polyline_charge.add(context, curves::bytes_of(polylines), "a drag"));
  mesh::MeshOptions meshing = units.mesh_options();
  meshing.room = units.roomy_frame();
  SFUMATO_TRY_ASSIGN(auto&& built, mesh::Mesher::build(context, polylines, meshing));
  SFUMATO_TRY_ASSIGN(auto&& patches, built.copy(context));
  SFUMATO_TRY_ASSIGN(auto&& mesh, built.visibility_mesh(context));
  FlatMesh flat_mesh{std::move(polylines), std::move(polyline_charge), std::move(built),
                     std::move(mesh)};
  SFUMATO_TRY_ASSIGN(auto&& prepared, fields(context, flat_mesh, flat_mesh.mesher, flat_mesh.mesh,
                                             {.use = {.may_be_changed = true}}));
  PreparedLayer layer = prepared_layer(std::move(prepared), std::move(patches));
  layer.flat_mesh.emplace(std::move(flat_mesh));
  return layer;
}

/// Removes the curves from the layer.
/// refined   the layer with the curves; it is unchanged afterwards
Status LayerSession::State::take_off(Context& context, RefinedLayer& refined) {
  const FlatMesh& whole = refined.flat_mesh;
  SFUMATO_TRY(charge.add(context, curves::bytes_of(whole.flat) + bytes_of(input.curves), "a drag"));
  flat = whole.flat;
  TableMemory memory("a drag");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& moves,
                     marks_of(context, flat, moving, memory));
  const mesh::MeshEdit edit{moves, static_cast<std::uint32_t>(flat.vertex.size())};
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& is_same,
                     mesh_rest(context, whole.mesher, edit, memory));
  SFUMATO_TRY_ASSIGN(auto&& rest, fields_without(context, refined, moves, is_same));
  WatchedFields with(refined.fields);
  SFUMATO_TRY(watch(context, whole, moves, with));
  SFUMATO_TRY_ASSIGN(auto&& patches, refined.mesher.copy(context));
  SFUMATO_TRY(patches.edit(context, flat, edit, true));
  base.emplace(context, prepared_layer(std::move(rest), std::move(patches)), input.options,
               nullptr);
  SFUMATO_TRY_ASSIGN(
      const gather::ShareBound& bound,
      gather::ShareBound::create(context, polylines_of(flat, moving),
                                 largest_weight(input.curves, moving), 0.5 * accuracy.most_missed));
  Result<std::optional<FrameRows>> rows =
      base->continue_without({refined, with.get(), is_same,
                              accuracy.most_missed > 0 ? &bound : nullptr, accuracy.holds_bound});
  if (rows && refined.is_all_shown) rows_of_solved = std::move(*rows);
  return rows.status();
}

/// Makes the visibility mesh without the curves. Returns which triangles it shares with that of the
/// whole layer.
Result<std::vector<std::uint8_t>> LayerSession::State::mesh_rest(const Context& context,
                                                                 const mesh::Mesher& whole,
                                                                 const mesh::MeshEdit& edit,
                                                                 TableMemory& memory) {
  SFUMATO_TRY_ASSIGN(auto&& copy, whole.copy(context));
  visibility.emplace(std::move(copy));
  SFUMATO_TRY(visibility->edit(context, flat, edit, false));
  SFUMATO_TRY_ASSIGN(visibility_mesh, visibility->visibility_mesh(context));
  return visibility->same_triangles(context, whole, memory);
}

/// Makes the fields of the whole layer watch the curves.
Status LayerSession::State::watch(Context& context, const FlatMesh& whole,
                                  std::span<const std::uint8_t> moves, WatchedFields& with) const {
  if (!with.are_thinned()) return with.watch(context, whole.mesh, moves);
  SFUMATO_TRY_ASSIGN(auto&& watched, fields(context, whole, whole.mesher, whole.mesh,
                                            {.use = {.is_watched = moves}}));
  with.take_instead(std::move(watched));
  return ok_status();
}

/// Prepares the layer's fields on the visibility mesh without the curves.
Result<PreparedFields> LayerSession::State::fields_without(
    Context& context, const RefinedLayer& refined, std::span<const std::uint8_t> moves,
    std::span<const std::uint8_t> is_same) const {
  const PreparedFields& with = refined.fields;
  FieldEdits edits{.use = {.is_watched = moves, .will_be_extended = true}};
  edits.color_before = &with.color;
  if (with.opacity) edits.opacity_before = &*with.opacity;
  edits.is_same = is_same;
  edits.whole = &refined.flat_mesh.mesh;
  return fields(context, refined.flat_mesh, *visibility, visibility_mesh, edits);
}

/// Returns whether the layer has the same fields with these curves instead of the moving ones.
bool LayerSession::State::has_fields_with(std::span<const Curve> now) const {
  return is_joint ==
         (curves::opacity_goes_with_color(input.curves) && curves::opacity_goes_with_color(now));
}

/// Places the curves behind the polylines of the layer. Returns false if the mesh has no room for
/// them, or if they need other fields.
Result<bool> LayerSession::State::place(Context& context, std::span<const Curve> now,
                                        LastFrame& frame) const {
  if (!has_fields_with(now)) return false;
  SFUMATO_TRY_ASSIGN(auto&& placed,
                     place_curves(context, flat, input.curves, now, units.flatten_options(),
                                  std::exchange(frame.placed, std::nullopt)));
  frame.placed.emplace(std::move(placed));
  return visibility->holds(frame.placed->flat, frame.placed->first);
}

/// Returns whether curves that lie on each other are drawn in the layer's order, although the
/// moving ones were inserted last.
Result<bool> LayerSession::State::is_in_order(const Context& context,
                                              const LastFrame& frame) const {
  TableMemory memory("a drag");
  std::vector<std::uint32_t> rank;  // per curve of `placed`: its place in the layer
  SFUMATO_TRY(memory.resize(context, rank, frame.placed->curves.size()));
  std::iota(rank.begin(), rank.end(), 0u);
  std::ranges::copy(moving, rank.begin() + static_cast<std::ptrdiff_t>(input.curves.size()));
  const std::vector<std::uint32_t>& curve = frame.placed->flat.vertex_curve;
  const auto rank_of = [&](const mesh::SegmentPiece& piece) { return rank[curve[piece.segment]]; };
  RarePoll<4096> poll(context);
  for (const mesh::Constraint& constraint : frame.seen_mesh.constraint) {
    if (poll.cancelled()) return context.cancel_status();
    if (!std::ranges::is_sorted(frame.seen_mesh.pieces(constraint), {}, rank_of)) return false;
  }
  return true;
}

/// Makes the frame's visibility mesh. Returns Mesher::same_triangles: which triangles it shares
/// with the mesh without the curves.
Result<std::vector<std::uint8_t>> LayerSession::State::insert_curves(const Context& context,
                                                                     LastFrame& frame,
                                                                     TableMemory& memory) const {
  const bool is_first = !frame.seen;
  if (is_first) {
    SFUMATO_TRY_ASSIGN(auto&& copy, visibility->copy(context));
    frame.seen.emplace(std::move(copy));
  } else if (Status status = frame.seen->copy_from(context, *visibility); !status) {
    return status;
  }
  mesh::Mesher& seen = *frame.seen;
  SFUMATO_TRY(seen.edit(context, frame.placed->flat, {{}, frame.placed->first}, false));
  SFUMATO_TRY_ASSIGN(auto&& is_same, seen.same_triangles(context, *visibility, memory));
  if (is_first) {
    SFUMATO_TRY_ASSIGN(frame.seen_mesh, seen.copy_mesh(context, visibility_mesh));
  } else {
    mesh::Mesher::take_back(visibility_mesh, frame.seen_changed, frame.seen_mesh);
  }
  SFUMATO_TRY(seen.update_visibility_mesh(context, is_same, frame.seen_mesh, frame.memory,
                                          frame.seen_changed));
  return std::move(is_same);
}

/// Returns the base's patch mesh with the curves inserted.
Result<mesh::Mesher> LayerSession::State::patches_with(const Context& context,
                                                       LastFrame& frame) const {
  std::optional<mesh::Mesher> patches = std::exchange(frame.tables.mesher, std::nullopt);
  if (patches) {
    SFUMATO_TRY(patches->copy_from(context, base->mesher()));
  } else {
    SFUMATO_TRY_ASSIGN(auto&& copy, base->mesher().copy(context));
    patches.emplace(std::move(copy));
  }
  SFUMATO_TRY(patches->edit(context, frame.placed->flat, {{}, frame.placed->first}, true));
  return std::move(*patches);
}

/// Samples the fields of all curves. Samples only the moving curves, and appends them to the
/// samples of the last frame, if these are kept, the fields are the same, and the curves have no
/// shaders.
Result<SampledFields> LayerSession::State::sample_frame(const Context& context,
                                                        LastFrame& frame) const {
  const PlacedCurves& placed = *frame.placed;
  FrameTables& tables = frame.tables;
  if (!tables.color.field) return sample(context, placed.flat, placed.curves);
  const bool has_opacity = tables.opacity.has_value();
  const auto moved = std::span(placed.curves).last(moving.size());
  SFUMATO_TRY_ASSIGN(auto&& tail, sample(context, placed.moved, moved, has_opacity));
  const bool has_shaders = !tail.color.attributes.shader.empty() ||
                           (tail.opacity && !tail.opacity->attributes.shader.empty());
  if (has_shaders || tail.opacity.has_value() != has_opacity) {
    return sample(context, placed.flat, placed.curves);
  }
  const auto first_curve = static_cast<std::uint32_t>(input.curves.size());
  const auto extend = [&](PreparedField& used, SampledField& one) {
    SampledField all{std::move(used.attributes), std::move(used.memory)};
    SFUMATO_TRY(curves::replace_tail(context, placed.first, first_curve, one.attributes, all.memory,
                                     all.attributes));
    one = std::move(all);
    return ok_status();
  };
  SFUMATO_TRY(extend(*tables.color.field, tail.color));
  if (has_opacity) SFUMATO_TRY(extend(*tables.opacity->field, *tail.opacity));
  return std::move(tail);
}

/// Makes a frame. Returns none if the mesh cannot take the curves.
/// keeps   uses the tables of the last frame, and leaves tables for the next
Result<std::optional<FramePatches>> LayerSession::State::frame(Context& context,
                                                               std::span<const Curve> moved,
                                                               bool keeps, const FramePolicy& how) {
  LastFrame now;
  if (keeps) now = std::exchange(last, {});
  TableMemory memory("a drag");
  SFUMATO_TRY_ASSIGN(const bool has_place, place(context, moved, now));
  if (!has_place) return std::optional<FramePatches>();
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& is_same, insert_curves(context, now, memory));
  if (accuracy.holds_bound) {
    SFUMATO_TRY_ASSIGN(const bool is_drawn_in_order, is_in_order(context, now));
    if (!is_drawn_in_order) return std::optional<FramePatches>();
  }
  std::vector<std::uint8_t> moves;  // per vertex: 1 on the moving curves
  SFUMATO_TRY(memory.resize(context, moves, now.placed->flat.vertex.size()));
  std::fill(moves.begin() + now.placed->first, moves.end(), std::uint8_t{1});
  SFUMATO_TRY_ASSIGN(auto&& patches, patches_with(context, now));
  SFUMATO_TRY_ASSIGN(auto&& sampled, sample_frame(context, now));
  FrameTables& tables = now.tables;
  const FieldEdits edits{
      {moves}, &base->color(),      base->opacity(),
      is_same, &tables.color.field, tables.opacity ? &tables.opacity->field : nullptr};
  SFUMATO_TRY_ASSIGN(auto&& fields, prepare_fields(context, *now.seen, now.seen_mesh,
                                                   std::move(sampled), input.options.ends, edits));
  LayerSolver layer(context, prepared_layer(std::move(fields), std::move(patches)), input.options,
                    how.stats, how.watch);
  SFUMATO_TRY(insert(context, now, keeps, how, {moves, is_same, nullptr, &tables}, layer));
  FramePatches result;
  if (keeps) {
    SFUMATO_TRY_ASSIGN(result, take(layer, std::move(now), how.wants_rows));
  } else {
    SFUMATO_TRY_ASSIGN(result.layer, layer.take());
  }
  return std::optional(std::move(result));
}

/// Continues the layer with the moving curves inserted.
/// insertion   without bound and limit
Status LayerSession::State::insert(Context& context, const LastFrame& now, bool keeps,
                                   const FramePolicy& how, CurveInsertion insertion,
                                   LayerSolver& layer) const {
  const curves::FlatCurves& moved = now.placed->moved;
  const std::vector<std::uint32_t> all = numbers(moving.size());
  const double weight = largest_weight(std::span(now.placed->curves).last(all.size()), all);
  const auto bound_of = [&](std::size_t most_runs) {
    return gather::ShareBound::create(context, polylines_of(moved, all), weight,
                                      accuracy.most_missed, most_runs);
  };
  SFUMATO_TRY_ASSIGN(const gather::ShareBound& bound, bound_of(SIZE_MAX));
  if (accuracy.most_missed > 0) insertion.bound = &bound;
  std::optional<gather::ShareBound> order;
  std::optional<FrameLimit> limit;
  if (keeps && how.time.is_limited()) {
    SFUMATO_TRY_ASSIGN(auto&& coarse, bound_of(kMostRuns));
    insertion.limit = &limit.emplace(FrameLimit{how.time, order.emplace(std::move(coarse))});
  }
  SFUMATO_TRY(layer.continue_inserted(*base, insertion));
  return accuracy.holds_bound ? layer.refine_changes() : ok_status();
}

/// Returns the patches of a frame, and keeps its tables for the next one.
Result<FramePatches> LayerSession::State::take(LayerSolver& layer, LastFrame now, bool wants_rows) {
  std::optional<FrameTables> kept;
  SFUMATO_TRY_ASSIGN(auto&& result, layer.take_frame(wants_rows, kept));
  now.tables = kept ? std::move(*kept) : FrameTables();
  last = std::move(now);
  return std::move(result);
}

Result<FramePatches> LayerSession::State::go_on(Context& context, const FramePolicy& how) {
  LastFrame now = std::exchange(last, {});
  FrameTables& tables = now.tables;
  PreparedFields fields{std::move(*tables.color.field), {}};
  if (tables.opacity) fields.opacity.emplace(std::move(*tables.opacity->field));
  LayerSolver layer(context, prepared_layer(std::move(fields), std::move(*tables.mesher)),
                    input.options, how.stats, how.watch);
  SFUMATO_TRY(layer.resume(*base, std::move(tables), how.time));
  return take(layer, std::move(now), how.wants_rows);
}

/// Returns the tables of the last frame, as the source of rows.
FrameSource LayerSession::State::shown() const {
  const FrameTables& tables = last.tables;
  return {*tables.mesh, tables.color.layout, tables.opacity ? &tables.opacity->layout : nullptr};
}

LayerInput input_of(const Document& document, std::uint32_t layer, const LayerSight& sight,
                    const DiffuseOptions& options) {
  return {document.artboard, document.interpolation, document.layers[layer].curves, sight, options};
}

LayerSession::LayerSession(std::unique_ptr<State> state) : state_(std::move(state)) {}
LayerSession::LayerSession(LayerSession&&) noexcept = default;
LayerSession& LayerSession::operator=(LayerSession&&) noexcept = default;
LayerSession::~LayerSession() = default;

Result<bool> LayerSession::is_costly(const Context& context, const RefinedLayer& refined,
                                     std::span<const std::uint32_t> moving) {
  const mesh::TriangleMesh& mesh = *refined.mesh;
  TableMemory memory("a drag");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& moves,
                     marks_of(context, refined.flat_mesh.flat, moving, memory));
  const auto is_of_curve = [&](const mesh::SegmentPiece& piece) {
    return moves[piece.segment] != 0;
  };
  const double share = kManyPerTriangle * static_cast<double>(mesh.triangle_count());
  const std::size_t most = std::max(kManyHalfEdges, static_cast<std::size_t>(share));
  std::size_t count = 0;
  RarePoll<65536> poll(context);
  for (const std::int32_t constraint : mesh.half_edge_constraint) {
    if (poll.cancelled()) return context.cancel_status();
    if (constraint == mesh::kNone) continue;
    count += std::ranges::any_of(mesh.pieces(mesh.constraint[constraint]), is_of_curve);
    if (count > most) return true;
  }
  return false;
}

Result<PatchLayer> LayerSession::solve_with_room(Context& context, const LayerInput& input,
                                                 DiffuseStats* stats,
                                                 std::optional<RefinedLayer>& refined) {
  const State state(input, {}, {});
  SFUMATO_TRY_ASSIGN(auto&& prepared, state.prepare_with_room(context, stats));
  return LayerSolver(context, std::move(prepared), input.options, stats).solve(&refined);
}

Result<LayerSession> LayerSession::open(Context& context, LayerInput input,
                                        std::vector<std::uint32_t> moving,
                                        std::optional<RefinedLayer>& refined,
                                        const FrameAccuracy& accuracy) {
  auto state = std::make_unique<State>(std::move(input), std::move(moving), accuracy);
  SFUMATO_TRY(state->begin(context, refined));
  return LayerSession(std::move(state));
}

const std::vector<std::uint32_t>& LayerSession::moving() const {
  return state_->moving;
}

bool LayerSession::has_room() const {
  return state_->has_room;
}

bool LayerSession::needs_room(std::span<const Curve> now) const {
  const Box roomy = state_->units.roomy_frame();
  const auto is_in_it = [&](Vec2 p) { return roomy.contains(p); };
  const auto lies_in_it = [&](const Curve& curve) {
    return std::ranges::all_of(curve.control_points, is_in_it);
  };
  return !has_room() && state_->has_fields_with(now) && std::ranges::all_of(now, lies_in_it);
}

Result<LayerSession> LayerSession::with_room(Context& context) const {
  std::optional<RefinedLayer> none;
  return open(context, state_->input, state_->moving, none, state_->accuracy);
}

std::optional<FrameRows> LayerSession::take_rows_of_solved() {
  return std::exchange(state_->rows_of_solved, std::nullopt);
}

Result<std::optional<FramePatches>> LayerSession::frame(Context& context,
                                                        std::span<const Curve> now,
                                                        const FramePolicy& policy) {
  // Only a frame in the Budget of the session may keep its tables.
  if (&context.budget == state_->budget) {
    Result<std::optional<FramePatches>> patches =
        no_throw([&] { return state_->frame(context, now, true, policy); });
    if (patches || !is_lack_of_memory(patches.status())) return patches;
  }
  return state_->frame(context, now, false, policy);
}

bool LayerSession::can_go_on(const Context& context) const {
  const FrameTables& tables = state_->last.tables;
  return &context.budget == state_->budget && tables.mesher && tables.color.field;
}

Result<FramePatches> LayerSession::go_on(Context& context, const FramePolicy& policy) {
  return no_throw([&] { return state_->go_on(context, policy); });
}

Status LayerSession::make_room(const Context& context, PatchLayer& layer) const {
  return solve::make_room(context, state_->shown(), layer);
}

void LayerSession::write(FramePatches& frame, const FrameRows& then, PatchLayer& layer) const {
  write_rows(state_->shown(), then, *frame.rows, layer);
  layer.soft_edge = std::move(frame.layer.soft_edge);
}

bool LayerSession::forget_frame() {
  const bool any = state_->last.placed.has_value();
  state_->last = {};
  return any;
}

}  // namespace sfumato::solve
