#include <algorithm>
#include <functional>
#include <utility>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "solve/layers/curve_bows.hpp"
#include "solve/layers/layer_solver.hpp"
#include "solve/layers/soft_edges.hpp"
#include "solve/points/layer_points.hpp"

/// The patches that a LayerSolver finally makes.
namespace sfumato::solve {
namespace {

/// A triangle whose opacity is nowhere above this is not visible in any pixel.
constexpr float kInvisibleOpacity = 1.0f / 4096;

constexpr std::size_t kTrianglesPerTask = 4096;

/// Pixels are interpolated where they miss by at most this share of DiffuseOptions::max_error.
constexpr double kMissShare = 0.5;

}  // namespace

/// Returns per half-edge, parts included, 1 on curves and where no triangle is kept beyond it.
Result<std::vector<std::uint8_t>> LayerSolver::edges_of_curves(std::span<const std::uint8_t> keep,
                                                               TableMemory& memory) const {
  const std::size_t whole = mesh_->half_edge_twin.size();
  std::vector<std::uint8_t> marks;
  SFUMATO_TRY(memory.resize(context_, marks, mesh_->triangle_vertex.size()));
  SFUMATO_TRY(parallel_for(
      context_, marks.size(), kTrianglesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::int32_t edge =
              i < whole ? static_cast<std::int32_t>(i) : cuts_.edge[i - whole];
          marks[i] = edge < 0 ? edge == BorderCuts::kBorder : is_end(edge, keep);
        }
      }));
  return marks;
}

/// Returns whether an edge of the mesher's triangles lies on a curve, or no triangle is kept beyond
/// it.
bool LayerSolver::is_end(std::int32_t half_edge, std::span<const std::uint8_t> keep) const {
  const std::int32_t twin = mesh_->half_edge_twin[half_edge];
  const auto beyond = static_cast<std::uint32_t>(twin) / 3;
  return (twin != mesh::kNone && !keep[beyond] && !is_cut(beyond)) ||
         is_curve(static_cast<std::uint32_t>(half_edge));
}

bool LayerSolver::may_be_fine(std::uint32_t half_edge) const {
  return color_.seams().may_be_fine(half_edge) ||
         (opacity_ && opacity_->seams().may_be_fine(half_edge));
}

/// Returns the half-edges that may have a fine blur, ascending.
Result<std::vector<std::uint32_t>> LayerSolver::fine_half_edges(TableMemory& memory) const {
  std::vector<std::uint32_t> fine;
  RarePoll<65536> poll(context_);
  for (std::uint32_t h = 0; h < mesh_->half_edge_twin.size(); ++h) {
    if (poll.cancelled()) return context_.cancel_status();
    if (!may_be_fine(h)) continue;
    SFUMATO_TRY(memory.push_back(context_, fine, h));
  }
  return fine;
}

/// Returns the half-edges among them whose triangles share a corner with a changed triangle.
/// is_near[c] becomes 1 at such corners.
Result<std::vector<std::uint32_t>> LayerSolver::fine_near_changes(
    std::span<const SoftEdge> before, std::vector<std::uint8_t>& is_near,
    TableMemory& memory) const {
  std::vector<std::uint32_t> fine;
  SFUMATO_TRY(memory.resize(context_, is_near, mesh_->vertex_position.size()));
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    for (std::uint32_t h = 3 * changed_[i]; h < 3 * changed_[i] + 3; ++h) {
      is_near[mesh_->origin(h)] = 1;
      if (may_be_fine(h)) SFUMATO_TRY(memory.push_back(context_, fine, h));
    }
  }
  RarePoll<65536> poll(context_);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    const std::uint32_t h = before[i].front;
    if (touches(*mesh_, h / 3, is_near) && may_be_fine(h)) {
      SFUMATO_TRY(memory.push_back(context_, fine, h));
    }
  }
  SFUMATO_TRY(TableMemory::sort(context_, fine, std::less<>()));
  fine.erase(std::unique(fine.begin(), fine.end()), fine.end());
  return fine;
}

/// Finds the soft edges, and adds the triangles beside them to the kept ones, unless that list is
/// empty, which means all. A blur also mixes the colours of transparent triangles.
Result<std::vector<SoftEdge>> LayerSolver::soft_edges(std::span<std::uint8_t> keep,
                                                      TableMemory& memory) const {
  if (!is_finely_blurred_) return std::vector<SoftEdge>();
  const Seams& color = color_.seams();
  const Seams* const opacity = opacity_ ? &opacity_->seams() : nullptr;
  const auto fine_radius = [&](std::uint32_t h, float u) {
    const float radius = color.fine_radius(h, u);
    return opacity ? std::max(radius, opacity->fine_radius(h, u)) : radius;
  };
  const auto is_meshed = [&](std::uint32_t h) {
    const auto is_blurred = [&](const Seams& seams) {
      return seams.blur_radius(h, 0) > 0 || seams.blur_radius(h, 1) > 0;
    };
    return is_blurred(color) || (opacity && is_blurred(*opacity));
  };
  TableMemory scratch("soft edges");
  std::vector<std::uint8_t> is_near;
  const bool updates = inserted_into_ && inserted_into_->soft_edge_ && keeps_everything();
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint32_t>& fine,
                     updates ? fine_near_changes(*inserted_into_->soft_edge_, is_near, scratch)
                             : fine_half_edges(scratch));
  std::vector<std::uint8_t> is_curve_edge;
  SFUMATO_TRY(scratch.resize(context_, is_curve_edge, mesh_->half_edge_twin.size()));
  for (std::uint32_t h = 0; h < is_curve_edge.size(); ++h) is_curve_edge[h] = is_curve(h);
  if (updates) {
    return update_soft_edges(context_, *mesh_, {is_curve_edge, fine, fine_radius, is_meshed},
                             *inserted_into_->soft_edge_, is_near, memory);
  }
  for (const std::uint32_t h : fine) {
    if (keep.empty() || keep[h / 3] || is_cut(h / 3)) continue;
    const bool is_soft = fine_radius(h, 0) > 0 || fine_radius(h, 1) > 0;
    keep[h / 3] = is_soft && color_.sees_curves(h / 3);
  }
  return find_soft_edges(context_, *mesh_, {is_curve_edge, fine, fine_radius, is_meshed}, keep,
                         memory);
}

/// Returns the edges of kept triangles whose curves stray from them.
Result<std::vector<CurveBow>> LayerSolver::bows(std::span<const std::uint8_t> keep,
                                                TableMemory& memory) const {
  if (!bowed_ || has_border()) return std::vector<CurveBow>();
  const auto is_jump = [&](std::uint32_t h) { return is_curve(h); };
  return find_curve_bows(context_, {*mesh_, bowed_->flat, is_jump}, keep, memory);
}

/// Returns whether no triangle is cut.
bool LayerSolver::sees_curves_everywhere() const {
  return cuts_.part_count() == 0 && color_.sees_curves_everywhere() &&
         (!opacity_ || opacity_->sees_curves_everywhere());
}

/// Returns whether points may see no colour. Where both sides of every edge with curves have a
/// value, each point sees at least the nearest edge.
bool LayerSolver::may_see_none() const {
  bool has_curves = false;
  for (std::uint32_t h = 0; h < mesh_->half_edge_twin.size(); ++h) {
    if (!mesh_->has_curves(h)) continue;
    if (!color_.seams().has_value(h)) return true;
    has_curves = true;
  }
  return !has_curves;
}

/// Returns whether no triangle is left out: because all are opaque, or because the frames of a drag
/// keep transparent triangles, so that every frame has the same rows.
bool LayerSolver::keeps_everything() const {
  return sees_curves_everywhere() && (inserted_into_ || (!opacity_ && !is_joint()));
}

/// Returns the visible triangles. A region that sees no curve has no colour, and one without
/// opacity shows nothing: both need no triangles.
Result<std::vector<std::uint8_t>> LayerSolver::visible_triangles(TableMemory& memory) const {
  std::vector<std::uint8_t> keep;
  const bool keeps_all = keeps_everything();
  SFUMATO_TRY(memory.resize(context_, keep, mesh_->triangle_count(), keeps_all));
  if (keeps_all) return keep;
  SFUMATO_TRY(parallel_for(context_, keep.size(), kTrianglesPerTask,
                           [&](std::size_t begin, std::size_t end) {
                             for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
                               keep[t] = !is_cut(t) && color_.sees_curves(t) &&
                                         largest_opacity(t, kInvisibleOpacity) >= kInvisibleOpacity;
                             }
                           }));
  return keep;
}

Result<PatchLayer> LayerSolver::take_patches(bool keeps_tables) {
  TableMemory memory("patches");
  SFUMATO_TRY_ASSIGN(auto&& visible, visible_triangles(memory));
  const std::span<std::uint8_t> keep = visible;
  PatchLayer layer;
  layer.frame = frame_;
  layer.order = options_.order;
  SFUMATO_TRY_ASSIGN(layer.soft_edge, soft_edges(keep, memory));
  SFUMATO_TRY_ASSIGN(layer.bow, bows(keep, memory));
  SFUMATO_TRY_ASSIGN(auto&& marks, edges_of_curves(keep, memory));
  SFUMATO_TRY(take_triangles(keep, std::move(marks), memory, layer));
  SFUMATO_TRY(take_fields(keep, keeps_tables, memory, layer));
  if (stats_) {
    stats_->triangles += layer.triangle_count();
    stats_->vertices += layer.vertex_position.size();
  }
  return layer;
}

Result<PatchLayer> LayerSolver::take_exact() {
  TableMemory memory("patches");
  SFUMATO_TRY(take_mesh());
  std::vector<std::uint8_t> keep;
  SFUMATO_TRY(memory.resize(context_, keep, mesh_->triangle_count(), 1));
  PatchLayer layer;
  layer.frame = frame_;
  SFUMATO_TRY_ASSIGN(layer.soft_edge, soft_edges(keep, memory));
  SFUMATO_TRY_ASSIGN(layer.bow, bows(keep, memory));
  SFUMATO_TRY_ASSIGN(auto&& marks, edges_of_curves(keep, memory));
  SFUMATO_TRY(take_triangles(keep, std::move(marks), memory, layer));
  layer.vertex_position = std::move(mesh_->vertex_position);
  PreparedFields fields{color_.release_field(), {}};
  if (opacity_) fields.opacity.emplace(opacity_->release_field());
  const double max_miss = options_.exact_pixels ? 0 : kMissShare * options_.max_error / 255;
  auto* const points = new LayerPoints(std::move(fields), options_.gather, may_see_none(),
                                       static_cast<float>(max_miss));
  layer.exact_points = PointFieldsRef(points);
  layer.color = points->color_field();
  layer.opacity = points->opacity_field();
  if (stats_) {
    stats_->triangles += layer.triangle_count();
    stats_->vertices += layer.vertex_position.size();
  }
  return layer;
}

/// Copies corners and marks of the triangles with keep[t].
Status LayerSolver::take_triangles(std::span<const std::uint8_t> keep,
                                   std::vector<std::uint8_t> marks, TableMemory& memory,
                                   PatchLayer& layer) {
  const auto kept = static_cast<std::size_t>(std::ranges::count(keep, 1));
  if (kept == keep.size()) {
    layer.edge_is_curve = std::move(marks);
    return memory.assign(context_, mesh_->triangle_vertex, layer.triangle_vertex);
  }
  SFUMATO_TRY(memory.reserve(context_, layer.triangle_vertex, 3 * kept));
  SFUMATO_TRY(memory.reserve(context_, layer.edge_is_curve, 3 * kept));
  RarePoll<16384> poll(context_);
  for (std::uint32_t t = 0; t < mesh_->triangle_count(); ++t) {
    if (poll.cancelled()) return context_.cancel_status();
    if (!keep[t]) continue;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      layer.triangle_vertex.push_back(mesh_->triangle_vertex[h]);
      layer.edge_is_curve.push_back(marks[h]);
    }
  }
  return context_.check();
}

/// Copies vertices, and nodes of the triangles with keep[t].
Status LayerSolver::take_fields(std::span<const std::uint8_t> keep, bool keeps_tables,
                                TableMemory& memory, PatchLayer& layer) {
  Status status =
      for_each_field([&](FieldSolver& field) { return field.fill_unseen_nodes(context_); });
  if (!status) return status;
  const auto take = [&](FieldSolver& field) -> Result<PatchField> {
    if (keeps_tables) return field.copy(context_, keep, memory);
    return field.take(keep);
  };
  if (keeps_tables || keeps_mesh_) {
    status = memory.assign(context_, mesh_->vertex_position, layer.vertex_position);
    if (!status) return status;
  } else {
    layer.vertex_position = std::move(mesh_->vertex_position);
  }
  SFUMATO_TRY_ASSIGN(layer.color, take(color_));
  if (!opacity_ && !is_joint()) return status;
  SFUMATO_TRY_ASSIGN(
      layer.opacity,
      opacity_ ? take(*opacity_) : split_channel(context_, layer.color, kOpacityChannel, memory));
  return context_.check();
}

}  // namespace sfumato::solve
