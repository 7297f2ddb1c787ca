// The radii of a StopFit, and its results.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/try.hpp"
#include "curves/attributes.hpp"
#include "trace/curves/drawing.hpp"
#include "trace/curves/drawing_stops.hpp"
#include "trace/fit/bounded_solve.hpp"
#include "trace/fit/row_slopes.hpp"
#include "trace/fit/stop_fit.hpp"

namespace sfumato::tracing {
namespace {

/// Added to the diagonal of the equations of radii, in shares of it.
constexpr float kDamping = 0.3f;
/// Pixels: the least and the largest radius that a step leads to, and the most that it changes one
/// whose half is less.
constexpr float kLeastSteppedRadius = 0.4f;
constexpr float kLargestSteppedRadius = 24;
constexpr float kLargestStep = 0.7f;

/// Three digits are enough for a radius.
float in_three_digits(float value) {
  double unit = 1;
  while (value < 100 * unit && unit > 1e-6) unit /= 10;
  while (value >= 1000 * unit) unit *= 10;
  return static_cast<float>(std::round(value / unit) * unit);
}

}  // namespace

/// Lists the fitted curves that have blur and no opacity; coefficients of opacity would change with
/// the blur.
Status StopFit::list_moving_curves() {
  std::size_t at = 0;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    for (const Curve& curve : drawing_.layers[i].curves) {
      const bool moves = layers_[i] && is_chosen_[at] && !curves::bears_opacity(curve);
      radius_px_[at] =
          moves ? largest_radius(curve) * static_cast<float>(layers_[i]->px_per_unit) : 0.0f;
      ++at;
    }
    if (context_.cancelled()) return context_.cancel_status();
  }
  return ok_status();
}

/// How a channel of a part's colour changes with factors of radii.
void StopFit::add_radius_terms(const Part& part, double share, std::size_t channel,
                               RowSummer& sum) const {
  const ShownInstance& shown = points_.shown[part.shown];
  const std::uint32_t first = first_curve_[shown.layer];
  const std::span x = std::span(x_).subspan(first_stop_[shown.layer]);
  const gather::Rows& rows = shown.sight.rows;
  for (std::uint32_t k = rows.begin[part.row]; k < rows.begin[part.row + 1]; ++k) {
    const gather::RowTerm& term = rows.term[k];
    const gather::RowSource& source = rows.source[term.source];
    const std::uint32_t curve = first + source.curve;
    const bool has_stops = source.front.shader < 0 && source.back.shader < 0;
    if (!(radius_px_[curve] > 0) || !source.back.has_value || !has_stops) continue;
    const double slope = term.lean * gather::radius_at(source, term.moment) *
                         share_slope(term.distance, radius_of(shown, source, term));
    if (slope == 0) continue;
    const double jump = double{value_of(source.front, term.moment, x)[channel]} -
                        value_of(source.back, term.moment, x)[channel];
    sum.add(curve, static_cast<float>(share * term.weight * slope * jump));
  }
}

Result<SparseMatrix> StopFit::radius_rows() const {
  const auto columns = static_cast<std::uint32_t>(factor_.size());
  return build_rows(context_, 3 * missing_.size(), columns, [&](std::size_t row, RowSummer& sum) {
    for_each_part(row / 3, [&](const Part& part, double share, const FourFloats& coefficient) {
      add_radius_terms(part, share * coefficient[3], row % 3, sum);
    });
  });
}

Status StopFit::fit_radii() {
  if (std::ranges::all_of(radius_px_, [](float radius) { return radius == 0; })) {
    return ok_status();
  }
  SFUMATO_TRY_ASSIGN(auto&& rows, radius_rows());
  SFUMATO_TRY_ASSIGN(auto&& transpose, transposed(context_, rows));
  SFUMATO_TRY_ASSIGN(auto&& normal, normal_matrix(context_, rows, transpose, {}));
  const std::size_t curves = factor_.size();
  TableMemory memory("the colours of a fit");
  std::vector<FourFloats> wanted, right_side, step, low, high;
  std::vector<std::uint8_t> has_next;
  std::vector<float> pull;
  SFUMATO_TRY(memory.resize(context_, wanted, rows.row_count()));
  SFUMATO_TRY(memory.resize_all(context_, curves, right_side, step, low, high));
  SFUMATO_TRY(memory.resize(context_, has_next, curves));
  SFUMATO_TRY(memory.resize(context_, pull, curves, kPull));
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i][0] = missing_[i / 3].color[i % 3];
  for (std::uint32_t i = 0; i < curves; ++i) {
    for (std::uint32_t k = normal.begin[i]; k < normal.begin[i + 1]; ++k) {
      if (normal.column[k] == i) pull[i] += kDamping * normal.value[k];
    }
    if (!(radius_px_[i] > 0)) continue;
    const float now = factor_[i] * radius_px_[i];
    const float most = std::max(0.5f * now, kLargestStep);
    low[i][0] = std::min(std::max(-most, kLeastSteppedRadius - now), 0.0f) / radius_px_[i];
    high[i][0] = std::max(std::min(most, kLargestSteppedRadius - now), 0.0f) / radius_px_[i];
  }
  SFUMATO_TRY(multiply(context_, transpose, wanted, right_side));
  SFUMATO_TRY(solve_bounded(context_, {normal, right_side, has_next, low, high, pull, 0}, step));
  for (std::size_t i = 0; i < curves; ++i) factor_[i] += step[i][0];
  Status status = build_matrix();
  return status ? find_missing() : status;
}

Status StopFit::write(Document& drawing) const {
  std::size_t at = 0;
  SFUMATO_TRY(for_each_color_list(context_, drawing, [&](ColorStops& list) {
    for (Stop<Rgb>& stop : list.stops) {
      const FourFloats& x = x_[at];
      const bool is_seen = is_shown(at++);
      if (!is_seen) continue;
      const Rgb code = to_srgb(drawing_.interpolation, {x[0], x[1], x[2]});
      stop.value = {in_eight_bits(code.r), in_eight_bits(code.g), in_eight_bits(code.b)};
    }
  }));
  std::size_t curve = 0;
  return for_each_curve(context_, drawing, [&](Curve& changed) {
    const float factor = factor_[curve++];
    if (factor == 1) return;
    for (Side* side : {&changed.left, &changed.right}) {
      for (Stop<float>& stop : side->blur_radius.stops) {
        stop.value = in_three_digits(factor * stop.value);
      }
    }
  });
}

}  // namespace sfumato::tracing
