#pragma once

#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "curves/attributes.hpp"
#include "picture/patch.hpp"
#include "solve/fields/angle.hpp"
#include "solve/fields/fan.hpp"
#include "solve/fields/nodes.hpp"
#include "solve/fields/seams.hpp"

namespace sfumato::solve {

/// A share of the value that a curve gives to a node.
struct FixedShare {
  std::uint32_t node;
  float share;
  SeamValue value;
};

/// Adds that share to the node's value.
inline void add_share(const FixedShare& fixed, int base_channels, NodeLayout& layout) {
  float* const out =
      layout.value.data() + static_cast<std::size_t>(layout.channel_count) * fixed.node;
  const auto& base = fixed.value.base.channel;
  for (std::size_t c = 0; c < static_cast<std::size_t>(base_channels); ++c) {
    out[c] += fixed.share * base[c];
  }
  for (int i = 0; i < 2; ++i) {
    if (fixed.value.share[i] == 0) continue;
    out[base_channels + static_cast<int>(fixed.value.shader[i])] +=
        fixed.share * fixed.value.share[i];
  }
}

/// The rules for the places of nodes and for the triangles that share them, independent of the
/// table that stores the nodes. A Table has
///
///   node_at(triangle, place)   a reference to the node of that place
///   kept(spokes)               the node kept at the origin of these spokes, or kNoNode
///   own(spoke)                 the same for only that triangle
///   put_free(kept, position)   places that node, or a new one, there; its value is gathered
///   put_fixed(kept, position)  the same, but a curve gives its value
///   set(spoke, node)           sets node_at(spoke / 3, spoke % 3)
template <class Table>
class NodePlacer {
 public:
  NodePlacer(const mesh::TriangleMesh& mesh, const Seams& seams, Table& table)
      : mesh_(mesh), seams_(seams), table_(table) {}

  /// Places the nodes at h's origin, for every triangle of the fan: one for all if no seam ends
  /// here, else one or more for each sector between seams. The order of the sectors depends on h,
  /// which must be the lowest half-edge that begins there.
  void place_around_vertex(std::uint32_t h) {
    const auto is_seam = [&](std::uint32_t spoke) { return seams_.is_seam(spoke); };
    fan_.collect(mesh_, h, is_seam);
    if (!touches(is_seam)) return place_for_all(corner(h));
    const std::vector<std::uint32_t>& spoke = fan_.spoke;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= spoke.size(); ++i) {
      if (i < spoke.size() && !is_seam(spoke[i])) continue;
      place_in_sector({spoke.data() + begin, i - begin});
      begin = i;
    }
  }

  /// Places the two nodes on edge k: shared with the neighbour unless the edge is a seam. The first
  /// of both triangles puts them.
  void place_on_edge(std::uint32_t t, std::uint32_t k) {
    const std::uint32_t h = 3 * t + k;
    const std::int32_t twin = mesh_.half_edge_twin[h];
    std::uint32_t& near = table_.node_at(t, near_node(k));
    std::uint32_t& far = table_.node_at(t, far_node(k));
    if (seams_.has_value(h)) {
      near = put_fixed(kNoNode, on_edge(h, 1.0 / 3), seams_.value(h, 1.0f / 3));
      far = put_fixed(kNoNode, on_edge(h, 2.0 / 3), seams_.value(h, 2.0f / 3));
    } else if (seams_.is_seam(h)) {
      near = put_free_inside(kNoNode, on_edge(h, 1.0 / 3), t);
      far = put_free_inside(kNoNode, on_edge(h, 2.0 / 3), t);
    } else if (twin == mesh::kNone || static_cast<std::uint32_t>(twin) > h) {
      near = table_.put_free(kNoNode, on_edge(h, 1.0 / 3));
      far = table_.put_free(kNoNode, on_edge(h, 2.0 / 3));
      if (twin != mesh::kNone) {
        const auto neighbour = static_cast<std::uint32_t>(twin) / 3;
        const auto slot = static_cast<std::uint32_t>(twin) % 3;
        table_.node_at(neighbour, near_node(slot)) = far;
        table_.node_at(neighbour, far_node(slot)) = near;
      }
    }
  }

  /// Does the same where the neighbour across a free edge already has these nodes; `twin` is the
  /// neighbour's half-edge.
  void keep_on_edge(std::uint32_t h, std::uint32_t twin) {
    const std::uint32_t near = table_.node_at(twin / 3, far_node(twin % 3));
    const std::uint32_t far = table_.node_at(twin / 3, near_node(twin % 3));
    table_.node_at(h / 3, near_node(h % 3)) = near;
    table_.node_at(h / 3, far_node(h % 3)) = far;
    // The triangle with the lower half-edge determines their positions, to the last bit.
    table_.put_free(near, h < twin ? on_edge(h, 1.0 / 3) : on_edge(twin, 2.0 / 3));
    table_.put_free(far, h < twin ? on_edge(h, 2.0 / 3) : on_edge(twin, 1.0 / 3));
  }

  void place_at_barycentre(std::uint32_t t) {
    table_.node_at(t, kCenterNode) = table_.put_free(kNoNode, barycentre(t));
  }

  /// Returns the values that curves give to nodes, in the order of placement.
  const std::vector<FixedShare>& fixed() const { return fixed_; }

  /// Moves out that list; its charge goes to `memory`.
  std::vector<FixedShare> take_fixed(TableMemory& memory) {
    memory.take(std::move(memory_));
    return std::move(fixed_);
  }

  /// Charges the growth of that list. Error: limit (memory).
  Status settle(const Context& context) {
    return memory_.settle(context, capacity_bytes(fixed_), known_bytes_);
  }

 private:
  using Sector = std::span<const std::uint32_t>;

  /// A free node that would stand on a curve is moved by this fraction towards its triangle's
  /// barycentre before it is gathered: it is then on the triangle's side of the curve and still
  /// next to it.
  static constexpr double kNudge = 4e-3;

  Vec2 corner(std::uint32_t half_edge) const {
    return mesh_.vertex_position[mesh_.origin(half_edge)];
  }

  Vec2 on_edge(std::uint32_t half_edge, double share) const {
    return lerp(corner(half_edge), mesh_.vertex_position[mesh_.target(half_edge)], share);
  }

  Vec2 barycentre(std::uint32_t t) const {
    return (corner(3 * t) + corner(3 * t + 1) + corner(3 * t + 2)) / 3;
  }

  std::uint32_t put_free_inside(std::uint32_t kept, Vec2 position, std::uint32_t triangle) {
    return table_.put_free(kept, lerp(position, barycentre(triangle), kNudge));
  }

  std::uint32_t put_fixed(std::uint32_t kept, Vec2 position, const SeamValue& value) {
    const std::uint32_t node = table_.put_fixed(kept, position);
    fixed_.push_back({node, 1, value});
    return node;
  }

  /// Returns whether the test holds for some edge that meets the fan's vertex.
  template <class Test>
  bool touches(Test test) const {
    for (std::uint32_t spoke : fan_.spoke) {
      if (test(spoke)) return true;
    }
    return test(previous_half_edge(fan_.spoke.back()));
  }

  void share(Sector sector, std::uint32_t node) {
    for (std::uint32_t spoke : sector) table_.set(spoke, node);
  }

  void place_for_all(Vec2 vertex) {
    const Sector all = fan_.spoke;
    const bool on_constraint = touches(
        [&](std::uint32_t spoke) { return mesh_.half_edge_constraint[spoke] != mesh::kNone; });
    const std::uint32_t kept = table_.kept(all);
    share(all, on_constraint ? put_free_inside(kept, vertex, all[all.size() / 2] / 3)
                             : table_.put_free(kept, vertex));
  }

  /// Applies the corner rule (docs/mathematics.md, paper Fig. 4) to a sector whose first spoke has
  /// the value a and whose last has the value b.
  void place_in_sector(Sector sector) {
    const std::uint32_t first = sector.front(), last = previous_half_edge(sector.back());
    const Vec2 vertex = corner(first);
    const bool knows_a = seams_.has_value(first), knows_b = seams_.has_value(last);
    const bool hull_a = !seams_.is_seam(first), hull_b = !seams_.is_seam(last);
    if (knows_a && (hull_b || (knows_b && same_value(value_a(first), value_b(last))))) {
      share(sector, put_fixed(table_.kept(sector), vertex, value_a(first)));
    } else if (knows_b && hull_a) {
      share(sector, put_fixed(table_.kept(sector), vertex, value_b(last)));
    } else if (knows_a && knows_b) {
      fan_values(sector, first, last);
    } else if (knows_a || knows_b) {
      for (std::uint32_t spoke : sector) {
        table_.set(spoke, put_free_inside(table_.own(spoke), vertex, spoke / 3));
      }
    } else {
      share(sector, put_free_inside(table_.kept(sector), vertex, sector[sector.size() / 2] / 3));
    }
  }

  SeamValue value_a(std::uint32_t first) const { return seams_.value(first, 0); }
  SeamValue value_b(std::uint32_t last) const { return seams_.value(last, 1); }

  /// Gives each triangle of the sector lerp(a, b, angle of its barycentre / angle of the sector).
  void fan_values(Sector sector, std::uint32_t first, std::uint32_t last) {
    const Vec2 vertex = corner(first);
    const Vec2 start = mesh_.vertex_position[mesh_.target(first)] - vertex;
    const Vec2 end = corner(last) - vertex;
    const bool whole_turn = mesh_.target(first) == mesh_.origin(last) && fan_.is_closed;
    const double angle = whole_turn ? 2 * std::numbers::pi : turn_angle(start, end);
    for (std::uint32_t spoke : sector) {
      const double turn = turn_angle(start, barycentre(spoke / 3) - vertex);
      const auto fraction = static_cast<float>(turn / angle);
      const std::uint32_t node = table_.put_fixed(table_.own(spoke), vertex);
      fixed_.push_back({node, 1 - fraction, value_a(first)});
      fixed_.push_back({node, fraction, value_b(last)});
      table_.set(spoke, node);
    }
  }

  const mesh::TriangleMesh& mesh_;
  const Seams& seams_;
  Table& table_;
  Fan fan_;
  std::vector<FixedShare> fixed_;
  TableMemory memory_{"patches along curves"};
  std::size_t known_bytes_ = 0;
};

}  // namespace sfumato::solve
