#include "solve/layout_order.hpp"

#include "base/poll.hpp"
#include "solve/fan.hpp"

namespace sfumato::solve {
namespace {

/// Goes through the triangles as lay_out_nodes does.
class NodeNumbering {
 public:
  NodeNumbering(const Context& context, const mesh::TriangleMesh& mesh, NodeLayout& layout)
      : context_(context), mesh_(mesh), layout_(layout) {}

  Result<std::vector<std::uint32_t>> run(TableMemory& memory) {
    Status status = memory_.resize(context_, number_, layout_.node_count(), kNoNode);
    if (status) status = memory_.resize(context_, vertex_, mesh_.vertex_position.size(), kPlain);
    if (status) status = memory.reserve(context_, order_, layout_.node_count());
    if (status) status = find_seams();
    if (status) status = number_triangles();
    if (!status) return status;
    return std::move(order_);
  }

 private:
  /// Only at the ends of seams do the triangles of a fan have more than one node.
  enum Vertex : std::uint8_t { kPlain, kOnSeam, kDone };

  Status find_seams() {
    RarePoll<65536> poll(context_);
    for (std::uint32_t h = 0; h < layout_.edge_is_curve.size(); ++h) {
      if (poll.cancelled()) return context_.cancel_status();
      if (layout_.edge_is_curve[h]) vertex_[mesh_.origin(h)] = vertex_[mesh_.target(h)] = kOnSeam;
    }
    return ok_status();
  }

  /// A triangle is not looked at again once its nodes are numbered: fans begin at their first.
  Status number_triangles() {
    RarePoll<4096> poll(context_);
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      if (poll.cancelled()) return context_.cancel_status();
      std::uint32_t* const node = layout_.triangle_node.data() + node_slot(t, 0);
      for (std::uint32_t k = 0; k < 3; ++k) number_corner(3 * t + k, node[k]);
      for (std::uint32_t i = 3; i < kNodesPerTriangle; ++i) give_number(node[i]);
      for (std::uint32_t i = 0; i < kNodesPerTriangle; ++i) node[i] = number_[node[i]];
    }
    return context_.check();
  }

  void number_corner(std::uint32_t h, std::uint32_t node) {
    Vertex& vertex = vertex_[mesh_.origin(h)];
    if (vertex == kPlain) return give_number(node);
    if (vertex == kDone) return;
    vertex = kDone;
    fan_.collect(mesh_, h, [&](std::uint32_t spoke) { return layout_.edge_is_curve[spoke] != 0; });
    for (const std::uint32_t spoke : fan_.spoke)
      give_number(layout_.triangle_node[node_slot(spoke / 3, spoke % 3)]);
  }

  void give_number(std::uint32_t node) {
    if (number_[node] != kNoNode) return;
    number_[node] = static_cast<std::uint32_t>(order_.size());
    order_.push_back(node);
  }

  const Context& context_;
  const mesh::TriangleMesh& mesh_;
  NodeLayout& layout_;
  TableMemory memory_{"patches"};
  std::vector<std::uint32_t> number_;  ///< per node: its new number
  std::vector<std::uint32_t> order_;   ///< and back
  std::vector<Vertex> vertex_;         ///< per vertex of the mesh
  Fan fan_;
};

}  // namespace

Result<std::vector<std::uint32_t>> put_in_order(const Context& context,
                                                const mesh::TriangleMesh& mesh, TableMemory& memory,
                                                NodeLayout& layout) {
  Result<std::vector<std::uint32_t>> order = NodeNumbering(context, mesh, layout).run(memory);
  if (!order) return order.status();
  const auto channels = static_cast<std::size_t>(layout.channel_count);
  Status status = reorder(context, *order, memory, layout.position);
  if (status) status = reorder(context, *order, memory, layout.is_fixed);
  if (status) status = reorder(context, *order, memory, layout.value, channels);
  if (!status) return status;
  return order;
}

}  // namespace sfumato::solve
