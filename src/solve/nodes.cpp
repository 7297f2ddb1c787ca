#include "solve/nodes.hpp"

#include <span>

#include "base/poll.hpp"
#include "solve/node_placer.hpp"

namespace sfumato::solve {
namespace {

/// The table of a first layout: every node is a new one.
class NewNodes {
 public:
  explicit NewNodes(NodeLayout& layout) : layout_(layout) {}

  std::uint32_t& node_at(std::uint32_t triangle, std::uint32_t place) {
    return layout_.triangle_node[node_slot(triangle, place)];
  }
  std::uint32_t kept(std::span<const std::uint32_t>) const { return kNoNode; }
  std::uint32_t own(std::uint32_t) const { return kNoNode; }
  std::uint32_t put_free(std::uint32_t, Vec2 position) {
    layout_.position.push_back(position);
    return layout_.node_count() - 1;
  }
  std::uint32_t put_fixed(std::uint32_t kept, Vec2 position) { return put_free(kept, position); }
  void set(std::uint32_t spoke, std::uint32_t node) { node_at(spoke / 3, spoke % 3) = node; }

 private:
  NodeLayout& layout_;
};

Status place_all(const Context& context, const mesh::TriangleMesh& mesh, const Seams& seams,
                 TableMemory& memory, NodeLayout& layout, NodePlacer<NewNodes>& placer) {
  std::size_t known = capacity_bytes(layout.position);
  RarePoll<4096> poll(context);
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    if (poll.cancelled()) return context.cancel_status();
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      layout.edge_is_curve[h] = seams.is_seam(h);
      if (layout.triangle_node[node_slot(t, h % 3)] == kNoNode) placer.place_around_vertex(h);
    }
    for (std::uint32_t k = 0; k < 3; ++k) placer.place_on_edge(t, k);
    placer.place_at_barycentre(t);
    Status status = memory.settle(context, capacity_bytes(layout.position), known);
    if (status) status = placer.settle(context);
    if (!status) return status;
  }
  return ok_status();
}

}  // namespace

Result<NodeLayout> lay_out_nodes(const Context& context, const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes, const Seams& seams,
                                 TableMemory& memory) {
  NodeLayout layout;
  layout.channel_count = attributes.channel_count();
  const std::size_t triangles = mesh.triangle_count();
  Status status =
      memory.resize(context, layout.triangle_node, kNodesPerTriangle * triangles, kNoNode);
  if (status) status = memory.resize(context, layout.edge_is_curve, 3 * triangles);
  if (status) status = memory.reserve(context, layout.position, 5 * triangles);
  if (!status) return status;
  NewNodes table(layout);
  NodePlacer placer(mesh, seams, table);
  status = place_all(context, mesh, seams, memory, layout, placer);
  if (status) status = memory.resize(context, layout.is_fixed, layout.node_count());
  const auto channels = static_cast<std::size_t>(layout.channel_count);
  if (status) status = memory.resize(context, layout.value, channels * layout.node_count());
  if (!status) return status;
  RarePoll<4096> poll(context);
  for (const FixedShare& fixed : placer.fixed()) {
    if (poll.cancelled()) return context.cancel_status();
    layout.is_fixed[fixed.node] = 1;
    add_share(fixed, attributes.base_channels, layout);
  }
  if (status = context.check(); !status) return status;
  return layout;
}

}  // namespace sfumato::solve
