#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "formats/svg/read/input.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// The effect of a mask's content: only the inside of a clip stays, with an opacity and with paints
/// that multiply it.
struct MaskContent {
  /// The content is too complex, so that only a picture of it shows the effect. The other members
  /// are then invalid.
  bool is_drawn = false;
  std::optional<std::uint32_t> clip{};   ///< of PlainContent::clips
  float opacity = 1;                     ///< 0: nothing is left
  std::vector<std::uint32_t> shaders{};  ///< of PlainContent::mask_shaders
};

/// Returns the effect of a mask's content: flat shapes that cover each other are a clip, and one
/// shape with a gradient or an image is a clip and a paint.
///
/// document, sketch   the content in the frame of the artboard, with the clips and masks of `kept`;
///                    paints are moved out of the document
/// kept               receives the clip and the paint
/// Errors: bad_input, limit (memory), cancelled.
Result<MaskContent> mask_content(Input& input, Element mask, TileUse use, Document& document,
                                 const PlainContent& sketch, PlainContent& kept);

}  // namespace sfumato::svg
