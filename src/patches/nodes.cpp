#include "patches/nodes.hpp"

#include <cmath>
#include <numbers>

#include "base/large_vector.hpp"
#include "patches/angle.hpp"
#include "patches/patch.hpp"

namespace sfumato::patches {
namespace {

using mesh::TriangleMesh;

constexpr std::uint32_t kUnset = 0xffffffff;

/// A free node that would stand on a curve is gathered this far towards its triangle's barycentre
/// (as a fraction): on the triangle's side of the curve, and still next to it.
constexpr double kNudge = 4e-3;

/// A share of the value that a curve gives to a node.
struct FixedShare {
  std::uint32_t node;
  float share;
  SeamValue value;
};

class LayoutBuilder {
 public:
  LayoutBuilder(const Context& context, const TriangleMesh& mesh,
                const curves::SegmentAttributes& attributes, const Seams& seams)
      : context_(context),
        poll_(context),
        mesh_(mesh),
        seams_(seams),
        base_channels_(attributes.base_channels) {
    layout_.channel_count = attributes.channel_count();
  }

  NodeLayout build() {
    const std::uint32_t triangle_count = mesh_.triangle_count();
    Status status = resize_large(context_, layout_.triangle_node, std::size_t{10} * triangle_count,
                                 std::uint32_t{kUnset});
    if (status) {
      status = resize_large(context_, layout_.edge_is_curve, std::size_t{3} * triangle_count);
    }
    if (!status) return {};
    layout_.position.reserve(std::size_t{5} * triangle_count);
    for (std::uint32_t t = 0; t < triangle_count; ++t) {
      if (poll_.cancelled()) return {};
      for (std::uint32_t k = 0; k < 3; ++k) {
        layout_.edge_is_curve[3 * t + k] = seams_.is_seam(3 * t + k);
        if (node_at(t, k) == kUnset) place_around_vertex(3 * t + k);
      }
      for (std::uint32_t k = 0; k < 3; ++k) place_on_edge(t, k);
      node_at(t, 9) = add_free(barycentre(t));
    }
    set_fixed_values();
    return std::move(layout_);
  }

 private:
  std::uint32_t& node_at(std::uint32_t triangle, std::uint32_t place) {
    return layout_.triangle_node[std::size_t{10} * triangle + place];
  }

  Vec2 corner(std::uint32_t half_edge) const {
    return mesh_.vertex_position[mesh_.origin(half_edge)];
  }

  Vec2 barycentre(std::uint32_t t) const {
    return (corner(3 * t) + corner(3 * t + 1) + corner(3 * t + 2)) / 3;
  }

  std::uint32_t add_free(Vec2 position) {
    layout_.position.push_back(position);
    return layout_.node_count() - 1;
  }

  std::uint32_t add_free_inside(Vec2 position, std::uint32_t triangle) {
    return add_free(lerp(position, barycentre(triangle), kNudge));
  }

  std::uint32_t add_fixed(Vec2 position, const SeamValue& value) {
    fixed_.push_back({layout_.node_count(), 1, value});
    layout_.position.push_back(position);
    return layout_.node_count() - 1;
  }

  void set_fixed_values() {
    const auto channel_count = static_cast<std::size_t>(layout_.channel_count);
    const std::size_t value_count = channel_count * layout_.node_count();
    if (!resize_large(context_, layout_.is_fixed, layout_.node_count()) ||
        !resize_large(context_, layout_.value, value_count)) {
      return;
    }
    for (const FixedShare& fixed : fixed_) {
      if (poll_.cancelled()) return;
      layout_.is_fixed[fixed.node] = 1;
      add_value(fixed, layout_.value.data() + channel_count * fixed.node);
    }
  }

  void add_value(const FixedShare& fixed, float* out) const {
    const auto& base = fixed.value.base.channel;
    for (std::size_t c = 0; c < static_cast<std::size_t>(base_channels_); ++c) {
      out[c] += fixed.share * base[c];
    }
    for (int i = 0; i < 2; ++i) {
      if (fixed.value.share[i] == 0) continue;
      out[base_channels_ + static_cast<int>(fixed.value.shader[i])] +=
          fixed.share * fixed.value.share[i];
    }
  }

  /// The two nodes on edge k: shared with the neighbour unless the edge is a seam.
  void place_on_edge(std::uint32_t t, std::uint32_t k) {
    const std::uint32_t h = 3 * t + k;
    const Vec2 from = corner(h), to = mesh_.vertex_position[mesh_.target(h)];
    std::uint32_t& near = node_at(t, 3 + 2 * k);
    std::uint32_t& far = node_at(t, 4 + 2 * k);
    const Vec2 near_position = lerp(from, to, 1.0 / 3), far_position = lerp(from, to, 2.0 / 3);
    if (seams_.has_value(h)) {
      near = add_fixed(near_position, seams_.value(h, 1.0f / 3));
      far = add_fixed(far_position, seams_.value(h, 2.0f / 3));
    } else if (seams_.is_seam(h)) {
      near = add_free_inside(near_position, t);
      far = add_free_inside(far_position, t);
    } else if (near == kUnset) {
      near = add_free(near_position);
      far = add_free(far_position);
      if (const std::int32_t twin = mesh_.half_edge_twin[h]; twin != mesh::kNone) {
        const auto neighbour = static_cast<std::uint32_t>(twin) / 3;
        const auto slot = static_cast<std::uint32_t>(twin) % 3;
        node_at(neighbour, 3 + 2 * slot) = far;
        node_at(neighbour, 4 + 2 * slot) = near;
      }
    }
  }

  /// The spoke after h around h's origin, in the direction of positive turns; kNone at the hull.
  std::int32_t next_spoke(std::uint32_t h) const {
    return mesh_.half_edge_twin[TriangleMesh::previous(h)];
  }

  /// Fills fan_ with the spokes around h's origin in the direction of positive turns. Begins at a
  /// seam where there is one, at the hull where the fan is open.
  void collect_fan(std::uint32_t h) {
    std::uint32_t first = h, seam = kUnset;
    closed_ = false;
    for (std::uint32_t spoke = h;;) {
      first = spoke;
      if (seams_.is_seam(spoke)) seam = spoke;
      const std::int32_t twin = mesh_.half_edge_twin[spoke];
      if (twin == mesh::kNone) break;
      spoke = TriangleMesh::next(static_cast<std::uint32_t>(twin));
      if (spoke == h) {
        closed_ = true;
        break;
      }
    }
    if (closed_ && seam != kUnset) first = seam;
    fan_.clear();
    for (std::uint32_t spoke = first;;) {
      fan_.push_back(spoke);
      const std::int32_t next = next_spoke(spoke);
      if (next == mesh::kNone || static_cast<std::uint32_t>(next) == first) break;
      spoke = static_cast<std::uint32_t>(next);
    }
  }

  /// The nodes at one vertex, for every triangle of the fan: one for all where no seam ends here,
  /// else one or more for each sector between seams.
  void place_around_vertex(std::uint32_t h) {
    collect_fan(h);
    if (!touches([&](std::uint32_t spoke) { return seams_.is_seam(spoke); })) {
      const bool on_constraint = touches(
          [&](std::uint32_t spoke) { return mesh_.half_edge_constraint[spoke] != mesh::kNone; });
      share(0, fan_.size(),
            on_constraint ? add_free_inside(corner(h), fan_[fan_.size() / 2] / 3)
                          : add_free(corner(h)));
      return;
    }
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= fan_.size(); ++i) {
      if (i < fan_.size() && !seams_.is_seam(fan_[i])) continue;
      place_in_sector(begin, i);
      begin = i;
    }
  }

  /// True where the test holds for an edge that meets the fan's vertex.
  template <class Test>
  bool touches(Test test) const {
    for (std::uint32_t spoke : fan_) {
      if (test(spoke)) return true;
    }
    return test(TriangleMesh::previous(fan_.back()));
  }

  void share(std::size_t begin, std::size_t end, std::uint32_t node) {
    for (std::size_t i = begin; i < end; ++i) node_at(fan_[i] / 3, fan_[i] % 3) = node;
  }

  /// The corner rule (docs/mathematics.md, paper Fig. 4) for the sector of triangles fan_[begin,
  /// end), between its first spoke, whose value is a, and its last, whose value is b.
  void place_in_sector(std::size_t begin, std::size_t end) {
    const std::uint32_t first = fan_[begin], last = TriangleMesh::previous(fan_[end - 1]);
    const Vec2 vertex = corner(first);
    const bool knows_a = seams_.has_value(first), knows_b = seams_.has_value(last);
    const bool hull_a = !seams_.is_seam(first), hull_b = !seams_.is_seam(last);
    if (knows_a && (hull_b || (knows_b && same_value(value_a(first), value_b(last))))) {
      share(begin, end, add_fixed(vertex, value_a(first)));
    } else if (knows_b && hull_a) {
      share(begin, end, add_fixed(vertex, value_b(last)));
    } else if (knows_a && knows_b) {
      fan_values(begin, end, first, last);
    } else if (knows_a || knows_b) {
      for (std::size_t i = begin; i < end; ++i) {
        node_at(fan_[i] / 3, fan_[i] % 3) = add_free_inside(vertex, fan_[i] / 3);
      }
    } else {
      share(begin, end, add_free_inside(vertex, fan_[(begin + end) / 2] / 3));
    }
  }

  SeamValue value_a(std::uint32_t first) const { return seams_.value(first, 0); }
  SeamValue value_b(std::uint32_t last) const { return seams_.value(last, 1); }

  /// Each triangle of the sector gets lerp(a, b, angle of its barycentre / angle of the sector).
  void fan_values(std::size_t begin, std::size_t end, std::uint32_t first, std::uint32_t last) {
    const Vec2 vertex = corner(first);
    const Vec2 start = mesh_.vertex_position[mesh_.target(first)] - vertex;
    const Vec2 stop = corner(last) - vertex;
    const bool whole_turn = mesh_.target(first) == mesh_.origin(last) && closed_;
    const double sector = whole_turn ? 2 * std::numbers::pi : turn_angle(start, stop);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t t = fan_[i] / 3;
      const auto fraction = static_cast<float>(turn_angle(start, barycentre(t) - vertex) / sector);
      const std::uint32_t node = add_free(vertex);
      fixed_.push_back({node, 1 - fraction, value_a(first)});
      fixed_.push_back({node, fraction, value_b(last)});
      node_at(t, fan_[i] % 3) = node;
    }
  }

  const Context& context_;
  RarePoll<4096> poll_;
  const TriangleMesh& mesh_;
  const Seams& seams_;
  int base_channels_;
  NodeLayout layout_;
  std::vector<FixedShare> fixed_;
  std::vector<std::uint32_t> fan_;
  bool closed_ = false;
};

}  // namespace

NodeLayout lay_out_nodes(const Context& context, const TriangleMesh& mesh,
                         const curves::SegmentAttributes& attributes, const Seams& seams) {
  return LayoutBuilder(context, mesh, attributes, seams).build();
}

}  // namespace sfumato::patches
