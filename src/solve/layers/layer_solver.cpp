#include "solve/layers/layer_solver.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "solve/layers/rough.hpp"

namespace sfumato::solve {
namespace {

/// The longest edge at a blurred curve, in blur radii. Its four nodes resolve a smoothstep to a few
/// code values. Where patches are probed, edges must be shorter, or probes would skip errors.
constexpr double kEdgePerRadius = 3;
constexpr double kProbedEdgePerRadius = 1.5;

/// Nodes are copied only if memory has room for this many copies.
constexpr std::size_t kRoomPerCopy = 8;

/// Accuracy of the border of the seen region on an edge, as a share of the smallest edge.
constexpr double kBorderPerEdge = 1e-4;

Status check_limits(const Limits& limits, const mesh::TriangleMesh& mesh) {
  if (mesh.triangle_count() <= limits.triangles) return ok_status();
  return limit_error(limits, &Limits::triangles, "triangles in one layer");
}

Status list_chosen(const Context& context, std::span<const std::uint8_t> chosen,
                   TableMemory& memory, std::vector<std::uint32_t>& indices) {
  indices.clear();
  const auto count = static_cast<std::size_t>(std::ranges::count(chosen, 1));
  SFUMATO_TRY(memory.reserve(context, indices, count));
  for (std::uint32_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) indices.push_back(i);
  }
  return ok_status();
}

using Radius = curves::SegmentValues<float> curves::SegmentSide::*;

bool any_blur(const PreparedField& field, Radius radius) {
  const auto is_blurred = [&](const curves::SegmentSide& side) {
    return (side.*radius).start > 0 || (side.*radius).end > 0;
  };
  return std::ranges::any_of(field.attributes.left, is_blurred) ||
         std::ranges::any_of(field.attributes.right, is_blurred);
}

bool any_blur(const PreparedLayer& prepared, Radius radius) {
  return any_blur(prepared.color, radius) ||
         (prepared.opacity && any_blur(*prepared.opacity, radius));
}

}  // namespace

LayerSolver::LayerSolver(Context& context, PreparedLayer prepared, const DiffuseOptions& options,
                         DiffuseStats* stats, std::optional<RoundWatch> watch, SolveWay way)
    : context_(context),
      mesher_(std::move(prepared.mesher)),
      is_mesh_refined_(prepared.is_mesh_refined),
      is_blurred_(any_blur(prepared, &curves::SegmentSide::blur_radius)),
      is_finely_blurred_(any_blur(prepared, &curves::SegmentSide::fine_radius)),
      color_(std::move(prepared.color), prepared.flat_mesh.has_value()),
      frame_(prepared.frame),
      smallest_edges_(prepared.smallest_edges),
      flat_mesh_(std::move(prepared.flat_mesh)),
      bowed_(std::move(prepared.bowed)),
      options_(options),
      stats_(stats),
      watch_(watch),
      way_(way) {
  if (prepared.opacity) opacity_.emplace(std::move(*prepared.opacity), flat_mesh_.has_value());
}

bool LayerSolver::is_joint() const {
  const curves::SegmentAttributes& colors = color_.field().attributes;
  return colors.base_channels > kOpacityChannel && !colors.has_response;
}

Status LayerSolver::for_fields_side_by_side(FunctionRef<Status(FieldSolver&)> body) {
  if (!opacity_ || !way_.side_by_side) return for_each_field(body);
  return run_both(
      context_, [&] { return body(color_); }, [&] { return body(*opacity_); });
}

Result<PatchLayer> LayerSolver::solve(std::optional<RefinedLayer>* refined) {
  const std::uint64_t nodes_before = stats_ ? stats_->nodes : 0;
  SFUMATO_TRY(refine());
  SFUMATO_TRY(put_in_order());
  if (refines(options_) && options_.gather.method != gather::Method::exact) {
    if (stats_) stats_->nodes = nodes_before;
    SFUMATO_TRY(gather(options_.gather, true));
  }
  if (!refined || options_.gather.method != gather::Method::exact || !has_spare_memory()) {
    return take();
  }
  Result<RefinedNodes> nodes = no_throw([&] { return copy_nodes(); });
  if (!nodes && !is_lack_of_memory(nodes.status())) return nodes.status();
  keeps_mesh_ = nodes.ok();
  Result<PatchLayer> layer = take();
  if (!layer || !nodes) return layer;
  const bool is_cut = cuts_.part_count() > 0;
  Result<RefinedLayer> kept = keep(std::move(*nodes));
  if (!kept && !is_lack_of_memory(kept.status())) return kept.status();
  if (!kept) return layer;
  kept->is_all_shown = !is_cut && layer->triangle_count() == kept->mesh->triangle_count();
  refined->emplace(std::move(*kept));
  Status status = no_throw([&] { return make_room(context_, *layer); });
  if (!status && !is_lack_of_memory(status)) return status;
  return layer;
}

/// Moves the solved layer out, with these nodes. Errors: limit (memory), cancelled.
Result<RefinedLayer> LayerSolver::keep(RefinedNodes nodes) {
  if (cuts_.part_count() > 0) {  // the parts were added to the mesh
    SFUMATO_TRY(take_mesh());
  }
  nodes.color.seams.emplace(color_.release_seams());
  PreparedFields fields{color_.release_field(), {}};
  if (opacity_) {
    nodes.opacity->seams.emplace(opacity_->release_seams());
    fields.opacity.emplace(opacity_->release_field());
  }
  TableMemory mesh_memory = mesher_.release_extracted();
  return RefinedLayer{std::move(mesher_), std::move(mesh_),       std::move(mesh_memory),
                      std::move(nodes),   std::move(*flat_mesh_), std::move(fields)};
}

/// Returns whether copies of all nodes leave enough memory for the patches.
bool LayerSolver::has_spare_memory() const {
  const std::size_t bytes = color_.bytes_of_nodes() + (opacity_ ? opacity_->bytes_of_nodes() : 0);
  return context_.budget.room() / kRoomPerCopy >= bytes;
}

Result<RefinedNodes> LayerSolver::copy_nodes() const {
  RefinedNodes nodes;
  SFUMATO_TRY_ASSIGN(nodes.color, color_.copy_nodes(context_));
  if (!opacity_) return nodes;
  SFUMATO_TRY_ASSIGN(nodes.opacity, opacity_->copy_nodes(context_));
  return nodes;
}

Result<RefinedLayer> LayerSolver::refine_only() {
  SFUMATO_TRY(refine());
  SFUMATO_TRY(put_in_order());
  RefinedNodes nodes{color_.release(), {}};
  if (opacity_) nodes.opacity = opacity_->release();
  return keep(std::move(nodes));
}

/// Refines the mesh as the options say, and gathers its nodes. The exact gather decides where to
/// refine. Random rays are shot only once, on the final mesh.
Status LayerSolver::refine() {
  const Stopwatch watch;
  if (!is_mesh_refined_) {
    SFUMATO_TRY(mesher_.refine(context_));
  }
  if (stats_) stats_->triangulation_seconds += watch.seconds();
  const bool is_led = refines(options_);
  Status status = take_mesh();
  if (status && is_blurred_) status = list_all_triangles();
  if (status && is_blurred_) status = follow_blur();
  if (status) status = lay_out();
  std::vector<std::uint32_t> missed;
  for (int round = 0; status; ++round) {
    if (way_.progress) (*way_.progress)(round / double{kMaxRounds});
    status = gather(is_led ? gather::GatherOptions{} : options_.gather, false);
    if (!status || !is_led || round == kMaxRounds) break;
    status = find_misses(missed);
    if (!status || missed.empty()) break;
    status = make_smaller(missed, smallest_edges_.missed);
    if (status) status = update_mesh();
  }
  return status;
}

Result<PatchLayer> LayerSolver::take() {
  SFUMATO_TRY(cut_at_border());
  Result<PatchLayer> layer = take_patches(false);
  if (context_.cancelled()) return context_.cancel_status();
  return layer;
}

/// Takes the mesher's first mesh, and starts the fields with it.
Status LayerSolver::take_mesh() {
  const Stopwatch watch;
  SFUMATO_TRY_ASSIGN(auto&& mesh, mesher_.patch_mesh(context_));
  *mesh_ = std::move(mesh);
  Status status = check_limits(context_.limits, *mesh_);
  if (status)
    status =
        for_fields_side_by_side([&](FieldSolver& field) { return field.start(context_, *mesh_); });
  if (stats_) stats_->triangulation_seconds += watch.seconds();
  return status;
}

/// Updates the mesh after a change of the mesher, and then the fields.
Status LayerSolver::update_mesh() {
  const Stopwatch watch;
  Status status = mesher_.update_patch_mesh(context_, *mesh_, memory_, changed_);
  if (status) status = check_limits(context_.limits, *mesh_);
  if (status) {
    status = for_fields_side_by_side(
        [&](FieldSolver& field) { return field.follow(context_, *mesh_, changed_); });
  }
  if (stats_) stats_->triangulation_seconds += watch.seconds();
  return status;
}

/// Lays out the nodes. All triangles then count as changed.
Status LayerSolver::lay_out() {
  const Stopwatch watch;
  const std::size_t spare = refines(options_) ? mesh_->triangle_count() / 2 : 0;
  Status status = for_fields_side_by_side(
      [&](FieldSolver& field) { return field.lay_out(context_, *mesh_, spare); });
  if (status) status = list_all_triangles();
  if (stats_) stats_->triangulation_seconds += watch.seconds();
  return status;
}

Status LayerSolver::put_in_order() {
  const Stopwatch watch;
  Status status = for_fields_side_by_side(
      [&](FieldSolver& field) { return field.put_in_order(context_, *mesh_); });
  if (stats_) stats_->triangulation_seconds += watch.seconds();
  return status;
}

/// Lists all triangles as changed.
Status LayerSolver::list_all_triangles() {
  Status status = memory_.resize(context_, changed_, mesh_->triangle_count());
  std::iota(changed_.begin(), changed_.end(), 0u);
  return status;
}

/// Refines changed triangles at blurred curves until they are small enough for the blur radii. Call
/// this before nodes are gathered.
Status LayerSolver::follow_blur(std::vector<std::uint32_t>* all_changed) {
  const double edge_per_radius = refines(options_) ? kProbedEdgePerRadius : kEdgePerRadius;
  TableMemory scratch("patches");
  std::vector<std::uint8_t> coarse;
  std::vector<std::uint32_t> triangles;
  Status status;
  for (int round = 0; status && round < kMaxRounds; ++round) {
    status = scratch.resize(context_, coarse, mesh_->triangle_count());
    if (!status) return status;
    for (const std::uint32_t t : changed_) coarse[t] = 0;
    SFUMATO_TRY(for_each_field([&](FieldSolver& field) {
      return field.find_coarse(context_, *mesh_, changed_, edge_per_radius, coarse);
    }));
    SFUMATO_TRY(list_chosen(context_, coarse, scratch, triangles));
    if (triangles.empty()) break;
    const std::uint32_t before = mesh_->triangle_count();
    status = make_smaller(triangles, smallest_edges_.blurred);
    if (status) status = update_mesh();
    if (status && all_changed) status = memory_.append(context_, changed_, *all_changed);
    if (mesh_->triangle_count() == before) break;
  }
  return status;
}

Status LayerSolver::gather(const gather::GatherOptions& options, bool all) {
  const Stopwatch watch;
  std::atomic<std::size_t> gathered{0};
  Status status = for_fields_side_by_side([&](FieldSolver& field) {
    SFUMATO_TRY_ASSIGN(const std::size_t nodes, field.gather(context_, options, all));
    gathered += nodes;
    return ok_status();
  });
  if (stats_) stats_->nodes += gathered;
  if (stats_) stats_->gather_seconds += watch.seconds();
  if (status && watch_) (*watch_)(*mesh_, color_, opacity_ ? &*opacity_ : nullptr);
  return status;
}

/// Returns the new triangles that are large enough to be refined.
Result<std::vector<std::uint32_t>> LayerSolver::large_triangles(TableMemory& memory) const {
  std::vector<std::uint32_t> large;
  SFUMATO_TRY(memory.reserve(context_, large, changed_.size()));
  RarePoll<16384> poll(context_);
  for (const std::uint32_t t : changed_) {
    if (poll.cancelled()) return context_.cancel_status();
    if (longest_edge(*mesh_, t) > smallest_edges_.missed) large.push_back(t);
  }
  return large;
}

/// Lists the triangles new in this round whose patches miss by more than max_error.
Status LayerSolver::find_misses(std::vector<std::uint32_t>& missed) {
  const Stopwatch watch;
  TableMemory scratch("patches");
  std::vector<std::uint8_t> misses;
  SFUMATO_TRY(scratch.resize(context_, misses, mesh_->triangle_count()));
  const auto limit = static_cast<float>(options_.max_error / 255);
  const auto opacity = [&](std::uint32_t t) { return largest_opacity(t, 1); };
  const bool for_grid = is_for_pixel_grid(options_);
  const MissLimit most{limit, options_.order, opacity, for_grid ? kGridMissFactors : MissFactors()};
  std::vector<std::uint32_t> large;
  if (for_grid) {
    SFUMATO_TRY_ASSIGN(large, large_triangles(scratch));
  }
  const std::vector<std::uint32_t>& searched = for_grid ? large : changed_;
  Status status = for_each_field([&](const FieldSolver& field) {
    return field.find_misses(context_, *mesh_, searched, most, misses);
  });
  if (status) status = list_chosen(context_, misses, memory_, missed);
  if (stats_) stats_->gather_seconds += watch.seconds();
  return status;
}

Status LayerSolver::make_smaller(const std::vector<std::uint32_t>& triangles,
                                 double smallest_edge) {
  const Stopwatch watch;
  Status status = mesher_.refine_triangles(context_, triangles, smallest_edge);
  if (stats_) stats_->triangulation_seconds += watch.seconds();
  return status;
}

/// Cuts triangles at the border of the region that sees a curve, and gathers nodes of the parts.
Status LayerSolver::cut_at_border() {
  const Stopwatch watch;
  bool has_border = false;
  Status status = for_each_field([&](const FieldSolver& field) {
    has_border |= !field.sees_curves_everywhere();
    return ok_status();
  });
  if (!has_border) return status;
  const auto node_sees = [&](std::uint32_t t, std::size_t place) {
    return color_.sees_curves(t, place) && (!opacity_ || opacity_->sees_curves(t, place));
  };
  const auto is_seam = [&](std::uint32_t h) { return is_curve(h); };
  const auto look = [&](std::span<const Vec2> points, std::span<std::uint8_t> seen) {
    std::ranges::fill(seen, std::uint8_t{1});
    return for_each_field(
        [&](const FieldSolver& field) { return field.look(context_, points, seen); });
  };
  SFUMATO_TRY_ASSIGN(cuts_, solve::cut_at_border(context_, *mesh_, {node_sees, is_seam, look},
                                                 kBorderPerEdge * smallest_edges_.missed));
  if (stats_) stats_->gather_seconds += watch.seconds();
  if (cuts_.part_count() == 0) return ok_status();
  status = for_each_field([&](FieldSolver& field) { return field.add_parts(context_, cuts_); });
  if (status) status = gather(options_.gather, false);
  if (status) status = memory_.append(context_, cuts_.vertex, mesh_->vertex_position);
  if (status) status = memory_.append(context_, cuts_.triangle_vertex, mesh_->triangle_vertex);
  return status ? check_limits(context_.limits, *mesh_) : status;
}

/// Returns whether a half-edge of a triangle of the mesher is a seam of a field.
bool LayerSolver::is_curve(std::uint32_t half_edge) const {
  return color_.seams().is_seam(half_edge) || (opacity_ && opacity_->seams().is_seam(half_edge));
}

/// Returns the largest opacity at the triangle's nodes, at most `enough`; 1 if the layer is opaque.
float LayerSolver::largest_opacity(std::uint32_t triangle, float enough) const {
  if (opacity_) return opacity_->largest_value(triangle, 0, enough);
  return is_joint() ? color_.largest_value(triangle, kOpacityChannel, enough) : 1;
}

}  // namespace sfumato::solve
