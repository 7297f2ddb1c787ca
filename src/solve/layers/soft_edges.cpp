#include "solve/layers/soft_edges.hpp"

#include <algorithm>
#include <functional>

#include "base/half_edge.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "solve/layers/kept_triangles.hpp"

namespace sfumato::solve {
namespace {

using mesh::TriangleMesh;

/// The most turns around a vertex; more occur only in a broken mesh.
constexpr int kMostTurns = 1000;

/// The cosine between the normals of two edges beyond which their corner is a spike.
constexpr double kSpikeCosine = -0.5;

/// The reach of an edge's blur at a corner, in radii.
constexpr double kSpikeReach = 2;

/// The reach of the blur of an edge which meets the frame, along the frame, in radii.
constexpr double kFrameReach = 8;

class SoftEdgeFinder {
 public:
  SoftEdgeFinder(const Context& context, const TriangleMesh& mesh, const EdgeBlurs& blurs)
      : context_(context), mesh_(mesh), blurs_(blurs) {}

  /// keep   per triangle; empty: all
  Result<std::vector<SoftEdge>> find(std::span<const std::uint8_t> keep, TableMemory& memory) {
    SFUMATO_TRY_ASSIGN(number_, numbers_of_kept(context_, keep, memory_));
    std::vector<SoftEdge> edges;
    RarePoll<16384> poll(context_);
    for (std::size_t i = 0; i < blurs_.fine.size(); ++i) {
      const std::uint32_t h = blurs_.fine[i];
      if (poll.cancelled()) return context_.cancel_status();
      if (mesh_.half_edge_twin[h] == mesh::kNone) continue;
      const float from = blurs_.fine_radius(h, 0), to = blurs_.fine_radius(h, 1);
      if (!(from > 0 || to > 0)) continue;
      SFUMATO_TRY(memory.make_room(context_, edges));
      add(h, from, to, edges);
    }
    return sorted_by_triangle(context_, edges, memory);
  }

 private:
  Vec2 position(std::uint32_t vertex) const { return mesh_.vertex_position[vertex]; }

  /// Returns the direction from the origin of a half-edge to its target, 1 long.
  Vec2 direction(std::uint32_t h) const {
    const Vec2 along = position(mesh_.target(h)) - position(mesh_.origin(h));
    return along / length(along);
  }

  /// Returns whether a curve begins, ends or passes at the origin of a half-edge.
  bool is_on_curve(std::uint32_t h) const {
    std::uint32_t spoke = h;
    for (int turns = 0; turns < kMostTurns; ++turns) {
      const std::uint32_t back = previous_half_edge(spoke);
      if (blurs_.is_curve[spoke] || blurs_.is_curve[back]) return true;
      if (mesh_.half_edge_twin[back] == mesh::kNone) break;
      spoke = static_cast<std::uint32_t>(mesh_.half_edge_twin[back]);
      if (spoke == h) return false;
    }
    // The other way round, from the frame.
    spoke = h;
    for (int turns = 0; turns < kMostTurns; ++turns) {
      if (mesh_.half_edge_twin[spoke] == mesh::kNone) return false;
      spoke = next_half_edge(static_cast<std::uint32_t>(mesh_.half_edge_twin[spoke]));
      if (blurs_.is_curve[spoke]) return true;
    }
    return false;
  }

  std::uint32_t slot(std::uint32_t h) const {
    if (number_.empty()) return h;
    const std::uint32_t triangle = number_[h / 3];
    return triangle == SoftEdge::kNone ? SoftEdge::kNone : 3 * triangle + h % 3;
  }

  void add(std::uint32_t h, float from, float to, std::vector<SoftEdge>& edges) const {
    const auto twin = static_cast<std::uint32_t>(mesh_.half_edge_twin[h]);
    SoftEdge edge;
    edge.front = slot(h);
    edge.back = slot(twin);
    if (edge.front == SoftEdge::kNone && edge.back == SoftEdge::kNone) return;
    const double share = share_of_way(h, std::max(from, to));
    edge.reach[0] = corner_reach(h, true) * (share * from);
    edge.reach[1] = corner_reach(h, false) * (share * to);
    edge.contrast = blurs_.is_meshed(twin) ? 2 : 1;
    edges.push_back(edge);
  }

  /// Returns the part of a radius that lies on the edge's half of the way to a curve across the
  /// triangle.
  double share_of_way(std::uint32_t h, double radius) const {
    const std::uint32_t next = next_half_edge(h), last = previous_half_edge(h);
    if (blurs_.is_curve[next] || blurs_.is_curve[last] || !is_on_curve(last)) return 1;
    const Vec2 apex = position(mesh_.origin(last)) - position(mesh_.origin(h));
    return std::min(1.0, 0.5 * cross(direction(h), apex) / radius);
  }

  /// Returns the vector from an end of an edge to the place where a blur of radius 1 ends there.
  Vec2 corner_reach(std::uint32_t h, bool at_origin) const {
    const Vec2 along = direction(h);
    const Vec2 normal{-along.y, along.x};
    const std::uint32_t neighbour = edge_in_face(h, at_origin);
    const Vec2 other = direction(neighbour);
    if (mesh_.half_edge_twin[neighbour] == mesh::kNone) {
      // Up to the frame, along it.
      const Vec2 inwards = at_origin ? -1.0 * other : other;
      return inwards / std::max(dot(inwards, normal), 1 / kFrameReach);
    }
    const Vec2 both = normal + Vec2{-other.y, other.x};
    const double cosine = dot(along, other);
    if (cosine > kSpikeCosine) return both / (1 + cosine);
    const double turn = at_origin ? cross(other, along) : cross(along, other);
    // Round the point of a spike, and within a notch.
    return turn > 0 ? both * (kSpikeReach / length(both)) : normal;
  }

  /// Returns the edge of the same face, or of the frame, that comes before a half-edge, or after
  /// it.
  std::uint32_t edge_in_face(std::uint32_t h, bool at_origin) const {
    std::uint32_t edge = at_origin ? previous_half_edge(h) : next_half_edge(h);
    for (int turns = 0; turns < kMostTurns && !blurs_.is_curve[edge]; ++turns) {
      const std::int32_t twin = mesh_.half_edge_twin[edge];
      if (twin == mesh::kNone) break;
      const auto across = static_cast<std::uint32_t>(twin);
      edge = at_origin ? previous_half_edge(across) : next_half_edge(across);
    }
    return edge;
  }

  const Context& context_;
  const TriangleMesh& mesh_;
  const EdgeBlurs& blurs_;
  TableMemory memory_{"patches along curves"};
  std::vector<std::uint32_t> number_;  ///< per triangle, among the kept ones; empty: all are kept
};

}  // namespace

bool touches(const mesh::TriangleMesh& mesh, std::uint32_t triangle,
             std::span<const std::uint8_t> is_near) {
  const std::uint32_t* const corner = mesh.triangle_vertex.data() + 3 * std::size_t{triangle};
  return is_near[corner[0]] || is_near[corner[1]] || is_near[corner[2]];
}

Result<std::vector<SoftEdge>> find_soft_edges(const Context& context, const TriangleMesh& mesh,
                                              const EdgeBlurs& blurs,
                                              std::span<const std::uint8_t> keep,
                                              TableMemory& memory) {
  return SoftEdgeFinder(context, mesh, blurs).find(keep, memory);
}

Result<std::vector<SoftEdge>> update_soft_edges(const Context& context, const TriangleMesh& mesh,
                                                const EdgeBlurs& blurs,
                                                std::span<const SoftEdge> before,
                                                std::span<const std::uint8_t> is_near,
                                                TableMemory& memory) {
  TableMemory scratch("soft edges");
  SFUMATO_TRY_ASSIGN(auto&& added, SoftEdgeFinder(context, mesh, blurs).find({}, scratch));
  std::vector<SoftEdge> all;
  SFUMATO_TRY(memory.reserve(context, all, before.size() + added.size()));
  auto next = added.begin();
  RarePoll<65536> poll(context);
  for (const SoftEdge& edge : before) {
    if (poll.cancelled()) return context.cancel_status();
    if (touches(mesh, painting_triangle(edge), is_near)) continue;
    for (; next != added.end() && painting_triangle(*next) < painting_triangle(edge); ++next)
      all.push_back(*next);
    all.push_back(edge);
  }
  all.insert(all.end(), next, added.end());
  return all;
}

}  // namespace sfumato::solve
