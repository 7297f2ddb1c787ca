#pragma once

#include "formats/svg/input.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg {

/// How an element is put onto what lies below it.
struct Compositing {
  float opacity = 1;
  BlendMode blend = BlendMode::normal;
  bool isolated = false;

  bool is_plain() const { return opacity == 1 && blend == BlendMode::normal && !isolated; }
};

/// opacity, mix-blend-mode and isolation of an element. Blend modes that are not known are normal,
/// with a warning. Errors: bad_input.
Result<Compositing> read_compositing(Input& input, Element element);

/// Warns of properties that would change the picture and are not read.
void warn_of_effects(Input& input, Element element);

}  // namespace sfumato::svg
