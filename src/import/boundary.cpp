#include "import/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "curves/bezier.hpp"
#include "import/chord_crossings.hpp"

namespace sfumato::svg_import {
namespace {

constexpr int kMostChords = 64;  ///< of one Bézier piece
constexpr std::size_t kChords = 2'000'000;
/// Chords that the stretches are held against, all together.
constexpr std::size_t kLooks = 200'000'000;
constexpr double kShortest = 1e-7;  ///< stretch, in the contour's parameter

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

/// A place where a contour is cut, and the point there, which all that are cut there share.
struct Cut {
  double parameter = 0;
  Vec2 point;
};

/// A stretch of a contour between two cuts.
struct Stretch {
  std::vector<Vec2> points;
  bool is_boundary = false;
};

class Boundary {
 public:
  Boundary(const Context& context, Contours contours, bool even_odd, double tolerance)
      : context_(context),
        contours_(std::move(contours)),
        even_odd_(even_odd),
        tolerance_(tolerance) {}

  Result<Contours> find();

 private:
  Status flatten();
  Status cut_at_crossings();
  void refine(Crossing& crossing, double& first, double& second) const;
  Status take_stretches();
  /// 1: inside on the right; −1: on the left; 0: no boundary.
  int side_of(std::size_t contour, double begin, double end) const;
  bool is_inside(Vec2 point) const;
  void keep(std::size_t contour, const Cut& begin, const Cut& end, int side);
  Contours linked() const;
  bool is_sliver(const std::vector<Vec2>& loop) const;
  Cubic piece_of(std::size_t contour, double parameter, double& t) const;

  const Context& context_;
  Contours contours_;
  bool even_odd_;
  double tolerance_;
  std::vector<Chord> chords_;
  std::vector<std::size_t> first_chord_;  ///< per contour, then their number
  std::vector<std::vector<Cut>> cuts_;
  Contours kept_;
};

Status Boundary::flatten() {
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    close(contours_[c], tolerance_);
    first_chord_.push_back(chords_.size());
    for (std::size_t i = 0; 3 * i + 3 < contours_[c].size(); ++i) {
      const Cubic cubic = curves::piece(contours_[c], i);
      const int count = chord_count(cubic, tolerance_);
      for (int k = 0; k < count; ++k) {
        const double t0 = double{1} * k / count, t1 = double{1} * (k + 1) / count;
        const Vec2 from = curves::point_at(cubic, t0), to = curves::point_at(cubic, t1);
        const auto base = static_cast<double>(i);
        if (!(from == to)) {
          chords_.push_back({from, to, base + t0, base + t1, static_cast<std::uint32_t>(c)});
        }
      }
      if (chords_.size() > kChords) {
        return make_error(StatusCode::limit, "a shape of the drawing is too long");
      }
      if (context_.cancelled()) return context_.stop_status();
    }
  }
  first_chord_.push_back(chords_.size());
  return ok_status();
}

Cubic Boundary::piece_of(std::size_t contour, double parameter, double& t) const {
  const std::vector<Vec2>& chain = contours_[contour];
  const std::size_t count = (chain.size() - 1) / 3;
  const auto i = std::min(static_cast<std::size_t>(parameter), count - 1);
  t = parameter - static_cast<double>(i);
  return curves::piece(chain, i);
}

/// From the crossing of two chords to that of their curves, by Newton's method; where it leads
/// away from the chords they stand.
void Boundary::refine(Crossing& crossing, double& first, double& second) const {
  const Chord& a = chords_[crossing.first];
  const Chord& b = chords_[crossing.second];
  first = a.begin + (a.end - a.begin) * crossing.at_first;
  second = b.begin + (b.end - b.begin) * crossing.at_second;
  double s = 0, u = 0;
  const Cubic on_a = piece_of(a.contour, (a.begin + a.end) / 2, s);
  const Cubic on_b = piece_of(b.contour, (b.begin + b.end) / 2, u);
  const double base_a = (a.begin + a.end) / 2 - s, base_b = (b.begin + b.end) / 2 - u;
  s = first - base_a;
  u = second - base_b;
  for (int step = 0; step < 4; ++step) {
    const Vec2 gap = curves::point_at(on_b, u) - curves::point_at(on_a, s);
    const Vec2 along_a = curves::derivative_at(on_a, s), along_b = curves::derivative_at(on_b, u);
    const double denominator = cross(along_a, along_b);
    if (denominator == 0) return;
    s += cross(gap, along_b) / denominator;
    u += cross(gap, along_a) / denominator;
    const double span_a = a.end - a.begin, span_b = b.end - b.begin;
    const bool strays = !(std::abs(base_a + s - first) <= span_a && s >= 0 && s <= 1) ||
                        !(std::abs(base_b + u - second) <= span_b && u >= 0 && u <= 1);
    if (strays) return;
  }
  first = base_a + s;
  second = base_b + u;
}

Status Boundary::cut_at_crossings() {
  Result<std::vector<Crossing>> crossings = find_crossings(context_, chords_);
  if (!crossings) return crossings.status();
  cuts_.resize(contours_.size());
  for (Crossing& crossing : *crossings) {
    double first = 0, second = 0, t = 0;
    refine(crossing, first, second);
    const std::uint32_t a = chords_[crossing.first].contour, b = chords_[crossing.second].contour;
    const Cubic on_a = piece_of(a, first, t);
    const Vec2 point = curves::point_at(on_a, t);
    cuts_[a].push_back({first, point});
    cuts_[b].push_back({second, point});
  }
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    std::vector<Cut>& cuts = cuts_[c];
    const auto end = static_cast<double>((contours_[c].size() - 1) / 3);
    cuts.push_back({0, contours_[c].front()});
    cuts.push_back({end, contours_[c].front()});
    std::ranges::stable_sort(cuts, {}, &Cut::parameter);
  }
  return ok_status();
}

bool Boundary::is_inside(Vec2 point) const {
  const int number = winding_number(chords_, point);
  return even_odd_ ? number % 2 != 0 : number != 0;
}

/// Asked beside the longest chord of the stretch.
int Boundary::side_of(std::size_t contour, double begin, double end) const {
  Vec2 from, to;
  const auto all = std::span(chords_).subspan(first_chord_[contour],
                                              first_chord_[contour + 1] - first_chord_[contour]);
  const auto first =
      std::ranges::partition_point(all, [begin](const Chord& chord) { return chord.end <= begin; });
  for (const Chord& chord : std::span(first, all.end())) {
    if (chord.begin >= end) break;
    const double low = std::max(begin, chord.begin), high = std::min(end, chord.end);
    const double span = chord.end - chord.begin;
    const Vec2 a = lerp(chord.from, chord.to, (low - chord.begin) / span);
    const Vec2 b = lerp(chord.from, chord.to, (high - chord.begin) / span);
    if (length_squared(b - a) > length_squared(to - from)) from = a, to = b;
  }
  const double size = length(to - from);
  if (!(size > 0)) return 0;
  const Vec2 left = left_of(to - from) / size * std::min(tolerance_ / 64, size / 4);
  const Vec2 middle = lerp(from, to, 0.4871);  // no place that symmetry leads others to
  return (is_inside(middle - left) ? 1 : 0) - (is_inside(middle + left) ? 1 : 0);
}

/// The stretch, with its inside on the right.
void Boundary::keep(std::size_t contour, const Cut& begin, const Cut& end, int side) {
  std::vector<Vec2> points{begin.point};
  double low = begin.parameter;
  while (low < end.parameter) {
    const double high = std::min(end.parameter, std::floor(low) + 1);
    double t = 0;
    const Cubic cubic = piece_of(contour, (low + high) / 2, t);
    const double base = (low + high) / 2 - t;
    const Cubic part = curves::subcurve(cubic, low - base, high - base);
    points.insert(points.end(), part.begin() + 1, part.end());
    low = high;
  }
  points.back() = end.point;
  if (side < 0) std::ranges::reverse(points);
  kept_.push_back(std::move(points));
}

Status Boundary::take_stretches() {
  std::size_t looks = 0;
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    const std::vector<Cut>& cuts = cuts_[c];
    std::size_t begin = 0;
    int side = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if (context_.cancelled()) return context_.stop_status();
      // Of no length: has no sides, and the chain goes on.
      if (cuts[i].parameter - cuts[i - 1].parameter < kShortest && i > 1) continue;
      if ((looks += 2 * chords_.size()) > kLooks) {
        return make_error(StatusCode::limit, "the shape crosses itself too often");
      }
      const int next = side_of(c, cuts[i - 1].parameter, cuts[i].parameter);
      if (i > 1 && next == side) continue;
      if (side != 0) keep(c, cuts[begin], cuts[i - 1], side);
      begin = i - 1;
      side = next;
    }
    if (side != 0) keep(c, cuts[begin], cuts.back(), side);
  }
  return ok_status();
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

/// Stretches one after another where one ends in the other's beginning.
Contours Boundary::linked() const {
  std::multimap<std::pair<double, double>, std::size_t> begins;
  const auto key = [](Vec2 p) { return std::pair(p.x, p.y); };
  for (std::size_t i = 0; i < kept_.size(); ++i) begins.emplace(key(kept_[i].front()), i);
  const auto take = [&](Vec2 point, std::size_t& index) {
    const auto found = begins.find(key(point));
    if (found == begins.end()) return false;
    index = found->second;
    begins.erase(found);
    return true;
  };
  Contours loops;
  std::vector<bool> is_taken(kept_.size(), false);
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (is_taken[i]) continue;
    const auto [low, high] = begins.equal_range(key(kept_[i].front()));
    begins.erase(std::find_if(low, high, [i](const auto& entry) { return entry.second == i; }));
    is_taken[i] = true;
    std::vector<Vec2> loop = kept_[i];
    std::size_t next = 0;
    while (!(loop.back() == loop.front()) && take(loop.back(), next)) {
      is_taken[next] = true;
      loop.insert(loop.end(), kept_[next].begin() + 1, kept_[next].end());
    }
    const bool is_loop = length(loop.back() - loop.front()) <= tolerance_;
    if (is_loop) loop.back() = loop.front();
    if (!is_loop || !is_sliver(loop)) loops.push_back(std::move(loop));
  }
  return loops;
}

Result<Contours> Boundary::find() {
  Status status = flatten();
  if (status) status = cut_at_crossings();
  if (status) status = take_stretches();
  if (!status) return status;
  return linked();
}

}  // namespace

Result<Contours> fill_boundary(const Context& context, Contours contours, bool even_odd,
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
