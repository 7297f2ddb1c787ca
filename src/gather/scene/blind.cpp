#include "gather/scene/blind.hpp"

#include <algorithm>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::gather {
namespace {

/// The most triangles that are searched behind one open side…
constexpr int kMostTriangles = 128;
/// …and in total, for each half-edge of the mesh. Most open sides meet a hit edge after a few.
constexpr std::int64_t kTrianglesPerHalfEdge = 32;

constexpr std::uint32_t kNobody = 0xffffffff;

/// Lattice steps from the mesh's first vertex.
struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(LatticePoint, LatticePoint) = default;
};

std::int64_t dot(LatticePoint normal, LatticePoint from, LatticePoint to) {
  return std::int64_t{normal.x} * (to.x - from.x) + std::int64_t{normal.y} * (to.y - from.y);
}

/// Returns twice the area of (a, b, p): exact, differences have 29 bits (mesh/lattice.hpp).
std::int64_t area(LatticePoint a, LatticePoint b, LatticePoint p) {
  return std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x);
}

// A triangle's area is half its perimeter times the radius of its inscribed circle. Where that
// radius is less than a step, rounding to the lattice decides on which side of an edge a point
// lies.
/// Returns whether the point lies on the far side of the line from a to b by more than rounding.
bool is_beyond(LatticePoint a, LatticePoint b, LatticePoint p) {
  const auto [left, right] = std::minmax({a.x, b.x, p.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, p.y});
  return -area(a, b, p) > 2 * (std::int64_t{right} - left + bottom - top);
}

/// The convex hull of points, for queries about its extent.
class Hull {
 public:
  /// points   by x, then by y
  /// Errors: cancelled; no other function may then be called.
  Status enclose(Context& context, std::span<const LatticePoint> points) {
    RarePoll<8192> poll(context);
    // Each chain has at most all points, and the upper one begins with the last of the lower.
    SFUMATO_TRY(memory_.reserve(context, corner_, 2 * points.size()));
    for (const LatticePoint p : points) {
      if (poll.cancelled()) return context.cancel_status();
      append(p, 0);
    }
    lower_end_ = corner_.empty() ? 0 : corner_.size() - 1;
    for (std::size_t i = points.size(); i > 0; --i) {
      if (poll.cancelled()) return context.cancel_status();
      append(points[i - 1], lower_end_);
    }
    if (corner_.size() > 1) corner_.pop_back();  // the first again
    return ok_status();
  }

  /// Returns whether some of it is_beyond the line from a to b.
  bool reaches_beyond(LatticePoint a, LatticePoint b) const {
    if (corner_.empty()) return false;
    const std::size_t count = corner_.size();
    const std::size_t farthest = farthest_corner(a, b);
    // For nearer corners a smaller distance suffices to be beyond.
    for (std::size_t i = farthest, left = count; left > 0 && area(a, b, corner_[i]) < 0; --left) {
      if (is_beyond(a, b, corner_[i])) return true;
      i = i + 1 < count ? i + 1 : 0;
    }
    for (std::size_t i = farthest, left = count; left > 0 && area(a, b, corner_[i]) < 0; --left) {
      if (is_beyond(a, b, corner_[i])) return true;
      i = (i > 0 ? i : count) - 1;
    }
    return false;
  }

 private:
  /// Appends to Andrew's monotone chain, which began at corner `first`.
  void append(LatticePoint p, std::size_t first) {
    while (corner_.size() > first + 1 &&
           area(corner_[corner_.size() - 2], corner_.back(), p) <= 0) {
      corner_.pop_back();
    }
    if (corner_.empty() || !(p == corner_.back())) corner_.push_back(p);
  }

  /// Returns the farthest corner. Along either chain the sides that lead outward come first.
  std::size_t farthest_corner(LatticePoint a, LatticePoint b) const {
    const LatticePoint outward{b.y - a.y, a.x - b.x};
    const bool on_upper = outward.y > 0 || (outward.y == 0 && outward.x < 0);
    std::size_t first = on_upper ? lower_end_ : 0;
    std::size_t last = on_upper ? corner_.size() : lower_end_;
    while (first < last) {
      const std::size_t middle = (first + last) / 2;
      if (dot(outward, corner_[middle], corner_[(middle + 1) % corner_.size()]) > 0) {
        first = middle + 1;
      } else {
        last = middle;
      }
    }
    return first % corner_.size();
  }

  std::vector<LatticePoint> corner_;  ///< counter-clockwise where y is up, from the least x
  std::size_t lower_end_ = 0;         ///< the corner of the largest x
  TableMemory memory_{"the visibility mesh"};
};

class BlindFinder {
 public:
  BlindFinder(Context& context, const mesh::TriangleMesh& mesh, std::span<const EdgeCode> code,
              std::vector<std::uint8_t>& blind)
      : context_(context), poll_(context), mesh_(mesh), code_(code), blind_(blind) {}

  Status run() {
    Status status = find_points();
    if (status) status = find_beyond_the_hull();
    if (status) status = find_facing_away();
    return status ? context_.check() : status;
  }

 private:
  enum class Sight : std::uint8_t { blind, hit, undecided };

  Status find_points() {
    Status status = memory_.resize(context_, point_, mesh_.vertex_position.size());
    for (std::size_t v = 0; v < point_.size(); ++v) {
      if (poll_.cancelled()) return context_.cancel_status();
      const Vec2 steps = (mesh_.vertex_position[v] - mesh_.vertex_position[0]) / mesh_.lattice_step;
      point_[v] = {static_cast<std::int32_t>(steps.x), static_cast<std::int32_t>(steps.y)};
    }
    return status;
  }

  LatticePoint from(std::uint32_t h) const { return point_[mesh_.origin(h)]; }
  LatticePoint to(std::uint32_t h) const { return point_[mesh_.target(h)]; }
  std::uint32_t half_edge_count() const { return static_cast<std::uint32_t>(code_.size()); }

  Status find_beyond_the_hull() {
    TableMemory scratch("the visibility mesh");
    std::vector<std::uint8_t> is_hit_at;
    SFUMATO_TRY(scratch.resize(context_, is_hit_at, point_.size()));
    for (std::uint32_t h = 0; h < half_edge_count(); ++h) {
      if (poll_.cancelled()) return context_.cancel_status();
      if (!is_hit(code_[h])) continue;
      is_hit_at[mesh_.origin(h)] = is_hit_at[mesh_.target(h)] = 1;
    }
    std::vector<LatticePoint> hit_points;
    for (std::size_t v = 0; v < point_.size(); ++v) {
      if (!is_hit_at[v]) continue;
      SFUMATO_TRY(scratch.push_back(context_, hit_points, point_[v]));
    }
    const auto lies_before = [](LatticePoint a, LatticePoint b) {
      return a.x != b.x ? a.x < b.x : a.y < b.y;
    };
    Hull hull;
    SFUMATO_TRY(TableMemory::sort(context_, hit_points, lies_before));
    SFUMATO_TRY(hull.enclose(context_, hit_points));
    for (std::uint32_t h = 0; h < half_edge_count(); ++h) {
      if (poll_.cancelled()) return context_.cancel_status();
      blind_[h] = code_[h] >= 0 && !hull.reaches_beyond(from(h), to(h));
    }
    return ok_status();
  }

  /// Returns whether a ray that crosses `near` and then `far` is possible: each reaches the region
  /// where the other is seen.
  bool face(std::uint32_t near, std::uint32_t far) const {
    const LatticePoint a = from(near), b = to(near), c = from(far), d = to(far);
    return (is_beyond(a, b, c) || is_beyond(a, b, d)) && (is_beyond(d, c, a) || is_beyond(d, c, b));
  }

  bool is_open_side(std::uint32_t h) const {
    return code_[h] >= 0 && !blind_[h] && mesh_.half_edge_constraint[h] != mesh::kNone;
  }

  /// Finds half-edges of the second case. Open sides wait for the first open side behind them that
  /// may not be blind: when it turns out to be blind, they are searched again.
  Status find_facing_away() {
    std::vector<std::uint32_t> unsettled;
    for (std::uint32_t h = 0; h < half_edge_count(); ++h) {
      if (poll_.cancelled()) return context_.cancel_status();
      if (!is_open_side(h)) continue;
      SFUMATO_TRY(memory_.push_back(context_, unsettled, h));
    }
    if (unsettled.empty()) return ok_status();
    SFUMATO_TRY(memory_.resize(context_, first_waiting_, code_.size(), kNobody));
    SFUMATO_TRY(memory_.resize(context_, next_waiting_, code_.size(), kNobody));
    SFUMATO_TRY(memory_.resize(context_, turn_, mesh_.triangle_count()));
    triangles_left_ = kTrianglesPerHalfEdge * static_cast<std::int64_t>(code_.size());
    while (!unsettled.empty() && triangles_left_ > 0) {
      if (poll_.cancelled()) return context_.cancel_status();
      const std::uint32_t h = unsettled.back();
      unsettled.pop_back();
      std::uint32_t unknown = kNobody;
      const Sight sight = look_through(h, unknown);
      if (sight == Sight::undecided && unknown != kNobody) {
        next_waiting_[h] = first_waiting_[unknown];
        first_waiting_[unknown] = h;
      }
      if (sight != Sight::blind) continue;
      blind_[h] = 1;
      for (std::uint32_t w = first_waiting_[h]; w != kNobody; w = next_waiting_[w]) {
        SFUMATO_TRY(memory_.push_back(context_, unsettled, w));
      }
    }
    return ok_status();
  }

  /// Goes through the triangles that can be reached through edges that face h.
  Sight look_through(std::uint32_t h, std::uint32_t& unknown) {
    ++turn_now_;
    stack_.assign(1, h);
    for (int count = 0; !stack_.empty();) {
      const auto twin = static_cast<std::uint32_t>(mesh_.half_edge_twin[stack_.back()]);
      stack_.pop_back();
      if (turn_[twin / 3] == turn_now_) continue;
      turn_[twin / 3] = turn_now_;
      if (++count > kMostTriangles || --triangles_left_ < 0) return Sight::undecided;
      // The entry edge too: other rays may enter by another edge and leave by it.
      for (std::uint32_t side = twin / 3 * 3; side < twin / 3 * 3 + 3; ++side) {
        if (code_[side] == kBorder || blind_[side] || !face(h, side)) continue;
        if (is_hit(code_[side])) return Sight::hit;
        if (unknown == kNobody && is_open_side(side)) unknown = side;
        stack_.push_back(side);
      }
    }
    return Sight::blind;
  }

  Context& context_;
  RarePoll<256> poll_;
  const mesh::TriangleMesh& mesh_;
  std::span<const EdgeCode> code_;
  std::vector<std::uint8_t>& blind_;
  TableMemory memory_{"the visibility mesh"};
  std::vector<LatticePoint> point_;
  std::vector<std::uint32_t>
      first_waiting_;  ///< per half-edge: a list of the half-edges that wait for it
  std::vector<std::uint32_t> next_waiting_;
  std::vector<std::uint32_t> turn_;  ///< per triangle: when it was last visited
  std::uint32_t turn_now_ = 0;
  std::int64_t triangles_left_ = 0;
  std::vector<std::uint32_t> stack_;
};

}  // namespace

Result<std::vector<std::uint8_t>> find_blind(Context& context, const mesh::TriangleMesh& mesh,
                                             std::span<const EdgeCode> code, TableMemory& memory) {
  std::vector<std::uint8_t> blind;
  SFUMATO_TRY(memory.resize(context, blind, code.size()));
  if (mesh.lattice_step > 0) SFUMATO_TRY(BlindFinder(context, mesh, code, blind).run());
  return blind;
}

}  // namespace sfumato::gather
