#pragma once

#include <string_view>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// preserveAspectRatio.
struct AspectRatio {
  enum class Fit : unsigned char { stretch, meet, slice };
  Fit fit = Fit::meet;
  double align_x = 0.5;  ///< 0: min, 1: max
  double align_y = 0.5;
};

/// Errors: bad_input, without a place.
Result<Box> parse_view_box(std::string_view text);
Result<AspectRatio> parse_aspect_ratio(std::string_view text);

/// The map that fits `content` into `target` (SVG 1.1, section 7.8).
/// Precondition: both have an area.
Affine fit(const Box& content, const Box& target, const AspectRatio& ratio);

}  // namespace sfumato::svg
