#pragma once

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

/// A layer's curves with one that moves, where a frame has it, after all others.
struct PlacedCurves {
  curves::FlatCurves flat{};
  std::vector<Curve> curves{};
  curves::FlatCurves moved{};  ///< the polyline of that curve by itself
  std::uint32_t first = 0;     ///< its first vertex in `flat`
  ScopedCharge charge{};
};

/// others   the polylines of `curves`
/// used     those of the last frame, whose tables are used again, or none
/// Errors   limit (memory), cancelled
Result<PlacedCurves> place_curve(Context& context, const curves::FlatCurves& others,
                                 std::span<const Curve> curves, const Curve& curve,
                                 const curves::FlattenOptions& options,
                                 std::optional<PlacedCurves> used);

}  // namespace sfumato::solve
