#include "trace/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "base/try.hpp"
#include "trace/curves/candidates.hpp"
#include "trace/curves/drawing.hpp"
#include "trace/curves/shape.hpp"
#include "trace/curves/side_colors.hpp"
#include "trace/curves/snap.hpp"
#include "trace/curves/thin_strokes.hpp"
#include "trace/curves/untangle.hpp"
#include "trace/image/blur_estimate.hpp"
#include "trace/image/missing.hpp"
#include "trace/image/texture.hpp"

namespace sfumato::tracing {
namespace {

/// Shares of the control points: of all for the picture's own edges, of the remaining ones for a
/// round.
constexpr double kFirstShare = 0.3;
constexpr double kRoundShare = 0.5;
/// Rounds with edges of the missing part.
constexpr int kMissingRounds = 4;
/// Fewer control points than this make no curve worth having.
constexpr std::size_t kLeastPoints = 20;
/// Colours along a side, Euclidean in sRGB code values.
constexpr double kStopTolerance = 0.02;
/// How far curves may be from edges of usual strength, pixels times √scale.
constexpr double kEdgeTolerance = 1.2;
constexpr double kMissingTolerance = 2.2;
/// The finest scales, pixels, of edges of the picture and of the missing part. In drawn pictures
/// finer edges count too.
struct FinestScales {
  double edge, missing;
};
constexpr FinestScales kTakenScales{1, 2};
constexpr FinestScales kDrawnScales{0.7, 1};
/// A little blur that is fitted to an edge of a drawn picture hides how its curve misses it, where
/// the edge itself looks sharp.
constexpr double kDrawnSharpRadius = 1.2;
/// With less blur a curve's radius does not show in its derivative.
constexpr double kFirstRadius = 1;
/// Sides of an end that differ less in every channel leak nothing that shows, and nothing that is
/// worth another fit.
constexpr float kLeak = 0.08f;
constexpr float kShowingLeak = 0.15f;
/// An end that moves less, pixels, changes nothing that shows.
constexpr double kMoved = 0.05;
/// How often ends are snapped and curves untangled again: fitted colours show which gaps leak.
constexpr int kTidyings = 5;
/// The steps of progress: the picture's edges, each round, and, at the end, the first fit, each
/// tidying and the last fit.
constexpr int kProgressSteps = 1 + (kMissingRounds + 1) + 1 + kTidyings + 1;
/// How often curves of a picture with opacity move once more in the end: an outline on clear ground
/// shows where it is off.
constexpr int kOpacityPasses = 3;
/// A drawn picture with a larger share of its edges along thin strokes is a page of strokes, for
/// example of text: its curves lie side by side, and are short and many. If the control points
/// suffice for all, curves follow their edges closely. Otherwise they begin farther from their
/// edges, and move more than the curves of other pictures.
constexpr double kStrokeShare = 0.7;
constexpr double kFineSlack = 0.7;
constexpr double kScarceSlack = 2;
constexpr double kScarceFirstShare = 0.4;
constexpr double kStrokeClear = 0.5;
constexpr double kStrokePrice = 2;
constexpr ShapeOptions kStrokeShape{1, 6};
constexpr int kStrokePasses = 4;
/// TraceStats::points_needed is a multiple of this.
constexpr std::size_t kNeededStep = 100;
/// Stops pruned at a time, and how often.
constexpr double kPruneShare = 0.18;
constexpr int kPruneNormal = 2;
constexpr int kPruneFew = 5;

/// Control points of a picture that are usual.
constexpr double kUsualPoints = 2000;
constexpr double kUsualPixels = 640.0 * 480.0;
/// Stops for each control point that may be used, so that few curves have few colours. For the
/// frame too, at least this many and a share of the control points.
constexpr std::size_t kStopsPerPoint = 8;
constexpr std::size_t kFrameStops = 250;
constexpr std::size_t kFramePoints = 4;
/// Pixels to fit to for each control point, in a round and in the end: with the usual number all
/// are taken in the end. And how much the equations may cost.
constexpr double kRoundPixels = 100;
constexpr double kLeastRoundPixels = kFittedPixels / 4;
constexpr double kLastPixels = 300;
constexpr double kRoundProducts = 1e6;
constexpr double kLastProducts = 4e6;
constexpr double kLeastBudget = 100;

double pixel_count(const Picture& picture) {
  return static_cast<double>(picture.width()) * picture.height();
}

std::size_t usual_points(const Picture& picture) {
  return static_cast<std::size_t>(
      std::lround(kUsualPoints * std::sqrt(pixel_count(picture) / kUsualPixels)));
}

/// Along strokes a stop bears more than elsewhere.
int prune_count(TraceStops stops, bool has_strokes) {
  if (has_strokes && stops == TraceStops::normal) return 0;
  switch (stops) {
    case TraceStops::few:
      return kPruneFew;
    case TraceStops::normal:
      return kPruneNormal;
    case TraceStops::many:
      break;
  }
  return 0;
}

std::vector<Vec2> ends_of(std::span<const TracedCurve> curves) {
  std::vector<Vec2> ends;
  for (const TracedCurve& curve : curves) {
    ends.insert(ends.end(), {curve.control_points.front(), curve.control_points.back()});
  }
  return ends;
}

std::size_t points_of(std::span<const TracedCurve> curves) {
  std::size_t sum = 0;
  for (const TracedCurve& curve : curves) sum += curve.control_points.size();
  return sum;
}

bool is_elsewhere(std::span<const Vec2> before, std::span<const Vec2> after) {
  return !std::ranges::equal(before, after, [](Vec2 a, Vec2 b) { return length(a - b) < kMoved; });
}

const FinestScales& finest_scales(bool is_drawn) {
  return is_drawn ? kDrawnScales : kTakenScales;
}

std::vector<double> scales_from(double finest) {
  return {finest, 2 * finest, 4 * finest};
}

}  // namespace

Result<Document> Tracer::run() {
  Status status = run_rounds();
  if (!status && status.limit == "time" && kept_) return kept_drawing();
  if (!status) return status;
  note(stats_.rounds.back().round);
  tell_progress(kProgressSteps);
  measure_curves();
  return finished_drawing();
}

Status Tracer::run_rounds() {
  Status status = begin();
  if (status) status = add_edges_of_picture();
  if (status && options_.watch) options_.watch->reached(state(0), drawing());
  tell_progress(1);
  if (status) status = fit();
  if (status) status = keep();
  if (status) note(0);
  for (int round = 1; round <= kMissingRounds && status && goes_on(); ++round) {
    status = find_missing(context_, *picture_, curves_, memory_, missing_);
    if (status) status = improve_shapes();
    if (status) status = add_edges_of_missing(round);
    if (status) status = fit();
    if (status) status = keep();
    if (status) note(round);
    tell_progress(2 + round);
  }
  return status ? finish() : status;
}

/// Keeps a copy of the curves as they are.
Status Tracer::keep() {
  if (!context_.deadline && !context_.outer) return ok_status();
  kept_.reset();
  kept_.emplace();
  SFUMATO_TRY(kept_->charge.add(context_, bytes_of(curves_), "the curves of a trace"));
  kept_->curves = curves_;
  return ok_status();
}

/// Returns the drawing of the last round that ended. Ignores the deadline.
Result<Document> Tracer::kept_drawing() {
  curves_ = std::move(kept_->curves);
  forget_blur();
  stats_.ended_early = true;
  TraceState last = stats_.rounds.back();
  last.seconds = watch_.seconds();
  stats_.rounds.push_back(last);
  if (options_.watch) options_.watch->reached(last, drawing());
  measure_curves();
  return drawing();
}

Status Tracer::begin() {
  SFUMATO_TRY_ASSIGN(picture_, look_at(context_, image_, options_.max_side, options_.has_opacity));
  picture_->scale *= static_cast<double>(image_.width) / width_;
  fit_.emplace(context_, *picture_);
  stats_.scale = picture_->scale;
  budget_ =
      options_.points > 0 ? static_cast<std::size_t>(options_.points) : usual_points(*picture_);
  curves_.push_back(frame_of(picture_->width(), picture_->height()));
  return sample_sides(context_, *picture_, kStopTolerance,
                      std::max(kFrameStops, budget_ / kFramePoints), curves_);
}

/// Returns the number of additional stops that curves may have.
std::size_t Tracer::stops_left() const {
  const std::size_t most = kStopsPerPoint * std::max(budget_, kFrameStops);
  return most - std::min(most, stop_count());
}

FitBudget Tracer::round_budget() const {
  const double points = std::max(static_cast<double>(budget_), kLeastBudget);
  return {std::clamp(kRoundPixels * points, kLeastRoundPixels, kFittedPixels),
          kRoundProducts * points};
}

FitBudget Tracer::last_budget() const {
  const double points = std::max(static_cast<double>(budget_), kLeastBudget);
  const double pixels =
      budget_ >= usual_points(*picture_) ? pixel_count(*picture_) : kLastPixels * points;
  return {std::max(pixels, kFittedPixels), kLastProducts * points};
}

Status Tracer::add_edges_of_picture() {
  TableMemory memory("the edges of a picture");
  std::vector<Plane> planes(3);
  Channels oklab;
  SFUMATO_TRY(to_oklab(context_, picture_->code, memory, oklab));
  std::ranges::move(oklab, planes.begin());
  SFUMATO_TRY_ASSIGN(const Noise& noise, estimate_noise(context_, planes[0]));
  stats_.noise = noise.deviation;
  is_drawn_ = noise.is_drawn;
  if (picture_->opacity) planes.push_back(*picture_->opacity);
  EdgeOptions edges;
  edges.scales =
      scales_from(std::max(finest_scales(is_drawn_).edge, options_.smooth_px * picture_->scale));
  edges.noise = stats_.noise;
  Candidates candidates;
  Status status = find(planes, edges, kEdgeTolerance, candidates);
  double share = kFirstShare;
  // A dense page of text has fewer flat pixels than other drawn pictures: still about half.
  const bool may_have_strokes = is_drawn_ || stats_.noise == 0;
  if (status && may_have_strokes) status = look_for_strokes(planes, edges, candidates, share);
  return status ? add(candidates, planes, share * static_cast<double>(budget_)) : status;
}

Status Tracer::add_edges_of_missing(int round) {
  const std::size_t left = budget_ - std::min(budget_, point_count());
  if (left < kLeastPoints) return ok_status();
  EdgeOptions edges;
  edges.scales =
      scales_from(std::max(finest_scales(is_drawn_).missing, options_.smooth_px * picture_->scale));
  edges.high = 0.015;
  edges.noise = 0.5 * stats_.noise;
  if (has_strokes_) edges.clear = kStrokeClear;
  const double share = round == kMissingRounds ? 1.0 : kRoundShare;
  Candidates candidates;
  Status status = find(missing_, edges, kMissingTolerance, candidates);
  return status ? add(candidates, picture_->code, share * static_cast<double>(left)) : status;
}

Status Tracer::find(std::span<const Plane> edges, const EdgeOptions& options, double tolerance,
                    Candidates& candidates) {
  tolerance *= slack_;
  SFUMATO_TRY_ASSIGN(candidates.curves, find_candidates(context_, edges, options, tolerance,
                                                        curves_, candidates.memory));
  return ok_status();
}

/// Replaces the candidates by curves for thin strokes, if most edges are sides of thin strokes.
/// share   the share of the control points for the picture's own edges
Status Tracer::look_for_strokes(std::span<const Plane> planes, const EdgeOptions& options,
                                Candidates& candidates, double& share) {
  SFUMATO_TRY_ASSIGN(const double of_strokes, stroke_share(context_, planes, candidates.curves));
  has_strokes_ = of_strokes > kStrokeShare;
  if (!has_strokes_) return ok_status();
  const std::size_t all = point_count() + points_of(candidates.curves);
  const bool is_enough = all <= budget_;
  share = is_enough ? 1 : kScarceFirstShare;
  slack_ = is_enough ? kFineSlack : kScarceSlack;
  if (!is_enough) stats_.points_needed = (all + kNeededStep - 1) / kNeededStep * kNeededStep;
  Candidates others;
  Status status = find(planes, options, kEdgeTolerance, others);
  const bool fits = !is_enough || point_count() + points_of(others.curves) <= budget_;
  if (!fits) slack_ = 1;
  if (status && fits) candidates = std::move(others);
  return status;
}

/// Adds the best candidates; their blur is estimated in the planes `blurred`.
Status Tracer::add(Candidates& candidates, std::span<const Plane> blurred, double budget) {
  std::vector<TracedCurve> chosen;
  Status status = choose(candidates, static_cast<std::size_t>(budget), chosen);
  if (status && options_.blur != TraceBlur::sharp) {
    status = estimate_blur(context_, blurred, chosen);
  }
  for (TracedCurve& curve : chosen) curve.seen_radius = curve.radius;
  if (status) status = sample_sides(context_, *picture_, kStopTolerance, stops_left(), chosen);
  for (TracedCurve& curve : chosen) curves_.push_back(std::move(curve));
  return status ? charge_curves() : status;
}

Status Tracer::choose(Candidates& candidates, std::size_t budget,
                      std::vector<TracedCurve>& chosen) {
  CurveBudget most{budget, curve_limit() - curves_.size()};
  if (has_strokes_) most.curve_price = kStrokePrice, most.apart = 0;
  SFUMATO_TRY_ASSIGN(chosen,
                     choose_curves(context_, std::move(candidates.curves), picture_->width(),
                                   picture_->height(), most, curves_, candidates.memory));
  return ok_status();
}

Status Tracer::improve_shapes() {
  return tracing::improve_shapes(context_, missing_, curves_,
                                 has_strokes_ ? kStrokeShape : ShapeOptions());
}

Status Tracer::fit() {
  Status status = prepare_fit();
  if (status) status = fit_->fit_values(curves_);
  return status ? improve_radii() : status;
}

/// Fits curves that mostly have fitted colours already; radii come first.
Status Tracer::fit_again() {
  SFUMATO_TRY(prepare_fit());
  if (!fits_radii()) return fit_->fit_values(curves_);
  Status status = fit_->take_values(curves_);
  return status ? improve_radii() : status;
}

/// To the most that they have had.
Status Tracer::charge_curves() {
  return curves_charge_.raise_to(context_, bytes_of(curves_), "the curves of a trace");
}

Status Tracer::prepare_fit() {
  SFUMATO_TRY(charge_curves());
  for (TracedCurve& curve : curves_) {
    if (fits_radii() && !curve.is_frame) curve.radius = std::max(curve.radius, kFirstRadius);
  }
  return fit_->prepare(curves_, round_budget(), options_.seed);
}

/// And then the colours, which depend on them.
Status Tracer::improve_radii() {
  if (!fits_radii()) return ok_status();
  Status status = fit_->fit_radii(curves_);
  return status ? fit_->fit_values(curves_) : status;
}

Status Tracer::finish() {
  Status status;
  if (!options_.edges_only) {
    status = find_missing(context_, *picture_, curves_, memory_, missing_);
    if (status) status = improve_shapes();
  }
  if (status) status = snap(kLeak);
  if (status) status = fit();
  if (status && !options_.edges_only) status = improve_outlines();
  tell_progress(1 + (kMissingRounds + 1) + 1);
  for (int pass = 0; pass < kTidyings && status && !stats_.ended_early; ++pass) {
    SFUMATO_TRY_ASSIGN(const bool is_changed, tidy());
    if (!is_changed) break;
    status = fit_again();
    tell_progress(1 + (kMissingRounds + 1) + 2 + pass);
  }
  forget_blur();
  if (!status) return status;
  return fit_->fit_to_all(curves_, last_budget(), options_.seed, kPruneShare,
                          prune_count(options_.stops, has_strokes_));
}

/// Moves curves again after their ends were led to others, which moved the curves, too.
Status Tracer::improve_outlines() {
  const int strokes = has_strokes_ ? kStrokePasses : 0;
  const int passes = picture_->opacity ? std::max(kOpacityPasses, strokes) : strokes;
  for (int pass = 0; pass < passes && !stats_.ended_early; ++pass) {
    SFUMATO_TRY(find_missing(context_, *picture_, curves_, memory_, missing_));
    SFUMATO_TRY(improve_shapes());
    SFUMATO_TRY(snap(kLeak));
    SFUMATO_TRY(fit());
  }
  return ok_status();
}

Status Tracer::snap(float leak) {
  return snap_to_curves(context_, picture_->width(), picture_->height(),
                        {leak, picture_->opacity.has_value()}, curves_);
}

/// Fixes faults that show since colours were fitted.
Result<bool> Tracer::tidy() {
  const std::vector<Vec2> before = ends_of(curves_);
  const std::size_t stops = stop_count();
  SFUMATO_TRY(snap(kShowingLeak));
  const bool is_snapped = stops != stop_count() || is_elsewhere(before, ends_of(curves_));
  const Result<bool> is_cut = untangle(context_, picture_->width(), picture_->height(), curves_);
  if (!is_cut || !*is_cut) return is_cut ? is_snapped : is_cut;
  drop_excess();
  for (TracedCurve& curve : curves_) {
    if (!curve.side[0].place.empty() || !curve.side[1].place.empty()) continue;
    SFUMATO_TRY(
        sample_sides(context_, *picture_, kStopTolerance, stops_left(), std::span(&curve, 1)));
  }
  return true;
}

/// Cut curves are more, with more control points.
void Tracer::drop_excess() {
  while (point_count() > budget_ || curves_.size() > curve_limit()) {
    const auto least = std::ranges::min_element(curves_, {}, [](const TracedCurve& curve) {
      return curve.is_frame ? std::numeric_limits<double>::infinity()
                            : curve.benefit / static_cast<double>(curve.control_points.size());
    });
    if (least->is_frame) return;
    curves_.erase(least);
  }
}

void Tracer::forget_blur() {
  for (TracedCurve& curve : curves_) {
    const bool is_seen_sharp = is_drawn_ && curve.seen_radius < kSharpRadius;
    if (curve.radius < (is_seen_sharp ? kDrawnSharpRadius : kSharpRadius)) curve.radius = 0;
  }
}

bool Tracer::is_time_over() const {
  return options_.max_seconds > 0 && watch_.seconds() > options_.max_seconds;
}

bool Tracer::goes_on() {
  if (options_.edges_only || curves_.size() >= curve_limit()) return false;
  if (options_.psnr_db > 0 && fit_->psnr_db() >= options_.psnr_db) return false;
  if (point_count() + kLeastPoints > budget_) return false;
  if (is_time_over()) stats_.ended_early = true;
  return !stats_.ended_early;
}

std::size_t Tracer::point_count() const {
  return points_of(curves_);
}

std::size_t Tracer::stop_count() const {
  std::size_t sum = 0;
  for (const TracedCurve& curve : curves_) sum += tracing::stop_count(curve);
  return sum;
}

std::size_t Tracer::curve_limit() const {
  const std::size_t most = context_.limits.curves;
  return options_.max_curves > 0 ? std::min(most, static_cast<std::size_t>(options_.max_curves))
                                 : most;
}

void Tracer::measure_curves() {
  std::vector<double> lengths, benefits;
  double left = 0;
  for (const TracedCurve& curve : curves_) {
    if (curve.is_frame) continue;
    lengths.push_back(length_of(curve) / picture_->scale);
    benefits.push_back(curve.benefit);
    left += 0.9 * curve.benefit;
  }
  if (lengths.empty()) return;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  stats_.median_length_px = *middle;
  std::ranges::sort(benefits, std::greater());
  for (std::size_t i = 0; i < benefits.size() && left > 0; ++i) {
    left -= benefits[i];
    stats_.curves_of_nine_tenths = i + 1;
  }
}

Result<Document> Tracer::finished_drawing() {
  Document finished = drawing();
  if (!options_.has_texture) return finished;
  fit_.reset();  // the memory of its rows is free for the texture's
  double psnr_db = 0;
  SFUMATO_TRY(add_texture(context_, *picture_, finished, psnr_db));
  stats_.textured_psnr_db = psnr_db;
  return finished;
}

Document Tracer::drawing() const {
  // A picture that was scaled down also has whole pixels. With one scale for both sides the frame
  // would end inside the artboard, or beyond it.
  const Vec2 size{static_cast<double>(width_), static_cast<double>(height_)};
  const Vec2 unit_per_pixel{size.x / picture_->width(), size.y / picture_->height()};
  return drawing_of(curves_, size, unit_per_pixel, picture_->opacity.has_value());
}

TraceState Tracer::state(int round) const {
  TraceState state;
  state.round = round;
  state.round_count = options_.edges_only ? 1 : kMissingRounds + 1;
  state.curves = curves_.size();
  state.control_points = point_count();
  state.stops = stop_count();
  state.psnr_db = fit_->psnr_db();
  state.seconds = watch_.seconds();
  return state;
}

void Tracer::tell_progress(int steps) const {
  if (context_.progress) {
    context_.progress->report("trace", static_cast<double>(steps) / kProgressSteps);
  }
}

void Tracer::note(int round) {
  stats_.rounds.push_back(state(round));
  if (options_.watch) options_.watch->reached(stats_.rounds.back(), drawing());
}

}  // namespace sfumato::tracing
