#pragma once

#include <array>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/fit/sparse.hpp"

namespace sfumato::tracing {

/// The equations of least squares, AᵀWA x = AᵀWb: Σ over pixels of w |A x - b|² is
/// xᵀ N x - 2 rᵀ x + s in each channel.
struct ValueEquations {
  SparseMatrix normal;                 ///< N
  std::vector<FourFloats> right_side;  ///< r
  std::array<double, 4> square{};      ///< s
  double weight = 0;                   ///< Σ of the weights that a mean is divided by
};

/// The pixels of some equations.
struct FittedPixels {
  const SparseMatrix& rows;            ///< A
  std::span<const FourFloats> target;  ///< b
  std::span<const float> weight;       ///< W, per pixel; empty: 1
};

/// Adds the equations of some pixels; empty equations become these. Errors: limit (memory),
/// cancelled.
Status add_pixels(Context& context, const FittedPixels& pixels, ValueEquations& equations);

/// Returns the equations for new unknowns; the present unknowns are `values` times the new ones.
/// Errors: limit (memory), cancelled.
Result<ValueEquations> reduced(Context& context, const ValueEquations& equations,
                               const SparseMatrix& values);

/// Returns the weighted sum of squares of the residual of the values, in each channel. Errors:
/// cancelled.
Result<std::array<double, 4>> squared_errors(Context& context, const ValueEquations& equations,
                                             std::span<const FourFloats> x);

}  // namespace sfumato::tracing
