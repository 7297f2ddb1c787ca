#include "solve/fields/layout_order.hpp"

#include <algorithm>
#include <utility>

#include "base/poll.hpp"
#include "picture/patch.hpp"
#include "solve/fields/fan.hpp"

namespace sfumato::solve {
namespace {

/// A node belongs to the part of the first triangle that visits it, as in lay_out_nodes.
constexpr std::uint32_t kTrianglesPerPart = 2048;

/// Numbers the nodes in the order of lay_out_nodes: first in each part separately, then all.
class NodeNumbering {
 public:
  NodeNumbering(const Context& context, const mesh::TriangleMesh& mesh, NodeLayout& layout)
      : context_(context), mesh_(mesh), layout_(layout) {}

  Result<std::vector<std::uint32_t>> run(TableMemory& memory) {
    SFUMATO_TRY(make_tables());
    SFUMATO_TRY(find_vertices());
    SFUMATO_TRY(for_each_part([&](std::size_t begin, std::size_t end) {
      return count_part(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
    }));
    SFUMATO_TRY(join_parts(memory));
    SFUMATO_TRY(number_triangles());
    return std::move(order_);
  }

 private:
  struct Part {
    std::vector<std::uint32_t> order;  ///< its nodes
    std::size_t first = 0;             ///< place of these in the whole
    TableMemory memory{"patches"};
  };

  template <class Body>
  Status for_each_part(Body body) {
    return try_parallel_for(context_, mesh_.triangle_count(), kTrianglesPerPart, body);
  }

  Status make_tables() {
    const std::size_t vertices = mesh_.vertex_position.size();
    const std::size_t parts = (mesh_.triangle_count() + kTrianglesPerPart - 1) / kTrianglesPerPart;
    SFUMATO_TRY(memory_.resize(context_, number_, layout_.node_count(), kNoNode));
    SFUMATO_TRY(memory_.resize(context_, is_on_seam_, vertices));
    SFUMATO_TRY(memory_.resize(context_, first_spoke_, vertices, kNoNode));
    SFUMATO_TRY(memory_.reserve(context_, parts_, parts));
    for (std::size_t i = 0; i < parts; ++i) parts_.emplace_back();
    return ok_status();
  }

  /// Finds vertices with several nodes. Only at the ends of seams do the triangles of a fan have
  /// more than one node.
  Status find_vertices() {
    RarePoll<65536> poll(context_);
    for (std::uint32_t h = 0; h < layout_.edge_is_curve.size(); ++h) {
      if (poll.cancelled()) return context_.cancel_status();
      std::uint32_t& first = first_spoke_[mesh_.origin(h)];
      first = std::min(first, h);
      if (layout_.edge_is_curve[h]) is_on_seam_[mesh_.origin(h)] = is_on_seam_[mesh_.target(h)] = 1;
    }
    return ok_status();
  }

  Status count_part(std::uint32_t begin, std::uint32_t end) {
    Part& part = parts_[begin / kTrianglesPerPart];
    SFUMATO_TRY(part.memory.reserve(context_, part.order, 5 * (end - begin)));
    Fan fan;
    for (std::uint32_t t = begin; t < end; ++t) {
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) SFUMATO_TRY(count_at_vertex(h, fan, part));
      SFUMATO_TRY(part.memory.make_room(context_, part.order, 7));
      count_in_triangle(t, part);
    }
    return ok_status();
  }

  Status count_at_vertex(std::uint32_t h, Fan& fan, Part& part) {
    const std::uint32_t vertex = mesh_.origin(h);
    if (first_spoke_[vertex] != h) return ok_status();
    fan.spoke.assign(1, h);
    if (is_on_seam_[vertex])
      fan.collect(mesh_, h, [&](std::uint32_t spoke) { return layout_.edge_is_curve[spoke] != 0; });
    SFUMATO_TRY(part.memory.make_room(context_, part.order, fan.spoke.size()));
    for (const std::uint32_t spoke : fan.spoke) count(node_at(spoke / 3, spoke % 3), part);
    return ok_status();
  }

  /// Counts the nodes of its edges and its barycentre.
  void count_in_triangle(std::uint32_t t, Part& part) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * t + k;
      const std::int32_t twin = mesh_.half_edge_twin[h];
      const bool is_other =
          !layout_.edge_is_curve[h] && twin != mesh::kNone && static_cast<std::uint32_t>(twin) < h;
      if (is_other) continue;
      count(node_at(t, near_node(k)), part);
      count(node_at(t, far_node(k)), part);
    }
    count(node_at(t, 9), part);
  }

  /// Counts a node. A node lies at one vertex, edge or barycentre: no other part visits it.
  void count(std::uint32_t node, Part& part) {
    if (number_[node] != kNoNode) return;
    number_[node] = static_cast<std::uint32_t>(part.order.size());
    part.order.push_back(node);
  }

  Status join_parts(TableMemory& memory) {
    std::size_t nodes = 0;
    for (Part& part : parts_) {
      part.first = nodes;
      nodes += part.order.size();
    }
    SFUMATO_TRY(memory.resize(context_, order_, nodes));
    return parallel_for(context_, parts_.size(), 1, [&](std::size_t i, std::size_t) {
      std::size_t place = parts_[i].first;
      for (const std::uint32_t node : parts_[i].order) {
        number_[node] = static_cast<std::uint32_t>(place);
        order_[place++] = node;
      }
    });
  }

  Status number_triangles() {
    return for_each_part([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = kNodesPerTriangle * begin; i < kNodesPerTriangle * end; ++i)
        layout_.triangle_node[i] = number_[layout_.triangle_node[i]];
      return ok_status();
    });
  }

  std::uint32_t node_at(std::uint32_t triangle, std::uint32_t place) const {
    return layout_.triangle_node[node_slot(triangle, place)];
  }

  const Context& context_;
  const mesh::TriangleMesh& mesh_;
  NodeLayout& layout_;
  TableMemory memory_{"patches"};
  std::vector<std::uint32_t> number_;       ///< per node: its new number
  std::vector<std::uint32_t> order_;        ///< and back
  std::vector<std::uint32_t> first_spoke_;  ///< per vertex of the mesh: its lowest half-edge
  std::vector<std::uint8_t> is_on_seam_;    ///< per vertex
  std::vector<Part> parts_;
};

}  // namespace

Result<std::vector<std::uint32_t>> put_in_order(const Context& context,
                                                const mesh::TriangleMesh& mesh, TableMemory& memory,
                                                NodeLayout& layout) {
  SFUMATO_TRY_ASSIGN(auto&& order, NodeNumbering(context, mesh, layout).run(memory));
  const auto channels = static_cast<std::size_t>(layout.channel_count);
  SFUMATO_TRY(reorder(context, order, memory, layout.position));
  SFUMATO_TRY(reorder(context, order, memory, layout.is_fixed));
  SFUMATO_TRY(reorder(context, order, memory, layout.value, channels));
  return std::move(order);
}

}  // namespace sfumato::solve
