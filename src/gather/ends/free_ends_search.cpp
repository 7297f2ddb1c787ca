#include "gather/ends/free_ends_search.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "base/half_edge.hpp"
#include "base/try.hpp"
#include "gather/scene/scene.hpp"

namespace sfumato::gather {
namespace {

using mesh::TriangleMesh;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// An end's own curve blocks its way where it has turned back: where it is longer than this many
/// times the straight way.
constexpr double kTurnedBack = 1.2;

/// The own curve is sampled at this many places within a reach, at even distances from the end…
constexpr int kPlaces = 16;
/// …and may deviate by this much from the arc that represents it there, relative to its distance.
constexpr double kBesideArc = 0.15;

/// The number at which places are counted again from 0.
constexpr std::uint32_t kMostMarks = 1u << 31;

/// Returns the distance from the end, the origin, to the part of its own curve's edge from a to b
/// that has turned back; `arc` is the curve's length from the end to a. (arc + u l)² > 1.44 |a + u
/// (b - a)|² between two roots.
double turned_back_distance(Vec2 a, Vec2 b, double arc) {
  constexpr double q = kTurnedBack * kTurnedBack;
  const Vec2 along = b - a;
  const double l_squared = length_squared(along);
  const double bend = (q - 1) * l_squared;
  const double half_slope = arc * std::sqrt(l_squared) - q * dot(a, along);
  const double start = arc * arc - q * length_squared(a);
  const double root = half_slope * half_slope + bend * start;
  if (!(root > 0)) return kInfinity;
  const double from = std::max((half_slope - std::sqrt(root)) / bend, 0.0);
  const double to = std::min((half_slope + std::sqrt(root)) / bend, 1.0);
  return from <= to ? segment_distance(a, b, from, to) : kInfinity;
}

/// Returns the part of the way from a along a vector at which it leaves the circle round the
/// origin.
double crossing(Vec2 a, Vec2 along, double radius) {
  const double l_squared = length_squared(along), ahead = dot(a, along);
  const double inside = radius * radius - length_squared(a);
  return (std::sqrt(std::max(0.0, ahead * ahead + l_squared * inside)) - ahead) / l_squared;
}

}  // namespace

Status EndSearch::size_tables() {
  const std::size_t half_edges = mesh_.triangle_vertex.size();
  SFUMATO_TRY(tables_.memory.grow(context_, tables_.mark, half_edges, half_edges / 4 * 5));
  SFUMATO_TRY(tables_.memory.grow(context_, tables_.seen, half_edges / 3, half_edges / 12 * 5));
  if (tables_.marks > kMostMarks || tables_.searches > kMostMarks) {
    std::ranges::fill(tables_.mark, 0u);
    std::ranges::fill(tables_.seen, 0u);
    tables_.marks = tables_.searches = 0;
  }
  return ok_status();
}

Status EndSearch::find_meetings() {
  SFUMATO_TRY(size_tables());
  const std::size_t vertices = mesh_.vertex_position.size();
  SFUMATO_TRY(tables_.memory.resize(context_, tables_.meeting, vertices));
  for (std::uint32_t h = 0; h < mesh_.triangle_vertex.size(); ++h) {
    if (poll_.cancelled()) return context_.cancel_status();
    if (!mesh_.has_curves(h) || name(h) != h) continue;
    for (const std::uint32_t v : {mesh_.origin(h), mesh_.target(h)}) {
      ++tables_.meeting[v].edges;
      tables_.meeting[v].all ^= h;
    }
  }
  return context_.check();
}

Status EndSearch::update_meetings(std::span<const std::uint8_t> is_same) {
  SFUMATO_TRY(size_tables());
  const std::size_t vertices = mesh_.vertex_position.size();
  SFUMATO_TRY(tables_.memory.grow(context_, tables_.meeting, vertices, vertices / 4 * 5));
  std::vector<std::uint64_t> spokes;  // the vertex, then a half-edge that begins there
  for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
    if (t < is_same.size() && is_same[t]) continue;
    SFUMATO_TRY(memory_.make_room(context_, spokes, 3));
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
      spokes.push_back(std::uint64_t{mesh_.origin(h)} << 32 | h);
  }
  SFUMATO_TRY(TableMemory::sort(context_, spokes, std::less<>()));
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    if (poll_.cancelled()) return context_.cancel_status();
    const bool is_known = i > 0 && spokes[i] >> 32 == spokes[i - 1] >> 32;
    if (!is_known) meet_around(static_cast<std::uint32_t>(spokes[i]));
  }
  memory_.free(spokes);
  return ok_status();
}

/// Visits the edges that meet at the origin of a half-edge.
void EndSearch::meet_around(std::uint32_t half_edge) {
  EndTables::Meeting meeting;
  const auto meet = [&](std::uint32_t h) {
    if (!mesh_.has_curves(h)) return;
    ++meeting.edges;
    meeting.all ^= name(h);
  };
  std::uint32_t spoke = half_edge;
  do {
    meet(spoke);
    const std::uint32_t back = previous_half_edge(spoke);
    if (mesh_.half_edge_twin[back] == mesh::kNone) {
      // The hull: the other way round from the start.
      meet(back);
      std::int32_t twin = mesh_.half_edge_twin[half_edge];
      while (twin != mesh::kNone) {
        spoke = next_half_edge(static_cast<std::uint32_t>(twin));
        meet(spoke);
        twin = mesh_.half_edge_twin[spoke];
      }
      break;
    }
    spoke = static_cast<std::uint32_t>(mesh_.half_edge_twin[back]);
  } while (spoke != half_edge);
  tables_.meeting[mesh_.origin(half_edge)] = meeting;
}

Status EndSearch::add_end(std::uint32_t vertex, TableMemory& memory, std::vector<FreeEnd>& ends) {
  const std::uint32_t h = tables_.meeting[vertex].all;
  const std::int32_t twin = mesh_.half_edge_twin[h];
  if (twin == mesh::kNone) return ok_status();
  const bool leaves = mesh_.origin(h) == vertex;
  const auto out = leaves ? h : static_cast<std::uint32_t>(twin);
  const auto in = leaves ? static_cast<std::uint32_t>(twin) : h;
  const Facing negative = facing_side(mesh_, attributes_, out);
  const Facing positive = facing_side(mesh_, attributes_, in);
  if (negative.kind != ShaderKind::curve_domain || positive.kind != ShaderKind::curve_domain ||
      (negative.from == positive.to && !differs_beside(out, in))) {
    return ok_status();
  }
  const Vec2 last = position(vertex) - position(mesh_.target(out));
  FreeEnd end{.position = position(vertex),
              .direction = last / length(last),
              .vertex = vertex,
              .weight = negative.weight,
              .positive = positive.to,
              .negative = negative.from,
              .blur_positive = positive.blur_to,
              .blur_negative = negative.blur_from};
  const Status status = find_term(out, end);
  if (!status || end.reach < mesh_.lattice_step) return status;
  return memory.push_back(context_, ends, end);
}

bool EndSearch::differs_beside(std::uint32_t out, std::uint32_t in) const {
  return beside_ &&
         !(facing_side(mesh_, *beside_, out).from == facing_side(mesh_, *beside_, in).to);
}

/// Finds how far the end reaches, and along which arc. `out` is the half-edge that begins there.
Status EndSearch::find_term(std::uint32_t out, FreeEnd& end) {
  SFUMATO_TRY_ASSIGN(const double arc, follow_curve(end.vertex));
  SFUMATO_TRY_ASSIGN(const double reach, find_reach(end.vertex, out, arc));
  end.reach = end.free_way = reach;
  end.nearest = nearest_;
  return bend(end);
}

/// Finds the arc that follows the own curve, by the place where the curve is half the reach away;
/// where it does not follow the curve far enough, the reach is reduced.
Status EndSearch::bend(FreeEnd& end) {
  SFUMATO_TRY_ASSIGN(const std::vector<Vec2>& own, own_places(end.vertex, end.reach));
  const std::vector<Vec2>& places = own;
  std::size_t count = places.size();
  for (; count > 0; --count) {
    const Vec2 middle = places[(count - 1) / 2];
    end.bend = cross(middle, end.direction) / length_squared(middle);
    const auto lies_beside = [&](Vec2 q) {
      return std::fabs(cross(end.direction, end.unbent(q))) > kBesideArc * length(q);
    };
    if (std::none_of(places.begin(), places.begin() + std::ptrdiff_t(count), lies_beside)) break;
  }
  if (count == places.size()) return ok_status();
  end.reach *= static_cast<double>(count) / kPlaces;
  end.nearest = mesh_.half_edge_constraint[chain_.front().half_edge];
  return ok_status();
}

/// Returns the places where the own curve is first 1/16, 2/16… of the reach away from the end,
/// relative to it.
Result<std::vector<Vec2>> EndSearch::own_places(std::uint32_t v, double reach) {
  std::vector<Vec2> places;
  for (const Edge& edge : chain_) {
    if (poll_.cancelled()) return context_.cancel_status();
    const std::uint32_t h = edge.half_edge;
    const Vec2 near = position(edge.origin_is_near ? mesh_.origin(h) : mesh_.target(h));
    const Vec2 far = position(edge.origin_is_near ? mesh_.target(h) : mesh_.origin(h));
    const Vec2 a = near - position(v);
    const Vec2 along = far - position(v) - a;
    while (places.size() < kPlaces) {
      const double distance = reach * static_cast<double>(places.size() + 1) / kPlaces;
      const double share = crossing(a, along, distance);
      if (!(share <= 1)) break;
      places.push_back(a + share * along);
    }
    if (places.size() == kPlaces) break;
  }
  return places;
}

/// Lists the curve's edges up to a junction or its other end. Returns its length.
Result<double> EndSearch::follow_curve(std::uint32_t v) {
  memory_.free(chain_);
  chain_begin_ = tables_.marks + 1;
  double arc = 0;
  std::uint32_t at = v;
  for (std::uint32_t h = tables_.meeting[v].all;;) {
    if (poll_.cancelled()) return context_.cancel_status();
    const bool origin_is_near = mesh_.origin(h) == at;
    SFUMATO_TRY(memory_.push_back(context_, chain_, {h, origin_is_near, arc}));
    tables_.mark[h] = ++tables_.marks;
    const std::uint32_t next = origin_is_near ? mesh_.target(h) : mesh_.origin(h);
    arc += length(position(next) - position(at));
    at = next;
    if (tables_.meeting[at].edges != 2) break;
    h ^= tables_.meeting[at].all;
  }
  return arc;
}

/// Returns the data of an edge of the curve that was followed last; null: the edge belongs to
/// another curve.
const EndSearch::Edge* EndSearch::own_edge(std::uint32_t half_edge) const {
  const std::uint32_t place = tables_.mark[name(half_edge)] - chain_begin_;
  return place < chain_.size() ? &chain_[place] : nullptr;
}

/// Returns ρ: triangles are visited from the end outwards, nearest first, until the nearest
/// remaining one is farther than the nearest curve found. Sets nearest_.
Result<double> EndSearch::find_reach(std::uint32_t v, std::uint32_t half_edge, double reach) {
  const auto farther = [](const Step& a, const Step& b) { return a.distance > b.distance; };
  const std::uint32_t search = ++tables_.searches;
  step_.assign(1, {0, half_edge / 3});
  nearest_ = mesh::kNone;
  for (std::size_t visited = 0; !step_.empty();) {
    if (poll_.cancelled()) return context_.cancel_status();
    std::pop_heap(step_.begin(), step_.end(), farther);
    const Step step = step_.back();
    step_.pop_back();
    if (!(step.distance < reach)) break;
    if (std::exchange(tables_.seen[step.triangle], search) == search) continue;
    if (++visited > kMostTriangles) {
      nearest_ = mesh_.half_edge_constraint[half_edge];
      return step.distance;
    }
    for (std::uint32_t h = 3 * step.triangle; h < 3 * step.triangle + 3; ++h) {
      if (mesh_.has_curves(h)) shorten(reach, v, h);
      const std::int32_t twin = mesh_.half_edge_twin[h];
      if (twin == mesh::kNone || tables_.seen[static_cast<std::size_t>(twin) / 3] == search)
        continue;
      const double distance = segment_distance(position(mesh_.origin(h)) - position(v),
                                               position(mesh_.target(h)) - position(v));
      if (!(distance < reach)) continue;
      step_.push_back({distance, static_cast<std::uint32_t>(twin) / 3});
      std::push_heap(step_.begin(), step_.end(), farther);
    }
  }
  return reach;
}

void EndSearch::shorten(double& reach, std::uint32_t v, std::uint32_t h) {
  const double distance = curve_distance(v, h);
  if (!(distance < reach)) return;
  reach = distance;
  nearest_ = mesh_.half_edge_constraint[h];
}

double EndSearch::curve_distance(std::uint32_t v, std::uint32_t h) const {
  const std::uint32_t edge = name(h);
  const Vec2 a = position(mesh_.origin(edge)) - position(v);
  const Vec2 b = position(mesh_.target(edge)) - position(v);
  const Edge* const own = own_edge(edge);
  if (!own) return segment_distance(a, b);
  return own->origin_is_near ? turned_back_distance(a, b, own->arc)
                             : turned_back_distance(b, a, own->arc);
}

Result<std::vector<FreeEnd>> find_free_ends(Context& context, const TriangleMesh& mesh,
                                            const curves::SegmentAttributes& attributes,
                                            TableMemory& memory, EndTables* tables,
                                            const curves::SegmentAttributes* beside) {
  EndTables own;
  EndTables& known = tables ? *tables : own;
  EndSearch search(context, mesh, attributes, known, beside);
  SFUMATO_TRY(search.find_meetings());
  std::vector<FreeEnd> ends;
  RarePoll<4096> poll(context);
  for (std::uint32_t v = 0; v < known.meeting.size(); ++v) {
    if (poll.cancelled()) return context.cancel_status();
    if (search.may_end(v)) SFUMATO_TRY(search.add_end(v, memory, ends));
  }
  return ends;
}

}  // namespace sfumato::gather
