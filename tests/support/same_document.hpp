#pragma once

#include <algorithm>
#include <variant>

#include "sfumato/document/document.hpp"

namespace sfumato::test {

inline bool same_item(const StackItem& a, const StackItem& b) {
  if (a.index() != b.index()) return false;
  if (const auto* x = std::get_if<LayerInstance>(&a)) {
    const auto& y = std::get<LayerInstance>(b);
    return x->layer == y.layer && x->artboard_from_layer == y.artboard_from_layer &&
           x->opacity == y.opacity && x->blend == y.blend;
  }
  if (const auto* x = std::get_if<LocalStroke>(&a)) {
    const auto& y = std::get<LocalStroke>(b);
    return x->curve == y.curve && x->artboard_from_stroke == y.artboard_from_stroke;
  }
  const auto* x = std::get_if<GroupBegin>(&a);
  return !x || (x->opacity == std::get<GroupBegin>(b).opacity &&
                x->blend == std::get<GroupBegin>(b).blend);
}

/// Returns whether two documents are equal in everything that is drawn, ignoring the content of
/// shaders.
inline bool same_document(const Document& a, const Document& b) {
  const auto same_layer = [](const Layer& x, const Layer& y) {
    return x.id == y.id && x.curves == y.curves;
  };
  return a.artboard == b.artboard && a.interpolation == b.interpolation &&
         a.background == b.background && a.shaders.size() == b.shaders.size() &&
         std::ranges::equal(a.layers, b.layers, same_layer) &&
         std::ranges::equal(a.stack, b.stack, same_item);
}

}  // namespace sfumato::test
