#pragma once

#include "support/drawing.hpp"

/// The document for tests that drag curves.
namespace sfumato::test {

inline Curve circle_at(Vec2 center) {
  return colored(circle_curve(center, 12), kRed, kBlue);
}

/// Returns two circles in one layer, with another layer over them.
inline Document circles() {
  Document document =
      one_layer({circle_at({30, 30}), colored(circle_curve({50, 50}, 45), kBlue, kGreen)});
  document.layers.push_back({"above", {colored(circle_curve({70, 70}, 9), kGreen, kRed)}});
  document.stack.push_back(LayerInstance{1, {}, 0.5f});
  return document;
}

}  // namespace sfumato::test
