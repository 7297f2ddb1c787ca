#include "solve/fields/layout_update.hpp"

#include <algorithm>
#include <functional>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "solve/fields/node_placer.hpp"

namespace sfumato::solve {
namespace {

using mesh::TriangleMesh;

/// The table of an update: nodes of triangles that did not change stay.
class KeptNodes {
 public:
  KeptNodes(TableMemory& memory, NodeLayout& layout, LayoutHistory& history)
      : memory_(memory), layout_(layout), history_(history) {}

  std::uint32_t& node_at(std::uint32_t triangle, std::uint32_t place) {
    return layout_.triangle_node[node_slot(triangle, place)];
  }

  bool is_changed(std::uint32_t triangle) const { return history_.is_changed[triangle] != 0; }

  std::uint32_t kept(std::span<const std::uint32_t> spokes) {
    for (const std::uint32_t spoke : spokes) {
      if (!is_changed(spoke / 3)) return node_at(spoke / 3, spoke % 3);
    }
    return kNoNode;
  }

  /// Makes a separate node. Values that were equal apart from rounding may no longer be so: a node
  /// that several triangles shared then belongs only to the first.
  std::uint32_t own(std::uint32_t spoke) {
    const std::uint32_t node = kept({&spoke, 1});
    return node == kNoNode || is_met(node) ? kNoNode : node;
  }

  std::uint32_t put_free(std::uint32_t kept, Vec2 position) {
    const std::uint32_t node = put_fixed(kept, position);
    if (kept == kNoNode) history_.fresh.push_back(node);
    return node;
  }

  std::uint32_t put_fixed(std::uint32_t kept, Vec2 position) {
    const std::uint32_t node = kept == kNoNode ? new_node() : kept;
    layout_.position[node] = position;
    meet(node);
    return node;
  }

  void set(std::uint32_t spoke, std::uint32_t node) {
    std::uint32_t& here = node_at(spoke / 3, spoke % 3);
    if (here == node) return;
    if (here != kNoNode) left_.push_back(here);
    if (history_.is_logged && !is_changed(spoke / 3)) history_.reassigned.push_back(spoke / 3);
    here = node;
  }

  /// Removes the nodes from a triangle that changed.
  void leave(std::uint32_t triangle) {
    std::uint32_t* const node = &node_at(triangle, 0);
    left_.insert(left_.end(), node, node + kNodesPerTriangle);
    std::fill_n(node, kNodesPerTriangle, kNoNode);
  }

  void meet(std::uint32_t node) {
    if (history_.is_logged && !is_met(node)) history_.met.push_back(node);
    history_.node_seen[node] = history_.updates;
  }

  /// Frees nodes that were removed from a triangle and not met since: no triangle uses them.
  Status free_unmet(const Context& context, RarePoll<4096>& poll) {
    for (const std::uint32_t node : left_) {
      if (poll.cancelled()) return context.cancel_status();
      if (is_met(node)) continue;
      meet(node);
      history_.unused.push_back(node);
    }
    return ok_status();
  }

  Status make_room(const Context& context, std::size_t changed_triangles) {
    const auto channels = static_cast<std::size_t>(layout_.channel_count);
    SFUMATO_TRY(own_memory_.reserve(context, left_, kNodesPerTriangle * changed_triangles));
    SFUMATO_TRY(memory_.reserve(context, history_.fresh, 5 * changed_triangles));
    // About five nodes to a triangle; room for more at a time, since moving takes long.
    const std::size_t nodes = layout_.position.size(), least = nodes + 6 * changed_triangles;
    const std::size_t most = std::max(least, nodes / 4 * 5);
    Status status;
    const auto make_room = [&](auto& table, std::size_t width) {
      if (!status || table.capacity() >= width * least) return;
      status = memory_.reserve(context, table, width * most);
    };
    make_room(layout_.position, 1);
    make_room(layout_.is_fixed, 1);
    make_room(layout_.value, channels);
    make_room(history_.node_seen, 1);
    kept_bytes_ = kept_bytes();
    left_bytes_ = capacity_bytes(left_);
    return status;
  }

  /// Charges the growth of the tables beyond that room.
  Status settle(const Context& context) {
    Status status = memory_.settle(context, kept_bytes(), kept_bytes_);
    return status ? own_memory_.settle(context, capacity_bytes(left_), left_bytes_) : status;
  }

 private:
  std::size_t kept_bytes() const {
    return capacity_bytes(layout_.position, layout_.is_fixed, layout_.value, history_.fresh,
                          history_.unused, history_.node_seen, history_.met, history_.reassigned);
  }

  bool is_met(std::uint32_t node) const { return history_.was_met(node); }

  std::uint32_t new_node() {
    if (!history_.unused.empty()) {
      const std::uint32_t node = history_.unused.back();
      history_.unused.pop_back();
      layout_.is_fixed[node] = 0;
      return node;
    }
    layout_.position.push_back({});
    layout_.is_fixed.push_back(0);
    layout_.value.resize(layout_.value.size() + static_cast<std::size_t>(layout_.channel_count));
    history_.node_seen.push_back(0);
    return layout_.node_count() - 1;
  }

  TableMemory& memory_;  ///< of the layout and its history
  NodeLayout& layout_;
  LayoutHistory& history_;
  std::vector<std::uint32_t> left_;  ///< nodes that triangles had before the update
  TableMemory own_memory_{"patches"};
  std::size_t kept_bytes_ = 0, left_bytes_ = 0;  ///< charged bytes of both
};

/// Returns the lowest half-edge with the same origin as h.
std::uint32_t lowest_spoke(const TriangleMesh& mesh, std::uint32_t h) {
  const auto start = static_cast<std::int32_t>(h);
  std::int32_t lowest = start;
  std::int32_t i = previous_spoke(mesh, h);
  for (; i != mesh::kNone && i != start; i = previous_spoke(mesh, static_cast<std::uint32_t>(i)))
    lowest = std::min(lowest, i);
  if (i == start) return static_cast<std::uint32_t>(lowest);
  for (i = next_spoke(mesh, h); i != mesh::kNone;
       i = next_spoke(mesh, static_cast<std::uint32_t>(i)))
    lowest = std::min(lowest, i);
  return static_cast<std::uint32_t>(lowest);
}

class LayoutUpdate {
 public:
  LayoutUpdate(const Context& context, const TriangleMesh& mesh,
               const curves::SegmentAttributes& attributes, const Seams& seams,
               std::span<const std::uint32_t> changed, TableMemory& memory, NodeLayout& layout,
               LayoutHistory& history)
      : context_(context),
        poll_(context),
        mesh_(mesh),
        base_channels_(attributes.base_channels),
        seams_(seams),
        changed_(changed),
        layout_memory_(memory),
        layout_(layout),
        history_(history),
        table_(memory, layout, history),
        placer_(mesh, seams, table_) {}

  Status run() {
    const std::size_t old_triangles = layout_.triangle_node.size() / kNodesPerTriangle;
    SFUMATO_TRY(begin());
    SFUMATO_TRY(leave_changed(old_triangles));
    SFUMATO_TRY(find_vertices());
    SFUMATO_TRY(TableMemory::sort(context_, first_spokes_, std::less<>()));
    SFUMATO_TRY(place_changed());
    SFUMATO_TRY(set_fixed_values());
    for (const std::uint32_t t : changed_) history_.is_changed[t] = 0;
    Status status = table_.free_unmet(context_, poll_);
    if (status) status = table_.settle(context_);
    return status ? context_.check() : status;
  }

 private:
  Status begin() {
    ++history_.updates;
    history_.fresh.clear();
    const std::size_t triangles = mesh_.triangle_count(), most = triangles / 4 * 5;
    const std::size_t vertices = mesh_.vertex_position.size();
    TableMemory& memory = layout_memory_;
    Status status = memory.grow(context_, layout_.triangle_node, kNodesPerTriangle * triangles,
                                kNodesPerTriangle * most, kNoNode);
    if (status) status = memory.grow(context_, layout_.edge_is_curve, 3 * triangles, 3 * most);
    if (status) status = memory.grow(context_, history_.is_changed, triangles, most);
    if (status) status = memory.grow(context_, history_.vertex_seen, vertices, vertices / 4 * 5);
    if (status) status = memory.resize(context_, history_.node_seen, layout_.node_count());
    return status ? table_.make_room(context_, changed_.size()) : status;
  }

  Status leave_changed(std::size_t old_triangles) {
    for (const std::uint32_t t : changed_) {
      if (poll_.cancelled()) return context_.cancel_status();
      history_.is_changed[t] = 1;
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
        layout_.edge_is_curve[h] = seams_.is_seam(h);
      if (t < old_triangles) table_.leave(t);
    }
    return ok_status();
  }

  /// Lists the corners of triangles that changed, each once.
  Status find_vertices() {
    for (const std::uint32_t t : changed_) {
      if (poll_.cancelled()) return context_.cancel_status();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        std::uint32_t& seen = history_.vertex_seen[mesh_.origin(h)];
        if (seen == history_.updates) continue;
        seen = history_.updates;
        SFUMATO_TRY(memory_.push_back(context_, first_spokes_, lowest_spoke(mesh_, h)));
      }
    }
    return ok_status();
  }

  /// Places nodes in the order of lay_out_nodes, which visits a vertex with its first triangle.
  Status place_changed() {
    auto vertex = first_spokes_.begin();
    for (const std::uint32_t t : changed_) {
      if (poll_.cancelled()) return context_.cancel_status();
      for (; vertex != first_spokes_.end() && *vertex / 3 <= t; ++vertex)
        placer_.place_around_vertex(*vertex);
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t h = 3 * t + k;
        if (keeps_edge(h)) {
          placer_.keep_on_edge(h, static_cast<std::uint32_t>(mesh_.half_edge_twin[h]));
        } else {
          placer_.place_on_edge(t, k);
        }
      }
      placer_.place_at_barycentre(t);
      SFUMATO_TRY(table_.settle(context_));
      SFUMATO_TRY(placer_.settle(context_));
    }
    return ok_status();
  }

  /// Returns whether the nodes of an edge belong to a neighbour that did not change.
  bool keeps_edge(std::uint32_t h) const {
    const std::int32_t twin = mesh_.half_edge_twin[h];
    return twin != mesh::kNone && !seams_.is_seam(h) &&
           !table_.is_changed(static_cast<std::uint32_t>(twin) / 3);
  }

  Status set_fixed_values() {
    const auto channels = static_cast<std::size_t>(layout_.channel_count);
    for (const FixedShare& fixed : placer_.fixed()) {
      if (poll_.cancelled()) return context_.cancel_status();
      layout_.is_fixed[fixed.node] = 1;
      std::fill_n(layout_.value.data() + channels * fixed.node, channels, 0.0f);
    }
    for (const FixedShare& fixed : placer_.fixed()) {
      if (poll_.cancelled()) return context_.cancel_status();
      add_share(fixed, base_channels_, layout_);
    }
    return ok_status();
  }

  const Context& context_;
  RarePoll<4096> poll_;
  const TriangleMesh& mesh_;
  int base_channels_;
  const Seams& seams_;
  std::span<const std::uint32_t> changed_;
  TableMemory& layout_memory_;
  NodeLayout& layout_;
  LayoutHistory& history_;
  KeptNodes table_;
  NodePlacer<KeptNodes> placer_;
  TableMemory memory_{"patches"};
  std::vector<std::uint32_t> first_spokes_;  ///< per vertex to lay out: its lowest half-edge
};

}  // namespace

void LayoutHistory::free(TableMemory& memory) {
  for (std::vector<std::uint32_t>* table :
       {&fresh, &unused, &node_seen, &vertex_seen, &met, &reassigned}) {
    memory.free(*table);
  }
  memory.free(is_changed);
  updates = 0;
}

Status update_layout(const Context& context, const TriangleMesh& mesh,
                     const curves::SegmentAttributes& attributes, const Seams& seams,
                     std::span<const std::uint32_t> changed, TableMemory& memory,
                     NodeLayout& layout, LayoutHistory& history) {
  return LayoutUpdate(context, mesh, attributes, seams, changed, memory, layout, history).run();
}

void take_back(const NodeLayout& before, std::span<const std::uint32_t> changed, NodeLayout& layout,
               LayoutHistory& history) {
  const auto channels = static_cast<std::size_t>(before.channel_count);
  layout.triangle_node.resize(before.triangle_node.size());
  layout.edge_is_curve.resize(before.edge_is_curve.size());
  layout.position.resize(before.position.size());
  layout.is_fixed.resize(before.is_fixed.size());
  layout.value.resize(before.value.size());
  const auto copy_rows = [](const auto& from, auto& to, std::size_t row, std::size_t width) {
    if (width * row >= from.size()) return;
    std::copy_n(from.data() + width * row, width, to.data() + width * row);
  };
  for (const std::span<const std::uint32_t> triangles : {changed, {history.reassigned}}) {
    for (const std::uint32_t t : triangles) {
      copy_rows(before.triangle_node, layout.triangle_node, t, kNodesPerTriangle);
      copy_rows(before.edge_is_curve, layout.edge_is_curve, t, 3);
    }
  }
  for (const std::uint32_t node : history.met) {
    copy_rows(before.position, layout.position, node, 1);
    copy_rows(before.is_fixed, layout.is_fixed, node, 1);
    copy_rows(before.value, layout.value, node, channels);
  }
  for (auto* list : {&history.fresh, &history.unused, &history.met, &history.reassigned})
    list->clear();
}

}  // namespace sfumato::solve
