#pragma once

#include <optional>

#include "formats/css/color.hpp"
#include "formats/svg/read/input.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"

namespace sfumato::svg {

/// An ordinary <rect> as the document's background.
struct BackgroundRect {
  bool covers = false;         ///< an upright rect of one colour that covers the whole artboard
  std::optional<Rgb> color{};  ///< its fill; no value for `none`
};

/// Reads a shape that may be the background. viewport: for percentages. Errors: bad_input.
Result<BackgroundRect> read_background_rect(Input& input, Element shape,
                                            const Affine& artboard_from_user, const Box& artboard,
                                            const Box& viewport);

/// The `background-color` of an ordinary <svg> (a property of styles alone); no value where it is
/// transparent.
Result<std::optional<css::Color>> read_root_background(Input& input);

}  // namespace sfumato::svg
