#include "solve/layers/curve_bows.hpp"

#include <algorithm>
#include <cmath>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "solve/layers/kept_triangles.hpp"

namespace sfumato::solve {
namespace {

/// A curve that strays from its edge by no more than this share of the edge's length is straight.
constexpr double kStraight = 1e-4;

class BowFinder {
 public:
  BowFinder(const BowedMesh& bowed, std::span<const std::uint32_t> number)
      : bowed_(bowed), mesh_(bowed.mesh), number_(number) {}

  std::uint32_t half_edge_count() const {
    return static_cast<std::uint32_t>(mesh_.half_edge_twin.size());
  }

  /// Finds the bow of a half-edge. Returns whether there is one, and the half-edge is the first of
  /// its edge.
  bool find(std::uint32_t h, CurveBow& bow) const {
    if (mesh_.half_edge_twin[h] == mesh::kNone || !mesh_.has_curves(h) || !bowed_.is_jump(h))
      return false;
    const auto twin = static_cast<std::uint32_t>(mesh_.half_edge_twin[h]);
    if (twin < h) return false;
    bow.front = slot(h);
    bow.back = slot(twin);
    return !(bow.front == SoftEdge::kNone && bow.back == SoftEdge::kNone) && measure(h, bow);
  }

 private:
  std::uint32_t slot(std::uint32_t h) const {
    const std::uint32_t triangle = number_[h / 3];
    return triangle == SoftEdge::kNone ? SoftEdge::kNone : 3 * triangle + h % 3;
  }

  /// Measures the curve over half-edge h.
  bool measure(std::uint32_t h, CurveBow& bow) const {
    const Vec2 a = mesh_.vertex_position[mesh_.origin(h)];
    const Vec2 edge = mesh_.vertex_position[mesh_.target(h)] - a;
    const double size = length(edge);
    double most = 0;
    for (int k = 0; k < 3; ++k) {
      const double height = cross(edge, curve_point(h, 0.5 * k) - a) / size;
      bow.height[k] = static_cast<float>(height);
      most = std::fmax(most, std::isfinite(height) ? std::fabs(height) : size);
    }
    return most > kStraight * size && most < size;
  }

  /// Returns the point of the curve over a share of half-edge h.
  Vec2 curve_point(std::uint32_t h, double share) const {
    const auto c = static_cast<std::size_t>(mesh_.half_edge_constraint[h]);
    const mesh::Constraint& constraint = mesh_.constraint[c];
    const mesh::SegmentPiece& piece = mesh_.piece[constraint.piece_end - 1];
    if (mesh_.origin(h) != constraint.from) share = 1 - share;
    const double u = piece.u_from + (double{piece.u_to} - piece.u_from) * share;
    const Vec2 from = bowed_.flat.vertex[piece.segment];
    const Vec2 chord = bowed_.flat.vertex[piece.segment + 1] - from;
    const Vec2 normal = Vec2{-chord.y, chord.x} / length(chord);
    return from + chord * u + normal * bowed_.flat.bow[piece.segment].at(u);
  }

  const BowedMesh& bowed_;
  const mesh::TriangleMesh& mesh_;
  std::span<const std::uint32_t> number_;
};

}  // namespace

Result<std::vector<CurveBow>> find_curve_bows(const Context& context, const BowedMesh& bowed,
                                              std::span<const std::uint8_t> keep,
                                              TableMemory& memory) {
  TableMemory scratch("patches along curves");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint32_t>& number,
                     numbers_of_kept(context, keep, scratch));
  const BowFinder finder(bowed, number);
  std::vector<CurveBow> bows;
  RarePoll<65536> poll(context);
  for (std::uint32_t i = 0; i < finder.half_edge_count(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    CurveBow bow;
    if (!finder.find(i, bow)) continue;
    SFUMATO_TRY(memory.make_room(context, bows));
    bows.push_back(bow);
  }
  return sorted_by_triangle(context, bows, memory);
}

}  // namespace sfumato::solve
