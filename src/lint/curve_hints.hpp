#pragma once

#include "lint/layer_under_test.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::lint_detail {

/// Hints that one curve gives by itself: loops, attributes, blur, place. Errors: cancelled.
Status check_curves(LayerUnderTest& test);

/// Hints on curves that lie on one another, and on sides that no ray from the artboard reaches.
/// Errors: cancelled.
Status check_visibility(LayerUnderTest& test);

/// Hints on curves that cross with colours that do not fit, and on ends that stop shortly before
/// another curve. Of many in a layer the first are told one by one. Errors: limit, cancelled.
Status check_meetings(LayerUnderTest& test);

}  // namespace sfumato::lint_detail
