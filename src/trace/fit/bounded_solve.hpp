#pragma once

#include <cstdint>
#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/fit/sparse.hpp"

namespace sfumato::tracing {

/// Two unknowns that should be equal: Σ kTie (x_first - x_second)² is added for them.
struct Tie {
  std::uint32_t first, second;
};

/// Minimise for each channel xᵀN x - 2 bᵀx + Σ pull_i (x_i - x⁰_i)² + even Σ (x_i - x_{i+1})², the
/// latter over neighbours on a side, with low <= x <= high.
struct BoundedProblem {
  const SparseMatrix& normal;              ///< N
  std::span<const FourFloats> right_side;  ///< b
  std::span<const std::uint8_t> has_next;  ///< per unknown: whether the next is a neighbour
  std::span<const FourFloats> low, high;
  std::span<const float> pull;
  float even = 0;
  std::span<const Tie> ties{};
  /// The search ends when the residual has fallen to this share of its first value.
  double tolerance = 1e-4;
};

/// x   in: x⁰, where the search begins; out: the solution, by conjugate gradients with the diagonal
///     as preconditioner; unknowns that leave their bounds are held there Errors: limit (memory),
///     cancelled.
Status solve_bounded(Context& context, const BoundedProblem& problem, std::span<FourFloats> x);

}  // namespace sfumato::tracing
