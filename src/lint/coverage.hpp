#pragma once

#include "lint/layer_under_test.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::lint_detail {

/// How much of the artboard a layer paints, sampled at points along its border and inside.
enum class Cover : std::uint8_t { none, some, all };

/// Gathers colour and opacity at 68 points just inside the artboard's border and 25 spread over it,
/// as this instance shows the layer. A point is painted if a ray from it meets a colour, and the
/// layer's opacity there is at least half a code value or comes from a shader. If the caller does
/// not need to know whether all points are painted, the result may be `some` instead of `all`,
/// which is faster. Errors: limit, cancelled.
Result<Cover> cover_of(const LayerUnderTest& test, const Affine& artboard_from_layer,
                       bool all_matters);

}  // namespace sfumato::lint_detail
