#include "solve/fields/nodes.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "base/limit_error.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "solve/fields/node_placer.hpp"

namespace sfumato::solve {
namespace {

/// Nodes around a vertex or on an edge belong to the part whose triangle visits them first.
constexpr std::uint32_t kTrianglesPerRun = 2048;

/// The nodes of some triangles, whose numbers begin at 0.
struct Part {
  std::vector<Vec2> position;
  std::vector<FixedShare> fixed;
  std::uint32_t first_node = 0;  ///< the final number of node 0
  TableMemory memory{"patches"};
};

/// The table of a first layout: every node is new.
class NewNodes {
 public:
  NewNodes(NodeLayout& layout, std::vector<Vec2>& position)
      : layout_(layout), position_(position) {}

  std::uint32_t& node_at(std::uint32_t triangle, std::uint32_t place) {
    return layout_.triangle_node[node_slot(triangle, place)];
  }
  std::uint32_t kept(std::span<const std::uint32_t>) const { return kNoNode; }
  std::uint32_t own(std::uint32_t) const { return kNoNode; }
  std::uint32_t put_free(std::uint32_t, Vec2 position) {
    position_.push_back(position);
    return static_cast<std::uint32_t>(position_.size()) - 1;
  }
  std::uint32_t put_fixed(std::uint32_t kept, Vec2 position) { return put_free(kept, position); }
  void set(std::uint32_t spoke, std::uint32_t node) { node_at(spoke / 3, spoke % 3) = node; }

 private:
  NodeLayout& layout_;
  std::vector<Vec2>& position_;
};

/// Lays out parts of the mesh in parallel, and then numbers all nodes.
class FirstLayout {
 public:
  FirstLayout(const Context& context, const mesh::TriangleMesh& mesh,
              const curves::SegmentAttributes& attributes, const Seams& seams, TableMemory& memory,
              std::size_t spare)
      : context_(context),
        mesh_(mesh),
        attributes_(attributes),
        seams_(seams),
        memory_(memory),
        spare_(spare) {
    layout_.channel_count = attributes.channel_count();
  }

  Result<NodeLayout> run() {
    SFUMATO_TRY(make_tables());
    SFUMATO_TRY(find_first_spokes());
    SFUMATO_TRY(place_parts());
    SFUMATO_TRY(number_nodes());
    SFUMATO_TRY(set_fixed_values());
    return std::move(layout_);
  }

 private:
  Status make_tables() {
    const std::size_t triangles = mesh_.triangle_count();
    const std::size_t parts = (triangles + kTrianglesPerRun - 1) / kTrianglesPerRun;
    SFUMATO_TRY(make_table(layout_.triangle_node, kNodesPerTriangle, triangles, spare_));
    SFUMATO_TRY(make_table(layout_.edge_is_curve, 3, triangles, spare_));
    SFUMATO_TRY(scratch_.reserve(context_, parts_, parts));
    for (std::size_t i = 0; i < parts; ++i) parts_.emplace_back();
    return ok_status();
  }

  /// Makes a table with `width` items for each of `count` entries, and room for `spare` more
  /// entries.
  template <class Table>
  Status make_table(Table& table, std::size_t width, std::size_t count, std::size_t spare) {
    Status status = memory_.reserve(context_, table, width * (count + spare));
    return status ? memory_.resize(context_, table, width * count) : status;
  }

  /// Returns about five for each triangle.
  std::size_t spare_nodes() const { return 5 * spare_; }

  /// Finds the lowest half-edge at each vertex, which NodePlacer::place_around_vertex begins with.
  Status find_first_spokes() {
    SFUMATO_TRY(scratch_.resize(context_, first_spoke_, mesh_.vertex_position.size(), kNoNode));
    RarePoll<65536> poll(context_);
    for (std::uint32_t h = 0; h < mesh_.triangle_vertex.size(); ++h) {
      if (poll.cancelled()) return context_.cancel_status();
      std::uint32_t& first = first_spoke_[mesh_.origin(h)];
      first = std::min(first, h);
    }
    return ok_status();
  }

  /// Places the nodes of the parts. The threads determine which part lacks memory first, so the
  /// error does not contain it.
  Status place_parts() {
    Status status = try_parallel_for(context_, mesh_.triangle_count(), kTrianglesPerRun,
                                     [&](std::size_t begin, std::size_t end) {
                                       return place_part(static_cast<std::uint32_t>(begin),
                                                         static_cast<std::uint32_t>(end));
                                     });
    if (status.limit != "memory") return status;
    return make_limit_error("memory", "memory limit reached: the nodes of patches need more");
  }

  Status place_part(std::uint32_t begin, std::uint32_t end) {
    Part& part = parts_[begin / kTrianglesPerRun];
    Status status = part.memory.reserve(context_, part.position, 5 * (end - begin));
    std::size_t known = capacity_bytes(part.position);
    NewNodes table(layout_, part.position);
    NodePlacer placer(mesh_, seams_, table);
    RarePoll<1024> poll(context_);
    for (std::uint32_t t = begin; status && t < end; ++t) {
      if (poll.cancelled()) return context_.cancel_status();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        layout_.edge_is_curve[h] = seams_.is_seam(h);
        if (first_spoke_[mesh_.origin(h)] == h) placer.place_around_vertex(h);
      }
      for (std::uint32_t k = 0; k < 3; ++k) placer.place_on_edge(t, k);
      placer.place_at_barycentre(t);
      status = part.memory.settle(context_, capacity_bytes(part.position), known);
      if (status) status = placer.settle(context_);
    }
    part.fixed = placer.take_fixed(part.memory);
    return status;
  }

  Status number_nodes() {
    std::uint32_t count = 0;
    for (Part& part : parts_) {
      part.first_node = count;
      count += static_cast<std::uint32_t>(part.position.size());
    }
    SFUMATO_TRY(make_table(layout_.position, 1, count, spare_nodes()));
    return parallel_for(context_, parts_.size(), 1, [&](std::size_t i, std::size_t) {
      Part& part = parts_[i];
      std::ranges::copy(part.position, layout_.position.begin() + part.first_node);
      part.memory.free(part.position);
      const auto begin = static_cast<std::uint32_t>(i) * kTrianglesPerRun;
      const std::uint32_t end = std::min(mesh_.triangle_count(), begin + kTrianglesPerRun);
      for (std::uint32_t t = begin; t < end; ++t) number_triangle(t);
    });
  }

  void number_triangle(std::uint32_t t) {
    std::uint32_t* const node = layout_.triangle_node.data() + node_slot(t, 0);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * t + k;
      node[k] += first_node_at(first_spoke_[mesh_.origin(h)]);
      const std::int32_t twin = seams_.is_seam(h) ? mesh::kNone : mesh_.half_edge_twin[h];
      const std::uint32_t first =
          first_node_at(twin == mesh::kNone ? h : std::min(h, static_cast<std::uint32_t>(twin)));
      node[near_node(k)] += first;
      node[far_node(k)] += first;
    }
    node[kCenterNode] += first_node_at(3 * t);
  }

  std::uint32_t first_node_at(std::uint32_t half_edge) const {
    return parts_[half_edge / 3 / kTrianglesPerRun].first_node;
  }

  Status set_fixed_values() {
    const std::size_t nodes = layout_.position.size();
    const auto channels = static_cast<std::size_t>(layout_.channel_count);
    SFUMATO_TRY(make_table(layout_.is_fixed, 1, nodes, spare_nodes()));
    SFUMATO_TRY(make_table(layout_.value, channels, nodes, spare_nodes()));
    return parallel_for(context_, parts_.size(), 1, [&](std::size_t i, std::size_t) {
      for (FixedShare fixed : parts_[i].fixed) {
        fixed.node += parts_[i].first_node;
        layout_.is_fixed[fixed.node] = 1;
        add_share(fixed, attributes_.base_channels, layout_);
      }
    });
  }

  const Context& context_;
  const mesh::TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  const Seams& seams_;
  TableMemory& memory_;
  std::size_t spare_;  ///< triangles
  NodeLayout layout_;
  TableMemory scratch_{"patches"};
  std::vector<std::uint32_t> first_spoke_;  ///< per vertex
  std::vector<Part> parts_;
};

}  // namespace

Result<NodeLayout> lay_out_nodes(const Context& context, const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes, const Seams& seams,
                                 TableMemory& memory, std::size_t spare) {
  return FirstLayout(context, mesh, attributes, seams, memory, spare).run();
}

}  // namespace sfumato::solve
