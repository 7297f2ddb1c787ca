// Colours of a StopFit in a space other than sRGB.
#include <array>
#include <cstddef>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "trace/fit/bounded_solve.hpp"
#include "trace/fit/row_color.hpp"
#include "trace/fit/stop_fit.hpp"

namespace sfumato::tracing {
namespace {

/// For differences of a colour's coordinates.
constexpr float kColorStep = 1e-3f;
/// Parts of one task.
constexpr std::size_t kNewtonParts = 256;

std::array<float, 3> coordinates(const Rgb& color) {
  return {color.r, color.g, color.b};
}

}  // namespace

/// How the code values of each part change with its colour's coordinates.
Status StopFit::find_slopes(std::span<Slopes> slopes) const {
  return parallel_for(context_, slopes.size(), kNewtonParts, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      const std::array<float, 3> color = coordinates(color_of(part_[i]));
      for (std::size_t k = 0; k < 3; ++k) {
        std::array<float, 3> more = color, less = color;
        more[k] += kColorStep;
        less[k] -= kColorStep;
        const auto above =
            coordinates(to_srgb(drawing_.interpolation, {more[0], more[1], more[2]}));
        const auto below =
            coordinates(to_srgb(drawing_.interpolation, {less[0], less[1], less[2]}));
        for (std::size_t c = 0; c < 3; ++c) {
          slopes[i][3 * c + k] = (above[c] - below[c]) / (2 * kColorStep);
        }
      }
    }
  });
}

/// Returns a row to each code value of each pixel; columns are the first coordinates of all stops,
/// then the second and the third.
Result<SparseMatrix> StopFit::slope_rows() const {
  TableMemory memory("the colours of a fit");
  std::vector<Slopes> slopes;
  SFUMATO_TRY(memory.resize(context_, slopes, part_.size()));
  SFUMATO_TRY(find_slopes(slopes));
  const std::size_t stops = x_.size();
  return build_rows(
      context_, 3 * missing_.size(), static_cast<std::uint32_t>(3 * stops),
      [&](std::size_t row, RowSummer& sum) {
        const std::size_t c = row % 3;
        for_each_part(row / 3, [&](const Part& part, double share, const FourFloats& coefficient) {
          const Slopes& slope = slopes[static_cast<std::size_t>(&part - part_.data())];
          for_each_stop(part, [&](std::uint32_t column, double weight) {
            for (std::size_t k = 0; k < 3; ++k) {
              const double entry = share * coefficient[c] * weight * slope[3 * c + k];
              if (entry == 0) continue;
              sum.add(static_cast<std::uint32_t>(k * stops + column), static_cast<float>(entry));
            }
          });
        });
      });
}

Status StopFit::improve_colors() {
  const std::size_t stops = x_.size(), count = 3 * stops;
  SFUMATO_TRY_ASSIGN(const SparseMatrix& rows, slope_rows());
  SFUMATO_TRY_ASSIGN(const SparseMatrix& transpose, transposed(context_, rows));
  SFUMATO_TRY_ASSIGN(const SparseMatrix& normal, normal_matrix(context_, rows, transpose, {}));
  TableMemory memory("the colours of a fit");
  std::vector<FourFloats> x, low, high, right_side, wanted;
  std::vector<std::uint8_t> has_next;
  std::vector<float> pull;
  SFUMATO_TRY(memory.resize_all(context_, count, x, low, high, right_side));
  SFUMATO_TRY(memory.resize(context_, has_next, count));
  SFUMATO_TRY(memory.resize(context_, pull, count, kPull));
  SFUMATO_TRY(memory.resize(context_, wanted, 3 * missing_.size()));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t column = i % stops, k = i / stops;
    x[i][0] = x_[column][k];
    low[i][0] = low_[column][k];
    high[i][0] = high_[column][k];
    has_next[i] = has_next_[column];
  }
  SFUMATO_TRY(multiply(context_, rows, x, wanted));
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i][0] += missing_[i / 3].code[i % 3];
  SFUMATO_TRY(multiply(context_, transpose, wanted, right_side));
  SFUMATO_TRY(solve_bounded(context_, {normal, right_side, has_next, low, high, pull, kEven}, x));
  for (std::size_t i = 0; i < count; ++i) x_[i % stops][i / stops] = x[i][0];
  return find_missing();
}

}  // namespace sfumato::tracing
