#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/charge.hpp"
#include "curves/flatten.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"

namespace sfumato::solve {

/// A layer's curves in a frame. The moving curves are the last ones.
struct PlacedCurves {
  curves::FlatCurves flat{};
  std::vector<Curve> curves{};
  curves::FlatCurves moved{};  ///< only the polylines of the moving curves
  std::uint32_t first = 0;     ///< their first vertex in `flat`
  ScopedCharge charge{};
};

/// Returns the bytes of memory that the curves' vectors take.
std::size_t bytes_of(std::span<const Curve> curves);

/// Returns `curves`, and `moving` after them.
/// others   the polylines of `curves`
/// used     the curves of the last frame, whose tables are reused, or empty
/// Errors   limit (memory), cancelled
Result<PlacedCurves> place_curves(Context& context, const curves::FlatCurves& others,
                                  std::span<const Curve> curves, std::span<const Curve> moving,
                                  const curves::FlattenOptions& options,
                                  std::optional<PlacedCurves> used);

}  // namespace sfumato::solve
