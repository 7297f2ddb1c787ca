#include "import/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <tuple>
#include <utility>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "curves/bezier.hpp"
#include "import/arrangement.hpp"
#include "import/chords.hpp"

namespace sfumato::svg_import {
namespace {

constexpr std::size_t kChords = 2'000'000;
constexpr const char* kBoundaryPurpose = "the boundary of a shape";
constexpr double kParallel = 1e-9;  ///< sine of an angle

using curves::Cubic;

/// By a straight line, for which there is room, or where hardly anything is missing, by moving the
/// end.
void close(std::vector<Vec2>& chain, double tolerance) {
  const Vec2 begin = chain.front(), end = chain.back();
  if (length(end - begin) <= tolerance) {
    chain.back() = begin;
    return;
  }
  chain.insert(chain.end(), {lerp(end, begin, 1.0 / 3), lerp(end, begin, 2.0 / 3), begin});
}

/// A stretch of a contour between two parameters; backwards where end < begin.
using Run = Source;

class Boundary {
 public:
  Boundary(Context& context, bool even_odd, double tolerance, TableMemory& loop_memory)
      : context_(context), even_odd_(even_odd), tolerance_(tolerance), loop_memory_(loop_memory) {}

  Result<Contours> find(const Contours& contours);

 private:
  Status copy_closed(const Contours& contours);
  Status flatten();
  Status link();
  Status order_begins(const BoundaryEdges& edges);
  std::size_t next_after(const BoundaryEdges& edges, std::size_t at, const std::vector<Run>& runs);
  Status go_on(std::vector<Run>& runs, const Source& source);
  Vec2 join(Run& before, Run& after) const;
  bool refine(Run& before, Run& after, Vec2& point) const;
  Status keep(std::vector<Run>& runs);
  bool is_sliver(const std::vector<Vec2>& loop) const;
  Vec2 point_of(std::uint32_t contour, double parameter) const;
  Cubic piece_of(const Run& run, double parameter, double& base) const;

  Context& context_;
  Contours contours_;
  bool even_odd_;
  double tolerance_;
  TableMemory memory_{kBoundaryPurpose};
  TableMemory& loop_memory_;
  std::vector<Chord> chords_;
  std::vector<std::pair<LatticePoint, std::size_t>> begins_;  ///< of edges, sorted
  /// Per entry of begins_ that is the first of its point: how many of these are taken for sure.
  std::vector<std::size_t> gone_;
  std::vector<std::uint8_t> is_taken_;  ///< per edge
  Contours loops_;
};

Status Boundary::copy_closed(const Contours& contours) {
  Status status = memory_.reserve(context_, contours_, contours.size());
  for (std::size_t c = 0; status && c < contours.size(); ++c) {
    std::vector<Vec2>& chain = contours_.emplace_back();
    status = memory_.reserve(context_, chain, contours[c].size() + 3);
    if (status) status = memory_.append(context_, contours[c], chain);
    if (status) close(chain, tolerance_);
  }
  return status;
}

Status Boundary::flatten() {
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    for (std::size_t i = 0; 3 * i + 3 < contours_[c].size(); ++i) {
      const Cubic cubic = curves::piece(contours_[c], i);
      const int count = chord_count(cubic, tolerance_);
      const auto base = static_cast<double>(i);
      Status status = memory_.make_room(context_, chords_, static_cast<std::size_t>(count));
      if (!status) return status;
      Vec2 from = cubic[0];
      for (int k = 0; k < count; ++k) {
        const double t0 = double{1} * k / count, t1 = double{1} * (k + 1) / count;
        const Vec2 to = k + 1 < count ? curves::point_at(cubic, t1) : cubic[3];
        chords_.push_back({from, to, base + t0, base + t1, static_cast<std::uint32_t>(c)});
        from = to;
      }
      if (chords_.size() > kChords) {
        return make_error(StatusCode::limit, "a shape of the drawing is too long");
      }
      if (context_.cancelled()) return context_.cancel_status();
    }
  }
  return ok_status();
}

Vec2 Boundary::point_of(std::uint32_t contour, double parameter) const {
  double base = 0;
  const Cubic cubic = piece_of({contour, parameter, parameter}, parameter, base);
  return curves::point_at(cubic, parameter - base);
}

/// The piece with a parameter; that which the run has a part of, where two meet.
Cubic Boundary::piece_of(const Run& run, double parameter, double& base) const {
  const std::vector<Vec2>& chain = contours_[run.contour];
  const auto last = static_cast<double>((chain.size() - 1) / 3 - 1);
  base = std::min(std::floor(parameter), last);
  if (base == parameter && std::max(run.begin, run.end) <= parameter && base > 0) base -= 1;
  return curves::piece(chain, static_cast<std::size_t>(base));
}

/// Moves two ends that meet to where their curves cross, by Newton's method, where that is near.
bool Boundary::refine(Run& before, Run& after, Vec2& point) const {
  double base_a = 0, base_b = 0;
  const Cubic on_a = piece_of(before, before.end, base_a);
  const Cubic on_b = piece_of(after, after.begin, base_b);
  double s = before.end - base_a, u = after.begin - base_b;
  const Vec2 begin = curves::point_at(on_a, s);
  for (int step = 0; step < 5; ++step) {
    const Vec2 gap = curves::point_at(on_b, u) - curves::point_at(on_a, s);
    const Vec2 along_a = curves::derivative_at(on_a, s), along_b = curves::derivative_at(on_b, u);
    const double denominator = cross(along_a, along_b);
    if (!(std::abs(denominator) > kParallel * length(along_a) * length(along_b))) return false;
    s += cross(gap, along_b) / denominator;
    u += cross(gap, along_a) / denominator;
    if (!(s >= 0 && s <= 1 && u >= 0 && u <= 1)) return false;
  }
  point = curves::point_at(on_a, s);
  if (!(length(point - begin) <= 4 * tolerance_)) return false;
  s += base_a;
  u += base_b;
  // No run turns round.
  if ((s - before.begin) * (before.end - before.begin) <= 0) return false;
  if ((after.end - u) * (after.end - after.begin) <= 0) return false;
  before.end = s;
  after.begin = u;
  return true;
}

/// Where one run ends and the next begins.
Vec2 Boundary::join(Run& before, Run& after) const {
  const auto is_corner = [](double parameter) { return parameter == std::floor(parameter); };
  const Vec2 end = point_of(before.contour, before.end);
  if (is_corner(before.end)) return end;
  const Vec2 begin = point_of(after.contour, after.begin);
  if (length(end - begin) > 8 * tolerance_)
    if (is_corner(after.begin)) return begin;
  Vec2 point = lerp(end, begin, 0.5);
  refine(before, after, point);
  return point;
}

/// A loop: its runs one after another.
Status Boundary::keep(std::vector<Run>& runs) {
  Run &first = runs.front(), &last = runs.back();
  if (runs.size() > 1 && last.contour == first.contour && last.end == first.begin &&
      (last.begin < last.end) == (first.begin < first.end)) {
    first.begin = last.begin;
    runs.pop_back();
  }
  TableMemory working(kBoundaryPurpose);
  std::vector<Vec2> joints, points;  // where each begins; of one
  Status status = working.resize(context_, joints, runs.size());
  if (!status) return status;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    joints[(i + 1) % runs.size()] = join(runs[i], runs[(i + 1) % runs.size()]);
  }
  std::vector<Vec2> loop;
  status = loop_memory_.push_back(context_, loop, joints[0]);
  for (std::size_t i = 0; status && i < runs.size(); ++i) {
    const auto& [contour, begin, end] = runs[i];
    points.clear();
    status = append_stretch(context_, contours_[contour], std::min(begin, end),
                            std::max(begin, end), working, points);
    if (!status || points.empty()) continue;
    if (end < begin) std::ranges::reverse(points);
    status = loop_memory_.append(context_, std::span(points).subspan(1), loop);
    loop.back() = joints[(i + 1) % runs.size()];
  }
  if (!status) return status;
  loop.back() = loop.front();
  if (loop.size() >= 4 && !is_sliver(loop)) {
    return loop_memory_.push_back(context_, loops_, std::move(loop));
  }
  loop_memory_.free(loop);
  return ok_status();
}

/// A loop so thin that nobody sees it: what is left where contours nearly touch.
bool Boundary::is_sliver(const std::vector<Vec2>& loop) const {
  const Vec2 origin = loop.front();
  Vec2 before = origin;
  double area = 0, around = 0;
  for_each_chord_end(loop, tolerance_, [&](Vec2 end) {
    area += cross(before - origin, end - origin) / 2;
    around += length(end - before);
    before = end;
  });
  return std::abs(area) <= 2 * tolerance_ * around;
}

bool goes_on_from(const Source& before, const Source& after) {
  return before.contour == after.contour && before.end == after.begin &&
         (before.begin < before.end) == (after.begin < after.end);
}

/// Of the contours that an edge lies on, that which the loop has followed so far.
const Source& source_after(std::span<const Source> sources, const std::vector<Run>& runs) {
  const auto goes_on = [&](const Source& source) {
    return !runs.empty() && goes_on_from(runs.back(), source);
  };
  const auto found = std::ranges::find_if(sources, goes_on);
  return found == sources.end() ? sources.front() : *found;
}

Status Boundary::go_on(std::vector<Run>& runs, const Source& source) {
  if (runs.empty() || !goes_on_from(runs.back(), source)) {
    return memory_.push_back(context_, runs, source);
  }
  runs.back().end = source.end;
  return ok_status();
}

Status Boundary::order_begins(const BoundaryEdges& edges) {
  const std::size_t count = edges.edge.size();
  Status status = memory_.reserve(context_, begins_, count);
  if (status) status = memory_.resize(context_, gone_, count);
  if (status) status = memory_.resize(context_, is_taken_, count);
  if (!status) return status;
  RarePoll<256> poll(context_);
  for (std::size_t i = 0; i < count; ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    begins_.emplace_back(edges.edge[i].from, i);
  }
  return TableMemory::sort(context_, begins_, std::less<>());
}

/// Of the edges that begin where edge `at` ends and are not taken: that which goes on along the
/// contour, or the first; `at` where there is none.
std::size_t Boundary::next_after(const BoundaryEdges& edges, std::size_t at,
                                 const std::vector<Run>& runs) {
  const auto point_of_entry = [](const auto& entry) { return entry.first; };
  const auto entries = std::ranges::equal_range(begins_, edges.edge[at].to, {}, point_of_entry);
  if (entries.empty()) return at;
  std::size_t& gone = gone_[static_cast<std::size_t>(entries.begin() - begins_.begin())];
  while (gone < entries.size() && is_taken_[entries[gone].second]) ++gone;
  const auto left = std::span(entries).subspan(gone);
  const auto is_free = [&](const auto& entry) { return !is_taken_[entry.second]; };
  auto next = std::ranges::find_if(left, [&](const auto& entry) {
    const auto sources = edges.sources_of(edges.edge[entry.second]);
    return is_free(entry) && goes_on_from(runs.back(), source_after(sources, runs));
  });
  if (next == left.end()) next = std::ranges::find_if(left, is_free);
  return next == left.end() ? at : next->second;
}

/// Edges one after another where one ends in the other's beginning: every end has its beginning.
Status Boundary::link() {
  Result<BoundaryEdges> found = boundary_edges(context_, chords_, even_odd_, tolerance_ / 64);
  if (!found) return found.status();
  const BoundaryEdges& edges = *found;
  const auto place = [&](const BoundaryEdge& edge) {
    const Source& source = edges.source[edge.first_source];
    return std::tuple(source.contour, std::min(source.begin, source.end), edge.from, edge.to);
  };
  Status status = TableMemory::sort(
      context_, found->edge,
      [&](const BoundaryEdge& a, const BoundaryEdge& b) { return place(a) < place(b); });
  if (status) status = order_begins(edges);
  if (!status) return status;
  RarePoll<256> poll(context_);
  std::vector<Run> runs;
  for (std::size_t i = 0; i < edges.edge.size(); ++i) {
    if (is_taken_[i]) continue;
    runs.clear();
    for (std::size_t at = i; !is_taken_[at];) {
      if (poll.cancelled()) return context_.cancel_status();
      is_taken_[at] = 1;
      status = go_on(runs, source_after(edges.sources_of(edges.edge[at]), runs));
      if (!status) return status;
      if (edges.edge[at].to == edges.edge[i].from) break;
      at = next_after(edges, at, runs);
    }
    if (status = keep(runs); !status) return status;
  }
  return ok_status();
}

Result<Contours> Boundary::find(const Contours& contours) {
  Status status = copy_closed(contours);
  if (status) status = flatten();
  if (status) status = link();
  if (!status) return status;
  return std::move(loops_);
}

}  // namespace

Result<Contours> fill_boundary(Context& context, const Contours& contours, bool even_odd,
                               double tolerance, TableMemory* memory) {
  TableMemory own(kBoundaryPurpose);
  return Boundary(context, even_odd, tolerance, memory ? *memory : own).find(contours);
}

}  // namespace sfumato::svg_import
