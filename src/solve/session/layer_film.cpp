#include "solve/session/layer_film.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "solve/layers/layer_solver.hpp"
#include "solve/layers/layer_units.hpp"

namespace sfumato::solve {
namespace {

constexpr std::string_view kPurpose = "a film";

/// The most triangles of the still mesh, relative to State::pristine.
constexpr double kMostGrowth = 1.5;

constexpr std::uint32_t kNoSlot = UINT32_MAX;

/// The fields that curves need.
struct FieldKinds {
  bool is_joint = false;     ///< as in FlatLayer
  bool has_opacity = false;  ///< whether any curve has opacity

  friend bool operator==(const FieldKinds&, const FieldKinds&) = default;
};

FieldKinds kinds_of(std::span<const Curve> curves) {
  return {curves::opacity_goes_with_color(curves),
          std::ranges::any_of(curves, curves::bears_opacity)};
}

/// Appends polylines to others.
void append(const curves::FlatCurves& more, curves::FlatCurves& all) {
  const auto first = static_cast<std::uint32_t>(all.vertex.size());
  const std::uint32_t curve = all.curve_count();
  const auto add = [](const auto& from, auto& to) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(more.vertex, all.vertex);
  add(more.parameter, all.parameter);
  add(more.arc_length, all.arc_length);
  for (const std::uint32_t c : more.vertex_curve) all.vertex_curve.push_back(curve + c);
  for (std::size_t c = 1; c < more.curve_begin.size(); ++c)
    all.curve_begin.push_back(first + more.curve_begin[c]);
}

struct Meshes;

/// Returns the size without the meshers, which charge their own memory.
std::size_t bytes_of(const Meshes& meshes);

/// A layer's curves and their meshes. Curves that were removed stay in the lists.
struct Meshes {
  curves::FlatCurves flat;
  std::vector<Curve> curves;        ///< one per polyline
  std::vector<std::uint32_t> slot;  ///< per curve of the layer: index into `curves`, or kNoSlot
  mesh::Mesher visibility;          ///< not refined
  mesh::Mesher patches;             ///< refined, unless no frame was solved yet
  ScopedCharge charge{};            ///< of the curves and polylines

  Result<Meshes> copy(const Context& context) const;
  Status take_out(const Context& context, std::span<const std::uint32_t> which);
  Status insert(Context& context, std::span<const std::uint32_t> which,
                std::span<const Curve> layer, const curves::FlattenOptions& options);
  Result<bool> is_in_order(const Context& context, const mesh::TriangleMesh& mesh) const;
  Result<std::vector<std::uint8_t>> segments_of(const Context& context,
                                                std::span<const std::uint32_t> which,
                                                TableMemory& memory) const;
};

std::size_t bytes_of(const Meshes& meshes) {
  std::size_t bytes = curves::bytes_of(meshes.flat) + capacity_bytes(meshes.slot, meshes.curves);
  for (const Curve& curve : meshes.curves) bytes += bytes_of(curve);
  return bytes;
}

Result<Meshes> Meshes::copy(const Context& context) const {
  SFUMATO_TRY_ASSIGN(auto&& seen, visibility.copy(context));
  SFUMATO_TRY_ASSIGN(auto&& refined, patches.copy(context));
  Meshes meshes{flat, curves, slot, std::move(seen), std::move(refined)};
  SFUMATO_TRY(meshes.charge.add(context, bytes_of(meshes), kPurpose));
  return meshes;
}

/// Returns a mark per segment: 1 for these curves of the layer, as far as the meshes contain them.
Result<std::vector<std::uint8_t>> Meshes::segments_of(const Context& context,
                                                      std::span<const std::uint32_t> which,
                                                      TableMemory& memory) const {
  std::vector<std::uint8_t> marks;
  SFUMATO_TRY(memory.resize(context, marks, flat.vertex.size()));
  for (const std::uint32_t curve : which) {
    const std::uint32_t at = slot[curve];
    if (at == kNoSlot) continue;
    std::fill(marks.begin() + flat.curve_begin[at], marks.begin() + flat.curve_begin[at + 1],
              std::uint8_t{1});
  }
  return marks;
}

Status Meshes::take_out(const Context& context, std::span<const std::uint32_t> which) {
  TableMemory memory(kPurpose);
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& is_removed,
                     segments_of(context, which, memory));
  for (const std::uint32_t curve : which) slot[curve] = kNoSlot;
  const mesh::MeshEdit edit{is_removed, static_cast<std::uint32_t>(flat.vertex.size())};
  Status status = visibility.edit(context, flat, edit, false);
  return status ? patches.edit(context, flat, edit, true) : status;
}

/// Inserts these curves of the layer, which the meshes lack. Errors: bad_input (they reach too
/// far), limit, cancelled.
Status Meshes::insert(Context& context, std::span<const std::uint32_t> which,
                      std::span<const Curve> layer, const curves::FlattenOptions& options) {
  std::vector<Curve> added;
  added.reserve(which.size());
  for (const std::uint32_t curve : which) added.push_back(layer[curve]);
  SFUMATO_TRY_ASSIGN(const curves::FlatCurves& polylines, curves::flatten(context, added, options));
  const mesh::MeshEdit edit{{}, static_cast<std::uint32_t>(flat.vertex.size())};
  append(polylines, flat);
  for (std::size_t i = 0; i < which.size(); ++i) {
    slot[which[i]] = static_cast<std::uint32_t>(curves.size());
    curves.push_back(std::move(added[i]));
  }
  Status status = charge.raise_to(context, bytes_of(*this), kPurpose);
  if (status) status = visibility.edit(context, flat, edit, false);
  return status ? patches.edit(context, flat, edit, true) : status;
}

/// Returns whether curves that lie on each other are drawn in the layer's order, although the
/// moving ones were inserted last.
Result<bool> Meshes::is_in_order(const Context& context, const mesh::TriangleMesh& mesh) const {
  TableMemory memory(kPurpose);
  std::vector<std::uint32_t> rank;
  SFUMATO_TRY(memory.resize(context, rank, curves.size()));
  for (std::uint32_t curve = 0; curve < slot.size(); ++curve) rank[slot[curve]] = curve;
  const auto rank_of = [&](const mesh::SegmentPiece& piece) {
    return rank[flat.vertex_curve[piece.segment]];
  };
  RarePoll<4096> poll(context);
  for (const mesh::Constraint& constraint : mesh.constraint) {
    if (poll.cancelled()) return context.cancel_status();
    if (!std::ranges::is_sorted(mesh.pieces(constraint), {}, rank_of)) return false;
  }
  return true;
}

/// Makes the fields watch these segments, and no others.
Status watch_all(const Context& context, const mesh::TriangleMesh& visibility,
                 std::span<const std::uint8_t> segments, PreparedFields& fields) {
  const auto watch_one = [&](gather::Gatherer& gatherer) {
    gatherer.forget_watched();
    return gatherer.watch(context, visibility, segments);
  };
  Status status = watch_one(fields.color.gatherer);
  return status && fields.opacity ? watch_one(fields.opacity->gatherer) : status;
}

/// The nodes of the last frame, and the visibility mesh of its fields.
struct LayerNodes {
  FilmNodes nodes;
  mesh::TriangleMesh visibility;
  TableMemory memory;  ///< of the mesh

  bool are_thinned() const {
    const PreparedFields& fields = nodes.fields;
    return fields.color.is_thinned || (fields.opacity && fields.opacity->is_thinned);
  }
};

}  // namespace

struct LayerFilm::State {
  State(const Document& document, std::uint32_t layer, const LayerSight& layer_sight,
        const DiffuseOptions& diffuse_options)
      : options(diffuse_options),
        sight(layer_sight),
        artboard(document.artboard),
        interpolation(document.interpolation),
        kinds(kinds_of(document.layers[layer].curves)),
        units(artboard, sight, options) {}

  Status begin(Context& context, const Layer& layer, DiffuseStats* stats, PatchLayer& patches);
  Result<std::optional<PatchLayer>> next(Context& context, const std::vector<Curve>& curves,
                                         DiffuseStats* stats);
  std::vector<std::uint32_t> changed(std::span<const Curve> curves) const;

  DiffuseOptions options;
  LayerSight sight;
  Box artboard;
  InterpolationSpace interpolation;
  FieldKinds kinds;
  LayerUnits units;
  std::optional<Meshes> now;  ///< the meshes of the last frame

 private:
  Status note_moves(const Context& context, std::span<const std::uint32_t> curves);
  Status remember(const Context& context, std::span<const std::uint32_t> which);
  Status refine_still(const Context& context, std::span<const std::uint32_t> missed);
  Result<std::size_t> number_still(const Context& context);
  Result<PreparedFields> fields(Context& context, const mesh::TriangleMesh& visibility,
                                std::span<const std::uint32_t> watched) const;
  /// which   the curves that changed since the last frame
  Result<std::optional<PatchLayer>> solve(Context& context, std::span<const std::uint32_t> which,
                                          DiffuseStats* stats);

  std::optional<LayerNodes> last;      ///< the nodes of the last frame, if known
  std::optional<mesh::Mesher> before;  ///< the last patch mesh, while the next frame is made
  /// The meshes without the curves that ever moved. Missed triangles are refined in `still`.
  /// `pristine` is its patch mesh from the last time that curves were removed.
  std::optional<Meshes> still;
  std::optional<mesh::Mesher> pristine;
  std::vector<std::uint32_t> moved;  ///< the curves that ever moved, ascending
  std::size_t least_triangles = 0;   ///< number of triangles of `pristine`
};

/// Returns the curves that changed since the last frame, ascending.
std::vector<std::uint32_t> LayerFilm::State::changed(std::span<const Curve> curves) const {
  std::vector<std::uint32_t> list;
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    if (!(now->curves[now->slot[i]] == curves[i])) list.push_back(i);
  }
  return list;
}

Status LayerFilm::State::begin(Context& context, const Layer& layer, DiffuseStats* stats,
                               PatchLayer& patches) {
  SFUMATO_TRY_ASSIGN(auto&& flat, flatten_layer(context, layer, sight, units));
  mesh::MeshOptions meshing = units.mesh_options();
  meshing.room = units.roomy_frame();
  SFUMATO_TRY_ASSIGN(auto&& visibility, mesh::Mesher::build(context, flat, meshing));
  SFUMATO_TRY_ASSIGN(auto&& refined, visibility.copy(context));
  std::vector<std::uint32_t> slot(layer.curves.size());
  for (std::uint32_t i = 0; i < slot.size(); ++i) slot[i] = i;
  now.emplace(Meshes{std::move(flat), layer.curves, std::move(slot), std::move(visibility),
                     std::move(refined)});
  SFUMATO_TRY(now->charge.add(context, bytes_of(*now), kPurpose));
  SFUMATO_TRY_ASSIGN(auto&& solved, solve(context, {}, stats));
  patches = std::move(*solved);
  return ok_status();
}

/// Numbers the triangles of the still mesh, as kept_triangles() and refine_triangles() require.
/// Returns their number.
Result<std::size_t> LayerFilm::State::number_still(const Context& context) {
  SFUMATO_TRY_ASSIGN(const mesh::TriangleMesh& mesh, still->patches.patch_mesh(context));
  const TableMemory memory = still->patches.release_extracted();
  return std::size_t{mesh.triangle_count()};
}

/// Removes the curves that have not moved before from the still meshes.
Status LayerFilm::State::note_moves(const Context& context, std::span<const std::uint32_t> curves) {
  std::vector<std::uint32_t> first;
  std::ranges::set_difference(curves, moved, std::back_inserter(first));
  if (first.empty()) return ok_status();
  if (!still) {
    SFUMATO_TRY_ASSIGN(auto&& copy, now->copy(context));
    still.emplace(std::move(copy));
  }
  moved.insert(moved.end(), first.begin(), first.end());
  std::ranges::sort(moved);
  SFUMATO_TRY(still->take_out(context, first));
  SFUMATO_TRY_ASSIGN(auto&& triangles, number_still(context));
  SFUMATO_TRY_ASSIGN(auto&& copy, still->patches.copy(context));
  pristine.emplace(std::move(copy));
  least_triangles = triangles;
  return ok_status();
}

/// Keeps the data of the last frame that the next frame needs.
/// which   the curves that change in the next frame
Status LayerFilm::State::remember(const Context& context, std::span<const std::uint32_t> which) {
  if (!last || last->are_thinned()) return ok_status();
  TableMemory memory(kPurpose);
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& segments,
                     now->segments_of(context, which, memory));
  SFUMATO_TRY(watch_all(context, last->visibility, segments, last->nodes.fields));
  before.emplace(std::move(now->patches));
  return ok_status();
}

/// Refines triangles of the still mesh for all later frames. Otherwise each frame would refine them
/// separately, or not at all. Restores `pristine` if the triangles become too many.
Status LayerFilm::State::refine_still(const Context& context,
                                      std::span<const std::uint32_t> missed) {
  if (missed.empty()) return ok_status();
  SFUMATO_TRY(still->patches.refine_triangles(context, missed, units.smallest_edges().missed));
  SFUMATO_TRY_ASSIGN(const std::size_t triangles, number_still(context));
  const double most = kMostGrowth * static_cast<double>(least_triangles);
  Status status;
  if (static_cast<double>(triangles) <= most) return status;
  SFUMATO_TRY_ASSIGN(still->patches, pristine->copy(context));
  return number_still(context).status();
}

Result<std::optional<PatchLayer>> LayerFilm::State::next(Context& context,
                                                         const std::vector<Curve>& curves,
                                                         DiffuseStats* stats) {
  std::optional<PatchLayer> none;
  if (!(kinds_of(curves) == kinds)) return none;
  const std::vector<std::uint32_t> which = changed(curves);
  SFUMATO_TRY(note_moves(context, which));
  SFUMATO_TRY(remember(context, which));
  SFUMATO_TRY_ASSIGN(auto&& copy, still->copy(context));
  now.emplace(std::move(copy));
  Status status = now->insert(context, moved, curves, units.flatten_options());
  if (status.code == StatusCode::bad_input) return none;
  return status ? solve(context, which, stats) : status;
}

/// Prepares the layer's fields. They watch curves of the layer if the last frame's nodes are known.
Result<PreparedFields> LayerFilm::State::fields(Context& context,
                                                const mesh::TriangleMesh& visibility,
                                                std::span<const std::uint32_t> watched) const {
  SFUMATO_TRY_ASSIGN(auto&& sampled, sample_fields(context,
                                                   {now->flat, now->curves, interpolation,
                                                    kinds.is_joint, kinds.has_opacity},
                                                   options, units.smallest_radius()));
  Result<PreparedFields> fields =
      prepare_fields(context, now->visibility, visibility, std::move(sampled), options.ends);
  if (!fields || !before) return fields;
  TableMemory memory(kPurpose);
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& segments,
                     now->segments_of(context, watched, memory));
  SFUMATO_TRY(watch_all(context, visibility, segments, *fields));
  return fields;
}

/// Solves a frame. Returns none if curves lie on each other in the wrong order.
Result<std::optional<PatchLayer>> LayerFilm::State::solve(Context& context,
                                                          std::span<const std::uint32_t> which,
                                                          DiffuseStats* stats) {
  SFUMATO_TRY_ASSIGN(auto&& mesh, now->visibility.visibility_mesh(context));
  SFUMATO_TRY_ASSIGN(const bool is_in_order, now->is_in_order(context, mesh));
  if (!is_in_order) return std::optional<PatchLayer>();
  SFUMATO_TRY_ASSIGN(auto&& prepared, fields(context, mesh, which));
  LayerSolver solver(
      context,
      {std::move(now->patches), std::move(prepared.color), std::move(prepared.opacity),
       units.mesh_options().frame, units.smallest_edges(), still.has_value()},
      options, stats);
  TableMemory memory(kPurpose);
  std::vector<std::uint32_t> missed;
  std::optional<FilmFrame> known;
  std::optional<StillMesh> rest;
  std::optional<FilmNodes> kept;
  if (before) known.emplace(FilmFrame{*before, last->nodes.nodes, last->nodes.fields});
  if (still) rest.emplace(StillMesh{still->patches, missed, memory});
  Result<PatchLayer> patches =
      solver.solve_next(known ? &*known : nullptr, rest ? &*rest : nullptr, kept);
  before.reset();
  last.reset();
  SFUMATO_TRY(patches);
  now->patches = solver.release_mesher();
  if (kept) {
    last.emplace(
        LayerNodes{std::move(*kept), std::move(mesh), now->visibility.release_extracted()});
  }
  if (stats) stats->curves += now->slot.size();
  if (stats) stats->segments += now->flat.segment_count();
  SFUMATO_TRY(refine_still(context, missed));
  return std::optional(std::move(*patches));
}

LayerFilm::LayerFilm(std::unique_ptr<State> state) : state_(std::move(state)) {}
LayerFilm::LayerFilm(LayerFilm&&) noexcept = default;
LayerFilm& LayerFilm::operator=(LayerFilm&&) noexcept = default;
LayerFilm::~LayerFilm() = default;

Result<LayerFilm> LayerFilm::begin(Context& context, const Document& document, std::uint32_t layer,
                                   const LayerSight& sight, const DiffuseOptions& options,
                                   DiffuseStats* stats, PatchLayer& patches) {
  auto state = std::make_unique<State>(document, layer, sight, options);
  SFUMATO_TRY(state->begin(context, document.layers[layer], stats, patches));
  return LayerFilm(std::move(state));
}

bool LayerFilm::can_go_on(const Document& document, std::uint32_t layer,
                          const LayerSight& sight) const {
  const std::vector<Curve>& curves = document.layers[layer].curves;
  return state_->now && curves.size() == state_->now->slot.size() && sight == state_->sight &&
         document.artboard == state_->artboard && document.interpolation == state_->interpolation &&
         2 * state_->changed(curves).size() <= curves.size();
}

Result<std::optional<PatchLayer>> LayerFilm::next(Context& context, const Document& document,
                                                  std::uint32_t layer, DiffuseStats* stats) {
  return state_->next(context, document.layers[layer].curves, stats);
}

}  // namespace sfumato::solve
