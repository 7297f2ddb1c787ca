#include <algorithm>
#include <utility>

#include "base/poll.hpp"
#include "solve/field_solver.hpp"

/// FieldSolver in the frames of a drag.
namespace sfumato::solve {

Status FieldSolver::start_from(const Context& context, const Seams& known,
                               const mesh::TriangleMesh& mesh) {
  Result<Seams> seams = known.copy(context, mesh);
  if (seams) seams_.emplace(std::move(*seams));
  return seams.status();
}

Status FieldSolver::start_from(const Context& context, const FieldSolver& before,
                               const mesh::TriangleMesh& mesh, FieldFrame frame,
                               std::span<const std::uint32_t> changed) {
  frame_.emplace(std::move(frame));
  if (!frame_->seams) {
    Result<Seams> seams = before.seams_->copy(context, mesh);
    if (!seams) return seams.status();
    seams_.emplace(std::move(*seams));
    return memory_.assign(context, before.vertex_radius_, vertex_radius_);
  }
  seams_.emplace(std::move(*frame_->seams));
  seams_->take_back(*before.seams_, changed);
  if (Status status = take_back_nodes(context, before, changed); !status) return status;
  memory_ = std::move(frame_->memory);
  vertex_radius_ = std::move(frame_->vertex_radius);
  return memory_.assign(context, before.vertex_radius_, vertex_radius_);
}

Status FieldSolver::take_back_nodes(const Context& context, const FieldSolver& before,
                                    std::span<const std::uint32_t> changed) {
  FieldFrame& frame = *frame_;
  const NodeLayout& old = before.layout_;
  const auto channels = static_cast<std::size_t>(old.channel_count);
  frame.node_hit.resize(old.node_count());
  for (const std::uint32_t node : frame.history.met)
    if (node < old.node_count()) frame.node_hit[node] = before.node_hit_[node];
  take_back(old, changed, frame.layout, frame.history);
  RarePoll<16384> poll(context);
  for (const std::uint32_t node : frame.gathered) {
    if (poll.cancelled()) return context.cancel_status();
    if (node >= old.node_count()) continue;
    std::copy_n(old.value.data() + channels * node, channels,
                frame.layout.value.data() + channels * node);
    frame.node_hit[node] = before.node_hit_[node];
  }
  frame.gathered.clear();
  return ok_status();
}

/// With room for what follows the change of so many triangles.
Status FieldSolver::copy_layout(const Context& context, const NodeLayout& from,
                                std::span<const std::uint8_t> node_hit, std::size_t changed) {
  const std::size_t triangles = seams_->half_edge_count() / 3;
  const std::size_t nodes = std::max(from.node_count() + 6 * changed,  // as update_layout asks
                                     std::size_t{from.node_count()} / 4 * 5);
  layout_.channel_count = from.channel_count;
  const auto width = static_cast<std::size_t>(from.channel_count);
  Status status;
  const auto copy = [&](const auto& source, auto& to, TableMemory& memory, std::size_t room) {
    if (status) status = memory.reserve(context, to, std::max(room, source.size()));
    if (status) status = memory.append(context, source, to);
  };
  copy(from.triangle_node, layout_.triangle_node, layout_memory_, kNodesPerTriangle * triangles);
  copy(from.edge_is_curve, layout_.edge_is_curve, layout_memory_, 3 * triangles);
  copy(from.position, layout_.position, layout_memory_, nodes);
  copy(from.is_fixed, layout_.is_fixed, layout_memory_, nodes);
  copy(from.value, layout_.value, layout_memory_, width * nodes);
  copy(node_hit, node_hit_, memory_, nodes);
  return status;
}

Status FieldSolver::list_moved(const Context& context, const NodeLayout& old) {
  RarePoll<65536> poll(context);
  for (const std::uint32_t node : history_.unused) layout_.is_fixed[node] = 1;  // nobody asks
  for (const std::uint32_t node : history_.met) {
    if (poll.cancelled()) return context.cancel_status();
    if (node >= old.node_count()) continue;  // it is new, and listed
    if (layout_.is_fixed[node]) {
      node_hit_[node] = 1;
    } else if (old.is_fixed[node] || !(layout_.position[node] == old.position[node])) {
      Status status = memory_.push_back(context, to_gather_, node);
      if (!status) return status;
    } else {
      history_.node_seen[node] = 0;
    }
  }
  return ok_status();
}

Status FieldSolver::list_changed(Context& context, const PreparedField& with,
                                 const FieldSolver& without, std::span<const std::uint8_t> is_same,
                                 const gather::ShareBound* bound, TableMemory& memory,
                                 std::vector<std::uint32_t>& changed) {
  const gather::Gatherer& rest = without.field_.gatherer;
  const std::span<const Vec2> positions = without.layout_.position;
  if (!with.is_thinned && !without.field_.is_thinned) {
    return with.gatherer.list_changes(context, rest, positions,
                                      {without.free_place_, is_same, bound, without.node_hit_},
                                      memory, changed);
  }
  std::vector<std::uint8_t> may_differ;
  std::vector<std::uint32_t> free;
  TableMemory scratch("patches");
  Status status = scratch.resize(context, may_differ, positions.size());
  if (status) status = without.list_free_nodes(context, scratch, free);
  if (!status) return status;
  status = with.gatherer.find_changes(context, rest, {positions, free}, may_differ);
  if (status) status = memory.reserve(context, changed, free.size());
  for (std::size_t i = 0; status && i < free.size(); ++i)
    if (may_differ[free[i]]) changed.push_back(free[i]);
  return status;
}

/// Of nodes that list_moved() has listed, or that need no value, none is listed again.
Status FieldSolver::list_to_gather(Context& context, const PreparedField& with,
                                   const FieldSolver& without,
                                   std::span<const std::uint8_t> is_same,
                                   const gather::ShareBound* bound) {
  TableMemory scratch("patches");
  std::vector<std::uint32_t> may_differ;
  Status status = list_changed(context, with, without, is_same, bound, scratch, may_differ);
  for (std::size_t i = 0; status && i < may_differ.size(); ++i) {
    if (history_.was_met(may_differ[i])) continue;
    status = memory_.push_back(context, to_gather_, may_differ[i]);
  }
  return status;
}

Status FieldSolver::lay_out_from(Context& context, const FieldSolver& before,
                                 const mesh::TriangleMesh& mesh,
                                 std::span<const std::uint32_t> changed,
                                 std::span<const std::uint8_t> is_same,
                                 const gather::ShareBound* bound) {
  history_ = std::move(frame_->history);
  history_.is_logged = true;
  Status status;
  if (frame_->layout.triangle_node.empty()) {
    status = copy_layout(context, before.layout_, before.node_hit_, changed.size());
  } else {
    layout_ = std::move(frame_->layout);
    layout_memory_ = std::move(frame_->layout_memory);
    node_hit_ = std::move(frame_->node_hit);
    to_gather_ = std::move(frame_->gathered);
  }
  if (status) status = follow(context, mesh, changed);
  if (status) status = list_moved(context, before.layout_);
  if (!has_code_values(field_.attributes)) bound = nullptr;
  return status ? list_to_gather(context, field_, before, is_same, bound) : status;
}

Status FieldSolver::lay_out_without(Context& context, const RefinedField& known,
                                    const PreparedField& with, const mesh::TriangleMesh& mesh,
                                    std::span<const std::uint32_t> changed,
                                    std::span<const std::uint8_t> is_same) {
  history_.is_logged = true;
  Status status = copy_layout(context, known.layout, known.node_hit, changed.size());
  if (status) status = follow(context, mesh, changed);
  if (status) status = list_moved(context, known.layout);
  if (status) status = locate_nodes(context, known, is_same);
  if (status) status = list_to_gather(context, with, *this, is_same, nullptr);
  field_.gatherer.forget_before();
  history_.free(layout_memory_);
  return status;
}

Status FieldSolver::list_rows(const Context& context, TableMemory& memory,
                              std::vector<std::uint32_t>& triangles,
                              std::vector<std::uint32_t>& nodes) const {
  Status status = memory.append(context, history_.reassigned, triangles);
  if (status) status = memory.append(context, history_.met, nodes);
  return status ? memory.append(context, to_gather_, nodes) : status;
}

FieldFrame FieldSolver::release_frame() {
  FieldFrame frame;
  frame.field.emplace(std::move(field_));
  frame.seams = std::move(seams_);
  frame.vertex_radius = std::move(vertex_radius_);
  frame.layout = std::move(layout_);
  frame.history = std::move(history_);
  frame.node_hit = std::move(node_hit_);
  frame.gathered = std::move(to_gather_);
  frame.layout_memory = std::move(layout_memory_);
  frame.memory = std::move(memory_);
  return frame;
}

Status FieldSolver::locate_nodes(Context& context, const RefinedField& known,
                                 std::span<const std::uint8_t> is_same) {
  if (field_.is_thinned) return ok_status();
  TableMemory scratch("patches");
  std::vector<std::uint32_t> free, place;
  Status status = list_free_nodes(context, scratch, free);
  if (status) status = scratch.append(context, known.node_place, place);
  if (!status) return status;
  for (std::uint32_t& triangle : place)
    if (triangle < is_same.size() && !is_same[triangle]) triangle = gather::kUnknownPlace;
  for (const std::uint32_t node : history_.met)
    if (node < place.size()) place[node] = gather::kUnknownPlace;
  Result<gather::PointPlaces> places =
      field_.gatherer.locate(context, {layout_.position, free}, place);
  if (!places) return places.status();
  free_place_ = std::move(*places);
  return ok_status();
}

}  // namespace sfumato::solve
