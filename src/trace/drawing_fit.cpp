#include "trace/drawing_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "trace/local_range.hpp"
#include "trace/prune.hpp"

namespace sfumato::tracing {
namespace {

/// BoundedProblem::tolerance: colours are rounded, and most are fitted several times.
constexpr double kTolerance = 3e-3;
/// Weights of the two regularisers of colours.
constexpr float kPull = 0.3f;
constexpr float kEven = 0.3f;
/// Added to the diagonal of the equations of radii, in shares of it and in all.
constexpr float kRadiusDamping = 0.3f;
constexpr float kRadiusPull = 1e-3f;
constexpr double kLeastFittedRadius = 0.4;
constexpr double kLargestFittedRadius = 24;
/// A step changes a radius by at most this, or by half of it.
constexpr double kRadiusStep = 0.7;
/// No bound.
constexpr float kAny = 1e3f;
/// As gather::RowOptions::negligible: while curves are still looked for, where colours that are a
/// little wrong change nothing that is kept, and in the end.
constexpr float kRoughlyNegligible = 1.5e-3f;
constexpr float kNegligible = 2e-4f;
/// Pixels, about, whose rows are there at once where all pixels are looked at.
constexpr int kBandPixels = 16384;
/// An error that nobody sees, in code values.
constexpr double kUnseenError = 0.5 / 255;
/// Leaving out a share of the stops may add so many times this share to the squared error.
constexpr double kPruneCost = 0.5;
/// Where nothing is seen of a pixel, its colour still counts a little.
constexpr float kLeastWeight = 1e-3f;

double weighted_mean_square(std::span<const FourFloats> residual, std::span<const float> stands_for,
                            std::span<const float> weight) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c) square += double{residual[i][c]} * residual[i][c];
    sum += square * stands_for[i] * (weight.empty() ? 1.0 : double{weight[i]});
    count += 3.0 * stands_for[i];
  }
  return count > 0 ? sum / count : 0.0;
}

double decibels(double square) {
  constexpr double kMost = 100;
  return square > 0 ? std::min(-10 * std::log10(square), kMost) : kMost;
}

std::vector<float> diagonal_of(const SparseMatrix& matrix) {
  std::vector<float> diagonal(matrix.row_count());
  for (std::uint32_t i = 0; i < matrix.row_count(); ++i) {
    for (std::uint32_t k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k) {
      if (matrix.column[k] == i) diagonal[i] = matrix.value[k];
    }
  }
  return diagonal;
}

}  // namespace

Status DrawingFit::prepare(std::span<const TracedCurve> curves, double one_in, std::uint64_t seed) {
  // What was gathered before goes first: the most that is taken at once counts.
  seen_.reset();
  matrix_.reset();
  const int width = picture_.width(), height = picture_.height();
  Result<PixelMarks> marks = mark_curves(context_, width, height, curves);
  if (!marks) return marks.status();
  marks_ = std::move(*marks);
  Result<SamplePixels> pixels = choose_pixels(context_, *marks_, {one_in, seed, 0, height});
  if (!pixels) return pixels.status();
  mesh_.reset();
  Result<CurveMesh> mesh = CurveMesh::build(context_, curves, width, height);
  if (!mesh) return mesh.status();
  mesh_ = std::move(*mesh);
  Result<PixelRows> seen = mesh_->gather(context_, std::move(*pixels), kRoughlyNegligible);
  if (!seen) return seen.status();
  seen_ = std::move(*seen);
  list_neighbours(curves);
  targets_ = {};
  return find_targets(seen_->pixels.pixel, targets_);
}

void DrawingFit::list_neighbours(std::span<const TracedCurve> curves) {
  has_next_.clear();
  ties_.clear();
  for (const TracedCurve& curve : curves) {
    for (const SideStops& side : curve.side) {
      const auto first = static_cast<std::uint32_t>(has_next_.size());
      const auto count = static_cast<std::uint32_t>(side.place.size());
      if (is_closed(curve) && count > 1) ties_.push_back({first, first + count - 1});
      for (std::size_t i = 0; i < side.place.size(); ++i) {
        // Two stops at one place are a step.
        has_next_.push_back(i + 1 < side.place.size() && side.place[i] < side.place[i + 1]);
      }
    }
  }
}

Status DrawingFit::find_targets(std::span<const std::uint32_t> pixels, Targets& targets) const {
  Status status = targets.memory.reserve(context_, targets.value, pixels.size());
  if (status && picture_.opacity) {
    status = targets.memory.reserve(context_, targets.weight, pixels.size());
  }
  if (!status) return status;
  RarePoll<65536> poll(context_);
  for (const std::uint32_t i : pixels) {
    if (poll.cancelled()) return context_.cancel_status();
    FourFloats value{};
    for (std::size_t c = 0; c < 3; ++c) value[c] = picture_.code[c].value[i];
    value[3] = picture_.opacity ? picture_.opacity->value[i] : 1.0f;
    targets.value.push_back(value);
    if (picture_.opacity) targets.weight.push_back(std::max(value[3] * value[3], kLeastWeight));
  }
  return context_.check();
}

Status DrawingFit::add(const SparseMatrix& rows, const Targets& targets, Equations& equations) {
  Status status = add_pixels(context_, {rows, targets.value, targets.weight}, equations.color);
  if (status && picture_.opacity) {
    status = add_pixels(context_, {rows, targets.value, {}}, equations.opacity);
  }
  return status;
}

Status DrawingFit::solve(const Equations& equations, std::span<TracedCurve> curves) {
  const Result<ValueBounds> bounds = bounds_near(context_, picture_, curves);
  if (!bounds) return bounds.status();
  std::vector<FourFloats> x = values_of(curves);
  const std::vector<float> pull(x.size(), kPull);
  const auto solve_one = [&](const ValueEquations& of, std::vector<FourFloats>& values) {
    return solve_bounded(context_,
                         {of.normal, of.right_side, has_next_, bounds->low, bounds->high, pull,
                          kEven, ties_, kTolerance},
                         values);
  };
  Status status;
  if (picture_.opacity) {
    std::vector<FourFloats> opacities = x;
    status = solve_one(equations.opacity, opacities);
    if (status) status = solve_one(equations.color, x);
    for (std::size_t i = 0; i < x.size(); ++i) x[i][3] = opacities[i][3];
  } else {
    status = solve_one(equations.color, x);
  }
  if (!status) return status;
  for (const Tie& tie : ties_) x[tie.second] = x[tie.first];
  std::size_t at = 0;
  for (TracedCurve& curve : curves) {
    for (SideStops& side : curve.side) {
      for (SideValue& value : side.value) value = x[at++];
    }
  }
  return status;
}

Status DrawingFit::build_matrix(std::span<const TracedCurve> curves) {
  matrix_.reset();
  Result<SparseMatrix> matrix = value_rows(context_, *seen_, curves);
  if (!matrix) return matrix.status();
  matrix_ = std::move(*matrix);
  return ok_status();
}

Status DrawingFit::take_values(std::span<const TracedCurve> curves) {
  Status status = build_matrix(curves);
  return status ? find_residual(values_of(curves)) : status;
}

Status DrawingFit::fit_values(std::span<TracedCurve> curves) {
  Equations equations;
  Status status = build_matrix(curves);
  if (status) status = add(*matrix_, targets_, equations);
  if (status) status = solve(equations, curves);
  return status ? find_residual(values_of(curves)) : status;
}

Status DrawingFit::find_residual(std::span<const FourFloats> x) {
  residual_.resize(targets_.value.size());
  Status status = multiply(context_, *matrix_, x, residual_);
  if (!status) return status;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) residual_[i][c] = targets_.value[i][c] - residual_[i][c];
  }
  psnr_db_ = decibels(weighted_mean_square(residual_, seen_->pixels.stands_for, targets_.weight));
  return status;
}

Status DrawingFit::for_each_band(std::span<const TracedCurve> curves, float negligible,
                                 FunctionRef<Status(const PixelRows&, const SparseMatrix&)> visit) {
  const int height = picture_.height();
  const int rows_at_once = std::max(1, kBandPixels / picture_.width());
  Status status;
  for (int y = 0; y < height && status; y += rows_at_once) {
    Result<SamplePixels> pixels =
        choose_pixels(context_, *marks_, {1, 0, y, std::min(y + rows_at_once, height)});
    if (!pixels) return pixels.status();
    const Result<PixelRows> seen = mesh_->gather(context_, std::move(*pixels), negligible);
    if (!seen) return seen.status();
    const Result<SparseMatrix> rows = value_rows(context_, *seen, curves);
    status = rows ? visit(*seen, *rows) : rows.status();
  }
  return status;
}

Status DrawingFit::fit_to_all(std::span<TracedCurve> curves, double share, int times) {
  seen_.reset();
  matrix_.reset();
  // Radii have changed since prepare(), and with them which curves are sharp.
  Result<PixelMarks> marks = mark_curves(context_, picture_.width(), picture_.height(), curves);
  if (!marks) return marks.status();
  marks_ = std::move(*marks);
  Equations equations;
  Status status =
      for_each_band(curves, kNegligible, [&](const PixelRows& seen, const SparseMatrix& rows) {
        Targets targets;
        Status found = find_targets(seen.pixels.pixel, targets);
        return found ? add(rows, targets, equations) : found;
      });
  if (status) status = solve(equations, curves);
  for (; times > 0 && status; --times) {
    status = prune(curves, share, equations);
    if (status) status = solve(equations, curves);
  }
  if (!status) return status;
  const Result<double> square = mean_square(context_, equations.color, values_of(curves));
  if (!square) return square.status();
  psnr_db_ = decibels(*square);
  return ok_status();
}

Result<double> DrawingFit::squared_error(const Equations& equations,
                                         std::span<const FourFloats> x) {
  const auto color = squared_errors(context_, equations.color, x);
  if (!color) return color.status();
  double sum = (*color)[0] + (*color)[1] + (*color)[2];
  if (!picture_.opacity) return sum;
  const auto opacity = squared_errors(context_, equations.opacity, x);
  if (!opacity) return opacity.status();
  return sum + (*opacity)[3];
}

Status DrawingFit::prune(std::span<TracedCurve> curves, double share, Equations& equations) {
  const std::vector<float> color_weight = diagonal_of(equations.color.normal);
  const std::vector<float> opacity_weight =
      picture_.opacity ? diagonal_of(equations.opacity.normal) : std::vector<float>{};
  const Result<double> error = squared_error(equations, values_of(curves));
  if (!error) return error.status();
  const double unseen = 3 * kUnseenError * kUnseenError * equations.color.weight;
  const PruneLimits limits{share, kPruneCost * share * std::max(*error, unseen)};
  const std::vector<std::uint8_t> goes =
      stops_to_prune(curves, {color_weight, opacity_weight}, limits);
  const Result<SparseMatrix> values = values_without(context_, curves, goes);
  if (!values) return values.status();
  Equations left;
  Result<ValueEquations> color = reduced(context_, equations.color, *values);
  if (!color) return color.status();
  left.color = std::move(*color);
  if (picture_.opacity) {
    Result<ValueEquations> opacity = reduced(context_, equations.opacity, *values);
    if (!opacity) return opacity.status();
    left.opacity = std::move(*opacity);
  }
  equations = std::move(left);
  prune_stops(goes, curves);
  list_neighbours(curves);
  return ok_status();
}

Status DrawingFit::fit_radii(std::span<TracedCurve> curves) {
  std::vector<float> weight;
  for (const float square : targets_.weight) weight.push_back(std::sqrt(square));
  const Result<SparseMatrix> rows = radius_rows(context_, *seen_, curves, weight);
  if (!rows) return rows.status();
  const Result<SparseMatrix> transpose = transposed(context_, *rows);
  if (!transpose) return transpose.status();
  const Result<SparseMatrix> normal = normal_matrix(context_, *rows, *transpose, {});
  if (!normal) return normal.status();
  std::vector<FourFloats> missing(rows->row_count());
  for (std::size_t i = 0; i < missing.size(); ++i) {
    missing[i][0] = (weight.empty() ? 1.0f : weight[i / 3]) * residual_[i / 3][i % 3];
  }
  std::vector<FourFloats> right_side(curves.size()), step(curves.size());
  Status status = multiply(context_, *transpose, missing, right_side);
  if (!status) return status;
  std::vector<float> pull = diagonal_of(*normal);
  for (float& own : pull) own = kRadiusDamping * own + kRadiusPull;
  const std::vector<std::uint8_t> no_next(curves.size());
  const std::vector<FourFloats> low(curves.size(), {-kAny}), high(curves.size(), {kAny});
  status = solve_bounded(context_, {*normal, right_side, no_next, low, high, pull, 0, {}}, step);
  if (!status) return status;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].is_frame) continue;
    const double most = std::max(0.5 * curves[i].radius, kRadiusStep);
    const double radius = curves[i].radius + std::clamp(double{step[i][0]}, -most, most);
    curves[i].radius = std::clamp(radius, kLeastFittedRadius, kLargestFittedRadius);
  }
  return ok_status();
}

}  // namespace sfumato::tracing
