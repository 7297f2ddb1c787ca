#include "solve/session/layer_drag.hpp"

#include <algorithm>
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

namespace sfumato::solve {
namespace {

/// The most runs of the bound that orders nodes. Few runs keep its cost per node low.
constexpr std::size_t kMostRuns = 16;

/// A curve is costly to drag if it has more half-edges than this number, and than this share of the
/// triangles. A frame computes about six triangles for each half-edge. In a large layer these are
/// few, and even solving it roughly would take longer.
constexpr std::size_t kManyHalfEdges = 100;
constexpr double kManyPerTriangle = 0.01;

/// Returns a mark per vertex: 1 for the vertices in [begin, end).
Result<std::vector<std::uint8_t>> marked(const Context& context, std::size_t count,
                                         std::uint32_t begin, std::uint32_t end,
                                         TableMemory& memory) {
  std::vector<std::uint8_t> marks;
  SFUMATO_TRY(memory.resize(context, marks, count));
  std::fill(marks.begin() + begin, marks.begin() + end, std::uint8_t{1});
  return marks;
}

/// The fields of a solved layer while they watch one of its curves.
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

  /// Uses `fields`, which watch the curve, instead of the layer's own.
  void take_instead(PreparedFields fields) { fields_ = &anew_.emplace(std::move(fields)); }

 private:
  std::optional<PreparedFields> anew_;
  PreparedFields* fields_;
};

/// The state that a frame leaves for the next one, which reuses its tables.
struct LastFrame {
  std::optional<PlacedCurves> placed{};
  std::optional<mesh::Mesher> seen{};         ///< the visibility mesh with the curve
  mesh::TriangleMesh seen_mesh{};             ///< returned by `seen`
  std::vector<std::uint32_t> seen_changed{};  ///< its triangles that the frame changed
  TableMemory memory{"a drag"};               ///< of `seen_changed`
  FrameTables tables{};
};

}  // namespace

struct LayerDrag::State {
  State(const Box& of_document, InterpolationSpace space, std::vector<Curve> of_layer,
        std::uint32_t curve, const LayerSight& layer_sight, const DiffuseOptions& diffuse_options,
        double most)
      : options(diffuse_options),
        sight(layer_sight),
        artboard(of_document),
        interpolation(space),
        curves(std::move(of_layer)),
        moving(curve),
        is_joint(curves::opacity_goes_with_color(curves)),
        most_missed(most),
        units(artboard, sight, options) {}

  Status begin(Context& context, std::optional<RefinedLayer>& refined);
  bool has_fields_with(const Curve& curve) const;
  Result<FramePatches> frame(Context& context, const Curve& curve, bool keeps,
                             const FrameOptions& how);
  Result<FramePatches> go_on(Context& context, const FrameOptions& how);
  FrameSource shown() const;

  DiffuseOptions options;
  LayerSight sight;
  Box artboard;
  InterpolationSpace interpolation;
  std::vector<Curve> curves;  ///< with the moving curve at its first place
  std::uint32_t moving;       ///< index of the moving curve
  bool is_joint;              ///< as in FlatLayer
  double most_missed;         ///< as kMostMissed
  bool has_room = false;      ///< whether the meshes have room beyond the picture
  LayerUnits units;
  ScopedCharge charge;                      ///< of the polylines and curves
  curves::FlatCurves flat;                  ///< the polylines of `curves`
  std::optional<mesh::Mesher> visibility;   ///< without the moving curve, not refined
  mesh::TriangleMesh visibility_mesh;       ///< returned by `visibility`
  std::optional<LayerSolver> base;          ///< the layer without the moving curve
  std::optional<FrameRows> rows_of_solved;  ///< for LayerDrag::take_rows_of_solved()
  const Budget* budget = nullptr;           ///< the Budget that all this is charged to
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
  PreparedLayer prepared_layer(PreparedFields fields, mesh::Mesher&& patches) const;
  Result<PreparedFields> fields(Context& context, const FlatMesh& whole, const mesh::Mesher& mesher,
                                const mesh::TriangleMesh& mesh, const FieldEdits& edits) const;
  Result<PreparedFields> fields_without(Context& context, const RefinedLayer& refined,
                                        std::span<const std::uint8_t> moves,
                                        std::span<const std::uint8_t> is_same) const;
  Result<RefinedLayer> solve(Context& context) const;
  Status take_off(Context& context, RefinedLayer& refined);
  Result<std::vector<std::uint8_t>> mesh_rest(const Context& context, const mesh::Mesher& whole,
                                              const mesh::MeshEdit& edit, TableMemory& memory);
  Status watch(Context& context, const FlatMesh& whole, std::span<const std::uint8_t> moves,
               WatchedFields& with) const;
  Result<FramePatches> take(LayerSolver& layer, LastFrame now, bool wants_rows);
};

/// Samples the fields of some curves.
/// has_opacity   as in FlatLayer
Result<SampledFields> LayerDrag::State::sample(const Context& context,
                                               const curves::FlatCurves& polylines,
                                               std::span<const Curve> of, bool has_opacity) const {
  return sample_fields(context, {polylines, of, interpolation, is_joint, has_opacity}, options,
                       units.smallest_radius());
}

/// Returns the layer on a mesh, ready to be solved or continued.
PreparedLayer LayerDrag::State::prepared_layer(PreparedFields fields,
                                               mesh::Mesher&& patches) const {
  return {std::move(patches), std::move(fields.color), std::move(fields.opacity),
          units.mesh_options().frame, units.smallest_edges()};
}

/// Prepares the fields of all curves of the layer.
/// mesh   mesher.visibility_mesh()
Result<PreparedFields> LayerDrag::State::fields(Context& context, const FlatMesh& whole,
                                                const mesh::Mesher& mesher,
                                                const mesh::TriangleMesh& mesh,
                                                const FieldEdits& edits) const {
  SFUMATO_TRY_ASSIGN(auto&& sampled, sample(context, whole.flat, curves));
  return prepare_fields(context, mesher, mesh, std::move(sampled), options.ends, edits);
}

Status LayerDrag::State::begin(Context& context, std::optional<RefinedLayer>& refined) {
  has_room = !refined;
  budget = &context.budget;
  if (refined) return take_off(context, *refined);
  Result<RefinedLayer> solved = solve(context);
  return solved ? take_off(context, *solved) : solved.status();
}

/// Solves the layer with the curve at its first place, on a mesh with room beyond the picture.
Result<RefinedLayer> LayerDrag::State::solve(Context& context) const {
  SFUMATO_TRY_ASSIGN(auto&& polylines, curves::flatten(context, curves, units.flatten_options()));
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
  return LayerSolver(context, std::move(layer), options, nullptr).refine_only();
}

/// Removes the curve from the layer.
/// refined   the layer with the curve; it is unchanged afterwards
Status LayerDrag::State::take_off(Context& context, RefinedLayer& refined) {
  const FlatMesh& whole = refined.flat_mesh;
  SFUMATO_TRY(charge.add(context, curves::bytes_of(whole.flat) + bytes_of_curves(), "a drag"));
  flat = whole.flat;
  TableMemory memory("a drag");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& moves,
                     marked(context, flat.vertex.size(), flat.curve_begin[moving],
                            flat.curve_begin[moving + 1], memory));
  const mesh::MeshEdit edit{moves, static_cast<std::uint32_t>(flat.vertex.size())};
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& is_same,
                     mesh_rest(context, whole.mesher, edit, memory));
  SFUMATO_TRY_ASSIGN(auto&& rest, fields_without(context, refined, moves, is_same));
  WatchedFields with(refined.fields);
  SFUMATO_TRY(watch(context, whole, moves, with));
  SFUMATO_TRY_ASSIGN(auto&& patches, refined.mesher.copy(context));
  SFUMATO_TRY(patches.edit(context, flat, edit, true));
  base.emplace(context, prepared_layer(std::move(rest), std::move(patches)), options, nullptr);
  const std::uint32_t first = flat.curve_begin[moving], end = flat.curve_begin[moving + 1];
  SFUMATO_TRY_ASSIGN(
      const gather::ShareBound& bound,
      gather::ShareBound::create(context, std::span(flat.vertex).subspan(first, end - first),
                                 curves[moving].weight, 0.5 * most_missed));
  Result<std::optional<FrameRows>> rows =
      base->continue_without({refined, with.get(), is_same, most_missed > 0 ? &bound : nullptr});
  if (rows && refined.is_all_shown) rows_of_solved = std::move(*rows);
  return rows.status();
}

/// Makes the visibility mesh without the curve. Returns which triangles it shares with that of the
/// whole layer.
Result<std::vector<std::uint8_t>> LayerDrag::State::mesh_rest(const Context& context,
                                                              const mesh::Mesher& whole,
                                                              const mesh::MeshEdit& edit,
                                                              TableMemory& memory) {
  SFUMATO_TRY_ASSIGN(auto&& copy, whole.copy(context));
  visibility.emplace(std::move(copy));
  SFUMATO_TRY(visibility->edit(context, flat, edit, false));
  SFUMATO_TRY_ASSIGN(visibility_mesh, visibility->visibility_mesh(context));
  return visibility->same_triangles(context, whole, memory);
}

/// Makes the fields of the whole layer watch the curve.
Status LayerDrag::State::watch(Context& context, const FlatMesh& whole,
                               std::span<const std::uint8_t> moves, WatchedFields& with) const {
  if (!with.are_thinned()) return with.watch(context, whole.mesh, moves);
  SFUMATO_TRY_ASSIGN(auto&& watched, fields(context, whole, whole.mesher, whole.mesh,
                                            {.use = {.is_watched = moves}}));
  with.take_instead(std::move(watched));
  return ok_status();
}

/// Prepares the layer's fields on the visibility mesh without the curve.
Result<PreparedFields> LayerDrag::State::fields_without(
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

/// Returns whether the layer has the same fields with this curve instead of the moving one.
bool LayerDrag::State::has_fields_with(const Curve& curve) const {
  return is_joint ==
         (curves::opacity_goes_with_color(curves) && curves::opacity_goes_with_color({&curve, 1}));
}

/// Places the curve behind the polylines of the layer. Errors: as LayerDrag::frame().
Status LayerDrag::State::place(Context& context, const Curve& curve, LastFrame& frame) const {
  SFUMATO_TRY_ASSIGN(auto&& placed,
                     place_curve(context, flat, curves, curve, units.flatten_options(),
                                 std::exchange(frame.placed, std::nullopt)));
  if (!visibility->holds(placed.flat, placed.first)) {
    return make_error(StatusCode::bad_input, "the curve is dragged too far beyond the picture");
  }
  if (!has_fields_with(curve)) {
    return make_error(StatusCode::bad_input, "the dragged curve changes the layer's fields");
  }
  frame.placed.emplace(std::move(placed));
  return ok_status();
}

/// Makes the frame's visibility mesh. Returns Mesher::same_triangles: which triangles it shares
/// with the mesh without the curve.
Result<std::vector<std::uint8_t>> LayerDrag::State::insert_curve(const Context& context,
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

/// Returns the base's patch mesh with the curve inserted.
Result<mesh::Mesher> LayerDrag::State::patches_with(const Context& context,
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

/// Samples the fields of all curves. Samples only the moving curve, and appends it to the samples
/// of the last frame, if these are kept, the fields are the same, and the curve has no shaders.
Result<SampledFields> LayerDrag::State::sample_frame(const Context& context,
                                                     LastFrame& frame) const {
  const PlacedCurves& placed = *frame.placed;
  FrameTables& tables = frame.tables;
  if (!tables.color.field) return sample(context, placed.flat, placed.curves);
  const bool has_opacity = tables.opacity.has_value();
  const auto moved = std::span(placed.curves).last(1);
  SFUMATO_TRY_ASSIGN(auto&& tail, sample(context, placed.moved, moved, has_opacity));
  const bool has_shaders = !tail.color.attributes.shader.empty() ||
                           (tail.opacity && !tail.opacity->attributes.shader.empty());
  if (has_shaders || tail.opacity.has_value() != has_opacity) {
    return sample(context, placed.flat, placed.curves);
  }
  const auto curve = static_cast<std::uint32_t>(curves.size());
  const auto extend = [&](PreparedField& used, SampledField& one) {
    SampledField all{std::move(used.attributes), std::move(used.memory)};
    SFUMATO_TRY(curves::replace_tail(context, placed.first, curve, one.attributes, all.memory,
                                     all.attributes));
    one = std::move(all);
    return ok_status();
  };
  SFUMATO_TRY(extend(*tables.color.field, tail.color));
  if (has_opacity) SFUMATO_TRY(extend(*tables.opacity->field, *tail.opacity));
  return std::move(tail);
}

/// Makes a frame.
/// keeps   uses the tables of the last frame, and leaves tables for the next
Result<FramePatches> LayerDrag::State::frame(Context& context, const Curve& curve, bool keeps,
                                             const FrameOptions& how) {
  LastFrame now;
  if (keeps) now = std::exchange(last, {});
  TableMemory memory("a drag");
  SFUMATO_TRY(place(context, curve, now));
  const auto vertices = static_cast<std::uint32_t>(now.placed->flat.vertex.size());
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& moves,
                     marked(context, vertices, now.placed->first, vertices, memory));
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& is_same, insert_curve(context, now, memory));
  SFUMATO_TRY_ASSIGN(auto&& patches, patches_with(context, now));
  SFUMATO_TRY_ASSIGN(auto&& sampled, sample_frame(context, now));
  FrameTables& tables = now.tables;
  const FieldEdits edits{
      {moves}, &base->color(),      base->opacity(),
      is_same, &tables.color.field, tables.opacity ? &tables.opacity->field : nullptr};
  SFUMATO_TRY_ASSIGN(auto&& fields, prepare_fields(context, *now.seen, now.seen_mesh,
                                                   std::move(sampled), options.ends, edits));
  LayerSolver layer(context, prepared_layer(std::move(fields), std::move(patches)), options,
                    how.stats, how.watch);
  SFUMATO_TRY_ASSIGN(
      const gather::ShareBound& bound,
      gather::ShareBound::create(context, now.placed->moved.vertex, curve.weight, most_missed));
  CurveInsertion insertion{moves, is_same, most_missed > 0 ? &bound : nullptr, &tables};
  std::optional<gather::ShareBound> order;
  std::optional<FrameLimit> limit;
  if (keeps && how.time.is_limited()) {
    SFUMATO_TRY_ASSIGN(auto&& coarse,
                       gather::ShareBound::create(context, now.placed->moved.vertex, curve.weight,
                                                  most_missed, kMostRuns));
    insertion.limit = &limit.emplace(FrameLimit{how.time, order.emplace(std::move(coarse))});
  }
  SFUMATO_TRY(layer.continue_inserted(*base, insertion));
  if (keeps) return take(layer, std::move(now), how.wants_rows);
  SFUMATO_TRY_ASSIGN(auto&& whole, layer.take());
  return FramePatches{std::move(whole), {}};
}

/// Returns the patches of a frame, and keeps its tables for the next one.
Result<FramePatches> LayerDrag::State::take(LayerSolver& layer, LastFrame now, bool wants_rows) {
  std::optional<FrameTables> kept;
  SFUMATO_TRY_ASSIGN(auto&& result, layer.take_frame(wants_rows, kept));
  now.tables = kept ? std::move(*kept) : FrameTables();
  last = std::move(now);
  return std::move(result);
}

Result<FramePatches> LayerDrag::State::go_on(Context& context, const FrameOptions& how) {
  LastFrame now = std::exchange(last, {});
  FrameTables& tables = now.tables;
  PreparedFields fields{std::move(*tables.color.field), {}};
  if (tables.opacity) fields.opacity.emplace(std::move(*tables.opacity->field));
  LayerSolver layer(context, prepared_layer(std::move(fields), std::move(*tables.mesher)), options,
                    how.stats, how.watch);
  SFUMATO_TRY(layer.resume(*base, std::move(tables), how.time));
  return take(layer, std::move(now), how.wants_rows);
}

/// Returns the tables of the last frame, as the source of rows.
FrameSource LayerDrag::State::shown() const {
  const FrameTables& tables = last.tables;
  return {*tables.mesh, tables.color.layout, tables.opacity ? &tables.opacity->layout : nullptr};
}

LayerDrag::LayerDrag(std::unique_ptr<State> state) : state_(std::move(state)) {}
LayerDrag::LayerDrag(LayerDrag&&) noexcept = default;
LayerDrag& LayerDrag::operator=(LayerDrag&&) noexcept = default;
LayerDrag::~LayerDrag() = default;

Result<bool> LayerDrag::is_costly(const Context& context, const RefinedLayer& refined,
                                  std::uint32_t curve) {
  const mesh::TriangleMesh& mesh = *refined.mesh;
  const std::vector<std::uint32_t>& begin = refined.flat_mesh.flat.curve_begin;
  const auto is_of_curve = [&](const mesh::SegmentPiece& piece) {
    return piece.segment >= begin[curve] && piece.segment < begin[curve + 1];
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

Result<LayerDrag> LayerDrag::begin(Context& context, const Document& document, std::uint32_t layer,
                                   std::uint32_t curve, const LayerSight& sight,
                                   const DiffuseOptions& options,
                                   std::optional<RefinedLayer>& refined, double most_missed) {
  auto state =
      std::make_unique<State>(document.artboard, document.interpolation,
                              document.layers[layer].curves, curve, sight, options, most_missed);
  SFUMATO_TRY(state->begin(context, refined));
  return LayerDrag(std::move(state));
}

bool LayerDrag::has_room() const {
  return state_->has_room;
}

bool LayerDrag::needs_room(const Curve& curve) const {
  const Box roomy = state_->units.roomy_frame();
  const auto is_in_it = [&](Vec2 p) { return roomy.contains(p); };
  return !has_room() && state_->has_fields_with(curve) &&
         std::ranges::all_of(curve.control_points, is_in_it);
}

Result<LayerDrag> LayerDrag::with_room(Context& context) const {
  const State& now = *state_;
  auto state = std::make_unique<State>(now.artboard, now.interpolation, now.curves, now.moving,
                                       now.sight, now.options, now.most_missed);
  std::optional<RefinedLayer> none;
  SFUMATO_TRY(state->begin(context, none));
  return LayerDrag(std::move(state));
}

std::optional<FrameRows> LayerDrag::take_rows_of_solved() {
  return std::exchange(state_->rows_of_solved, std::nullopt);
}

Result<FramePatches> LayerDrag::frame(Context& context, const Curve& curve,
                                      const FrameOptions& options) {
  // Only a frame in the Budget of the drag may keep its tables.
  if (&context.budget == state_->budget) {
    Result<FramePatches> patches =
        no_throw([&] { return state_->frame(context, curve, true, options); });
    if (patches || !is_lack_of_memory(patches.status())) return patches;
  }
  return state_->frame(context, curve, false, options);
}

bool LayerDrag::can_go_on(const Context& context) const {
  const FrameTables& tables = state_->last.tables;
  return &context.budget == state_->budget && tables.mesher && tables.color.field;
}

Result<FramePatches> LayerDrag::go_on(Context& context, const FrameOptions& options) {
  return no_throw([&] { return state_->go_on(context, options); });
}

Status LayerDrag::make_room(const Context& context, PatchLayer& layer) const {
  return solve::make_room(context, state_->shown(), layer);
}

void LayerDrag::write(FramePatches& frame, const FrameRows& then, PatchLayer& layer) const {
  write_rows(state_->shown(), then, *frame.rows, layer);
  layer.soft_edge = std::move(frame.layer.soft_edge);
}

bool LayerDrag::forget_frame() {
  const bool any = state_->last.placed.has_value();
  state_->last = {};
  return any;
}

}  // namespace sfumato::solve
