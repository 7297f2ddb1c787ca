#pragma once

#include "formats/svg/read/input.hpp"
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

/// The effects that the caller reads.
struct ReadEffects {
  bool clip_path = false;
  bool mask = false;
  bool filter = false;
};

/// Warns about properties that would change the picture but are not read.
void warn_of_effects(Input& input, Element element, const ReadEffects& read);

}  // namespace sfumato::svg
