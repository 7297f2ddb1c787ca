#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

#include "base/poll.hpp"
#include "base/stopwatch.hpp"
#include "base/try.hpp"
#include "gather/rows/weight_class.hpp"
#include "solve/fields/field_solver.hpp"
#include "solve/fields/frame_rows.hpp"

/// The functions of FieldSolver for the frames of a drag.
namespace sfumato::solve {
namespace {

/// The fewest nodes that are gathered between two readings of the clock.
constexpr std::size_t kLeastBatch = 256;

/// The resolution of clocks in browsers, seconds.
constexpr double kClockTick = 1e-4;

}  // namespace

Status FieldSolver::start_from(const Context& context, const RefinedField& known,
                               const mesh::TriangleMesh& mesh) {
  SFUMATO_TRY_ASSIGN(auto&& seams, known.seams->copy(context, mesh));
  seams_.emplace(std::move(seams));
  return memory_.assign(context, known.vertex_radius, vertex_radius_);
}

Status FieldSolver::start_from(const Context& context, const FieldSolver& before,
                               const mesh::TriangleMesh& mesh, FieldFrame frame,
                               std::span<const std::uint32_t> changed, bool remembers) {
  frame_.emplace(std::move(frame));
  if (!frame_->seams) {
    SFUMATO_TRY_ASSIGN(auto&& seams, before.seams_->copy(context, mesh));
    seams_.emplace(std::move(seams));
    return memory_.assign(context, before.vertex_radius_, vertex_radius_);
  }
  seams_.emplace(std::move(*frame_->seams));
  seams_->take_back(*before.seams_, changed);
  if (remembers) {
    SFUMATO_TRY(remember_values(context, *frame_, before.layout_.node_count()));
  }
  SFUMATO_TRY(take_back_nodes(context, before, changed));
  memory_ = std::move(frame_->memory);
  vertex_radius_ = std::move(frame_->vertex_radius);
  return memory_.assign(context, before.vertex_radius_, vertex_radius_);
}

/// Keeps the values of gathered nodes below `nodes` that have the same position as in the base of
/// the frame.
Status FieldSolver::remember_values(const Context& context, const FieldFrame& frame,
                                    std::size_t nodes) {
  const auto channels = static_cast<std::size_t>(frame.layout.channel_count);
  std::vector<std::uint32_t>& known = last_.node;
  SFUMATO_TRY(last_.memory.assign(context, frame.gathered, known));
  std::erase_if(known,
                [&](std::uint32_t node) { return node >= nodes || frame.history.was_met(node); });
  SFUMATO_TRY(sort_rows(context, nodes, known));
  SFUMATO_TRY(last_.memory.reserve(context, last_.value, channels * known.size()));
  SFUMATO_TRY(last_.memory.reserve(context, last_.hit, known.size()));
  for (const std::uint32_t node : known) {
    const auto value = frame.layout.value.begin() + static_cast<std::ptrdiff_t>(channels * node);
    last_.value.insert(last_.value.end(), value, value + static_cast<std::ptrdiff_t>(channels));
    last_.hit.push_back(frame.node_hit[node]);
  }
  return ok_status();
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

/// Copies a layout, with room for the update of this many triangles.
Status FieldSolver::copy_layout(const Context& context, const NodeLayout& from,
                                std::span<const std::uint8_t> node_hit, std::size_t changed) {
  const std::size_t triangles = seams_->half_edge_count() / 3;
  const std::size_t nodes = std::max(from.node_count() + 6 * changed,  // as update_layout needs
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
  for (const std::uint32_t node : history_.unused) layout_.is_fixed[node] = 1;  // needs no value
  for (const std::uint32_t node : history_.met) {
    if (poll.cancelled()) return context.cancel_status();
    if (node >= old.node_count()) continue;  // new nodes are listed already
    if (layout_.is_fixed[node]) {
      node_hit_[node] = 1;
    } else if (old.is_fixed[node] || !(layout_.position[node] == old.position[node])) {
      SFUMATO_TRY(memory_.push_back(context, to_gather_, node));
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
  SFUMATO_TRY(scratch.resize(context, may_differ, positions.size()));
  SFUMATO_TRY(without.list_free_nodes(context, scratch, free));
  std::optional<gather::InsertedShare> inserted;
  if (bound) inserted.emplace(gather::InsertedShare{*bound, without.node_hit_});
  SFUMATO_TRY(with.gatherer.find_changes(context, rest, {positions, free}, may_differ,
                                         inserted ? &*inserted : nullptr));
  SFUMATO_TRY(memory.reserve(context, changed, free.size()));
  for (std::size_t i = 0; i < free.size(); ++i)
    if (may_differ[free[i]]) changed.push_back(free[i]);
  return ok_status();
}

/// Skips nodes that the update met: list_moved() has listed them, or they need no value.
Status FieldSolver::list_to_gather(Context& context, const PreparedField& with,
                                   const FieldSolver& without,
                                   std::span<const std::uint8_t> is_same,
                                   const gather::ShareBound* bound,
                                   std::vector<std::uint32_t>& listed) {
  TableMemory scratch("patches");
  std::vector<std::uint32_t> may_differ;
  SFUMATO_TRY(list_changed(context, with, without, is_same, bound, scratch, may_differ));
  for (std::size_t i = 0; i < may_differ.size(); ++i) {
    if (history_.was_met(may_differ[i])) continue;
    SFUMATO_TRY(memory_.push_back(context, listed, may_differ[i]));
  }
  return ok_status();
}

Status FieldSolver::lay_out_from(Context& context, const FieldSolver& before,
                                 const mesh::TriangleMesh& mesh,
                                 std::span<const std::uint32_t> changed,
                                 std::span<const std::uint8_t> is_same,
                                 const gather::ShareBound* bound,
                                 const gather::ShareBound* waiting) {
  history_ = std::move(frame_->history);
  history_.is_logged = true;
  Status status;
  if (frame_->layout.triangle_node.empty()) {
    status = copy_layout(context, before.layout_, before.node_hit_, changed.size());
  } else {
    layout_ = std::move(frame_->layout);
    layout_memory_ = std::move(frame_->layout_memory);
    node_hit_ = std::move(frame_->node_hit);
    gathered_ = std::move(frame_->gathered);
    left_ = std::move(frame_->left);
    left_.clear();
  }
  if (status) status = follow(context, mesh, changed);
  if (status) status = list_moved(context, before.layout_);
  if (!has_code_values(field_.attributes)) bound = nullptr;
  if (!status) return status;
  status = list_to_gather(context, field_, before, is_same, bound, waiting ? left_ : to_gather_);
  return status && waiting ? order_left(context, before, *waiting) : status;
}

/// Sorts left_ by the largest change that the curve may cause at a node, the largest last. Nodes
/// whose value in the last frame is known come first and show that value. The other nodes show
/// their value without the curve; they are gathered now if the curve may change it completely.
Status FieldSolver::order_left(const Context& context, const FieldSolver& before,
                               const gather::ShareBound& share) {
  std::vector<std::uint64_t> known, unknown;  // keys: the change, then the node
  TableMemory scratch("patches");
  Status status = scratch.reserve(context, known, std::min(left_.size(), last_.node.size()));
  if (status) status = scratch.reserve(context, unknown, left_.size());
  RarePoll<256> poll(context);
  const float unit = before.field_.gatherer.weight_unit();
  if (status) status = sort_rows(context, layout_.node_count(), left_);
  for (std::size_t i = 0, last = 0; status && i < left_.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const std::uint32_t node = left_[i];
    const bool is_known = show_last_value(node, last);
    const float weight = gather::least_weight(before.node_hit_[node]);
    const auto change = static_cast<float>(share.share_at(layout_.position[node], weight, unit));
    const std::uint64_t place = std::uint64_t{std::bit_cast<std::uint32_t>(change)} << 32 | ~node;
    if (is_known || change < 1) {
      (is_known ? known : unknown).push_back(place);
    } else {
      status = memory_.push_back(context, to_gather_, node);
    }
  }
  left_.clear();
  shown_left_ = known.size();
  last_ = {};
  for (std::vector<std::uint64_t>* list : {&known, &unknown}) {
    if (status) status = TableMemory::sort(context, *list, std::less<>());
    for (const std::uint64_t place : *list) left_.push_back(~static_cast<std::uint32_t>(place));
  }
  return status;
}

/// Sets a node to its value in the last frame if that is known, and returns whether it is.
/// at   position in last_: 0 for the first node; later nodes must ascend
bool FieldSolver::show_last_value(std::uint32_t node, std::size_t& at) {
  while (at < last_.node.size() && last_.node[at] < node) ++at;
  if (at == last_.node.size() || last_.node[at] != node) return false;
  const auto channels = static_cast<std::size_t>(layout_.channel_count);
  std::copy_n(last_.value.data() + channels * at, channels, layout_.value.data() + channels * node);
  node_hit_[node] = last_.hit[at];
  return true;
}

Result<std::size_t> FieldSolver::gather_left(Context& context, const FrameTime& time,
                                             bool advances) {
  const std::size_t all = left_.size();
  std::size_t batch = kLeastBatch;
  while (!left_.empty() && (advances || time.seconds_left() > 0)) {
    const Stopwatch watch;
    const std::size_t count = time.is_limited() ? std::min(batch, left_.size()) : left_.size();
    SFUMATO_TRY(gather_last_of_left(context, count));
    advances = false;
    const double fit = time.seconds_left() / (watch.seconds() + kClockTick) * double(count);
    batch = std::max(kLeastBatch, static_cast<std::size_t>(std::min(fit, 4.0 * double(count))));
  }
  return all - left_.size();
}

Status FieldSolver::count_shown(const Context& context) {
  const auto shown = std::span(left_).first(std::min(shown_left_, left_.size()));
  shown_left_ = 0;
  return memory_.append(context, shown, gathered_);
}

Status FieldSolver::gather_last_of_left(Context& context, std::size_t count) {
  const auto batch = std::span(left_).last(count);
  std::ranges::sort(batch);  // numbers of neighbours are close
  Status status = memory_.append(context, batch, gathered_);
  if (status) {
    status = field_.gatherer.gather(context, {layout_.position, batch}, {}, layout_.value,
                                    node_hit_, true);
  }
  left_.resize(left_.size() - count);
  return status;
}

Status FieldSolver::lay_out_without(Context& context, const RefinedField& known,
                                    const PreparedField& with, const mesh::TriangleMesh& mesh,
                                    std::span<const std::uint32_t> changed,
                                    std::span<const std::uint8_t> is_same,
                                    const gather::ShareBound* bound) {
  history_.is_logged = true;
  Status status = copy_layout(context, known.layout, known.node_hit, changed.size());
  if (status) status = follow(context, mesh, changed);
  if (status) status = list_moved(context, known.layout);
  if (status) status = locate_nodes(context, known, is_same);
  // Known weights are in units of the heaviest curve. The bound cannot use them if that curve was
  // removed.
  const bool is_heaviest = field_.gatherer.weight_unit() != with.gatherer.weight_unit();
  if (is_heaviest || !has_code_values(field_.attributes)) bound = nullptr;
  if (status) status = list_to_gather(context, with, *this, is_same, bound, to_gather_);
  field_.gatherer.forget_before();
  return status;
}

Status FieldSolver::list_rows(const Context& context, TableMemory& memory,
                              std::vector<std::uint32_t>& triangles,
                              std::vector<std::uint32_t>& nodes) const {
  Status status = memory.append(context, history_.reassigned, triangles);
  if (status) status = memory.append(context, history_.met, nodes);
  return status ? memory.append(context, gathered_, nodes) : status;
}

FieldFrame FieldSolver::release_frame() {
  FieldFrame frame;
  frame.field.emplace(std::move(field_));
  frame.seams = std::move(seams_);
  frame.vertex_radius = std::move(vertex_radius_);
  frame.layout = std::move(layout_);
  frame.history = std::move(history_);
  frame.node_hit = std::move(node_hit_);
  frame.gathered = std::move(gathered_);
  frame.left = std::move(left_);
  frame.layout_memory = std::move(layout_memory_);
  frame.memory = std::move(memory_);
  return frame;
}

void FieldSolver::resume(FieldFrame frame) {
  seams_ = std::move(frame.seams);
  vertex_radius_ = std::move(frame.vertex_radius);
  layout_ = std::move(frame.layout);
  history_ = std::move(frame.history);
  node_hit_ = std::move(frame.node_hit);
  gathered_ = std::move(frame.gathered);
  left_ = std::move(frame.left);
  layout_memory_ = std::move(frame.layout_memory);
  memory_ = std::move(frame.memory);
  frame_.emplace();
}

Status FieldSolver::locate_all(Context& context) {
  return locate_free(context, {});
}

/// known   as Gatherer::locate
Status FieldSolver::locate_free(Context& context, std::span<const std::uint32_t> known) {
  if (field_.is_thinned) return ok_status();
  TableMemory scratch("patches");
  std::vector<std::uint32_t> free;
  SFUMATO_TRY(list_free_nodes(context, scratch, free));
  SFUMATO_TRY_ASSIGN(free_place_, field_.gatherer.locate(context, {layout_.position, free}, known));
  return ok_status();
}

Status FieldSolver::locate_nodes(Context& context, const RefinedField& known,
                                 std::span<const std::uint8_t> is_same) {
  TableMemory scratch("patches");
  std::vector<std::uint32_t> place;
  SFUMATO_TRY(scratch.append(context, known.node_place, place));
  for (std::uint32_t& triangle : place)
    if (triangle < is_same.size() && !is_same[triangle]) triangle = gather::kUnknownPlace;
  for (const std::uint32_t node : history_.met)
    if (node < place.size()) place[node] = gather::kUnknownPlace;
  return locate_free(context, place);
}

}  // namespace sfumato::solve
