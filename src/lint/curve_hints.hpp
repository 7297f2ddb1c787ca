#pragma once

#include "lint/layer_under_test.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::lint_detail {

/// Hints about single curves: loops, attributes, blur, place. Errors: cancelled.
Status check_curves(LayerUnderTest& test);

/// Hints about curves that lie on one another, and about sides that no ray from the artboard
/// reaches.
/// Errors: cancelled.
Status check_visibility(LayerUnderTest& test);

/// Hints about curves that cross with conflicting colours, and about ends that stop shortly before
/// another curve. If a layer has many, only the first are reported one by one. Errors: limit,
/// cancelled.
Status check_meetings(LayerUnderTest& test);

}  // namespace sfumato::lint_detail
