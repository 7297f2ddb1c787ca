#include "solve/fields/border.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "picture/patch.hpp"

namespace sfumato::solve {
namespace {

using mesh::TriangleMesh;

/// Edges are tested at this share of their length from their ends. Corners lie on curves, which
/// cannot be tested, and on the border itself, which begins at ends of curves.
constexpr double kFromEnd = 1.0 / 512;

/// New nodes on a seam or on the border are gathered this far towards the middle of the seen part…
constexpr double kNudge = 4e-3;
/// …and on a seam the border is searched nearer to it.
constexpr double kLookNudge = 5e-4;

/// Finer crossings than this share of an edge are below the rounding of the gather.
constexpr double kFinestShare = 1e-7;

/// An edge of a mixed triangle; one edge for both its triangles unless it is a seam.
struct Edge {
  std::uint32_t half_edge = 0;
  bool is_seam = false;
  bool sees_begin = false, sees_end = false;
  std::uint32_t vertex = 0;  ///< at the crossing
  double low = kFromEnd;     ///< the crossing lies between these shares of the edge
  double high = 1 - kFromEnd;

  bool crosses() const { return sees_begin != sees_end; }
  double crossing() const { return 0.5 * (low + high); }
};

/// A point of a triangle's rim.
struct RimPoint {
  Vec2 position;
  std::uint32_t vertex = 0;
  int corner = -1;         ///< of the triangle; -1: a crossing
  std::int32_t edge = -1;  ///< slot of the edge that leads to the next point, or kBorder
  const Edge* crossed = nullptr;
};

/// The seen part of a triangle: convex, positive turns.
using RimPart = std::vector<RimPoint>;

class BorderCutter {
 public:
  BorderCutter(Context& context, const TriangleMesh& mesh, const Sight& sight, double accuracy)
      : context_(context), mesh_(mesh), sight_(sight), accuracy_(accuracy), poll_(context) {}

  Result<BorderCuts> cut() {
    SFUMATO_TRY_ASSIGN(auto&& fresh, mixed_triangles());
    if (fresh.empty()) return std::move(cuts_);
    SFUMATO_TRY(make_tables());
    for (std::uint32_t t : fresh) is_known_[t] = 1;
    while (!fresh.empty()) SFUMATO_TRY(look_at_edges(fresh));
    SFUMATO_TRY(find_crossings());
    SFUMATO_TRY(cut_triangles());
    return std::move(cuts_);
  }

 private:
  Result<std::vector<std::uint32_t>> mixed_triangles();
  Status make_tables();
  Status settle();
  Status look_at_edges(std::vector<std::uint32_t>& fresh);
  void add_edges(std::uint32_t triangle);
  Status find_crossings();
  Status cut_triangles();
  void cut_triangle(std::uint32_t triangle);
  void add_crossing_vertices();
  std::vector<RimPart> seen_parts(std::uint32_t triangle);
  void triangulate(std::uint32_t triangle, const RimPart& part);
  void add_nodes(std::uint32_t triangle, const RimPart& part, const std::array<std::size_t, 3>& at,
                 const std::array<std::int32_t, 3>& edge);

  Vec2 corner(std::uint32_t h) const { return mesh_.vertex_position[mesh_.origin(h)]; }
  Vec2 end(std::uint32_t h) const { return mesh_.vertex_position[mesh_.target(h)]; }
  Vec2 middle(std::uint32_t t) const {
    return (corner(3 * t) + corner(3 * t + 1) + corner(3 * t + 2)) / 3;
  }
  const Edge& edge_at(std::uint32_t h) const {
    return edges_[static_cast<std::size_t>(edge_of_[h])];
  }
  /// Returns whether the edge was made for the triangle on its other side.
  bool is_turned(std::uint32_t h) const { return edge_at(h).half_edge != h; }

  Vec2 point_to_ask(const Edge& edge, double share) const {
    const Vec2 p = lerp(corner(edge.half_edge), end(edge.half_edge), share);
    return edge.is_seam ? lerp(p, middle(edge.half_edge / 3), kLookNudge) : p;
  }

  bool sees(std::uint32_t t, std::size_t place) const { return sight_.node_sees(t, place); }

  Context& context_;
  const TriangleMesh& mesh_;
  const Sight& sight_;
  double accuracy_;
  RarePoll<4096> poll_;
  TableMemory memory_{"patches at a border"};
  std::size_t own_bytes_ = 0, cut_bytes_ = 0;  ///< for the lists that grow, charged
  std::vector<std::int32_t> edge_of_;          ///< per half-edge: index into edges_, or kNone
  std::vector<std::uint8_t> is_known_;         ///< per triangle: its edges were tested, or will be
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> mixed_;  ///< triangles with edges
  BorderCuts cuts_;
};

Result<std::vector<std::uint32_t>> BorderCutter::mixed_triangles() {
  std::vector<std::uint32_t> mixed;
  for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
    if (poll_.cancelled()) return context_.cancel_status();
    const bool first = sees(t, 0);
    for (std::size_t i = 1; i < kNodesPerTriangle; ++i) {
      if (sees(t, i) == first) continue;
      SFUMATO_TRY(memory_.push_back(context_, mixed, t));
      break;
    }
  }
  return mixed;
}

Status BorderCutter::make_tables() {
  Status status = memory_.resize(context_, edge_of_, mesh_.triangle_vertex.size(), mesh::kNone);
  if (status) status = memory_.resize(context_, is_known_, mesh_.triangle_count());
  return status ? cuts_.memory.resize(context_, cuts_.is_cut, mesh_.triangle_count()) : status;
}

/// Charges the growth of the lists.
Status BorderCutter::settle() {
  const BorderCuts& c = cuts_;
  SFUMATO_TRY(memory_.settle(context_, capacity_bytes(edges_, mixed_), own_bytes_));
  return cuts_.memory.settle(
      context_, capacity_bytes(c.vertex, c.triangle_vertex, c.edge, c.parent, c.node, c.point),
      cut_bytes_);
}

void BorderCutter::add_edges(std::uint32_t triangle) {
  mixed_.push_back(triangle);
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    if (edge_of_[h] != mesh::kNone) continue;
    const auto index = static_cast<std::int32_t>(edges_.size());
    Edge edge;
    edge.half_edge = h;
    edge.is_seam = sight_.is_seam(h);
    edges_.push_back(edge);
    edge_of_[h] = index;
    const std::int32_t twin = mesh_.half_edge_twin[h];
    if (twin != mesh::kNone && !edge.is_seam) edge_of_[twin] = index;
  }
}

/// Tests the ends of the edges of `fresh`. Leaves there the neighbours that are mixed too.
Status BorderCutter::look_at_edges(std::vector<std::uint32_t>& fresh) {
  const std::size_t first = edges_.size();
  for (std::uint32_t t : fresh) add_edges(t);
  TableMemory scratch("patches at a border");
  std::vector<Vec2> points;
  std::vector<std::uint8_t> seen;
  const std::size_t looks = 2 * (edges_.size() - first);
  SFUMATO_TRY(settle());
  SFUMATO_TRY(scratch.reserve(context_, points, looks));
  SFUMATO_TRY(scratch.resize(context_, seen, looks));
  for (std::size_t i = first; i < edges_.size(); ++i) {
    points.push_back(point_to_ask(edges_[i], kFromEnd));
    points.push_back(point_to_ask(edges_[i], 1 - kFromEnd));
  }
  SFUMATO_TRY(sight_.look(points, seen));
  std::vector<std::uint32_t> more;
  SFUMATO_TRY(memory_.reserve(context_, more, edges_.size() - first));
  for (std::size_t i = first; i < edges_.size(); ++i) {
    Edge& edge = edges_[i];
    edge.sees_begin = seen[2 * (i - first)] != 0;
    edge.sees_end = seen[2 * (i - first) + 1] != 0;
    const std::int32_t twin = mesh_.half_edge_twin[edge.half_edge];
    if (edge.crosses() && !edge.is_seam && twin != mesh::kNone)
      more.push_back(static_cast<std::uint32_t>(twin) / 3);
  }
  std::erase_if(more, [&](std::uint32_t t) { return std::exchange(is_known_[t], 1) != 0; });
  fresh.swap(more);
  memory_.free(more);
  return ok_status();
}

/// Bisects all edges across the border, in parallel.
Status BorderCutter::find_crossings() {
  TableMemory scratch("patches at a border");
  std::vector<std::uint32_t> open;
  std::vector<Vec2> points;
  std::vector<std::uint8_t> seen;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    if (!edges_[i].crosses()) continue;
    SFUMATO_TRY(scratch.push_back(context_, open, i));
  }
  SFUMATO_TRY(scratch.reserve(context_, points, open.size()));
  SFUMATO_TRY(scratch.reserve(context_, seen, open.size()));
  while (!open.empty()) {
    points.clear();
    for (std::uint32_t i : open) points.push_back(point_to_ask(edges_[i], edges_[i].crossing()));
    seen.assign(points.size(), 0);
    SFUMATO_TRY(sight_.look(points, seen));
    for (std::size_t k = 0; k < open.size(); ++k) {
      Edge& edge = edges_[open[k]];
      (edge.sees_begin == (seen[k] != 0) ? edge.low : edge.high) = edge.crossing();
    }
    std::erase_if(open, [&](std::uint32_t i) {
      const Edge& edge = edges_[i];
      const double span = edge.high - edge.low;
      return span < kFinestShare ||
             span * length(end(edge.half_edge) - corner(edge.half_edge)) < accuracy_;
    });
  }
  return ok_status();
}

void BorderCutter::add_crossing_vertices() {
  for (Edge& edge : edges_) {
    if (!edge.crosses()) continue;
    edge.vertex = static_cast<std::uint32_t>(mesh_.vertex_position.size() + cuts_.vertex.size());
    cuts_.vertex.push_back(lerp(corner(edge.half_edge), end(edge.half_edge), edge.crossing()));
  }
}

Status BorderCutter::cut_triangles() {
  add_crossing_vertices();
  for (std::uint32_t t : mixed_) {
    if (poll_.cancelled()) return context_.cancel_status();
    cut_triangle(t);
    SFUMATO_TRY(settle());
  }
  return ok_status();
}

/// Returns the seen stretches of the rim, each with the points where it begins and ends. Where the
/// middle is seen they bound one part, with the border between them; else each is a separate part.
std::vector<RimPart> BorderCutter::seen_parts(std::uint32_t triangle) {
  struct Look {
    RimPoint point;  ///< the one before it
    bool seen;
  };
  std::vector<Look> rim;  // two tests for each edge, next to its ends
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t h = 3 * triangle + k;
    const Edge& edge = edge_at(h);
    const bool turned = is_turned(h);
    const auto slot = static_cast<std::int32_t>(h);
    const RimPoint at_corner{corner(h), mesh_.origin(h), static_cast<int>(k), slot, nullptr};
    rim.push_back({at_corner, turned ? edge.sees_end : edge.sees_begin});
    RimPoint at_crossing{{}, edge.vertex, -1, slot, &edge};
    if (edge.crosses())
      at_crossing.position = cuts_.vertex[edge.vertex - mesh_.vertex_position.size()];
    rim.push_back({at_crossing, turned ? edge.sees_begin : edge.sees_end});
  }
  std::vector<RimPart> parts;
  const auto starts = [&](std::size_t i) { return rim[i].seen && !rim[(i + 5) % 6].seen; };
  for (std::size_t i = 0; i < 6; ++i) {
    if (!starts(i)) continue;
    RimPart run{rim[i].point};
    std::size_t k = i + 1;
    for (; rim[k % 6].seen; ++k)
      if (k % 2 == 0) run.push_back(rim[k % 6].point);
    run.push_back(rim[k % 6].point);
    run.back().edge = BorderCuts::kBorder;
    parts.push_back(std::move(run));
  }
  if (parts.size() > 1 && sees(triangle, kCenterNode)) {
    for (std::size_t i = 1; i < parts.size(); ++i)
      parts[0].insert(parts[0].end(), parts[i].begin(), parts[i].end());
    parts.resize(1);
  }
  return parts;
}

void BorderCutter::cut_triangle(std::uint32_t triangle) {
  std::vector<RimPart> parts = seen_parts(triangle);
  // Two points: the border runs along an edge. Without a part, the visibility of the middle counts
  // for the whole triangle.
  std::erase_if(parts, [](const RimPart& part) { return part.size() < 3; });
  if (parts.empty()) return;
  cuts_.is_cut[triangle] = 1;
  for (const RimPart& part : parts) triangulate(triangle, part);
}

/// Makes a fan around the first point.
void BorderCutter::triangulate(std::uint32_t triangle, const RimPart& part) {
  for (std::size_t i = 1; i + 1 < part.size(); ++i) {
    const std::array<std::size_t, 3> at{0, i, i + 1};
    const std::array<std::int32_t, 3> edge{
        i == 1 ? part[0].edge : BorderCuts::kInside, part[i].edge,
        i + 2 == part.size() ? part[i + 1].edge : BorderCuts::kInside};
    cuts_.parent.push_back(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      cuts_.triangle_vertex.push_back(part[at[k]].vertex);
      cuts_.edge.push_back(edge[k]);
    }
    add_nodes(triangle, part, at, edge);
  }
}

void BorderCutter::add_nodes(std::uint32_t triangle, const RimPart& part,
                             const std::array<std::size_t, 3>& at,
                             const std::array<std::int32_t, 3>& edge) {
  Vec2 center;
  for (const RimPoint& p : part) center = center + p.position / static_cast<double>(part.size());
  const auto add_new = [&](Vec2 p) {
    cuts_.point.push_back(p);
    cuts_.node.push_back(-static_cast<std::int32_t>(cuts_.point.size()));
  };
  const auto add_old = [&](int place, Vec2 or_new) {
    if (sees(triangle, static_cast<std::size_t>(place))) {
      cuts_.node.push_back(place);
    } else {
      add_new(lerp(or_new, center, kNudge));
    }
  };
  for (std::size_t k : at) {
    const RimPoint& p = part[k];
    if (p.corner >= 0) {
      add_old(p.corner, p.position);
    } else if (p.crossed->is_seam) {
      add_new(lerp(p.position, center, kNudge));
    } else {
      // Along the edge, so that both its triangles test the same point.
      const Edge& e = *p.crossed;
      add_new(lerp(p.position, e.sees_begin ? corner(e.half_edge) : end(e.half_edge), kNudge));
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const RimPoint &from = part[at[k]], &to = part[at[(k + 1) % 3]];
    const bool is_whole = edge[k] >= 0 && from.corner >= 0 && to.corner >= 0;
    const bool is_free = edge[k] == BorderCuts::kInside ||
                         (edge[k] >= 0 && !edge_at(static_cast<std::uint32_t>(edge[k])).is_seam);
    for (int i = 1; i <= 2; ++i) {
      const Vec2 p = lerp(from.position, to.position, i / 3.0);
      if (is_whole) {
        add_old(i == 1 ? near_node(from.corner) : far_node(from.corner), p);
      } else {
        add_new(is_free ? p : lerp(p, center, kNudge));
      }
    }
  }
  add_new((part[at[0]].position + part[at[1]].position + part[at[2]].position) / 3);
}

}  // namespace

Result<BorderCuts> cut_at_border(Context& context, const TriangleMesh& mesh, const Sight& sight,
                                 double accuracy) {
  return BorderCutter(context, mesh, sight, accuracy).cut();
}

}  // namespace sfumato::solve
