#include "import/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"
#include "import/arrangement.hpp"
#include "import/boundary_check.hpp"
#include "import/chords.hpp"
#include "import/edge_loops.hpp"
#include "import/loop_area.hpp"
#include "import/shape_limits.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg_import {
namespace {

constexpr double kFiner = 16;            ///< where the tolerance hides crossings
constexpr std::size_t kFinerChords = 4;  ///< so many times as many chords then
constexpr double kFinerToClose = 4;      ///< chords, where curves have leaked
constexpr int kMostRounds = 8;           ///< of writing lines where curves leak
constexpr const char* kBoundaryPurpose = "the boundary of a shape";
constexpr double kParallel = 1e-9;  ///< sine of an angle

bool is_corner(double parameter) {
  return parameter == std::floor(parameter);
}

using curves::Cubic;

/// Closes a gap by a straight line, for which there is room, or, if the gap is tiny, by moving the
/// end.
void close(std::vector<Vec2>& chain, double tolerance) {
  const Vec2 begin = chain.front(), end = chain.back();
  if (length(end - begin) <= tolerance) {
    chain.back() = begin;
    return;
  }
  chain.insert(chain.end(), {lerp(end, begin, 1.0 / 3), lerp(end, begin, 2.0 / 3), begin});
}

/// A stretch of a contour between two parameters; backwards if end < begin.
using Run = Source;

/// Steps of a loop that are written together: along a contour, or as one straight line.
struct Stretch {
  Run run;
  std::size_t first = 0;  ///< step, from the loop's first
  std::size_t count = 1;  ///< may go on with the loop's first step
  bool is_line = false;
};

/// The steps of a loop for which a written piece stands, both included; the first may come after
/// the last.
struct PieceSteps {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// A loop as it is written.
struct WrittenLoop {
  std::size_t of = 0;  ///< loop of steps
  std::vector<Vec2> chain;
  std::vector<PieceSteps> pieces;
};

class Boundary {
 public:
  /// chord_tolerance   how far chords may deviate from the contours
  Boundary(Context& context, double tolerance, double chord_tolerance)
      : context_(context), tolerance_(tolerance), chord_tolerance_(chord_tolerance) {}

  /// Finds the loops and writes them along the contours.
  Status find(const Contours& contours, const RegionRule& rule, Vertices vertices);
  double tolerance() const { return tolerance_; }
  /// How far the crossing of two curves may be from where their chords cross.
  double farthest_joint() const { return 4 * tolerance_; }
  /// Property of the contours; known once find() is done.
  std::size_t chord_count() const { return chord_count_; }
  /// Returns whether a written part crosses another or is too near to it.
  Result<bool> leaks() const;
  /// Writes straight lines, which do not cross, between vertices of the arrangement where anything
  /// leaks.
  Status stop_leaks();
  /// Charges `memory` for the loops.
  Result<Contours> take(TableMemory& memory);

 private:
  Status copy_closed(const Contours& contours);
  Status flatten(std::vector<Chord>& chords, TableMemory& memory);
  Status write_loops();
  Status write_loop(std::size_t index);
  Status find_stretches(std::size_t loop, std::vector<Stretch>& stretches, TableMemory& memory);
  Status write_stretch(const Stretch& stretch, std::size_t loop, Vec2 end, WrittenLoop& written);
  Status write_line(const Stretch& stretch, Vec2 end, WrittenLoop& written);
  Status note_steps(const Stretch& stretch, std::size_t loop, std::size_t piece_count,
                    WrittenLoop& written);
  Vec2 begin_of(const Stretch& stretch, std::size_t loop) const;
  void place_ends(Stretch& stretch, Vec2 begin, Vec2 end) const;
  Vec2 joint_between(Stretch& before, Stretch& after, std::size_t loop) const;
  Vec2 join(Run& before, Run& after) const;
  std::optional<Vec2> refine(Run& before, Run& after) const;
  Status keep(WrittenLoop written);
  Status drop_within(const std::vector<Vec2>& dropped);
  void forget(WrittenLoop& loop);
  Status find_touches();
  Result<std::vector<DrawnLoop>> drawn_loops(TableMemory& memory) const;
  Result<std::vector<LoopPiece>> leaking(TableMemory& memory) const;
  bool mark_lines(const std::vector<LoopPiece>& pieces);
  bool mark_all(std::size_t loop);
  Vec2 point_of(std::uint32_t contour, double parameter) const;
  Cubic piece_of(const Run& run, double parameter, double& base) const;
  double parameter_near(const Run& run, double parameter, Vec2 vertex) const;

  Context& context_;
  double tolerance_;
  double chord_tolerance_;
  std::size_t chord_count_ = 0;
  TableMemory memory_{kBoundaryPurpose};
  Contours contours_;
  BoundaryEdges edges_;
  EdgeLoops steps_;
  std::vector<Vec2> touches_;          ///< of loops, sorted by x
  std::vector<std::uint8_t> is_line_;  ///< per step
  TableMemory written_memory_{kBoundaryPurpose};
  std::vector<WrittenLoop> written_;
  std::vector<std::vector<Vec2>> slivers_;  ///< loops too thin to be written
};

Status Boundary::copy_closed(const Contours& contours) {
  SFUMATO_TRY(memory_.reserve(context_, contours_, contours.size()));
  for (std::size_t c = 0; c < contours.size(); ++c) {
    std::vector<Vec2>& chain = contours_.emplace_back();
    SFUMATO_TRY(memory_.reserve(context_, chain, contours[c].size() + 3));
    SFUMATO_TRY(memory_.append(context_, contours[c], chain));
    close(chain, tolerance_);
  }
  return ok_status();
}

Status Boundary::flatten(std::vector<Chord>& chords, TableMemory& memory) {
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    for (std::size_t i = 0; 3 * i + 3 < contours_[c].size(); ++i) {
      const Cubic cubic = curves::piece(contours_[c], i);
      const int count = svg_import::chord_count(cubic, chord_tolerance_);
      const auto base = static_cast<double>(i);
      SFUMATO_TRY(memory.make_room(context_, chords, static_cast<std::size_t>(count)));
      Vec2 from = cubic[0];
      for (int k = 0; k < count; ++k) {
        const double t0 = double{1} * k / count, t1 = double{1} * (k + 1) / count;
        const Vec2 to = k + 1 < count ? curves::point_at(cubic, t1) : cubic[3];
        chords.push_back({from, to, base + t0, base + t1, static_cast<std::uint32_t>(c)});
        from = to;
      }
      if (chords.size() > context_.limits.chords) return too_long(context_);
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

/// Returns the piece with a parameter. If two pieces meet there, returns the piece that belongs to
/// the run.
Cubic Boundary::piece_of(const Run& run, double parameter, double& base) const {
  const std::vector<Vec2>& chain = contours_[run.contour];
  const auto last = static_cast<double>((chain.size() - 1) / 3 - 1);
  base = std::min(std::floor(parameter), last);
  if (base == parameter && std::max(run.begin, run.end) <= parameter && base > 0) base -= 1;
  return curves::piece(chain, static_cast<std::size_t>(base));
}

/// Returns the parameter at a vertex of the arrangement. `parameter` was found in proportion to the
/// length of a chord, which is wrong where the speed of the curve changes along the chord.
double Boundary::parameter_near(const Run& run, double parameter, Vec2 vertex) const {
  if (is_corner(parameter)) return parameter;
  if (length(point_of(run.contour, parameter) - vertex) <= farthest_joint()) return parameter;
  double base = 0;
  const Cubic cubic = piece_of(run, parameter, base);
  const double count = svg_import::chord_count(cubic, chord_tolerance_);
  const double chord = std::min(std::floor((parameter - base) * count), count - 1);
  return base + parameter_beside(cubic, chord / count, (chord + 1) / count, vertex);
}

/// Moves the ends of a stretch's run to the vertices where it begins and ends.
void Boundary::place_ends(Stretch& stretch, Vec2 begin, Vec2 end) const {
  if (stretch.is_line) return;
  Run& run = stretch.run;
  const Run placed{run.contour, parameter_near(run, run.begin, begin),
                   parameter_near(run, run.end, end)};
  if ((placed.end - placed.begin) * (run.end - run.begin) > 0) run = placed;
}

/// Moves two ends that meet to the crossing of their curves, by Newton's method, if it is near.
/// Returns the crossing, or no value if the ends stay.
std::optional<Vec2> Boundary::refine(Run& before, Run& after) const {
  double base_a = 0, base_b = 0;
  const Cubic on_a = piece_of(before, before.end, base_a);
  const Cubic on_b = piece_of(after, after.begin, base_b);
  double s = before.end - base_a, u = after.begin - base_b;
  const Vec2 begin = curves::point_at(on_a, s);
  for (int step = 0; step < 5; ++step) {
    const Vec2 gap = curves::point_at(on_b, u) - curves::point_at(on_a, s);
    const Vec2 along_a = curves::derivative_at(on_a, s), along_b = curves::derivative_at(on_b, u);
    const double denominator = cross(along_a, along_b);
    if (!(std::abs(denominator) > kParallel * length(along_a) * length(along_b)))
      return std::nullopt;
    s += cross(gap, along_b) / denominator;
    u += cross(gap, along_a) / denominator;
    if (!(s >= 0 && s <= 1 && u >= 0 && u <= 1)) return std::nullopt;
  }
  const Vec2 crossing = curves::point_at(on_a, s);
  if (!(length(crossing - begin) <= farthest_joint())) return std::nullopt;
  if (!(length(curves::point_at(on_b, u) - crossing) <= tolerance_)) return std::nullopt;
  s += base_a;
  u += base_b;
  // No run turns round.
  if ((s - before.begin) * (before.end - before.begin) <= 0) return std::nullopt;
  if ((after.end - u) * (after.end - after.begin) <= 0) return std::nullopt;
  before.end = s;
  after.begin = u;
  return crossing;
}

/// Where one run ends and the next begins.
Vec2 Boundary::join(Run& before, Run& after) const {
  const Vec2 end = point_of(before.contour, before.end);
  if (is_corner(before.end)) return end;
  const Vec2 begin = point_of(after.contour, after.begin);
  if (length(end - begin) > 8 * tolerance_)
    if (is_corner(after.begin)) return begin;
  return refine(before, after).value_or(lerp(end, begin, 0.5));
}

/// The vertex of the arrangement at which a stretch begins.
Vec2 Boundary::begin_of(const Stretch& stretch, std::size_t loop) const {
  return edges_.position_of(edges_.edge[steps_.steps_of(loop)[stretch.first].edge].from);
}

/// Where one stretch of a loop ends and the next begins.
Vec2 Boundary::joint_between(Stretch& before, Stretch& after, std::size_t loop) const {
  if (!before.is_line && !after.is_line) return join(before.run, after.run);
  return begin_of(after, loop);
}

Status Boundary::find_stretches(std::size_t loop, std::vector<Stretch>& stretches,
                                TableMemory& memory) {
  const std::span<const LoopStep> steps = steps_.steps_of(loop);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_line = is_line_[steps_.begin[loop] + i] != 0;
    const bool goes_on = !stretches.empty() && !is_line && !stretches.back().is_line &&
                         goes_on_from(stretches.back().run, steps[i].source);
    if (goes_on) {
      stretches.back().run.end = steps[i].source.end;
      ++stretches.back().count;
      continue;
    }
    const Stretch added{steps[i].source, i, 1, is_line};
    SFUMATO_TRY(memory.push_back(context_, stretches, added));
  }
  Stretch &first = stretches.front(), &last = stretches.back();
  if (stretches.size() > 1 && !first.is_line && !last.is_line &&
      goes_on_from(last.run, first.run)) {
    first.run.begin = last.run.begin;
    first.first = last.first;
    first.count += last.count;
    stretches.pop_back();
  }
  return ok_status();
}

/// Appends a stretch to a loop that has its first point. A stretch without length adds nothing.
Status Boundary::write_stretch(const Stretch& stretch, std::size_t loop, Vec2 end,
                               WrittenLoop& written) {
  if (stretch.is_line) return write_line(stretch, end, written);
  const auto& [contour, begin, last] = stretch.run;
  TableMemory working(kBoundaryPurpose);
  std::vector<Vec2> points;
  SFUMATO_TRY(append_stretch(context_, contours_[contour], std::min(begin, last),
                             std::max(begin, last), working, points));
  if (points.empty()) return ok_status();
  if (last < begin) std::ranges::reverse(points);
  SFUMATO_TRY(written_memory_.append(context_, std::span(points).subspan(1), written.chain));
  written.chain.back() = end;
  return note_steps(stretch, loop, (points.size() - 1) / 3, written);
}

Status Boundary::write_line(const Stretch& stretch, Vec2 end, WrittenLoop& written) {
  const Vec2 from = written.chain.back();
  const std::array<Vec2, 3> line{lerp(from, end, 1.0 / 3), lerp(from, end, 2.0 / 3), end};
  SFUMATO_TRY(written_memory_.append(context_, line, written.chain));
  return written_memory_.push_back(context_, written.pieces, {stretch.first, stretch.first});
}

/// For each piece of a stretch that was written, the steps that it stands for.
Status Boundary::note_steps(const Stretch& stretch, std::size_t loop, std::size_t piece_count,
                            WrittenLoop& written) {
  const std::span<const LoopStep> steps = steps_.steps_of(loop);
  const auto& [contour, begin, last] = stretch.run;
  const bool is_forward = begin <= last;
  const auto index = [&](std::size_t k) { return (stretch.first + k) % steps.size(); };
  std::size_t step = 0;
  double at = begin;
  for (std::size_t i = 0; i < piece_count; ++i) {
    // A piece ends at the next whole parameter.
    at = is_forward ? std::min(std::floor(at) + 1, last) : std::max(std::ceil(at) - 1, last);
    const auto ends_before = [&](std::size_t k) {
      const double end = steps[index(k)].source.end;
      return is_forward ? end < at : end > at;
    };
    const std::size_t first = step;
    while (step + 1 < stretch.count && ends_before(step)) ++step;
    SFUMATO_TRY(written_memory_.push_back(context_, written.pieces, {index(first), index(step)}));
    if (step + 1 < stretch.count && steps[index(step)].source.end == at) ++step;
  }
  return ok_status();
}

/// A loop: its stretches one after another.
Status Boundary::write_loop(std::size_t index) {
  TableMemory working(kBoundaryPurpose);
  std::vector<Stretch> stretches;
  std::vector<Vec2> joints;  // where each begins
  SFUMATO_TRY(find_stretches(index, stretches, working));
  SFUMATO_TRY(working.resize(context_, joints, stretches.size()));
  const auto next = [&](std::size_t i) { return (i + 1) % stretches.size(); };
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    place_ends(stretches[i], begin_of(stretches[i], index), begin_of(stretches[next(i)], index));
  }
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    joints[next(i)] = joint_between(stretches[i], stretches[next(i)], index);
  }
  WrittenLoop written{index, {}, {}};
  SFUMATO_TRY(written_memory_.push_back(context_, written.chain, joints[0]));
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    SFUMATO_TRY(write_stretch(stretches[i], index, joints[next(i)], written));
  }
  written.chain.back() = written.chain.front();
  return keep(std::move(written));
}

Status Boundary::keep(WrittenLoop written) {
  if (written.chain.size() >= 4 && !is_sliver(written.chain, tolerance_)) {
    return written_memory_.push_back(context_, written_, std::move(written));
  }
  written_memory_.free(written.pieces);
  return written_memory_.push_back(context_, slivers_, std::move(written.chain));
}

bool is_within(const std::vector<Vec2>& chain, const Box& box) {
  return std::ranges::all_of(chain, [&](Vec2 p) { return box.contains(p); });
}

/// Drops the loops within a dropped loop, because the region there would have no outline.
Status Boundary::drop_within(const std::vector<Vec2>& dropped) {
  TableMemory working(kBoundaryPurpose);
  std::vector<Chord> chords;
  Box box;
  Vec2 from = dropped.front();
  Status status;
  for_each_chord_end(dropped, tolerance_, [&](Vec2 to) {
    if (status) status = working.push_back(context_, chords, {from, to});
    box.extend(to);
    from = to;
  });
  if (!status) return status;
  const Box around = box.grown_by(tolerance_);
  std::size_t count = 0;
  RarePoll<256> poll(context_);
  for (WrittenLoop& loop : written_) {
    if (poll.cancelled()) return context_.cancel_status();
    // Loops may share corners. No point of an edge lies on both.
    const Vec2 at = curves::point_at(curves::piece(loop.chain, 0), 0.5);
    const bool is_inside = is_within(loop.chain, around) && winding_number(chords, at) != 0;
    if (is_inside) {
      forget(loop);
    } else if (&loop != &written_[count++]) {
      written_[count - 1] = std::move(loop);
    }
  }
  written_.resize(count);
  return ok_status();
}

void Boundary::forget(WrittenLoop& loop) {
  written_memory_.free(loop.chain);
  written_memory_.free(loop.pieces);
}

Status Boundary::write_loops() {
  for (WrittenLoop& loop : written_) forget(loop);
  written_.clear();
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    SFUMATO_TRY(write_loop(i));
  }
  for (std::vector<Vec2>& sliver : slivers_) {
    SFUMATO_TRY(drop_within(sliver));
    written_memory_.free(sliver);
  }
  slivers_.clear();
  return ok_status();
}

Result<std::vector<DrawnLoop>> Boundary::drawn_loops(TableMemory& memory) const {
  std::vector<DrawnLoop> loops;
  SFUMATO_TRY(memory.reserve(context_, loops, written_.size()));
  for (const WrittenLoop& loop : written_) {
    loops.push_back({&loop.chain, area_of(edges_, steps_, loop.of)});
  }
  return loops;
}

Result<std::vector<LoopPiece>> Boundary::leaking(TableMemory& memory) const {
  SFUMATO_TRY_ASSIGN(const std::vector<DrawnLoop>& loops, drawn_loops(memory));
  return leaking_pieces(context_, loops, tolerance_, touches_, memory);
}

/// Finds the vertices that several edges begin at.
Status Boundary::find_touches() {
  TableMemory working(kBoundaryPurpose);
  std::vector<LatticePoint> begins;
  SFUMATO_TRY(working.reserve(context_, begins, edges_.edge.size()));
  for (const BoundaryEdge& edge : edges_.edge) begins.push_back(edge.from);
  const auto place = [](LatticePoint p) { return std::pair(p.x, p.y); };
  SFUMATO_TRY(
      TableMemory::sort(context_, begins, [&](auto a, auto b) { return place(a) < place(b); }));
  for (std::size_t i = 1; i < begins.size(); ++i) {
    if (begins[i] != begins[i - 1]) continue;
    SFUMATO_TRY(memory_.push_back(context_, touches_, edges_.position_of(begins[i])));
  }
  return ok_status();
}

Result<bool> Boundary::leaks() const {
  TableMemory memory(kBoundaryPurpose);
  SFUMATO_TRY_ASSIGN(const std::vector<LoopPiece>& found, leaking(memory));
  return !found.empty();
}

/// Returns whether any step of the loop was not marked before.
bool Boundary::mark_all(std::size_t loop) {
  bool is_new = false;
  for (std::size_t i = steps_.begin[loop]; i < steps_.begin[loop + 1]; ++i) {
    is_new = is_new || is_line_[i] == 0;
    is_line_[i] = 1;
  }
  return is_new;
}

/// Turns pieces into lines or, if all pieces are lines already, their whole loops. Returns whether
/// anything changed.
bool Boundary::mark_lines(const std::vector<LoopPiece>& pieces) {
  bool is_new = false;
  for (const auto& [index, piece] : pieces) {
    const WrittenLoop& loop = written_[index];
    const std::size_t begin = steps_.begin[loop.of], count = steps_.begin[loop.of + 1] - begin;
    const auto [first, last] = loop.pieces[piece];
    for (std::size_t i = first;; i = (i + 1) % count) {
      is_new = is_new || is_line_[begin + i] == 0;
      is_line_[begin + i] = 1;
      if (i == last) break;
    }
  }
  if (is_new) return true;
  for (const LoopPiece& piece : pieces) is_new = mark_all(written_[piece.loop].of) || is_new;
  return is_new;
}

Status Boundary::stop_leaks() {
  for (int round = 0; round < kMostRounds; ++round) {
    TableMemory memory(kBoundaryPurpose);
    const Result<std::vector<LoopPiece>> found = leaking(memory);
    if (!found || found->empty()) return found.status();
    const bool is_last = round + 1 == kMostRounds;
    for (std::size_t i = 0; is_last && i < steps_.size(); ++i) mark_all(i);
    if (!is_last && !mark_lines(*found)) break;
    SFUMATO_TRY(write_loops());
  }
  TableMemory memory(kBoundaryPurpose);
  SFUMATO_TRY_ASSIGN(const std::vector<DrawnLoop>& loops, drawn_loops(memory));
  return refuse_crossings(context_, loops, tolerance_, touches_);
}

Status Boundary::find(const Contours& contours, const RegionRule& rule, Vertices vertices) {
  SFUMATO_TRY(copy_closed(contours));
  TableMemory working(kBoundaryPurpose);
  std::vector<Chord> chords;
  SFUMATO_TRY(flatten(chords, working));
  chord_count_ = chords.size();
  SFUMATO_TRY_ASSIGN(edges_, boundary_edges(context_, chords, rule, tolerance_ / 64, vertices));
  SFUMATO_TRY_ASSIGN(steps_, link_edges(context_, edges_));
  SFUMATO_TRY(find_touches());
  SFUMATO_TRY(memory_.resize(context_, is_line_, steps_.step.size()));
  return write_loops();
}

Result<Contours> Boundary::take(TableMemory& memory) {
  Contours loops;
  SFUMATO_TRY(memory.reserve(context_, loops, written_.size()));
  for (WrittenLoop& loop : written_) {
    written_memory_.free(loop.pieces);
    loops.push_back(std::move(loop.chain));
  }
  written_memory_.free(written_);
  written_memory_.free(slivers_);
  memory.take(std::move(written_memory_));
  return loops;
}

/// Finds the boundary of a shape that leaks. First finds crossings that the tolerance hides, if
/// that is `finer` and not too much work; then closes thin parts.
Status find_closely(Context& context, const Contours& contours, const RegionRule& rule, bool finer,
                    Boundary& boundary) {
  if (finer) {
    const double tolerance = boundary.tolerance() / kFiner;
    TableMemory working(kBoundaryPurpose);
    Boundary crossings(context, tolerance, tolerance);
    Status status = crossings.find(contours, rule, Vertices::keep);
    if (status) {
      const Result<Contours> loops = crossings.take(working);
      return loops ? boundary.find(*loops, {}, Vertices::weld) : loops.status();
    }
    if (!is_too_intricate(status)) return status;
  }
  return boundary.find(contours, rule, Vertices::weld);
}

Result<Contours> region_boundary(Context& context, const Contours& contours, const RegionRule& rule,
                                 double tolerance, TableMemory* memory) {
  TableMemory own(kBoundaryPurpose);
  TableMemory& kept = memory ? *memory : own;
  bool finer = false;
  {
    Boundary boundary(context, tolerance, tolerance);
    Status status = boundary.find(contours, rule, Vertices::keep);
    if (status) {
      SFUMATO_TRY_ASSIGN(const bool leaks, boundary.leaks());
      if (!leaks) return boundary.take(kept);
      finer = boundary.chord_count() <= context.limits.chords / kFinerChords;
    } else if (!is_too_intricate(status)) {
      return status;
    }
  }
  // If parts nearly coincide, pieces may multiply until the vertices are welded.
  Boundary boundary(context, tolerance, finer ? tolerance / kFinerToClose : tolerance);
  SFUMATO_TRY(find_closely(context, contours, rule, finer, boundary));
  SFUMATO_TRY(boundary.stop_leaks());
  return boundary.take(kept);
}

}  // namespace

bool is_too_intricate(const Status& status) {
  return status.code == StatusCode::bad_input ||
         (status.code == StatusCode::limit &&
          (status.limit == "chords" || status.limit == "chord-pairs"));
}

Result<Contours> fill_boundary(Context& context, const Contours& contours, bool even_odd,
                               double tolerance, TableMemory* memory) {
  return region_boundary(context, contours, {.even_odd = even_odd}, tolerance, memory);
}

Result<Contours> combined_boundary(Context& context, RegionOperation operation,
                                   const FilledContours& first, const FilledContours& second,
                                   double tolerance, TableMemory* memory) {
  TableMemory working(kBoundaryPurpose);
  Contours both;
  SFUMATO_TRY(working.reserve(context, both, first.contours.size() + second.contours.size()));
  for (const Contours* contours : {&first.contours, &second.contours}) {
    for (const std::vector<Vec2>& contour : *contours) {
      SFUMATO_TRY(working.append(context, contour, both.emplace_back()));
    }
  }
  const RegionRule rule{.even_odd = first.even_odd,
                        .operation = operation,
                        .second = static_cast<std::uint32_t>(first.contours.size()),
                        .second_even_odd = second.even_odd};
  return region_boundary(context, both, rule, tolerance, memory);
}

}  // namespace sfumato::svg_import
