#include <cstddef>
#include <cstdint>

#include "sfumato/base/color_space.hpp"
#include "sfumato/sfumato.h"

int32_t sfumato_convert_colors(int32_t from, int32_t to, const double* colors, size_t color_count,
                               double* converted) {
  using sfumato::InterpolationSpace;
  const auto is_space = [](int32_t s) { return s >= SFUMATO_SRGB && s <= SFUMATO_OKLAB; };
  if (!is_space(from) || !is_space(to) || (color_count > 0 && (!colors || !converted))) {
    return SFUMATO_BAD_USAGE;
  }
  for (std::size_t i = 0; i < 3 * color_count; i += 3) {
    const sfumato::Rgb color{static_cast<float>(colors[i]), static_cast<float>(colors[i + 1]),
                             static_cast<float>(colors[i + 2])};
    const sfumato::Rgb code = to_srgb(static_cast<InterpolationSpace>(from), color);
    const sfumato::Rgb out = from_srgb(static_cast<InterpolationSpace>(to), code);
    converted[i] = double{out.r};
    converted[i + 1] = double{out.g};
    converted[i + 2] = double{out.b};
  }
  return SFUMATO_OK;
}
