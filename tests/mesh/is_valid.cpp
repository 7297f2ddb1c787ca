#include "mesh/is_valid.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/try.hpp"
#include "mesh/lattice.hpp"

namespace sfumato::mesh {
namespace {

Status violation(std::string what) {
  return make_error(StatusCode::internal, "invalid mesh: " + std::move(what));
}

Status violation(const char* what, std::size_t index) {
  return violation(std::string(what) + " " + std::to_string(index));
}

/// Computes positions in lattice steps from the smallest coordinates.
Status to_lattice(const TriangleMesh& mesh, std::vector<Point>& points) {
  int exponent = 0;
  if (!(mesh.lattice_step > 0) || std::frexp(mesh.lattice_step, &exponent) != 0.5) {
    return violation("lattice step is not a power of two");
  }
  Vec2 low{HUGE_VAL, HUGE_VAL};
  for (const Vec2 p : mesh.vertex_position) {
    low = {std::min(low.x, p.x / mesh.lattice_step), std::min(low.y, p.y / mesh.lattice_step)};
  }
  points.reserve(mesh.vertex_position.size());
  for (std::size_t v = 0; v < mesh.vertex_position.size(); ++v) {
    const double x = mesh.vertex_position[v].x / mesh.lattice_step;
    const double y = mesh.vertex_position[v].y / mesh.lattice_step;
    const double most = std::ldexp(1.0, kLatticeBits);
    if (x != std::floor(x) || y != std::floor(y) || !(x - low.x <= most && y - low.y <= most)) {
      return violation("off the lattice: vertex", v);
    }
    points.push_back({static_cast<std::int32_t>(x - low.x), static_cast<std::int32_t>(y - low.y)});
  }
  return ok_status();
}

Status check_indices(const TriangleMesh& mesh) {
  const std::size_t half_edges = mesh.triangle_vertex.size();
  if (half_edges % 3 != 0 || mesh.half_edge_twin.size() != half_edges ||
      mesh.half_edge_constraint.size() != half_edges) {
    return violation("array sizes differ");
  }
  for (std::size_t h = 0; h < half_edges; ++h) {
    if (mesh.triangle_vertex[h] >= mesh.vertex_position.size()) {
      return violation("vertex index out of range at half-edge", h);
    }
    const std::int32_t twin = mesh.half_edge_twin[h];
    if (twin != kNone && (twin < 0 || static_cast<std::size_t>(twin) >= half_edges)) {
      return violation("twin out of range at half-edge", h);
    }
    const std::int32_t c = mesh.half_edge_constraint[h];
    if (c != kNone && (c < 0 || static_cast<std::size_t>(c) >= mesh.constraint.size())) {
      return violation("constraint out of range at half-edge", h);
    }
  }
  return ok_status();
}

Status check_adjacency(const TriangleMesh& mesh) {
  for (std::uint32_t h = 0; h < mesh.triangle_vertex.size(); ++h) {
    const std::int32_t twin = mesh.half_edge_twin[h];
    if (twin == kNone) continue;
    const auto f = static_cast<std::uint32_t>(twin);
    if (mesh.half_edge_twin[f] != static_cast<std::int32_t>(h) || f == h ||
        mesh.origin(f) != mesh.target(h) || mesh.target(f) != mesh.origin(h)) {
      return violation("twins disagree at half-edge", h);
    }
    if (mesh.half_edge_constraint[f] != mesh.half_edge_constraint[h]) {
      return violation("constraint differs between the twins of half-edge", h);
    }
  }
  return ok_status();
}

Status check_constraints(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> edges(mesh.constraint.size(), 0);
  for (std::uint32_t h = 0; h < mesh.triangle_vertex.size(); ++h) {
    const std::int32_t index = mesh.half_edge_constraint[h];
    if (index == kNone) continue;
    const Constraint& c = mesh.constraint[index];
    const bool along = c.from == mesh.origin(h) && c.to == mesh.target(h);
    const bool against = c.to == mesh.origin(h) && c.from == mesh.target(h);
    if (!along && !against) return violation("constraint ends elsewhere than half-edge", h);
    const auto twin = mesh.half_edge_twin[h];
    if (twin == kNone || static_cast<std::uint32_t>(twin) > h) ++edges[index];
  }
  std::uint32_t piece = 0;
  for (std::size_t i = 0; i < mesh.constraint.size(); ++i) {
    const Constraint& c = mesh.constraint[i];
    if (edges[i] != 1) return violation("not exactly one edge for constraint", i);
    if (c.piece_begin != piece || c.piece_end < piece || c.piece_end > mesh.piece.size()) {
      return violation("piece range of constraint", i);
    }
    for (; piece < c.piece_end; ++piece) {
      const SegmentPiece& p = mesh.piece[piece];
      if (!(p.u_from >= 0 && p.u_from <= 1 && p.u_to >= 0 && p.u_to <= 1)) {
        return violation("fractions out of range in piece", piece);
      }
      if (piece > c.piece_begin && mesh.piece[piece - 1].segment > p.segment) {
        return violation("pieces out of drawing order at constraint", i);
      }
    }
  }
  return piece == mesh.piece.size() ? ok_status() : violation("pieces without a constraint");
}

Status check_shape(const TriangleMesh& mesh, const std::vector<Point>& points) {
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    const Point a = points[mesh.origin(3 * t)], b = points[mesh.target(3 * t)];
    if (orient2d(a, b, points[mesh.apex(3 * t)]) <= 0)
      return violation("not positive: triangle", t);
  }
  for (std::uint32_t h = 0; h < mesh.triangle_vertex.size(); ++h) {
    const std::int32_t twin = mesh.half_edge_twin[h];
    if (twin == kNone || mesh.half_edge_constraint[h] != kNone) continue;
    if (in_circle(points[mesh.origin(h)], points[mesh.target(h)], points[mesh.apex(h)],
                  points[mesh.apex(static_cast<std::uint32_t>(twin))])) {
      return violation("not locally Delaunay: half-edge", h);
    }
  }
  return ok_status();
}

/// Fans: the triangles around a vertex that are connected by edges, either all of them, or a part
/// from one hull edge to another.
struct Fans {
  std::vector<std::uint32_t> fan_of_corner;  ///< per half-edge: the fan of its origin
  std::vector<std::uint32_t> vertex_of_fan;
  std::vector<std::uint8_t> is_open;
};

Fans find_fans(const TriangleMesh& mesh) {
  constexpr std::uint32_t kUnseen = 0xffffffffu;
  Fans fans;
  fans.fan_of_corner.assign(mesh.triangle_vertex.size(), kUnseen);
  for (std::uint32_t h = 0; h < mesh.triangle_vertex.size(); ++h) {
    if (fans.fan_of_corner[h] != kUnseen) continue;
    // Back to the fan's first corner, if it has one: over the edge h.
    std::uint32_t first = h;
    bool open = false;
    for (;;) {
      const std::int32_t twin = mesh.half_edge_twin[first];
      open = twin == kNone;
      if (open) break;
      first = next_half_edge(static_cast<std::uint32_t>(twin));
      if (first == h) break;
    }
    const auto fan = static_cast<std::uint32_t>(fans.vertex_of_fan.size());
    fans.vertex_of_fan.push_back(mesh.origin(h));
    fans.is_open.push_back(open);
    std::int32_t e = static_cast<std::int32_t>(first);
    do {
      fans.fan_of_corner[e] = fan;
      e = mesh.half_edge_twin[previous_half_edge(static_cast<std::uint32_t>(e))];
    } while (e != kNone && static_cast<std::uint32_t>(e) != first);
  }
  return fans;
}

/// Returns whether the corner at the origin of h contains the direction +x (its first edge counts,
/// its second does not). Precondition: the triangle is positive, so that the corner is below 180
/// degrees.
bool holds_positive_x(const TriangleMesh& mesh, const std::vector<Point>& points, std::uint32_t h) {
  const Point p = points[mesh.origin(h)];
  const Point a = points[mesh.target(h)], b = points[mesh.apex(h)];
  return (a.y < p.y || (a.y == p.y && a.x > p.x)) && b.y > p.y;
}

/// Checks that no triangle covers another: around every vertex the triangles make at most one turn.
Status check_turns(const TriangleMesh& mesh, const std::vector<Point>& points, const Fans& fans) {
  std::vector<std::uint32_t> turns_of_vertex(points.size(), 0);
  std::vector<std::uint8_t> closed_fans(points.size(), 0), fan_count(points.size(), 0);
  for (std::uint32_t h = 0; h < mesh.triangle_vertex.size(); ++h) {
    if (holds_positive_x(mesh, points, h)) ++turns_of_vertex[mesh.origin(h)];
  }
  for (std::size_t fan = 0; fan < fans.vertex_of_fan.size(); ++fan) {
    const std::uint32_t v = fans.vertex_of_fan[fan];
    if (!fans.is_open[fan]) closed_fans[v] = 1;
    fan_count[v] = static_cast<std::uint8_t>(std::min(fan_count[v] + 1, 255));
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (fan_count[v] == 0) return violation("no triangle at vertex", v);
    if (closed_fans[v] && fan_count[v] > 1) return violation("triangles overlap at vertex", v);
    if (turns_of_vertex[v] > 1 || (closed_fans[v] && turns_of_vertex[v] != 1)) {
      return violation("triangles do not go round once at vertex", v);
    }
  }
  return ok_status();
}

std::uint32_t component_count(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> seen(mesh.triangle_count(), 0);
  std::vector<std::uint32_t> stack;
  std::uint32_t count = 0;
  for (std::uint32_t start = 0; start < mesh.triangle_count(); ++start) {
    if (seen[start]) continue;
    ++count;
    seen[start] = 1;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::int32_t twin = mesh.half_edge_twin[h];
        if (twin == kNone || seen[twin / 3]) continue;
        seen[twin / 3] = 1;
        stack.push_back(static_cast<std::uint32_t>(twin) / 3);
      }
    }
  }
  return count;
}

/// Returns the next hull edge around the fan at the target of hull edge h.
std::uint32_t next_on_hull(const TriangleMesh& mesh, std::uint32_t h) {
  std::uint32_t e = next_half_edge(h);
  while (mesh.half_edge_twin[e] != kNone) {
    e = next_half_edge(static_cast<std::uint32_t>(mesh.half_edge_twin[e]));
  }
  return e;
}

std::uint32_t hull_loop_count(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> seen(mesh.half_edge_twin.size(), 0);
  std::uint32_t loops = 0;
  for (std::uint32_t h = 0; h < mesh.half_edge_twin.size(); ++h) {
    if (mesh.half_edge_twin[h] != kNone || seen[h]) continue;
    ++loops;
    for (std::uint32_t e = h; !seen[e]; e = next_on_hull(mesh, e)) seen[e] = 1;
  }
  return loops;
}

/// Checks pieces of the plane with holes: vertices − edges + triangles = 2 · pieces − boundaries. A
/// vertex where two parts only touch counts once for each.
Status check_euler(const TriangleMesh& mesh, const Fans& fans) {
  std::int64_t hull_edges = 0;
  for (const std::int32_t twin : mesh.half_edge_twin) hull_edges += twin == kNone;
  const auto half_edges = static_cast<std::int64_t>(mesh.half_edge_twin.size());
  const auto vertices = static_cast<std::int64_t>(fans.vertex_of_fan.size());
  const std::int64_t euler = vertices - (half_edges + hull_edges) / 2 + half_edges / 3;
  const std::int64_t expected =
      2 * std::int64_t{component_count(mesh)} - std::int64_t{hull_loop_count(mesh)};
  return euler == expected ? ok_status() : violation("Euler's formula does not hold");
}

/// Checks the area. A free hull is that of the whole domain: a rectangle, and the triangles fill
/// it.
Status check_area(const TriangleMesh& mesh, const std::vector<Point>& points) {
  std::int64_t doubled_area = 0, hull_edges = 0, free_hull_edges = 0;
  Point high;
  for (const Point p : points) high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  for (std::uint32_t h = 0; h < mesh.half_edge_twin.size(); ++h) {
    if (h % 3 == 0) {
      doubled_area +=
          orient2d(points[mesh.origin(h)], points[mesh.target(h)], points[mesh.apex(h)]);
    }
    if (mesh.half_edge_twin[h] != kNone) continue;
    ++hull_edges;
    free_hull_edges += mesh.half_edge_constraint[h] == kNone;
  }
  if (free_hull_edges == 0) return ok_status();
  if (free_hull_edges != 4 || hull_edges != 4) return violation("the hull is not the domain's");
  const std::int64_t domain = 2 * std::int64_t{high.x} * high.y;
  return doubled_area == domain ? ok_status() : violation("the triangles do not fill the domain");
}

}  // namespace

Status is_valid(const TriangleMesh& mesh) {
  std::vector<Point> points;
  SFUMATO_TRY(to_lattice(mesh, points));
  for (const auto check : {check_indices, check_adjacency, check_constraints}) {
    SFUMATO_TRY(check(mesh));
  }
  SFUMATO_TRY(check_shape(mesh, points));
  const Fans fans = find_fans(mesh);
  SFUMATO_TRY(check_turns(mesh, points, fans));
  SFUMATO_TRY(check_euler(mesh, fans));
  return check_area(mesh, points);
}

}  // namespace sfumato::mesh
