#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/flatten.hpp"
#include "gather/scene/share_bound.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"

namespace sfumato::solve {

/// Returns a mark per vertex: 1 for the vertices of these curves. Errors: limit (memory),
/// cancelled.
Result<std::vector<std::uint8_t>> marks_of(const Context& context, const curves::FlatCurves& flat,
                                           std::span<const std::uint32_t> which,
                                           TableMemory& memory);

/// Returns the polylines of these curves, which belong to `flat`.
std::vector<gather::ShareBound::Polyline> polylines_of(const curves::FlatCurves& flat,
                                                       std::span<const std::uint32_t> which);

/// Returns 0, 1, …, count - 1.
std::vector<std::uint32_t> numbers(std::size_t count);

/// Returns the largest weight of these curves.
double largest_weight(std::span<const Curve> curves, std::span<const std::uint32_t> which);

}  // namespace sfumato::solve
