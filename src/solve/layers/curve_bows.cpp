#include "solve/layers/curve_bows.hpp"

#include <algorithm>
#include <cmath>

#include "base/half_edge.hpp"
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
      : bowed_(bowed),
        mesh_(bowed.mesh),
        whole_(static_cast<std::uint32_t>(mesh_.half_edge_twin.size())),
        number_(number) {}

  std::uint32_t edge_count() const {
    return static_cast<std::uint32_t>(mesh_.triangle_vertex.size());
  }

  /// Finds the bow of edge i of a triangle or part. Returns whether there is one, and i is the side
  /// that represents it.
  bool find(std::uint32_t i, CurveBow& bow) const {
    const std::int32_t half_edge =
        i < whole_ ? static_cast<std::int32_t>(i) : bowed_.cuts.edge[i - whole_];
    if (half_edge < 0 || is_replaced(i / 3)) return false;
    const auto h = static_cast<std::uint32_t>(half_edge);
    if (mesh_.half_edge_twin[h] == mesh::kNone || !mesh_.has_curves(h) || !bowed_.is_jump(h))
      return false;
    const auto twin = static_cast<std::uint32_t>(mesh_.half_edge_twin[h]);
    // A part represents its edge, and of two whole triangles the first.
    if (is_replaced(twin / 3) || (i < whole_ && twin < h)) return false;
    bow.front = slot(i);
    bow.back = slot(twin);
    return !(bow.front == SoftEdge::kNone && bow.back == SoftEdge::kNone) && measure(i, h, bow);
  }

 private:
  bool is_replaced(std::uint32_t triangle) const {
    return triangle < bowed_.cuts.is_cut.size() && bowed_.cuts.is_cut[triangle] != 0;
  }

  std::uint32_t slot(std::uint32_t i) const {
    const std::uint32_t triangle = number_[i / 3];
    return triangle == SoftEdge::kNone ? SoftEdge::kNone : 3 * triangle + i % 3;
  }

  /// Measures the curve on half-edge h over edge i, which is h or a part of it.
  bool measure(std::uint32_t i, std::uint32_t h, CurveBow& bow) const {
    const auto position = [&](std::uint32_t corner) {
      return mesh_.vertex_position[mesh_.triangle_vertex[corner]];
    };
    const Vec2 a = position(i), edge = position(next_half_edge(i)) - a;
    const Vec2 origin = position(h), along = position(next_half_edge(h)) - origin;
    const double size = length(edge), square = dot(along, along);
    double most = 0;
    for (int k = 0; k < 3; ++k) {
      const double share = dot(a + edge * (0.5 * k) - origin, along) / square;
      const double height = cross(edge, curve_point(h, share) - a) / size;
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
  std::uint32_t whole_;
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
  for (std::uint32_t i = 0; i < finder.edge_count(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    CurveBow bow;
    if (!finder.find(i, bow)) continue;
    SFUMATO_TRY(memory.make_room(context, bows));
    bows.push_back(bow);
  }
  return sorted_by_triangle(context, bows, memory);
}

}  // namespace sfumato::solve
