#include "import/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "base/charge.hpp"
#include "base/large_vector.hpp"
#include "base/poll.hpp"
#include "curves/bezier.hpp"
#include "import/arrangement.hpp"
#include "import/chords.hpp"

namespace sfumato::svg_import {
namespace {

constexpr int kMostChords = 64;  ///< of one Bézier piece
constexpr std::size_t kChords = 2'000'000;
constexpr std::size_t kFirstChords = 256;
constexpr double kParallel = 1e-9;  ///< sine of an angle

using curves::Cubic;

int chord_count(const Cubic& cubic, double tolerance) {
  const curves::ChordDeviation deviation = curves::chord_deviation(cubic);
  const double wanted = std::sqrt(std::max(deviation.across, deviation.along / 8) / tolerance);
  return static_cast<int>(std::clamp(std::ceil(wanted), 1.0, double{kMostChords}));
}

/// By a straight line, or where hardly anything is missing, by moving the end.
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
  Boundary(Context& context, Contours contours, bool even_odd, double tolerance)
      : context_(context),
        contours_(std::move(contours)),
        even_odd_(even_odd),
        tolerance_(tolerance) {}

  Result<Contours> find();

 private:
  Status flatten();
  Status charge_chords();
  Status link();
  Vec2 join(Run& before, Run& after) const;
  bool refine(Run& before, Run& after, Vec2& point) const;
  void keep(std::vector<Run> runs);
  bool is_sliver(const std::vector<Vec2>& loop) const;
  Vec2 point_of(std::uint32_t contour, double parameter) const;
  Cubic piece_of(const Run& run, double parameter, double& base) const;

  Context& context_;
  Contours contours_;
  bool even_odd_;
  double tolerance_;
  std::vector<Chord> chords_;
  std::size_t charged_ = 0;  ///< chords, twice: their edges become loops
  ScopedCharge charge_;
  Contours loops_;
};

Status Boundary::flatten() {
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    close(contours_[c], tolerance_);
    for (std::size_t i = 0; 3 * i + 3 < contours_[c].size(); ++i) {
      const Cubic cubic = curves::piece(contours_[c], i);
      const int count = chord_count(cubic, tolerance_);
      const auto base = static_cast<double>(i);
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
      if (Status status = charge_chords(); !status) return status;
    }
  }
  return ok_status();
}

/// In steps that double.
Status Boundary::charge_chords() {
  if (chords_.size() <= charged_) return ok_status();
  const std::size_t more = std::max(charged_, kFirstChords);
  charged_ += more;
  return charge_.add(context_, 2 * more * sizeof(Chord), "the boundary of a shape");
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
void Boundary::keep(std::vector<Run> runs) {
  Run &first = runs.front(), &last = runs.back();
  if (runs.size() > 1 && last.contour == first.contour && last.end == first.begin &&
      (last.begin < last.end) == (first.begin < first.end)) {
    first.begin = last.begin;
    runs.pop_back();
  }
  std::vector<Vec2> joints(runs.size());  // where each begins
  for (std::size_t i = 0; i < runs.size(); ++i) {
    joints[(i + 1) % runs.size()] = join(runs[i], runs[(i + 1) % runs.size()]);
  }
  std::vector<Vec2> loop{joints[0]};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& [contour, begin, end] = runs[i];
    std::vector<Vec2> points =
        stretch(contours_[contour], std::min(begin, end), std::max(begin, end));
    if (points.empty()) continue;
    if (end < begin) std::ranges::reverse(points);
    loop.insert(loop.end(), points.begin() + 1, points.end());
    loop.back() = joints[(i + 1) % runs.size()];
  }
  loop.back() = loop.front();
  if (loop.size() >= 4 && !is_sliver(loop)) loops_.push_back(std::move(loop));
}

/// A loop so thin that nobody sees it: what is left where contours nearly touch.
bool Boundary::is_sliver(const std::vector<Vec2>& loop) const {
  const std::vector<Vec2> polygon = flattened(loop, tolerance_);
  double area = 0, around = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    area += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]) / 2;
    around += length(polygon[i] - polygon[i - 1]);
  }
  return std::abs(area) <= 2 * tolerance_ * around;
}

bool goes_on_from(const Source& before, const Source& after) {
  return before.contour == after.contour && before.end == after.begin &&
         (before.begin < before.end) == (after.begin < after.end);
}

/// Of the contours that an edge lies on, that which the loop has followed so far.
const Source& source_after(const BoundaryEdge& edge, const std::vector<Run>& runs) {
  const auto goes_on = [&](const Source& source) {
    return !runs.empty() && goes_on_from(runs.back(), source);
  };
  const auto found = std::ranges::find_if(edge.sources, goes_on);
  return found == edge.sources.end() ? edge.sources.front() : *found;
}

void go_on(std::vector<Run>& runs, const Source& source) {
  if (!runs.empty() && goes_on_from(runs.back(), source)) {
    runs.back().end = source.end;
  } else {
    runs.push_back(source);
  }
}

/// Edges one after another where one ends in the other's beginning: every end has its beginning.
Status Boundary::link() {
  Result<std::vector<BoundaryEdge>> found =
      boundary_edges(context_, chords_, even_odd_, tolerance_ / 64, charge_);
  if (!found) return found.status();
  std::vector<BoundaryEdge>& edges = *found;
  const auto place = [](const BoundaryEdge& edge) {
    const Source& source = edge.sources.front();
    return std::tuple(source.contour, std::min(source.begin, source.end), edge.from, edge.to);
  };
  const Status sorted =
      sort_large(context_, edges,
                 [&](const BoundaryEdge& a, const BoundaryEdge& b) { return place(a) < place(b); });
  if (!sorted) return sorted;
  std::multimap<LatticePoint, std::size_t> begins;
  RarePoll<256> poll(context_);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    begins.emplace(edges[i].from, i);
  }
  std::vector<bool> is_taken(edges.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_taken[i]) continue;
    std::vector<Run> runs;
    for (std::size_t at = i; !is_taken[at];) {
      if (poll.cancelled()) return context_.cancel_status();
      is_taken[at] = true;
      go_on(runs, source_after(edges[at], runs));
      if (edges[at].to == edges[i].from) break;
      auto [low, high] = begins.equal_range(edges[at].to);
      while (low != high && is_taken[low->second]) low = begins.erase(low);
      auto next = std::find_if(low, high, [&](const auto& entry) {
        return !is_taken[entry.second] &&
               goes_on_from(runs.back(), source_after(edges[entry.second], runs));
      });
      if (next == high) {
        next = std::find_if(low, high, [&](const auto& entry) { return !is_taken[entry.second]; });
      }
      if (next != high) at = next->second;
    }
    keep(std::move(runs));
  }
  return ok_status();
}

Result<Contours> Boundary::find() {
  Status status = flatten();
  if (status) status = link();
  if (!status) return status;
  return std::move(loops_);
}

}  // namespace

Result<Contours> fill_boundary(Context& context, Contours contours, bool even_odd,
                               double tolerance) {
  return Boundary(context, std::move(contours), even_odd, tolerance).find();
}

std::vector<Vec2> flattened(const std::vector<Vec2>& chain, double tolerance) {
  std::vector<Vec2> polygon{chain.front()};
  for (std::size_t i = 0; 3 * i + 3 < chain.size(); ++i) {
    const Cubic cubic = curves::piece(chain, i);
    const int count = chord_count(cubic, tolerance);
    for (int k = 1; k <= count; ++k) {
      polygon.push_back(curves::point_at(cubic, double{1} * k / count));
    }
  }
  return polygon;
}

}  // namespace sfumato::svg_import
