#include "trace/fit/drawing_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "trace/fit/prune.hpp"
#include "trace/image/local_range.hpp"

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
/// The approximate number of pixels whose rows are in memory at once when all pixels are evaluated.
constexpr int kBandPixels = 16384;
/// An error that nobody sees, in code values.
constexpr double kUnseenError = 0.5 / 255;
/// Leaving out a share of the stops may add this many times the share to the squared error.
constexpr double kPruneCost = 0.5;
/// Where nothing is seen of a pixel, its colour still counts a little.
constexpr float kLeastWeight = 1e-3f;

/// Pixels by whose rows the cost of all is estimated.
constexpr double kTriedPixels = 1000;

/// Returns a pixel's squared difference: mean of its colours', weighted, and that of its opacity.
/// On the background where it shows most, opacity shows as much as a colour.
double squared_difference(const FourFloats& residual, double weight, bool has_opacity) {
  double square = 0;
  for (std::size_t c = 0; c < 3; ++c) square += double{residual[c]} * residual[c];
  square = square * weight / 3;
  return has_opacity ? square + double{residual[3]} * residual[3] : square;
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

/// Returns n for a fit to one of n pixels. A few pixels show how much work a pixel is.
Result<double> DrawingFit::one_in(std::span<const TracedCurve> curves, const FitBudget& budget,
                                  std::uint64_t seed, float negligible) {
  const int height = picture_.height();
  const double pixels = static_cast<double>(picture_.width()) * height;
  const double most = std::max(1.0, pixels / budget.pixels);
  if (pixels <= kTriedPixels) return most;
  SFUMATO_TRY_ASSIGN(auto&& tried,
                     choose_pixels(context_, *marks_, {pixels / kTriedPixels, seed, 0, height}));
  SFUMATO_TRY_ASSIGN(const PixelRows& seen, mesh_->gather(context_, std::move(tried), negligible));
  SFUMATO_TRY_ASSIGN(const SparseMatrix& rows, value_rows(context_, seen, curves));
  double products = 0;
  for (std::uint32_t i = 0; i < rows.row_count(); ++i) {
    const double entries = rows.begin[i + 1] - rows.begin[i];
    products += 0.5 * entries * entries;
  }
  const double mean = products / std::max<double>(rows.row_count(), 1);
  return std::max(most, mean * pixels / budget.products);
}

Status DrawingFit::prepare(std::span<const TracedCurve> curves, const FitBudget& budget,
                           std::uint64_t seed) {
  // Frees the earlier rows first, because the largest amount of memory at one time counts.
  seen_.reset();
  matrix_.reset();
  const int width = picture_.width(), height = picture_.height();
  SFUMATO_TRY_ASSIGN(marks_, mark_curves(context_, width, height, curves));
  mesh_.reset();
  SFUMATO_TRY_ASSIGN(mesh_, CurveMesh::build(context_, curves, width, height));
  SFUMATO_TRY_ASSIGN(const double one_in, this->one_in(curves, budget, seed, kRoughlyNegligible));
  SFUMATO_TRY_ASSIGN(auto&& pixels, choose_pixels(context_, *marks_, {one_in, seed, 0, height}));
  SFUMATO_TRY_ASSIGN(seen_, mesh_->gather(context_, std::move(pixels), kRoughlyNegligible));
  list_neighbours(curves);
  targets_ = {};
  return find_targets(seen_->pixels, false, targets_);
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

/// is_sampled   whether a pixel counts for all pixels that it represents
Status DrawingFit::find_targets(const SamplePixels& pixels, bool is_sampled,
                                Targets& targets) const {
  const std::size_t count = pixels.pixel.size();
  const bool has_opacity = picture_.opacity.has_value();
  SFUMATO_TRY(targets.memory.reserve(context_, targets.value, count));
  if (has_opacity || is_sampled) {
    SFUMATO_TRY(targets.memory.reserve(context_, targets.weight, count));
  }
  if (has_opacity && is_sampled) {
    SFUMATO_TRY(targets.memory.append(context_, pixels.stands_for, targets.opacity_weight));
  }
  RarePoll<65536> poll(context_);
  for (std::size_t k = 0; k < count; ++k) {
    if (poll.cancelled()) return context_.cancel_status();
    const std::uint32_t i = pixels.pixel[k];
    FourFloats value{};
    for (std::size_t c = 0; c < 3; ++c) value[c] = picture_.code[c].value[i];
    value[3] = has_opacity ? picture_.opacity->value[i] : 1.0f;
    targets.value.push_back(value);
    if (!has_opacity && !is_sampled) continue;
    const float shown = has_opacity ? std::max(value[3] * value[3], kLeastWeight) : 1.0f;
    targets.weight.push_back(is_sampled ? shown * pixels.stands_for[k] : shown);
  }
  return context_.check();
}

Status DrawingFit::add(const SparseMatrix& rows, const Targets& targets, Equations& equations) {
  SFUMATO_TRY(add_pixels(context_, {rows, targets.value, targets.weight}, equations.color));
  if (picture_.opacity) {
    SFUMATO_TRY(
        add_pixels(context_, {rows, targets.value, targets.opacity_weight}, equations.opacity));
  }
  return ok_status();
}

Status DrawingFit::solve(const Equations& equations, std::span<TracedCurve> curves) {
  SFUMATO_TRY_ASSIGN(const ValueBounds& bounds, bounds_near(context_, picture_, curves));
  std::vector<FourFloats> x = values_of(curves);
  const std::vector<float> pull(x.size(), kPull);
  const auto solve_one = [&](const ValueEquations& of, std::vector<FourFloats>& values) {
    return solve_bounded(context_,
                         {of.normal, of.right_side, has_next_, bounds.low, bounds.high, pull, kEven,
                          ties_, kTolerance},
                         values);
  };
  std::vector<FourFloats> opacities;
  if (picture_.opacity) {
    opacities = x;
    SFUMATO_TRY(solve_one(equations.opacity, opacities));
  }
  SFUMATO_TRY(solve_one(equations.color, x));
  for (std::size_t i = 0; i < opacities.size(); ++i) x[i][3] = opacities[i][3];
  for (const Tie& tie : ties_) x[tie.second] = x[tie.first];
  std::size_t at = 0;
  for (TracedCurve& curve : curves) {
    for (SideStops& side : curve.side) {
      for (SideValue& value : side.value) value = x[at++];
    }
  }
  return ok_status();
}

Status DrawingFit::build_matrix(std::span<const TracedCurve> curves) {
  matrix_.reset();
  SFUMATO_TRY_ASSIGN(matrix_, value_rows(context_, *seen_, curves));
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
  SFUMATO_TRY(multiply(context_, *matrix_, x, residual_));
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) residual_[i][c] = targets_.value[i][c] - residual_[i][c];
  }
  psnr_db_ = decibels(mean_square());
  return ok_status();
}

/// Returns the residual's error over all pixels.
double DrawingFit::mean_square() const {
  const std::vector<float>& stands_for = seen_->pixels.stands_for;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    const double weight = targets_.weight.empty() ? 1.0 : double{targets_.weight[i]};
    sum += squared_difference(residual_[i], weight, picture_.opacity.has_value()) * stands_for[i];
    count += stands_for[i];
  }
  return count > 0 ? sum / count : 0.0;
}

/// Returns the same of the pixels of equations.
Result<double> DrawingFit::mean_square(const Equations& equations, std::span<const FourFloats> x) {
  SFUMATO_TRY_ASSIGN(const auto& color, squared_errors(context_, equations.color, x));
  const double colors = (color[0] + color[1] + color[2]) / 3;
  const double pixels = picture_.opacity ? equations.opacity.weight : equations.color.weight;
  if (!(pixels > 0)) return 0.0;
  if (!picture_.opacity) return colors / pixels;
  SFUMATO_TRY_ASSIGN(const auto& opacity, squared_errors(context_, equations.opacity, x));
  return (colors + opacity[3]) / pixels;
}

Status DrawingFit::for_each_band(std::span<const TracedCurve> curves, double one_in,
                                 std::uint64_t seed,
                                 FunctionRef<Status(const PixelRows&, const SparseMatrix&)> visit) {
  const int height = picture_.height();
  const int rows_at_once = std::max(1, static_cast<int>(kBandPixels * one_in) / picture_.width());
  for (int y = 0; y < height; y += rows_at_once) {
    SFUMATO_TRY_ASSIGN(
        auto&& pixels,
        choose_pixels(context_, *marks_, {one_in, seed, y, std::min(y + rows_at_once, height)}));
    SFUMATO_TRY_ASSIGN(const PixelRows& seen,
                       mesh_->gather(context_, std::move(pixels), kNegligible));
    const Result<SparseMatrix> rows = value_rows(context_, seen, curves);
    SFUMATO_TRY(rows ? visit(seen, *rows) : rows.status());
  }
  return ok_status();
}

Status DrawingFit::fit_to_all(std::span<TracedCurve> curves, const FitBudget& budget,
                              std::uint64_t seed, double share, int times) {
  seen_.reset();
  matrix_.reset();
  // Radii have changed since prepare(), and with them which curves are sharp.
  SFUMATO_TRY_ASSIGN(marks_, mark_curves(context_, picture_.width(), picture_.height(), curves));
  SFUMATO_TRY_ASSIGN(const double one_in, this->one_in(curves, budget, seed, kNegligible));
  Equations equations;
  SFUMATO_TRY(
      for_each_band(curves, one_in, seed, [&](const PixelRows& seen, const SparseMatrix& rows) {
        Targets targets;
        Status found = find_targets(seen.pixels, one_in > 1, targets);
        return found ? add(rows, targets, equations) : found;
      }));
  SFUMATO_TRY(solve(equations, curves));
  for (; times > 0; --times) {
    SFUMATO_TRY(prune(curves, share, equations));
    SFUMATO_TRY(solve(equations, curves));
  }
  SFUMATO_TRY_ASSIGN(const double square, mean_square(equations, values_of(curves)));
  psnr_db_ = decibels(square);
  return ok_status();
}

Result<double> DrawingFit::squared_error(const Equations& equations,
                                         std::span<const FourFloats> x) {
  SFUMATO_TRY_ASSIGN(const auto& color, squared_errors(context_, equations.color, x));
  double sum = color[0] + color[1] + color[2];
  if (!picture_.opacity) return sum;
  SFUMATO_TRY_ASSIGN(const auto& opacity, squared_errors(context_, equations.opacity, x));
  return sum + opacity[3];
}

Status DrawingFit::prune(std::span<TracedCurve> curves, double share, Equations& equations) {
  const std::vector<float> color_weight = diagonal_of(equations.color.normal);
  const std::vector<float> opacity_weight =
      picture_.opacity ? diagonal_of(equations.opacity.normal) : std::vector<float>{};
  SFUMATO_TRY_ASSIGN(const double error, squared_error(equations, values_of(curves)));
  const double unseen = 3 * kUnseenError * kUnseenError * equations.color.weight;
  const PruneLimits limits{share, kPruneCost * share * std::max(error, unseen)};
  const std::vector<std::uint8_t> goes =
      stops_to_prune(curves, {color_weight, opacity_weight}, limits);
  SFUMATO_TRY_ASSIGN(const SparseMatrix& values, values_without(context_, curves, goes));
  Equations left;
  SFUMATO_TRY_ASSIGN(left.color, reduced(context_, equations.color, values));
  if (picture_.opacity) {
    SFUMATO_TRY_ASSIGN(left.opacity, reduced(context_, equations.opacity, values));
  }
  equations = std::move(left);
  prune_stops(goes, curves);
  list_neighbours(curves);
  return ok_status();
}

Status DrawingFit::fit_radii(std::span<TracedCurve> curves) {
  std::vector<float> weight;
  for (const float square : targets_.weight) weight.push_back(std::sqrt(square));
  const std::size_t channels = picture_.opacity ? 4 : 3;
  SFUMATO_TRY_ASSIGN(const SparseMatrix& rows,
                     radius_rows(context_, *seen_, curves, weight, channels));
  SFUMATO_TRY_ASSIGN(const SparseMatrix& transpose, transposed(context_, rows));
  SFUMATO_TRY_ASSIGN(const SparseMatrix& normal, normal_matrix(context_, rows, transpose, {}));
  std::vector<FourFloats> missing(rows.row_count());
  for (std::size_t i = 0; i < missing.size(); ++i) {
    const std::size_t pixel = i / channels, channel = i % channels;
    const bool has_weight = channel < 3 && !weight.empty();
    missing[i][0] = (has_weight ? weight[pixel] : 1.0f) * residual_[pixel][channel];
  }
  std::vector<FourFloats> right_side(curves.size()), step(curves.size());
  SFUMATO_TRY(multiply(context_, transpose, missing, right_side));
  std::vector<float> pull = diagonal_of(normal);
  for (float& own : pull) own = kRadiusDamping * own + kRadiusPull;
  const std::vector<std::uint8_t> no_next(curves.size());
  const std::vector<FourFloats> low(curves.size(), {-kAny}), high(curves.size(), {kAny});
  SFUMATO_TRY(solve_bounded(context_, {normal, right_side, no_next, low, high, pull, 0, {}}, step));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].is_frame) continue;
    const double most = std::max(0.5 * curves[i].radius, kRadiusStep);
    const double radius = curves[i].radius + std::clamp(double{step[i][0]}, -most, most);
    curves[i].radius = std::clamp(radius, kLeastFittedRadius, kLargestFittedRadius);
  }
  return ok_status();
}

}  // namespace sfumato::tracing
