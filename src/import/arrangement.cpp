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
#include "base/try.hpp"
#include "import/active_pieces.hpp"
#include "import/shape_limits.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg_import {
namespace {

constexpr std::uint64_t kRayEdgesFactor = 7;  ///< Limits::chord_pairs: edges of winding numbers
/// Share of Limits::chord_pairs where vertices are kept, for close parts may multiply without end.
constexpr double kKeptPairs = 0.2;
constexpr int kMaxRounds = 64;   ///< two or three are usual
constexpr int kWideRounds = 32;  ///< after these the snap distance falls, so that rounds end
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

/// Returns whether a piece passes within `distance` of a lattice point between its ends and must be
/// split there. Both parts are then shorter than the piece, so splitting ends.
bool snaps_to(const Piece& piece, LatticePoint p, std::int64_t distance) {
  const LatticePoint a = piece.from, b = piece.to;
  const std::int64_t square = distance_squared(a, b);
  const std::int64_t along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
  if (!(along > 0 && along < square)) return false;
  if (distance_squared(a, p) >= square || distance_squared(p, b) >= square) return false;
  const auto off = static_cast<double>(orient2d(a, b, p));
  return off * off <= static_cast<double>(distance * distance) * static_cast<double>(square);
}

/// Returns the intersection of two pieces, rounded to the lattice; none if they do not cross, or
/// cross only in an end.
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

/// The coordinate along a sweep; `across` is the other one.
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

/// A vertex and its cell of a square grid, ordered by rows of cells.
struct CellVertex {
  std::int64_t row = 0;
  std::int64_t column = 0;
  LatticePoint point;

  auto operator<=>(const CellVertex&) const = default;
};

CellVertex in_cell(LatticePoint p, std::int64_t width) {
  return {p.y / width, p.x / width, p};
}

/// Returns the first of sorted vertices within the distance of `v`, in its cell or one beside it.
/// Cells are as wide as the distance.
std::optional<LatticePoint> near_vertex(std::span<const CellVertex> sorted, const CellVertex& v,
                                        std::int64_t distance) {
  for (std::int64_t row = v.row - 1; row <= v.row; ++row) {
    auto at = std::ranges::lower_bound(sorted, CellVertex{row, v.column - 1, {}});
    for (; at != sorted.end() && at->row == row && at->column <= v.column + 1; ++at) {
      if (distance_squared(at->point, v.point) <= distance * distance) return at->point;
    }
  }
  return std::nullopt;
}

/// Winding numbers of the two sets of contours.
struct Windings {
  int first = 0;
  int second = 0;

  friend Windings operator+(Windings a, Windings b) {
    return {a.first + b.first, a.second + b.second};
  }
  friend Windings operator-(Windings a, Windings b) {
    return {a.first - b.first, a.second - b.second};
  }
  bool operator==(const Windings&) const = default;
};

bool is_filled(int winding, bool even_odd) {
  return even_odd ? winding % 2 != 0 : winding != 0;
}

bool is_inside(Windings at, const RegionRule& rule) {
  const bool first = is_filled(at.first, rule.even_odd);
  const bool second = is_filled(at.second, rule.second_even_odd);
  switch (rule.operation) {
    case RegionOperation::unite:
      return first || second;
    case RegionOperation::intersect:
      return first && second;
    case RegionOperation::subtract:
      return first && !second;
    case RegionOperation::exclude:
      break;
  }
  return first != second;
}

/// An edge of the arrangement, stored downwards; a horizontal edge is stored from left to right.
struct Edge {
  LatticePoint upper;
  LatticePoint lower;
  Windings net;  ///< pieces that run from upper to lower, minus pieces that run back
  std::size_t first_piece = 0;
  std::size_t piece_end = 0;
  std::optional<Windings> right_winding{};
};

LatticePoint far_end(const Edge& edge, LatticePoint vertex) {
  return edge.upper == vertex ? edge.lower : edge.upper;
}

class Arrangement {
 public:
  Arrangement(Context& context, const RegionRule& rule, Vertices vertices)
      : context_(context), rule_(rule), vertices_(vertices) {}

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
  Status weld_vertices();
  Status move_vertices(const std::vector<std::pair<LatticePoint, LatticePoint>>& moved);
  bool snaps_to(const Piece& piece, LatticePoint p) const {
    return svg_import::snaps_to(piece, p, snap_distance_);
  }
  Windings winding_by_ray(const Edge& edge) const;
  void take_star(LatticePoint vertex);
  void propagate_winding(LatticePoint vertex, std::size_t known);
  Windings winding_of(const Piece& piece) const {
    return piece.source.contour < rule_.second ? Windings{1, 0} : Windings{0, 1};
  }

  Context& context_;
  TableMemory memory_{kArrangementPurpose};
  RegionRule rule_;
  Vertices vertices_;
  std::int64_t snap_distance_ = kSnapDistance;
  Vec2 origin_;  ///< of the lattice
  double step_ = 1;
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
  SFUMATO_TRY(memory_.reserve(context_, pieces_, chords.size()));
  step_ = std::max(step, std::max(box.width(), box.height()) / kLatticeSize);
  origin_ = box.min;
  sweep_ = box.width() >= box.height() ? Sweep::along_x : Sweep::along_y;
  const auto rounded = [&](Vec2 p) {
    const Vec2 at = (p - origin_) / step_;
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
  std::vector<std::uint32_t> order;
  std::vector<Extent> extent;
  SFUMATO_TRY(working.resize(context_, order, pieces_.size()));
  SFUMATO_TRY(working.reserve(context_, extent, pieces_.size()));
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::pair(lowest(pieces_[i], sweep_), i); };
  SFUMATO_TRY(TableMemory::sort(context_, order, [&](auto a, auto b) { return key(a) < key(b); }));
  for (const Piece& piece : pieces_) {
    extent.push_back(
        {lowest(piece, across(sweep_)) - kSnapDistance, highest(piece, across(sweep_))});
  }
  const auto compare = [&](const Piece& a, const Piece& b) {
    const auto point = intersection_of(a, b);
    meet = meet || point || snaps_to(a, b.from) || snaps_to(a, b.to) || snaps_to(b, a.from) ||
           snaps_to(b, a.to);
    return point;
  };
  ActivePieces active(extent);
  for (const std::uint32_t i : order) {
    if (context_.cancelled()) return context_.cancel_status();
    const std::int64_t begin = lowest(pieces_[i], sweep_) - kSnapDistance;
    for (std::size_t band = active.band_of(extent[i].low); band <= active.band_of(extent[i].high);
         ++band) {
      std::vector<std::uint32_t>& beside = active[band];
      std::erase_if(beside, [&](std::uint32_t k) { return highest(pieces_[k], sweep_) < begin; });
      SFUMATO_TRY(check_counts(beside.size(), intersections.size()));
      for (const std::uint32_t k : beside) {
        if (extent[i].low > extent[k].high || extent[k].low > extent[i].high) continue;
        const bool is_first = band == active.band_of(std::max(extent[i].low, extent[k].low));
        const auto point = is_first ? compare(pieces_[i], pieces_[k]) : std::nullopt;
        if (point) SFUMATO_TRY(memory.push_back(context_, intersections, *point));
      }
      SFUMATO_TRY(working.push_back(context_, beside, i));
    }
  }
  return ok_status();
}

Status Arrangement::check_counts(std::size_t pairs, std::size_t found) {
  pairs_ += pairs;
  const double share = vertices_ == Vertices::keep ? kKeptPairs : 1;
  const auto most = static_cast<double>(context_.limits.chord_pairs);
  if (static_cast<double>(pairs_) > share * most) return has_too_many_pairs(context_);
  return pieces_.size() + found > context_.limits.chords ? has_too_many_crossings(context_)
                                                         : ok_status();
}

/// Finds for every piece the points that it snaps to: ends of pieces, and `points`.
Status Arrangement::find_snaps(TableMemory& memory, std::vector<LatticePoint>& points,
                               std::vector<Snap>& snaps) {
  SFUMATO_TRY(memory.reserve(context_, points, points.size() + 2 * pieces_.size()));
  for (const Piece& piece : pieces_) {
    points.push_back(piece.from);
    points.push_back(piece.to);
  }
  const auto key = [&](LatticePoint p) { return std::pair(coordinate(p, sweep_), p); };
  SFUMATO_TRY(TableMemory::sort(context_, points, [&](auto a, auto b) { return key(a) < key(b); }));
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
    SFUMATO_TRY(check_counts(size, snaps.size()));
    for (const LatticePoint point : std::span(low, high)) {
      if (snaps_to(pieces_[i], point)) SFUMATO_TRY(memory.push_back(context_, snaps, {i, point}));
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
  SFUMATO_TRY(TableMemory::sort(context_, snaps,
                                [&](const Snap& a, const Snap& b) { return place(a) < place(b); }));
  std::vector<Piece> result;
  SFUMATO_TRY(memory_.reserve(context_, result, pieces_.size() + snaps.size()));
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

/// Moves each vertex to an earlier vertex within the snap distance, if there is one. Vertices are
/// ordered by cells that are as wide as that distance.
Status Arrangement::weld_vertices() {
  TableMemory working(kArrangementPurpose);
  std::vector<CellVertex> vertex, kept;
  std::vector<std::pair<LatticePoint, LatticePoint>> moved;
  SFUMATO_TRY(working.reserve(context_, vertex, 2 * pieces_.size()));
  for (const Piece& piece : pieces_) {
    vertex.push_back(in_cell(piece.from, snap_distance_));
    vertex.push_back(in_cell(piece.to, snap_distance_));
  }
  SFUMATO_TRY(TableMemory::sort(context_, vertex, std::less<>()));
  const auto repeated = std::ranges::unique(vertex);
  vertex.erase(repeated.begin(), repeated.end());
  SFUMATO_TRY(working.reserve(context_, kept, vertex.size()));
  RarePoll<1024> poll(context_);
  for (const CellVertex& v : vertex) {
    if (poll.cancelled()) return context_.cancel_status();
    const std::optional<LatticePoint> near = near_vertex(kept, v, snap_distance_);
    if (!near) kept.push_back(v);
    if (near) SFUMATO_TRY(working.push_back(context_, moved, {v.point, *near}));
  }
  if (moved.empty()) return ok_status();
  Status status = TableMemory::sort(context_, moved, std::less<>());
  return status ? move_vertices(moved) : status;
}

/// Moves ends of pieces, and leaves out pieces whose ends become one. The next piece of the contour
/// runs from where such a piece began.
Status Arrangement::move_vertices(const std::vector<std::pair<LatticePoint, LatticePoint>>& moved) {
  const auto place_of = [&](LatticePoint p) {
    const auto entry =
        std::ranges::lower_bound(moved, p, {}, [](const auto& move) { return move.first; });
    return entry != moved.end() && entry->first == p ? entry->second : p;
  };
  RarePoll<1024> poll(context_);
  std::size_t count = 0;
  const Piece* left_out = nullptr;
  Piece last_out;
  for (const Piece& piece : pieces_) {
    if (poll.cancelled()) return context_.cancel_status();
    Piece to{place_of(piece.from), place_of(piece.to), piece.source, piece.since};
    const bool goes_on = left_out && left_out->source.contour == to.source.contour &&
                         left_out->source.end == to.source.begin;
    if (goes_on) to.since = left_out->since;
    left_out = nullptr;
    if (to.from == to.to) {
      last_out = to;
      left_out = &last_out;
    } else {
      pieces_[count++] = to;
    }
  }
  pieces_.resize(count);
  return ok_status();
}

/// Snap rounding (Hobby 1999) with a wider reach: contours nearer to each other than the tolerance
/// become one there, since the area between them shows nothing but would need colours. Iterated
/// until no piece snaps to a point (Halperin and Packer 2002).
Status Arrangement::snap_round() {
  for (int round = 0; round < kMaxRounds; ++round) {
    if (round >= kWideRounds && round % 4 == 0) snap_distance_ = (snap_distance_ + 1) / 2;
    if (vertices_ == Vertices::weld) {
      SFUMATO_TRY(weld_vertices());
    }
    TableMemory memory(kArrangementPurpose);
    std::vector<LatticePoint> points;
    bool meet = false;
    SFUMATO_TRY(find_intersections(memory, points, meet));
    if (!meet) return ok_status();
    std::vector<Snap> snaps;
    SFUMATO_TRY(find_snaps(memory, points, snaps));
    memory.free(points);
    if (snaps.empty()) return ok_status();  // they cross in their ends, apart from rounding
    SFUMATO_TRY(split_pieces(snaps));
  }
  return make_error(StatusCode::bad_input,
                    "crossings of the shape lie too close together; simplify the shape there");
}

/// Joins the pieces between the same two points into one edge, or none if they cancel each other.
Status Arrangement::merge_coincident() {
  const auto ends = [](const Piece& piece) { return std::minmax(piece.from, piece.to); };
  const auto place = [&](const Piece& piece) {
    const auto [upper, lower] = ends(piece);
    return std::tuple(LatticePoint(upper), LatticePoint(lower), piece.source.contour,
                      piece.source.begin);
  };
  SFUMATO_TRY(TableMemory::sort(
      context_, pieces_, [&](const Piece& a, const Piece& b) { return place(a) < place(b); }));
  RarePoll<1024> poll(context_);
  for (std::size_t i = 0; i < pieces_.size();) {
    if (poll.cancelled()) return context_.cancel_status();
    const LatticePoint upper = ends(pieces_[i]).first, lower = ends(pieces_[i]).second;
    Edge edge{upper, lower, {}, i, i};
    for (; i < pieces_.size() && ends(pieces_[i]) == std::minmax(upper, lower); ++i) {
      const Windings one = winding_of(pieces_[i]);
      edge.net = pieces_[i].from == upper ? edge.net + one : edge.net - one;
    }
    edge.piece_end = i;
    if (edge.net != Windings{}) SFUMATO_TRY(memory_.push_back(context_, edges_, edge));
  }
  SFUMATO_TRY(memory_.reserve(context_, edge_at_, 2 * edges_.size()));
  SFUMATO_TRY(memory_.resize(context_, is_taken_, 2 * edges_.size()));
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    edge_at_.emplace_back(edges_[i].upper, i);
    edge_at_.emplace_back(edges_[i].lower, i);
  }
  return TableMemory::sort(context_, edge_at_, std::less<>());
}

/// Returns the winding number on the edge's right. A ray runs to the right from the edge's middle,
/// a little lower: it crosses what passes that height, and not the edge.
Windings Arrangement::winding_by_ray(const Edge& edge) const {
  const LatticePoint twice{edge.upper.y + edge.lower.y, edge.upper.x + edge.lower.x};
  Windings number;
  for (const Edge& other : edges_) {
    if (&other == &edge || !(2 * other.upper.y <= twice.y && 2 * other.lower.y > twice.y)) continue;
    const std::int64_t side = (other.lower.x - other.upper.x) * (twice.y - 2 * other.upper.y) -
                              (other.lower.y - other.upper.y) * (twice.x - 2 * other.upper.x);
    if (side > 0) number = number + other.net;
  }
  return edge.upper.y == edge.lower.y ? number : number + edge.net;
}

/// Sets star_ to the star of a vertex, clockwise on the screen; empty if it was requested before.
void Arrangement::take_star(LatticePoint vertex) {
  const auto of_vertex = [](const auto& entry) { return entry.first; };
  const auto entries = std::ranges::equal_range(edge_at_, vertex, {}, of_vertex);
  const auto first = static_cast<std::size_t>(entries.begin() - edge_at_.begin());
  star_.clear();
  if (is_taken_[first]) return;
  is_taken_[first] = 1;
  for (const auto& [at, edge] : entries) star_.push_back(edge);
  // Edges that lead down from the vertex come first; stored edges do so from their upper end.
  std::ranges::sort(star_, [&](std::size_t a, std::size_t b) {
    const bool a_leads_on = edges_[a].upper == vertex, b_leads_on = edges_[b].upper == vertex;
    if (a_leads_on != b_leads_on) return a_leads_on;
    return orient2d(vertex, far_end(edges_[a], vertex), far_end(edges_[b], vertex)) > 0;
  });
}

/// Carries winding numbers round a vertex from an edge with a known number, once to each edge.
void Arrangement::propagate_winding(LatticePoint vertex, std::size_t known) {
  take_star(vertex);
  if (star_.empty()) return;
  const auto first = static_cast<std::size_t>(std::ranges::find(star_, known) - star_.begin());
  const Edge& begin = edges_[known];
  Windings winding = *begin.right_winding;
  if (begin.upper != vertex) winding = winding - begin.net;
  for (std::size_t i = 1; i < star_.size(); ++i) {
    const std::size_t index = star_[(first + i) % star_.size()];
    Edge& edge = edges_[index];
    const bool leads_on = edge.upper == vertex;
    const Windings beyond = leads_on ? winding + edge.net : winding - edge.net;
    if (!edge.right_winding) {
      edge.right_winding = leads_on ? beyond : winding;
      reached_.push_back(index);
    }
    winding = beyond;
  }
}

/// A winding number is counted once for all connected edges, and carried on round their vertices.
Status Arrangement::find_windings() {
  // An edge is reached at most once, and at most once in a star.
  SFUMATO_TRY(memory_.reserve(context_, reached_, edges_.size()));
  SFUMATO_TRY(memory_.reserve(context_, star_, edges_.size()));
  std::uint64_t ray_edges = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].right_winding) continue;
    if (context_.cancelled()) return context_.cancel_status();
    if ((ray_edges += edges_.size()) > kRayEdgesFactor * context_.limits.chord_pairs) {
      return has_too_many_pairs(context_);
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
  result.origin = origin_;
  result.step = step_;
  SFUMATO_TRY(result.memory.reserve(context_, result.edge, edges_.size()));
  SFUMATO_TRY(result.memory.reserve(context_, result.source, pieces_.size()));
  RarePoll<1024> poll(context_);
  for (const Edge& edge : edges_) {
    if (poll.cancelled()) return context_.cancel_status();
    const bool right = is_inside(*edge.right_winding, rule_);
    const bool left = is_inside(*edge.right_winding - edge.net, rule_);
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
                                     const RegionRule& rule, double step, Vertices vertices) {
  Arrangement arrangement(context, rule, vertices);
  SFUMATO_TRY(arrangement.round_to_lattice(chords, step));
  SFUMATO_TRY(arrangement.snap_round());
  SFUMATO_TRY(arrangement.merge_coincident());
  SFUMATO_TRY(arrangement.find_windings());
  return arrangement.boundary();
}

}  // namespace sfumato::svg_import
