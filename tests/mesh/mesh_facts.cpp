#include "mesh/mesh_facts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace sfumato::mesh::test {

std::optional<Constraint> constraint_between(const TriangleMesh& mesh, Vec2 p, Vec2 q) {
  for (const Constraint& c : mesh.constraint) {
    const Vec2 from = mesh.vertex_position[c.from], to = mesh.vertex_position[c.to];
    if ((from == p && to == q) || (from == q && to == p)) return c;
  }
  return std::nullopt;
}

std::vector<std::vector<PlacedPiece>> pieces_by_segment(const TriangleMesh& mesh,
                                                        std::size_t segment_count) {
  std::vector<std::vector<PlacedPiece>> of_segment(segment_count);
  for (const Constraint& c : mesh.constraint) {
    for (const SegmentPiece& piece : mesh.pieces(c)) {
      PlacedPiece placed{mesh.vertex_position[c.from], mesh.vertex_position[c.to], piece.u_from,
                         piece.u_to};
      if (placed.u_from > placed.u_to) {
        std::swap(placed.from, placed.to);
        std::swap(placed.u_from, placed.u_to);
      }
      of_segment[piece.segment].push_back(placed);
    }
  }
  for (auto& pieces : of_segment) {
    std::sort(pieces.begin(), pieces.end(), [](const PlacedPiece& a, const PlacedPiece& b) {
      return a.u_from != b.u_from ? a.u_from < b.u_from : a.u_to < b.u_to;
    });
  }
  return of_segment;
}

std::vector<PlacedPiece> pieces_of_segment(const TriangleMesh& mesh, std::uint32_t segment) {
  std::uint32_t count = segment + 1;
  for (const SegmentPiece& piece : mesh.piece) count = std::max(count, piece.segment + 1);
  return pieces_by_segment(mesh, count)[segment];
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const double length2 = length_squared(b - a);
  const double t = length2 > 0 ? std::clamp(dot(p - a, b - a) / length2, 0.0, 1.0) : 0;
  return length(p - lerp(a, b, t));
}

double smallest_angle(const TriangleMesh& mesh, std::uint32_t t) {
  double least = 180;
  for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
    const Vec2 p = mesh.vertex_position[mesh.origin(h)];
    const Vec2 u = mesh.vertex_position[mesh.target(h)] - p;
    const Vec2 w = mesh.vertex_position[mesh.apex(h)] - p;
    least = std::min(least, std::atan2(cross(u, w), dot(u, w)) * 180 / std::numbers::pi);
  }
  return least;
}

double area(const TriangleMesh& mesh, std::uint32_t t) {
  const Vec2 p = mesh.vertex_position[mesh.origin(3 * t)];
  return 0.5 * cross(mesh.vertex_position[mesh.target(3 * t)] - p,
                     mesh.vertex_position[mesh.apex(3 * t)] - p);
}

double total_area(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) sum += area(mesh, t);
  return sum;
}

std::uint64_t mesh_hash(const TriangleMesh& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) {
      hash = (hash ^ ((value >> (8 * byte)) & 0xff)) * 0x100000001b3u;
    }
  };
  for (const Vec2 p : mesh.vertex_position) {
    add(static_cast<std::uint64_t>(std::llround(p.x / mesh.lattice_step)));
    add(static_cast<std::uint64_t>(std::llround(p.y / mesh.lattice_step)));
  }
  for (const std::uint32_t v : mesh.triangle_vertex) add(v);
  for (const Constraint& c : mesh.constraint) {
    add(c.from);
    add(c.to);
    for (const SegmentPiece& piece : mesh.pieces(c)) add(piece.segment);
  }
  return hash;
}

}  // namespace sfumato::mesh::test
