#pragma once

#include "formats/svg/input.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg {

/// How an element is composited onto the backdrop.
struct Compositing {
  float opacity = 1;
  BlendMode blend = BlendMode::normal;
  bool isolated = false;

  bool is_plain() const { return opacity == 1 && blend == BlendMode::normal && !isolated; }
};

/// opacity, mix-blend-mode and isolation of an element. Unknown blend modes are treated as normal,
/// with a warning. Errors: bad_input.
Result<Compositing> read_compositing(Input& input, Element element);

/// Warns about properties that would change the picture but are not supported.
void warn_of_effects(Input& input, Element element);

}  // namespace sfumato::svg
