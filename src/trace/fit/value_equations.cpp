#include "trace/fit/value_equations.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/try.hpp"

namespace sfumato::tracing {

Status add_pixels(Context& context, const FittedPixels& pixels, ValueEquations& equations) {
  const auto& [rows, target, weight] = pixels;
  SFUMATO_TRY_ASSIGN(const SparseMatrix& transpose, transposed(context, rows));
  SFUMATO_TRY_ASSIGN(auto&& normal, normal_matrix(context, rows, transpose, weight));
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
  SFUMATO_TRY(multiply(context, transpose, weighted, right_side));
  Status status;
  if (equations.right_side.empty()) {
    equations.normal = std::move(normal);
    equations.right_side = std::move(right_side);
    return status;
  }
  SFUMATO_TRY_ASSIGN(equations.normal, sum_of(context, equations.normal, normal));
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
  SFUMATO_TRY_ASSIGN(const SparseMatrix& transpose, transposed(context, values));
  SFUMATO_TRY_ASSIGN(const SparseMatrix& left, product(context, transpose, equations.normal));
  SFUMATO_TRY_ASSIGN(out.normal, product(context, left, values));
  out.right_side.resize(values.column_count);
  SFUMATO_TRY(multiply(context, transpose, equations.right_side, out.right_side));
  return out;
}

Result<std::array<double, 4>> squared_errors(Context& context, const ValueEquations& equations,
                                             std::span<const FourFloats> x) {
  std::vector<FourFloats> image(x.size());
  SFUMATO_TRY(multiply(context, equations.normal, x, image));
  std::array<double, 4> sum = equations.square;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum[c] += double{x[i][c]} * (double{image[i][c]} - 2.0 * equations.right_side[i][c]);
    }
    sum[c] = std::max(sum[c], 0.0);
  }
  return sum;
}

}  // namespace sfumato::tracing
