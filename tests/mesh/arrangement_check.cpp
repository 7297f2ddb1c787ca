#include "mesh/arrangement_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mesh/mesh_facts.hpp"

namespace sfumato::mesh::test {
namespace {

/// Returns whether the pieces run from u = 0 to u = 1 without gaps, each from the end of the
/// previous one.
bool covers_in_order(const std::vector<PlacedPiece>& pieces) {
  float reached = 0;
  Vec2 place = pieces.front().from;
  for (const PlacedPiece& piece : pieces) {
    // Stretches of zero length in u may be in any order; they join up in the plane anyway.
    if (piece.u_from != reached) return false;
    if (piece.u_from < piece.u_to && piece.u_from > 0 && !(piece.from == place)) {
      const bool led_over = std::any_of(pieces.begin(), pieces.end(), [&](const PlacedPiece& p) {
        return p.u_from == p.u_to && p.u_from == reached;
      });
      if (!led_over) return false;
    }
    reached = piece.u_to;
    place = piece.to;
  }
  return reached == 1;
}

double farthest_sample(Vec2 a, Vec2 b, const std::vector<PlacedPiece>& pieces) {
  constexpr int kSamples = 16;
  double farthest = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const Vec2 p = lerp(a, b, static_cast<double>(i) / kSamples);
    double nearest = std::numeric_limits<double>::infinity();
    for (const PlacedPiece& piece : pieces) {
      nearest = std::min(nearest, distance_to_segment(p, piece.from, piece.to));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

double smallest_gap(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  double least2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const double dx = points[j].x - points[i].x;
      if (dx * dx >= least2) break;
      least2 = std::min(least2, length_squared(points[j] - points[i]));
    }
  }
  return std::sqrt(least2);
}

}  // namespace

ArrangementFacts check_arrangement(const TriangleMesh& mesh, const curves::FlatCurves& flat,
                                   double weld) {
  ArrangementFacts facts;
  const auto of_segment = pieces_by_segment(mesh, flat.vertex.size());
  for (std::uint32_t s = 0; s < flat.vertex.size(); ++s) {
    const std::vector<PlacedPiece>& pieces = of_segment[s];
    if (!flat.begins_segment(s)) {
      if (!pieces.empty()) facts.broken = "pieces of no segment at vertex " + std::to_string(s);
      continue;
    }
    const Vec2 a = flat.vertex[s], b = flat.vertex[s + 1];
    if (pieces.empty()) {
      // Its ends became one vertex, each within the weld distance of it.
      if (length(b - a) > 2 * weld + 2 * mesh.lattice_step) {
        facts.broken = "segment " + std::to_string(s) + " is lost";
      }
      continue;
    }
    if (!covers_in_order(pieces)) {
      facts.broken = "segment " + std::to_string(s) + " is not covered in order";
    }
    facts.input_to_mesh = std::max(facts.input_to_mesh, farthest_sample(a, b, pieces));
    for (const PlacedPiece& piece : pieces) {
      facts.mesh_to_input = std::max({facts.mesh_to_input, distance_to_segment(piece.from, a, b),
                                      distance_to_segment(piece.to, a, b)});
    }
  }
  facts.vertex_gap = smallest_gap(mesh.vertex_position);
  return facts;
}

}  // namespace sfumato::mesh::test
