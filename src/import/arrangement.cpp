#include "import/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg_import {
namespace {

constexpr std::size_t kMaxPairs = 150'000'000;  ///< looked at: about a second
constexpr std::size_t kMaxPieces = 2'000'000;
constexpr std::size_t kMaxRayEdges =
    1'000'000'000;              ///< edges that winding numbers are counted over
constexpr int kMaxRounds = 64;  ///< two or three are usual
constexpr const char* kArrangementPurpose = "the boundary of a shape";
/// A piece is split at every vertex nearer than this, lattice steps: more than the tolerance.
constexpr std::int64_t kSnapDistance = 66;
constexpr double kLatticeSize = 536'870'912;  // 2^29: products of differences fit 64 bits

/// A part of a chord, on the lattice.
struct Piece {
  LatticePoint from;
  LatticePoint to;
  Source source;
  double since = 0;  ///< source.begin, or where chords before it began that the lattice swallowed
};

/// A piece is to be split at a point near it.
struct Snap {
  std::uint32_t piece = 0;
  LatticePoint point;
};

/// Twice the area of a triangle; above 0: c lies right of the way from a to b, on the screen.
std::int64_t orient2d(LatticePoint a, LatticePoint b, LatticePoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::int64_t distance_squared(LatticePoint a, LatticePoint b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

/// Whether a piece passes near a lattice point, between its ends, so that it is to be split there.
/// Both parts are shorter than the piece then: splitting ends.
bool snaps_to(const Piece& piece, LatticePoint p) {
  const LatticePoint a = piece.from, b = piece.to;
  const std::int64_t square = distance_squared(a, b);
  const std::int64_t along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
  if (!(along > 0 && along < square)) return false;
  if (distance_squared(a, p) >= square || distance_squared(p, b) >= square) return false;
  const auto off = static_cast<double>(orient2d(a, b, p));
  return off * off <=
         static_cast<double>(kSnapDistance * kSnapDistance) * static_cast<double>(square);
}

/// The intersection of two pieces, rounded to the lattice; none where they do not cross, or only
/// in an end.
std::optional<LatticePoint> intersection_of(const Piece& a, const Piece& b) {
  const std::int64_t from_b = orient2d(a.from, a.to, b.from), to_b = orient2d(a.from, a.to, b.to);
  const std::int64_t from_a = orient2d(b.from, b.to, a.from), to_a = orient2d(b.from, b.to, a.to);
  const bool parts_b = (from_b < 0 && to_b > 0) || (from_b > 0 && to_b < 0);
  const bool parts_a = (from_a < 0 && to_a > 0) || (from_a > 0 && to_a < 0);
  if (!parts_a || !parts_b) return std::nullopt;
  const double share =
      static_cast<double>(from_a) / (static_cast<double>(from_a) - static_cast<double>(to_a));
  return LatticePoint{a.from.y + std::llround(share * static_cast<double>(a.to.y - a.from.y)),
                      a.from.x + std::llround(share * static_cast<double>(a.to.x - a.from.x))};
}

/// What a sweep goes along; `across` is the other coordinate.
enum class Sweep { along_x, along_y };

Sweep across(Sweep sweep) {
  return sweep == Sweep::along_x ? Sweep::along_y : Sweep::along_x;
}
std::int64_t coordinate(LatticePoint p, Sweep sweep) {
  return sweep == Sweep::along_x ? p.x : p.y;
}
std::int64_t lowest(const Piece& piece, Sweep sweep) {
  return std::min(coordinate(piece.from, sweep), coordinate(piece.to, sweep));
}
std::int64_t highest(const Piece& piece, Sweep sweep) {
  return std::max(coordinate(piece.from, sweep), coordinate(piece.to, sweep));
}

/// Of a piece across the sweep, with what counts as near.
struct Extent {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// The way round an edge is kept: downwards, or to the right.
struct Edge {
  LatticePoint upper;
  LatticePoint lower;
  int net = 0;  ///< pieces that run from upper to lower, less those that run back
  std::size_t first_piece = 0;
  std::size_t piece_end = 0;
  std::optional<int> right_winding{};
};

LatticePoint far_end(const Edge& edge, LatticePoint vertex) {
  return edge.upper == vertex ? edge.lower : edge.upper;
}

class Arrangement {
 public:
  Arrangement(Context& context, bool even_odd) : context_(context), even_odd_(even_odd) {}

  Status round_to_lattice(const std::vector<Chord>& chords, double step);
  Status snap_round();
  Status merge_coincident();
  Status find_windings();
  Result<BoundaryEdges> boundary() const;

 private:
  Status find_intersections(TableMemory& memory, std::vector<LatticePoint>& intersections,
                            bool& meet);
  Status find_snaps(TableMemory& memory, std::vector<LatticePoint>& points,
                    std::vector<Snap>& snaps);
  Status check_counts(std::size_t pairs, std::size_t found);
  Status split_pieces(std::vector<Snap>& snaps);
  int winding_by_ray(const Edge& edge) const;
  void take_star(LatticePoint vertex);
  void propagate_winding(LatticePoint vertex, std::size_t known);
  bool is_inside(int winding) const { return even_odd_ ? winding % 2 != 0 : winding != 0; }

  Context& context_;
  TableMemory memory_{kArrangementPurpose};
  bool even_odd_;
  std::vector<Piece> pieces_;
  std::vector<Edge> edges_;
  std::vector<std::pair<LatticePoint, std::size_t>> edge_at_;  ///< both ends of each, sorted
  std::vector<std::uint8_t> is_taken_;  ///< per entry of edge_at_ that is the first of its vertex
  std::vector<std::size_t> star_;       ///< that was taken last
  std::vector<std::size_t> reached_;    ///< edges whose winding is known, to be carried on
  Sweep sweep_ = Sweep::along_x;
  std::size_t pairs_ = 0;
};

Status Arrangement::round_to_lattice(const std::vector<Chord>& chords, double step) {
  Box box;
  for (const Chord& chord : chords) box.extend(chord.from);
  if (box.empty()) return ok_status();
  Status status = memory_.reserve(context_, pieces_, chords.size());
  if (!status) return status;
  step = std::max(step, std::max(box.width(), box.height()) / kLatticeSize);
  sweep_ = box.width() >= box.height() ? Sweep::along_x : Sweep::along_y;
  const auto rounded = [&](Vec2 p) {
    const Vec2 at = (p - box.min) / step;
    return LatticePoint{std::llround(at.y), std::llround(at.x)};
  };
  double since = 0;
  for (const Chord& chord : chords) {
    if (chord.begin == 0) since = 0;
    const LatticePoint from = rounded(chord.from), to = rounded(chord.to);
    if (from == to) continue;
    pieces_.push_back({from, to, {chord.contour, chord.begin, chord.end}, since});
    since = chord.end;
  }
  return ok_status();
}

/// Where pieces cross. `meet`: whether any cross, or snap to an end of another.
Status Arrangement::find_intersections(TableMemory& memory,
                                       std::vector<LatticePoint>& intersections, bool& meet) {
  TableMemory working(kArrangementPurpose);
  std::vector<std::uint32_t> order, active;
  std::vector<Extent> extent;
  Status status = working.resize(context_, order, pieces_.size());
  if (status) status = working.reserve(context_, active, pieces_.size());
  if (status) status = working.reserve(context_, extent, pieces_.size());
  if (!status) return status;
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::pair(lowest(pieces_[i], sweep_), i); };
  status = TableMemory::sort(context_, order, [&](auto a, auto b) { return key(a) < key(b); });
  if (!status) return status;
  for (const Piece& piece : pieces_) {
    extent.push_back(
        {lowest(piece, across(sweep_)) - kSnapDistance, highest(piece, across(sweep_))});
  }
  const auto ends_snap = [](const Piece& a, const Piece& b) {
    return snaps_to(a, b.from) || snaps_to(a, b.to);
  };
  for (const std::uint32_t i : order) {
    if (context_.cancelled()) return context_.cancel_status();
    const Piece& piece = pieces_[i];
    const std::int64_t begin = lowest(piece, sweep_) - kSnapDistance;
    std::erase_if(active, [&](std::uint32_t k) { return highest(pieces_[k], sweep_) < begin; });
    if (status = check_counts(active.size(), intersections.size()); !status) return status;
    for (const std::uint32_t k : active) {
      if (extent[i].low > extent[k].high || extent[k].low > extent[i].high) continue;
      const Piece& other = pieces_[k];
      const auto point = intersection_of(piece, other);
      if (point) status = memory.push_back(context_, intersections, *point);
      if (!status) return status;
      meet = meet || point || ends_snap(piece, other) || ends_snap(other, piece);
    }
    active.push_back(i);
  }
  return ok_status();
}

Status Arrangement::check_counts(std::size_t pairs, std::size_t found) {
  pairs_ += pairs;
  if (pairs_ <= kMaxPairs && pieces_.size() + found <= kMaxPieces) return ok_status();
  return make_error(StatusCode::limit, "the shape crosses itself too often");
}

/// For every piece the points that it snaps to: ends of pieces, and `points`.
Status Arrangement::find_snaps(TableMemory& memory, std::vector<LatticePoint>& points,
                               std::vector<Snap>& snaps) {
  Status status = memory.reserve(context_, points, points.size() + 2 * pieces_.size());
  if (!status) return status;
  for (const Piece& piece : pieces_) {
    points.push_back(piece.from);
    points.push_back(piece.to);
  }
  const auto key = [&](LatticePoint p) { return std::pair(coordinate(p, sweep_), p); };
  status = TableMemory::sort(context_, points, [&](auto a, auto b) { return key(a) < key(b); });
  if (!status) return status;
  const auto repeated = std::ranges::unique(points);
  points.erase(repeated.begin(), repeated.end());
  const auto coordinate_of = [&](LatticePoint p) { return coordinate(p, sweep_); };
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (context_.cancelled()) return context_.cancel_status();
    const std::int64_t begin = lowest(pieces_[i], sweep_) - kSnapDistance;
    const std::int64_t end = highest(pieces_[i], sweep_) + kSnapDistance;
    const auto low = std::ranges::lower_bound(points, begin, {}, coordinate_of);
    const auto high = std::ranges::upper_bound(points, end, {}, coordinate_of);
    const auto size = static_cast<std::size_t>(high - low);
    if (status = check_counts(size, snaps.size()); !status) return status;
    for (const LatticePoint point : std::span(low, high)) {
      if (snaps_to(pieces_[i], point)) status = memory.push_back(context_, snaps, {i, point});
      if (!status) return status;
    }
  }
  return ok_status();
}

/// Splits pieces, in the order in which their contour meets the points. The snaps are sorted.
Status Arrangement::split_pieces(std::vector<Snap>& snaps) {
  const auto share_of = [&](const Snap& snap) {
    const Piece& piece = pieces_[snap.piece];
    const auto x = static_cast<double>(piece.to.x - piece.from.x);
    const auto y = static_cast<double>(piece.to.y - piece.from.y);
    const double along = static_cast<double>(snap.point.x - piece.from.x) * x +
                         static_cast<double>(snap.point.y - piece.from.y) * y;
    return std::clamp(along / (x * x + y * y), 0.0, 1.0);
  };
  const auto place = [&](const Snap& snap) {
    return std::tuple(snap.piece, share_of(snap), snap.point);
  };
  Status status = TableMemory::sort(
      context_, snaps, [&](const Snap& a, const Snap& b) { return place(a) < place(b); });
  std::vector<Piece> result;
  if (status) status = memory_.reserve(context_, result, pieces_.size() + snaps.size());
  if (!status) return status;
  auto snap = snaps.begin();
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    Piece rest = pieces_[i];
    const Source whole = rest.source;
    for (; snap != snaps.end() && snap->piece == i; ++snap) {
      if (!snaps_to(rest, snap->point)) continue;  // not any more: the next round sees it
      const double parameter = whole.begin + (whole.end - whole.begin) * share_of(*snap);
      rest.source.end = parameter;
      result.push_back({rest.from, snap->point, rest.source, rest.since});
      rest.from = snap->point;
      rest.source = {whole.contour, parameter, whole.end};
      rest.since = parameter;
    }
    result.push_back(rest);
  }
  memory_.free(pieces_);
  pieces_ = std::move(result);
  return ok_status();
}

/// Snap rounding (Hobby 1999), with a wider reach: contours nearer to each other than the tolerance
/// become one there, since what lies between them shows nothing but would need colours. Iterated
/// until no piece snaps to a point (Halperin and Packer 2002).
Status Arrangement::snap_round() {
  for (int round = 0; round < kMaxRounds; ++round) {
    TableMemory memory(kArrangementPurpose);
    std::vector<LatticePoint> points;
    bool meet = false;
    if (Status status = find_intersections(memory, points, meet); !status) return status;
    if (!meet) return ok_status();
    std::vector<Snap> snaps;
    if (Status status = find_snaps(memory, points, snaps); !status) return status;
    memory.free(points);
    if (snaps.empty()) return ok_status();  // they cross in their ends, but for rounding
    if (Status status = split_pieces(snaps); !status) return status;
  }
  return make_error(StatusCode::limit, "the shape crosses itself too often");
}

/// Makes one edge of the pieces between the same two points; none where they cancel each other.
Status Arrangement::merge_coincident() {
  const auto ends = [](const Piece& piece) { return std::minmax(piece.from, piece.to); };
  const auto place = [&](const Piece& piece) {
    const auto [upper, lower] = ends(piece);
    return std::tuple(LatticePoint(upper), LatticePoint(lower), piece.source.contour,
                      piece.source.begin);
  };
  Status status = TableMemory::sort(
      context_, pieces_, [&](const Piece& a, const Piece& b) { return place(a) < place(b); });
  if (!status) return status;
  RarePoll<1024> poll(context_);
  for (std::size_t i = 0; i < pieces_.size();) {
    if (poll.cancelled()) return context_.cancel_status();
    const LatticePoint upper = ends(pieces_[i]).first, lower = ends(pieces_[i]).second;
    Edge edge{upper, lower, 0, i, i};
    for (; i < pieces_.size() && ends(pieces_[i]) == std::minmax(upper, lower); ++i) {
      edge.net += pieces_[i].from == upper ? 1 : -1;
    }
    edge.piece_end = i;
    if (edge.net != 0) status = memory_.push_back(context_, edges_, edge);
    if (!status) return status;
  }
  status = memory_.reserve(context_, edge_at_, 2 * edges_.size());
  if (status) status = memory_.resize(context_, is_taken_, 2 * edges_.size());
  if (!status) return status;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    edge_at_.emplace_back(edges_[i].upper, i);
    edge_at_.emplace_back(edges_[i].lower, i);
  }
  return TableMemory::sort(context_, edge_at_, std::less<>());
}

/// The winding number on the edge's right. A ray runs to the right from the edge's middle, a little
/// lower: it crosses what passes that height, and not the edge.
int Arrangement::winding_by_ray(const Edge& edge) const {
  const LatticePoint twice{edge.upper.y + edge.lower.y, edge.upper.x + edge.lower.x};
  int number = 0;
  for (const Edge& other : edges_) {
    if (&other == &edge || !(2 * other.upper.y <= twice.y && 2 * other.lower.y > twice.y)) continue;
    const std::int64_t side = (other.lower.x - other.upper.x) * (twice.y - 2 * other.upper.y) -
                              (other.lower.y - other.upper.y) * (twice.x - 2 * other.upper.x);
    if (side > 0) number += other.net;
  }
  return edge.upper.y == edge.lower.y ? number : number + edge.net;
}

/// Makes star_ the star of a vertex, clockwise on the screen; empty where that was asked before.
void Arrangement::take_star(LatticePoint vertex) {
  const auto of_vertex = [](const auto& entry) { return entry.first; };
  const auto entries = std::ranges::equal_range(edge_at_, vertex, {}, of_vertex);
  const auto first = static_cast<std::size_t>(entries.begin() - edge_at_.begin());
  star_.clear();
  if (is_taken_[first]) return;
  is_taken_[first] = 1;
  for (const auto& [at, edge] : entries) star_.push_back(edge);
  // Those that lead down from the vertex first, which canonical edges do from their upper end.
  std::ranges::sort(star_, [&](std::size_t a, std::size_t b) {
    const bool a_leads_on = edges_[a].upper == vertex, b_leads_on = edges_[b].upper == vertex;
    if (a_leads_on != b_leads_on) return a_leads_on;
    return orient2d(vertex, far_end(edges_[a], vertex), far_end(edges_[b], vertex)) > 0;
  });
}

/// Round a vertex from an edge whose winding is known to those where it is not; once for each.
void Arrangement::propagate_winding(LatticePoint vertex, std::size_t known) {
  take_star(vertex);
  if (star_.empty()) return;
  const auto first = static_cast<std::size_t>(std::ranges::find(star_, known) - star_.begin());
  const Edge& begin = edges_[known];
  int winding = *begin.right_winding - (begin.upper == vertex ? 0 : begin.net);
  for (std::size_t i = 1; i < star_.size(); ++i) {
    const std::size_t index = star_[(first + i) % star_.size()];
    Edge& edge = edges_[index];
    const bool leads_on = edge.upper == vertex;
    const int beyond = winding + (leads_on ? edge.net : -edge.net);
    if (!edge.right_winding) {
      edge.right_winding = leads_on ? beyond : winding;
      reached_.push_back(index);
    }
    winding = beyond;
  }
}

/// Counted once for all edges that hang together, and carried on round their vertices.
Status Arrangement::find_windings() {
  // An edge is reached once at most, and in a star once.
  Status status = memory_.reserve(context_, reached_, edges_.size());
  if (status) status = memory_.reserve(context_, star_, edges_.size());
  if (!status) return status;
  std::size_t ray_edges = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].right_winding) continue;
    if (context_.cancelled()) return context_.cancel_status();
    if ((ray_edges += edges_.size()) > kMaxRayEdges) {
      return make_error(StatusCode::limit, "the shape crosses itself too often");
    }
    edges_[i].right_winding = winding_by_ray(edges_[i]);
    for (reached_.push_back(i); !reached_.empty();) {
      const std::size_t at = reached_.back();
      reached_.pop_back();
      if (context_.cancelled()) return context_.cancel_status();
      propagate_winding(edges_[at].upper, at);
      propagate_winding(edges_[at].lower, at);
    }
  }
  return ok_status();
}

Result<BoundaryEdges> Arrangement::boundary() const {
  BoundaryEdges result;
  Status status = result.memory.reserve(context_, result.edge, edges_.size());
  if (status) status = result.memory.reserve(context_, result.source, pieces_.size());
  if (!status) return status;
  RarePoll<1024> poll(context_);
  for (const Edge& edge : edges_) {
    if (poll.cancelled()) return context_.cancel_status();
    const bool right = is_inside(*edge.right_winding);
    const bool left = is_inside(*edge.right_winding - edge.net);
    if (left == right) continue;
    BoundaryEdge& added = result.edge.emplace_back();
    added.first_source = result.source.size();
    added.from = right ? edge.upper : edge.lower;
    added.to = right ? edge.lower : edge.upper;
    for (std::size_t i = edge.first_piece; i < edge.piece_end; ++i) {
      Source source = pieces_[i].source;
      source.begin = pieces_[i].since;
      if (pieces_[i].from != added.from) std::swap(source.begin, source.end);
      result.source.push_back(source);
    }
    added.source_end = result.source.size();
  }
  return result;
}

}  // namespace

Result<BoundaryEdges> boundary_edges(Context& context, const std::vector<Chord>& chords,
                                     bool even_odd, double step) {
  Arrangement arrangement(context, even_odd);
  Status status = arrangement.round_to_lattice(chords, step);
  if (status) status = arrangement.snap_round();
  if (status) status = arrangement.merge_coincident();
  if (status) status = arrangement.find_windings();
  if (!status) return status;
  return arrangement.boundary();
}

}  // namespace sfumato::svg_import
