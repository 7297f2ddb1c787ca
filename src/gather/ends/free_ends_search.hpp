#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "gather/ends/free_ends.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// Returns the distance from the origin to the segment from a to b, or to its part between two
/// fractions.
inline double segment_distance(Vec2 a, Vec2 b, double from = 0, double to = 1) {
  const Vec2 along = b - a;
  return length(a + std::clamp(-dot(a, along) / length_squared(along), from, to) * along);
}

/// Finds free ends, their reach and their arcs.
class EndSearch {
 public:
  /// The most triangles that are visited for the reach of one end: hostile meshes have all in each
  /// reach.
  static constexpr std::size_t kMostTriangles = 1024;

  /// beside   as in GatherUse
  EndSearch(Context& context, const mesh::TriangleMesh& mesh,
            const curves::SegmentAttributes& attributes, EndTables& tables,
            const curves::SegmentAttributes* beside = nullptr)
      : context_(context),
        poll_(context),
        mesh_(mesh),
        attributes_(attributes),
        beside_(beside),
        tables_(tables) {}

  /// Fills the tables. Errors: limit (memory), cancelled.
  Status find_meetings();

  /// Updates tables that were copied from another mesh, whose triangles differ in some places and
  /// at the end: `is_same` as in FreeEnds::extend. Errors: limit (memory), cancelled.
  Status update_meetings(std::span<const std::uint8_t> is_same);

  /// Returns whether one edge with curves ends there.
  bool may_end(std::uint32_t vertex) const { return tables_.meeting[vertex].edges == 1; }

  /// Adds the end at a vertex that may have one, if there is one. Errors: limit (memory),
  /// cancelled.
  Status add_end(std::uint32_t vertex, TableMemory& memory, std::vector<FreeEnd>& ends);

 private:
  /// An edge of the followed curve, from the view of its end.
  struct Edge {
    std::uint32_t half_edge;  ///< its name
    bool origin_is_near;
    double arc;  ///< the curve's length from the end to the nearer vertex
  };

  struct Step {
    double distance;  ///< from the end to the edge that leads into the triangle
    std::uint32_t triangle;
  };

  Vec2 position(std::uint32_t v) const { return mesh_.vertex_position[v]; }
  std::uint32_t name(std::uint32_t half_edge) const {
    return std::min(half_edge, static_cast<std::uint32_t>(mesh_.half_edge_twin[half_edge]));
  }
  bool differs_beside(std::uint32_t out, std::uint32_t in) const;
  Status size_tables();
  void meet_around(std::uint32_t half_edge);
  Status find_term(std::uint32_t out, FreeEnd& end);
  Status bend(FreeEnd& end);
  Result<std::vector<Vec2>> own_places(std::uint32_t v, double reach);
  Result<double> follow_curve(std::uint32_t v);
  Result<double> find_reach(std::uint32_t v, std::uint32_t half_edge, double reach);
  void shorten(double& reach, std::uint32_t v, std::uint32_t h);
  double curve_distance(std::uint32_t v, std::uint32_t h) const;
  const Edge* own_edge(std::uint32_t half_edge) const;

  Context& context_;
  RarePoll<4096> poll_;
  const mesh::TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  const curves::SegmentAttributes* beside_;
  EndTables& tables_;
  TableMemory memory_{"free ends of curves"};
  std::vector<Edge> chain_;             ///< of the curve that was followed last
  std::uint32_t chain_begin_ = 0;       ///< the mark of its first edge
  std::vector<Step> step_;              ///< a heap
  std::int32_t nearest_ = mesh::kNone;  ///< the constraint that limits the last reach
};

}  // namespace sfumato::gather
