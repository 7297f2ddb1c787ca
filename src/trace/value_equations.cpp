#include "trace/value_equations.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sfumato::tracing {

Status add_pixels(Context& context, const FittedPixels& pixels, ValueEquations& equations) {
  const auto& [rows, target, weight] = pixels;
  const Result<SparseMatrix> transpose = transposed(context, rows);
  if (!transpose) return transpose.status();
  Result<SparseMatrix> normal = normal_matrix(context, rows, *transpose, weight);
  if (!normal) return normal.status();
  std::vector<FourFloats> weighted(target.begin(), target.end());
  for (std::size_t i = 0; i < weighted.size(); ++i) {
    const float w = weight.empty() ? 1.0f : weight[i];
    equations.weight += w;
    for (std::size_t c = 0; c < 4; ++c) {
      weighted[i][c] *= w;
      equations.square[c] += double{weighted[i][c]} * target[i][c];
    }
  }
  std::vector<FourFloats> right_side(rows.column_count);
  Status status = multiply(context, *transpose, weighted, right_side);
  if (!status) return status;
  if (equations.right_side.empty()) {
    equations.normal = std::move(*normal);
    equations.right_side = std::move(right_side);
    return status;
  }
  Result<SparseMatrix> sum = sum_of(context, equations.normal, *normal);
  if (!sum) return sum.status();
  equations.normal = std::move(*sum);
  for (std::size_t i = 0; i < right_side.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) equations.right_side[i][c] += right_side[i][c];
  }
  return status;
}

Result<ValueEquations> reduced(Context& context, const ValueEquations& equations,
                               const SparseMatrix& values) {
  ValueEquations out;
  out.square = equations.square;
  out.weight = equations.weight;
  const Result<SparseMatrix> transpose = transposed(context, values);
  if (!transpose) return transpose.status();
  const Result<SparseMatrix> left = product(context, *transpose, equations.normal);
  if (!left) return left.status();
  Result<SparseMatrix> normal = product(context, *left, values);
  if (!normal) return normal.status();
  out.normal = std::move(*normal);
  out.right_side.resize(values.column_count);
  Status status = multiply(context, *transpose, equations.right_side, out.right_side);
  if (!status) return status;
  return out;
}

Result<std::array<double, 4>> squared_errors(Context& context, const ValueEquations& equations,
                                             std::span<const FourFloats> x) {
  std::vector<FourFloats> image(x.size());
  Status status = multiply(context, equations.normal, x, image);
  if (!status) return status;
  std::array<double, 4> sum = equations.square;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum[c] += double{x[i][c]} * (double{image[i][c]} - 2.0 * equations.right_side[i][c]);
    }
    sum[c] = std::max(sum[c], 0.0);
  }
  return sum;
}

Result<double> mean_square(Context& context, const ValueEquations& equations,
                           std::span<const FourFloats> x) {
  const Result<std::array<double, 4>> sum = squared_errors(context, equations, x);
  if (!sum) return sum.status();
  if (!(equations.weight > 0)) return 0.0;
  return ((*sum)[0] + (*sum)[1] + (*sum)[2]) / (3 * equations.weight);
}

}  // namespace sfumato::tracing
