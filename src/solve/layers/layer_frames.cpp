#include <algorithm>
#include <functional>
#include <utility>

#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "base/poll.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "solve/fields/fan.hpp"
#include "solve/layers/layer_solver.hpp"
#include "solve/layers/rough.hpp"

/// The functions of LayerSolver for layers that are edited, for example in the frames of a drag.
namespace sfumato::solve {
/// Lays out all nodes again, after any edit of a copy of the mesher of `before`. Nodes keep their
/// values in `before` unless the edit may change them, by more than the bound if there is one.
Status LayerSolver::continue_from(const LayerSolver& before, const gather::ShareBound* bound) {
  SFUMATO_TRY(take_mesh());
  if (is_blurred_) SFUMATO_TRY(list_all_triangles());
  if (is_blurred_) SFUMATO_TRY(follow_blur());
  SFUMATO_TRY(lay_out());
  TableMemory scratch("patches");
  SFUMATO_TRY_ASSIGN(const std::vector<std::int32_t>& kept,
                     mesher_.kept_triangles(context_, before.mesher_, scratch));
  SFUMATO_TRY(color_.carry_over(context_, before.color_.known(), kept, bound));
  if (opacity_ && before.opacity_) {
    SFUMATO_TRY(opacity_->carry_over(context_, before.opacity_->known(), kept, bound));
  }
  return gather(gather::GatherOptions{}, false);
}

Status LayerSolver::refine_changes() {
  if (!refines(options_)) return ok_status();
  std::vector<std::uint32_t> all_changed, missed;
  SFUMATO_TRY(memory_.append(context_, changed_, all_changed));
  SFUMATO_TRY(add_gathered_triangles());
  for (int round = 0; round < kMaxRounds; ++round) {
    SFUMATO_TRY(find_misses(missed));
    if (missed.empty()) break;
    SFUMATO_TRY(make_smaller(missed, smallest_edges_.missed));
    SFUMATO_TRY(update_mesh());
    SFUMATO_TRY(memory_.append(context_, changed_, all_changed));
    SFUMATO_TRY(gather(gather::GatherOptions{}, false));
  }
  return set_changed(all_changed);
}

/// Adds the triangles with nodes that the edit gathered to changed_.
Status LayerSolver::add_gathered_triangles() {
  TableMemory scratch("patches");
  std::vector<std::uint8_t> marks;
  SFUMATO_TRY(scratch.resize(context_, marks, mesh_->triangle_count()));
  for (const std::uint32_t t : changed_) marks[t] = 1;
  SFUMATO_TRY(for_each_field([&](FieldSolver& f) { return f.mark_gathered(context_, marks); }));
  changed_.clear();
  SFUMATO_TRY(
      memory_.reserve(context_, changed_, static_cast<std::size_t>(std::ranges::count(marks, 1))));
  for (std::uint32_t t = 0; t < marks.size(); ++t)
    if (marks[t]) changed_.push_back(t);
  return ok_status();
}

/// Moves a list to changed_, in order and without duplicates.
Status LayerSolver::set_changed(std::vector<std::uint32_t>& all_changed) {
  Status status = TableMemory::sort(context_, all_changed, std::less<>());
  all_changed.erase(std::unique(all_changed.begin(), all_changed.end()), all_changed.end());
  changed_.swap(all_changed);
  memory_.free(all_changed);
  return status;
}

Result<std::optional<FrameRows>> LayerSolver::continue_without(const CurveRemoval& removal) {
  const RefinedNodes& nodes = removal.known.nodes;
  SFUMATO_TRY_ASSIGN(auto&& mesh, mesher_.copy_mesh(context_, *removal.known.mesh));
  *mesh_ = std::move(mesh);
  SFUMATO_TRY(color_.start_from(context_, nodes.color, *mesh_));
  if (opacity_) SFUMATO_TRY(opacity_->start_from(context_, *nodes.opacity, *mesh_));
  SFUMATO_TRY(update_mesh());
  if (is_blurred_) SFUMATO_TRY(follow_blur_too());
  const auto lay_out = [&](FieldSolver& field, const RefinedField& known,
                           const PreparedField& with) {
    return field.lay_out_without(context_, known, with, *mesh_, changed_, removal.is_same,
                                 removal.bound);
  };
  SFUMATO_TRY(lay_out(color_, nodes.color, removal.fields.color));
  if (opacity_) SFUMATO_TRY(lay_out(*opacity_, *nodes.opacity, *removal.fields.opacity));
  SFUMATO_TRY(gather(gather::GatherOptions{}, false));
  if (removal.holds_bound) {
    SFUMATO_TRY(refine_changes());
    SFUMATO_TRY(for_each_field([&](FieldSolver& f) { return f.locate_all(context_); }));
  }
  std::optional<FrameRows> rows;
  if (sees_curves_everywhere()) {
    SFUMATO_TRY_ASSIGN(auto&& listed, list_rows(removal.known.mesh->vertex_position.size()));
    rows.emplace(std::move(listed));
  }
  color_.forget_rows();
  if (opacity_) opacity_->forget_rows();
  SFUMATO_TRY(prepare_to_be_edited());
  return rows;
}

/// Prepares this object so that other solvers can continue_inserted() from it.
Status LayerSolver::prepare_to_be_edited() {
  SFUMATO_TRY(mesher_.bake(context_));
  if (sees_curves_everywhere()) {
    std::vector<std::uint8_t> keep;
    TableMemory scratch("patches");
    SFUMATO_TRY(scratch.resize(context_, keep, mesh_->triangle_count(), 1));

    SFUMATO_TRY_ASSIGN(auto&& soft, soft_edges(keep, memory_));
    soft_edge_.emplace(std::move(soft));
  }
  return ok_status();
}

Status LayerSolver::continue_inserted(const LayerSolver& before, const CurveInsertion& insertion) {
  const bool has_fields = color_.has_channels_of(before.color_) &&
                          opacity_.has_value() == before.opacity_.has_value() &&
                          (!opacity_ || opacity_->has_channels_of(*before.opacity_));
  if (!has_fields || !mesher_.follows_changes()) {
    if (insertion.last) *insertion.last = {};
    return continue_from(before, insertion.bound);
  }
  FrameTables none;
  const FrameLimit* const limit = insertion.limit;
  SFUMATO_TRY(start_inserted(before, insertion.last ? *insertion.last : none, limit != nullptr));
  SFUMATO_TRY(update_mesh());
  SFUMATO_TRY(add_fans(insertion.is_inserted));
  if (is_blurred_) SFUMATO_TRY(follow_blur_too());
  const auto lay_out = [&](FieldSolver& field, const FieldSolver& from) {
    return field.lay_out_from(context_, from, *mesh_, changed_, insertion.is_same, insertion.bound,
                              limit ? &limit->share : nullptr);
  };
  SFUMATO_TRY(lay_out(color_, before.color_));
  if (opacity_) SFUMATO_TRY(lay_out(*opacity_, *before.opacity_));
  SFUMATO_TRY(gather(gather::GatherOptions{}, false));
  inserted_into_ = &before;
  Status status;
  if (!limit) return status;
  return gather_left(limit->time, false);
}

/// Gathers deferred nodes until the time is over. If a node sees no curve, ignores the time: the
/// cuts at the border of the seen region depend on all nodes.
Status LayerSolver::gather_left(const FrameTime& time, bool advances) {
  const Stopwatch watch;
  const auto gather_within = [&](const FrameTime& limit) {
    return for_each_field([&](FieldSolver& field) {
      const Result<std::size_t> nodes = field.gather_left(context_, limit, advances);
      if (nodes && stats_) stats_->nodes += *nodes;
      return nodes.status();
    });
  };
  Status status = gather_within(can_keep_tables() ? time : FrameTime());
  if (status && !can_keep_tables()) status = gather_within(FrameTime());
  if (status) status = for_each_field([&](FieldSolver& f) { return f.count_shown(context_); });
  if (stats_) stats_->gather_seconds += watch.seconds();
  return status;
}

Status LayerSolver::resume(const LayerSolver& before, FrameTables frame, const FrameTime& time) {
  mesh_ = std::move(frame.mesh);
  changed_ = std::move(frame.changed);
  memory_ = std::move(frame.memory);
  color_.resume(std::move(frame.color));
  if (opacity_) opacity_->resume(std::move(*frame.opacity));
  inserted_into_ = &before;
  return gather_left(time, true);
}

/// Begins with the mesh and the fields of `before`: restores the tables of the last frame to them,
/// or copies them if there was no frame.
/// remembers   as FieldSolver::start_from
Status LayerSolver::start_inserted(const LayerSolver& before, FrameTables& last, bool remembers) {
  if (last.mesh) {
    mesh_ = std::move(last.mesh);
    mesh::Mesher::take_back(*before.mesh_, last.changed, *mesh_);
  } else {
    SFUMATO_TRY_ASSIGN(auto&& mesh, mesher_.copy_mesh(context_, *before.mesh_));
    *mesh_ = std::move(mesh);
  }
  Status status = color_.start_from(context_, before.color_, *mesh_, std::move(last.color),
                                    last.changed, remembers);
  if (!status || !opacity_) return status;
  return opacity_->start_from(context_, *before.opacity_, *mesh_,
                              last.opacity ? std::move(*last.opacity) : FieldFrame(), last.changed,
                              remembers);
}

/// Returns whether patches can be copied from the tables of continue_inserted(), without added
/// nodes or parts.
bool LayerSolver::can_keep_tables() const {
  return inserted_into_ && sees_curves_everywhere();
}

FrameTables LayerSolver::release_frame() {
  FrameTables frame;
  frame.mesher.emplace(std::move(mesher_));
  frame.mesh = std::move(mesh_);
  frame.color = color_.release_frame();
  frame.changed = std::move(changed_);
  if (opacity_) frame.opacity = opacity_->release_frame();
  frame.memory = std::move(memory_);
  return frame;
}

/// Refines the mesh at blurs where it changed, and adds the refined triangles to changed_.
Status LayerSolver::follow_blur_too() {
  std::vector<std::uint32_t> all_changed;
  SFUMATO_TRY(memory_.append(context_, changed_, all_changed));
  SFUMATO_TRY(follow_blur(&all_changed));
  return set_changed(all_changed);
}

/// Adds the triangles around the vertices of inserted curves to changed_: such a curve splits a
/// sector in two.
Status LayerSolver::add_fans(std::span<const std::uint8_t> is_inserted) {
  TableMemory scratch("patches");
  std::vector<std::uint8_t> is_listed, is_met;
  SFUMATO_TRY(scratch.resize(context_, is_listed, mesh_->triangle_count()));
  SFUMATO_TRY(scratch.resize(context_, is_met, mesh_->vertex_position.size()));
  RarePoll<1024> poll(context_);
  const std::size_t count = changed_.size();
  for (const std::uint32_t t : changed_) is_listed[t] = 1;
  Fan fan;
  Status status;
  for (std::size_t i = 0; i < count && status; ++i) {
    for (std::uint32_t h = 3 * changed_[i]; h < 3 * changed_[i] + 3 && status; ++h) {
      if (poll.cancelled()) return context_.cancel_status();
      if (!mesh_->has_segment(h, is_inserted)) continue;
      if (std::exchange(is_met[mesh_->origin(h)], std::uint8_t{1})) continue;
      fan.collect(*mesh_, h, [](std::uint32_t) { return false; });
      for (const std::uint32_t spoke : fan.spoke) {
        if (std::exchange(is_listed[spoke / 3], std::uint8_t{1})) continue;
        if (status) status = memory_.push_back(context_, changed_, spoke / 3);
      }
    }
  }
  return status ? TableMemory::sort(context_, changed_, std::less<>()) : status;
}

Result<FramePatches> LayerSolver::take_frame(bool wants_rows, std::optional<FrameTables>& kept) {
  kept.reset();
  SFUMATO_TRY(cut_at_border());
  const bool keeps_tables = can_keep_tables();
  FramePatches patches;
  if (keeps_tables) {
    SFUMATO_TRY_ASSIGN(auto&& rows, list_rows(inserted_into_->mesh_->vertex_position.size()));
    patches.rows.emplace(std::move(rows));
  }
  patches.is_whole = !patches.rows || !wants_rows;
  if (patches.is_whole) {
    SFUMATO_TRY_ASSIGN(patches.layer, take_patches(keeps_tables));
  } else {
    SFUMATO_TRY(take_rows(patches));
  }
  patches.left = color_.left_count() + (opacity_ ? opacity_->left_count() : 0);
  if (keeps_tables) kept.emplace(release_frame());
  if (context_.cancelled()) return context_.cancel_status();
  return patches;
}

/// Lists the rows that differ from the base, for patches with all triangles and nodes.
/// first_vertex   only one of the two meshes has vertices from this one on
Result<FrameRows> LayerSolver::list_rows(std::size_t first_vertex) const {
  FrameRows rows;
  rows.first_vertex = static_cast<std::uint32_t>(first_vertex);
  Status status = rows.memory.append(context_, changed_, rows.triangles);
  if (status) status = color_.list_rows(context_, rows.memory, rows.triangles, rows.nodes);
  if (status && opacity_) {
    status = opacity_->list_rows(context_, rows.memory, rows.triangles, rows.opacity_nodes);
  }
  const auto order = [&](std::size_t count, std::vector<std::uint32_t>& list) {
    if (status) status = sort_rows(context_, count, list);
  };
  order(mesh_->triangle_count(), rows.triangles);
  order(color_.layout().node_count(), rows.nodes);
  if (opacity_) order(opacity_->layout().node_count(), rows.opacity_nodes);
  if (status && is_joint()) status = rows.memory.append(context_, rows.nodes, rows.opacity_nodes);
  if (!status) return status;
  return rows;
}

/// Finds the soft edges of a frame, which write_rows() does not copy.
Status LayerSolver::take_rows(FramePatches& patches) const {
  TableMemory memory("patches");
  SFUMATO_TRY_ASSIGN(patches.layer.soft_edge, soft_edges({}, memory));
  if (stats_) stats_->triangles += mesh_->triangle_count();
  if (stats_) stats_->vertices += mesh_->vertex_position.size();
  return context_.check();
}

}  // namespace sfumato::solve
