#pragma once

#include <optional>

#include "formats/svg/input.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"

namespace sfumato::svg {

/// An ordinary <rect> as the document's background.
struct BackgroundRect {
  bool covers = false;         ///< an upright rect of one colour that covers the whole artboard
  std::optional<Rgb> color{};  ///< its fill; no value for `none`
};

/// Reads a shape that may be the background. Errors: bad_input.
Result<BackgroundRect> read_background_rect(Input& input, Element shape,
                                            const Affine& artboard_from_user, const Box& artboard);

}  // namespace sfumato::svg
