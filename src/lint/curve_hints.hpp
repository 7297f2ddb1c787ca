#pragma once

#include "lint/layer_under_test.hpp"

namespace sfumato::lint_detail {

/// Hints that one curve gives by itself: loops, attributes, blur, place.
void check_curves(LayerUnderTest& test);

/// Hints on curves that lie on one another, and on sides that no ray from the artboard reaches.
void check_visibility(LayerUnderTest& test);

}  // namespace sfumato::lint_detail
