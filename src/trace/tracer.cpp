#include "trace/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "trace/blur_estimate.hpp"
#include "trace/candidates.hpp"
#include "trace/drawing.hpp"
#include "trace/missing.hpp"
#include "trace/shape.hpp"
#include "trace/side_colors.hpp"
#include "trace/snap.hpp"
#include "trace/texture.hpp"
#include "trace/untangle.hpp"

namespace sfumato::tracing {
namespace {

/// Shares of the control points: of all for the picture's own edges, of what is left for a round.
constexpr double kFirstShare = 0.3;
constexpr double kRoundShare = 0.5;
/// Rounds of edges of what is missing.
constexpr int kMissingRounds = 4;
/// Fewer control points than this make no curve worth having.
constexpr std::size_t kLeastPoints = 20;
/// Colours along a side, Euclidean in sRGB code values.
constexpr double kStopTolerance = 0.02;
/// How far curves may be from edges of usual strength, pixels times √scale.
constexpr double kEdgeTolerance = 1.2;
constexpr double kMissingTolerance = 2.2;
/// The finest scales, pixels, of edges of the picture and of what is missing. In drawn pictures
/// finer edges are edges.
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
/// How often ends are snapped and curves untangled again: fitted colours tell what leaks.
constexpr int kTidyings = 5;
/// What is told of as progress: the picture's edges, each round, and of the end the first fit, each
/// tidying and the last fit.
constexpr int kProgressSteps = 1 + (kMissingRounds + 1) + 1 + kTidyings + 1;
/// Stops pruned at a time, and how often.
constexpr double kPruneShare = 0.18;
constexpr int kPruneNormal = 2;
constexpr int kPruneFew = 5;

double pixel_count(const Picture& picture) {
  return static_cast<double>(picture.width()) * picture.height();
}

int prune_count(TraceStops stops) {
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
  Status status = begin();
  if (status) status = add_edges_of_picture();
  if (status && options_.watch) options_.watch->reached(state(0), drawing());
  tell_progress(1);
  if (status) status = fit();
  if (status) note(0);
  for (int round = 1; round <= kMissingRounds && status && goes_on(); ++round) {
    status = find_missing(context_, *picture_, curves_, memory_, missing_);
    if (status) status = improve_shapes();
    if (status) status = add_edges_of_missing(round);
    if (status) status = fit();
    if (status) note(round);
    tell_progress(2 + round);
  }
  if (status) status = finish();
  if (!status) return status;
  note(stats_.rounds.back().round);
  tell_progress(kProgressSteps);
  measure_curves();
  return finished_drawing();
}

Status Tracer::begin() {
  Result<Picture> picture = look_at(context_, image_, options_.max_side, options_.has_opacity);
  if (!picture) return picture.status();
  picture_ = std::move(*picture);
  fit_.emplace(context_, *picture_);
  stats_.scale = picture_->scale;
  constexpr double kUsualPoints = 2000, kUsualPixels = 640.0 * 480.0;
  budget_ = options_.points > 0
                ? static_cast<std::size_t>(options_.points)
                : static_cast<std::size_t>(
                      std::lround(kUsualPoints * std::sqrt(pixel_count(*picture_) / kUsualPixels)));
  curves_.push_back(frame_of(picture_->width(), picture_->height()));
  return sample_sides(context_, *picture_, kStopTolerance, curves_);
}

Status Tracer::add_edges_of_picture() {
  TableMemory memory("the edges of a picture");
  std::vector<Plane> planes(3);
  Channels oklab;
  Status status = to_oklab(context_, picture_->code, memory, oklab);
  if (!status) return status;
  std::ranges::move(oklab, planes.begin());
  const Result<Noise> noise = estimate_noise(context_, planes[0]);
  if (!noise) return noise.status();
  stats_.noise = noise->deviation;
  is_drawn_ = noise->is_drawn;
  if (picture_->opacity) planes.push_back(*picture_->opacity);
  EdgeOptions edges;
  edges.scales =
      scales_from(std::max(finest_scales(is_drawn_).edge, options_.smooth_px * picture_->scale));
  edges.noise = stats_.noise;
  return add(planes, planes, edges, kEdgeTolerance, kFirstShare * static_cast<double>(budget_));
}

Status Tracer::add_edges_of_missing(int round) {
  const std::size_t left = budget_ - std::min(budget_, point_count());
  if (left < kLeastPoints) return ok_status();
  EdgeOptions edges;
  edges.scales =
      scales_from(std::max(finest_scales(is_drawn_).missing, options_.smooth_px * picture_->scale));
  edges.high = 0.015;
  edges.noise = 0.5 * stats_.noise;
  const double share = round == kMissingRounds ? 1.0 : kRoundShare;
  return add(missing_, picture_->code, edges, kMissingTolerance, share * static_cast<double>(left));
}

/// Curves along edges of some planes, whose blur shows in others.
Status Tracer::add(std::span<const Plane> edges, std::span<const Plane> blurred,
                   const EdgeOptions& options, double tolerance, double budget) {
  TableMemory memory("curves along edges");
  Result<std::vector<TracedCurve>> candidates =
      find_candidates(context_, edges, options, tolerance, curves_, memory);
  if (!candidates) return candidates.status();
  Result<std::vector<TracedCurve>> chosen = choose_curves(
      context_, std::move(*candidates), picture_->width(), picture_->height(),
      {static_cast<std::size_t>(budget), curve_limit() - curves_.size()}, curves_, memory);
  if (!chosen) return chosen.status();
  Status status;
  if (options_.blur != TraceBlur::sharp) status = estimate_blur(context_, blurred, *chosen);
  for (TracedCurve& curve : *chosen) curve.seen_radius = curve.radius;
  if (status) status = sample_sides(context_, *picture_, kStopTolerance, *chosen);
  for (TracedCurve& curve : *chosen) curves_.push_back(std::move(curve));
  return status ? charge_curves() : status;
}

Status Tracer::improve_shapes() {
  return tracing::improve_shapes(context_, missing_, curves_);
}

Status Tracer::fit() {
  Status status = prepare_fit();
  if (status) status = fit_->fit_values(curves_);
  return status ? improve_radii() : status;
}

/// Of curves most of which have fitted colours: radii come first.
Status Tracer::fit_again() {
  Status status = prepare_fit();
  if (!status) return status;
  if (!fits_radii()) return fit_->fit_values(curves_);
  status = fit_->take_values(curves_);
  return status ? improve_radii() : status;
}

/// To the most that they have had.
Status Tracer::charge_curves() {
  return curves_charge_.raise_to(context_, bytes_of(curves_), "the curves of a trace");
}

Status Tracer::prepare_fit() {
  if (Status status = charge_curves(); !status) return status;
  for (TracedCurve& curve : curves_) {
    if (fits_radii() && !curve.is_frame) curve.radius = std::max(curve.radius, kFirstRadius);
  }
  const double one_in = std::max(1.0, pixel_count(*picture_) / kFittedPixels);
  return fit_->prepare(curves_, one_in, options_.seed);
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
  tell_progress(1 + (kMissingRounds + 1) + 1);
  for (int pass = 0; pass < kTidyings && status; ++pass) {
    const Result<bool> is_changed = tidy();
    if (!is_changed) return is_changed.status();
    if (!*is_changed) break;
    status = fit_again();
    tell_progress(1 + (kMissingRounds + 1) + 2 + pass);
  }
  forget_blur();
  return status ? fit_->fit_to_all(curves_, kPruneShare, prune_count(options_.stops)) : status;
}

Status Tracer::snap(float leak) {
  return snap_to_curves(context_, picture_->width(), picture_->height(), leak, curves_);
}

/// Mends what shows since colours were fitted.
Result<bool> Tracer::tidy() {
  const std::vector<Vec2> before = ends_of(curves_);
  const std::size_t stops = stop_count();
  Status status = snap(kShowingLeak);
  if (!status) return status;
  const bool is_snapped = stops != stop_count() || is_elsewhere(before, ends_of(curves_));
  const Result<bool> is_cut = untangle(context_, picture_->width(), picture_->height(), curves_);
  if (!is_cut || !*is_cut) return is_cut ? is_snapped : is_cut;
  drop_excess();
  for (TracedCurve& curve : curves_) {
    if (!curve.side[0].place.empty() || !curve.side[1].place.empty()) continue;
    status = sample_sides(context_, *picture_, kStopTolerance, std::span(&curve, 1));
    if (!status) return status;
  }
  return true;
}

/// What is cut has more curves and control points.
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

bool Tracer::goes_on() const {
  if (options_.edges_only || curves_.size() >= curve_limit()) return false;
  if (options_.max_seconds > 0 && watch_.seconds() > options_.max_seconds) return false;
  if (options_.psnr_db > 0 && fit_->psnr_db() >= options_.psnr_db) return false;
  return point_count() + kLeastPoints <= budget_;
}

std::size_t Tracer::point_count() const {
  std::size_t sum = 0;
  for (const TracedCurve& curve : curves_) sum += curve.control_points.size();
  return sum;
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
  Status status = add_texture(context_, *picture_, finished, psnr_db);
  if (!status) return status;
  stats_.textured_psnr_db = psnr_db;
  return finished;
}

Document Tracer::drawing() const {
  // A picture that is looked at smaller has whole pixels, too: by one scale for both sides the
  // frame would end inside the artboard, or beyond.
  const Vec2 size{static_cast<double>(image_.width), static_cast<double>(image_.height)};
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
