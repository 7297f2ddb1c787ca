#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "gather/free_ends.hpp"
#include "gather/scene.hpp"

namespace sfumato::gather {
namespace {

using mesh::TriangleMesh;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNobody = 0xffffffff;

/// An end's own curve stands in its way where it has turned back: where it is longer than this many
/// times the straight way.
constexpr double kTurnedBack = 1.2;

/// The own curve is looked at in so many places within a reach, at even distances from the end…
constexpr int kPlaces = 16;
/// …and may lie so much beside the arc that stands for it there, over its distance.
constexpr double kBesideArc = 0.15;

/// Triangles that are looked at for the reach of one end: hostile meshes have all in each reach.
constexpr int kMostTriangles = 1024;

/// From the origin to the segment from a to b, or to its part between two fractions.
double segment_distance(Vec2 a, Vec2 b, double from = 0, double to = 1) {
  const Vec2 along = b - a;
  return length(a + std::clamp(-dot(a, along) / length_squared(along), from, to) * along);
}

/// From the end, the origin, to what has turned back of its own curve's edge from a to b; `arc` is
/// the curve's length from the end to a. (arc + u l)² > 1.44 |a + u (b - a)|² between two roots.
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

/// Which part of the way from a along a vector leaves the circle round the origin.
double crossing(Vec2 a, Vec2 along, double radius) {
  const double l_squared = length_squared(along), ahead = dot(a, along);
  const double inside = radius * radius - length_squared(a);
  return (std::sqrt(std::max(0.0, ahead * ahead + l_squared * inside)) - ahead) / l_squared;
}

class EndSearch {
 public:
  EndSearch(Context& context, const TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
            const KnownEnds& known, TableMemory& ends_memory)
      : context_(context),
        poll_(context),
        mesh_(mesh),
        attributes_(attributes),
        known_(known),
        ends_memory_(ends_memory) {}

  Result<std::vector<FreeEnd>> run() {
    Status status = memory_.resize(context_, meeting_, mesh_.vertex_position.size());
    if (status) status = memory_.resize(context_, edge_, mesh_.constraint.size());
    if (status) status = memory_.resize(context_, seen_from_, mesh_.triangle_count(), kNobody);
    if (status) status = find_edges();
    if (status && !known_.end.empty()) status = find_known_ends();
    std::vector<FreeEnd> ends;
    for (std::uint32_t v = 0; status && v < meeting_.size(); ++v) {
      if (poll_.cancelled()) return context_.cancel_status();
      if (meeting_[v].edges == 1) status = add_end(v, ends);
    }
    if (status) status = context_.check();
    if (!status) return status;
    return ends;
  }

 private:
  /// The edges with curves that meet at a vertex.
  struct Meeting {
    std::uint32_t edges = 0;
    std::uint32_t all = 0;  ///< their constraints, by exclusive or: of two, the other one
  };

  /// An edge with curves, as the end sees it whose curve was followed last.
  struct Edge {
    std::uint32_t half_edge = kNobody;
    std::uint32_t end = kNobody;
    bool origin_is_near = false;
    double arc = 0;  ///< the curve's length from the end to the nearer vertex
  };

  Vec2 position(std::uint32_t v) const { return mesh_.vertex_position[v]; }

  /// The known ends that no watched edge has come near.
  Status find_known_ends() {
    std::vector<std::uint32_t> watched;
    Status status = memory_.resize(context_, known_end_, meeting_.size(), nullptr);
    for (std::size_t c = 0; c < edge_.size() && status; ++c) {
      const std::uint32_t h = edge_[c].half_edge;
      if (h == kNobody || !mesh_.has_segment(h, known_.is_watched)) continue;
      status = memory_.push_back(context_, watched, h);
    }
    if (!status || watched.size() > kMostTriangles) return status;  // a search takes less
    for (const FreeEnd& end : known_.end) {
      const Vec2 p = position(end.vertex);
      bool is_near = false;
      for (std::size_t i = 0; i < watched.size() && !is_near; ++i) {
        if (poll_.cancelled()) return context_.cancel_status();
        is_near = segment_distance(position(mesh_.origin(watched[i])) - p,
                                   position(mesh_.target(watched[i])) - p) <= end.free_way;
      }
      if (!is_near) known_end_[end.vertex] = &end;
    }
    return context_.check();
  }

  Status find_edges() {
    for (std::uint32_t h = 0; h < mesh_.triangle_vertex.size(); ++h) {
      if (poll_.cancelled()) return context_.cancel_status();
      const auto c = static_cast<std::uint32_t>(mesh_.half_edge_constraint[h]);
      if (!mesh_.has_curves(h) || edge_[c].half_edge != kNobody) continue;
      edge_[c].half_edge = h;
      for (std::uint32_t v : {mesh_.origin(h), mesh_.target(h)}) {
        ++meeting_[v].edges;
        meeting_[v].all ^= c;
      }
    }
    return context_.check();
  }

  Status add_end(std::uint32_t v, std::vector<FreeEnd>& ends) {
    const std::uint32_t h = edge_[meeting_[v].all].half_edge;
    const std::int32_t twin = mesh_.half_edge_twin[h];
    if (twin == mesh::kNone) return ok_status();
    const bool leaves = mesh_.origin(h) == v;
    const auto out = leaves ? h : static_cast<std::uint32_t>(twin);
    const auto in = leaves ? static_cast<std::uint32_t>(twin) : h;
    const Facing negative = facing_side(mesh_, attributes_, out);
    const Facing positive = facing_side(mesh_, attributes_, in);
    if (negative.kind != ShaderKind::curve_domain || positive.kind != ShaderKind::curve_domain ||
        negative.from == positive.to) {
      return ok_status();
    }
    const Vec2 last = position(v) - position(mesh_.target(out));
    FreeEnd end{.position = position(v),
                .direction = last / length(last),
                .vertex = v,
                .weight = negative.weight,
                .positive = positive.to,
                .negative = negative.from,
                .blur_positive = positive.blur_to,
                .blur_negative = negative.blur_from};
    const Status status = find_term(out, end);
    if (!status || end.reach < mesh_.lattice_step) return status;
    return ends_memory_.push_back(context_, ends, end);
  }

  /// How far the end reaches, and along which arc. `out` is the half-edge that begins there.
  Status find_term(std::uint32_t out, FreeEnd& end) {
    if (const FreeEnd* known = known_end_.empty() ? nullptr : known_end_[end.vertex]) {
      end.bend = known->bend;
      end.reach = known->reach;
      end.free_way = known->free_way;
      return ok_status();
    }
    const Result<double> arc = follow_curve(end.vertex);
    if (!arc) return arc.status();
    const Result<double> reach = find_reach(end.vertex, out, *arc);
    if (!reach) return reach.status();
    end.reach = end.free_way = *reach;
    end.nearest = nearest_;
    return bend(end.vertex, end);
  }

  /// Finds the arc that follows the own curve, by where the curve is half the reach away; where it
  /// does not follow it far enough, the reach is made less.
  Status bend(std::uint32_t v, FreeEnd& end) {
    const Result<std::vector<Vec2>> own = own_places(v, end.reach);
    if (!own) return own.status();
    const std::vector<Vec2>& places = *own;
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
    end.nearest = static_cast<std::int32_t>(meeting_[v].all);
    return ok_status();
  }

  /// Where the own curve is first 1/16, 2/16… of the reach away from the end, relative to it.
  Result<std::vector<Vec2>> own_places(std::uint32_t v, double reach) {
    std::vector<Vec2> places;
    std::uint32_t at = v;
    for (std::uint32_t c = meeting_[v].all; places.size() < kPlaces;) {
      if (poll_.cancelled()) return context_.cancel_status();
      const Edge& edge = edge_[c];
      const Vec2 a = position(at) - position(v);
      at = edge.origin_is_near ? mesh_.target(edge.half_edge) : mesh_.origin(edge.half_edge);
      const Vec2 along = position(at) - position(v) - a;
      while (places.size() < kPlaces) {
        const double distance = reach * static_cast<double>(places.size() + 1) / kPlaces;
        const double share = crossing(a, along, distance);
        if (!(share <= 1)) break;
        places.push_back(a + share * along);
      }
      if (meeting_[at].edges != 2) break;
      c ^= meeting_[at].all;
    }
    return places;
  }

  /// Marks the curve's edges up to a junction or its other end, and gives its length.
  Result<double> follow_curve(std::uint32_t v) {
    double arc = 0;
    std::uint32_t at = v;
    for (std::uint32_t c = meeting_[v].all;;) {
      if (poll_.cancelled()) return context_.cancel_status();
      Edge& edge = edge_[c];
      edge.end = v;
      edge.origin_is_near = mesh_.origin(edge.half_edge) == at;
      edge.arc = arc;
      const std::uint32_t next =
          edge.origin_is_near ? mesh_.target(edge.half_edge) : mesh_.origin(edge.half_edge);
      arc += length(position(next) - position(at));
      at = next;
      if (meeting_[at].edges != 2) break;
      c ^= meeting_[at].all;
    }
    return arc;
  }

  /// ρ: triangles are visited from the end outwards, nearest first, until the nearest that is left
  /// is farther than what was found. Sets nearest_.
  Result<double> find_reach(std::uint32_t v, std::uint32_t half_edge, double reach) {
    const auto farther = [](const Step& a, const Step& b) { return a.distance > b.distance; };
    step_.assign(1, {0, half_edge / 3});
    nearest_ = mesh::kNone;
    for (int visited = 0; !step_.empty();) {
      if (poll_.cancelled()) return context_.cancel_status();
      std::pop_heap(step_.begin(), step_.end(), farther);
      const Step step = step_.back();
      step_.pop_back();
      if (!(step.distance < reach)) break;
      if (seen_from_[step.triangle] == v) continue;
      seen_from_[step.triangle] = v;
      if (++visited > kMostTriangles) {
        nearest_ = mesh_.half_edge_constraint[half_edge];
        return step.distance;
      }
      for (std::uint32_t h = 3 * step.triangle; h < 3 * step.triangle + 3; ++h) {
        if (mesh_.has_curves(h)) shorten(reach, v, h);
        const std::int32_t twin = mesh_.half_edge_twin[h];
        if (twin == mesh::kNone || seen_from_[static_cast<std::size_t>(twin) / 3] == v) continue;
        const double distance = segment_distance(position(mesh_.origin(h)) - position(v),
                                                 position(mesh_.target(h)) - position(v));
        if (!(distance < reach)) continue;
        step_.push_back({distance, static_cast<std::uint32_t>(twin) / 3});
        std::push_heap(step_.begin(), step_.end(), farther);
      }
    }
    return reach;
  }

  void shorten(double& reach, std::uint32_t v, std::uint32_t h) {
    const double distance = curve_distance(v, h);
    if (!(distance < reach)) return;
    reach = distance;
    nearest_ = mesh_.half_edge_constraint[h];
  }

  double curve_distance(std::uint32_t v, std::uint32_t h) const {
    const Edge& edge = edge_[static_cast<std::size_t>(mesh_.half_edge_constraint[h])];
    const Vec2 a = position(mesh_.origin(edge.half_edge)) - position(v);
    const Vec2 b = position(mesh_.target(edge.half_edge)) - position(v);
    if (edge.end != v) return segment_distance(a, b);
    return edge.origin_is_near ? turned_back_distance(a, b, edge.arc)
                               : turned_back_distance(b, a, edge.arc);
  }

  struct Step {
    double distance;  ///< from the end to the edge that leads into the triangle
    std::uint32_t triangle;
  };

  Context& context_;
  RarePoll<4096> poll_;
  const TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  const KnownEnds& known_;
  TableMemory& ends_memory_;
  TableMemory memory_{"free ends of curves"};
  std::vector<Meeting> meeting_;           ///< per vertex
  std::vector<Edge> edge_;                 ///< per constraint
  std::vector<std::uint32_t> seen_from_;   ///< per triangle: the end that looked at it last
  std::vector<Step> step_;                 ///< a heap
  std::vector<const FreeEnd*> known_end_;  ///< per vertex: one that keeps its term; null: none
  std::int32_t nearest_ = mesh::kNone;     ///< the constraint that limits the reach asked for last
};

}  // namespace

Result<std::vector<FreeEnd>> find_free_ends(Context& context, const TriangleMesh& mesh,
                                            const curves::SegmentAttributes& attributes,
                                            TableMemory& memory, const KnownEnds& known) {
  return EndSearch(context, mesh, attributes, known, memory).run();
}

}  // namespace sfumato::gather
