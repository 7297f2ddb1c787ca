#pragma once

#include <array>
#include <string_view>

#include "sfumato/document/document.hpp"

namespace sfumato {

/// The names of BlendMode's modes in CSS's mix-blend-mode, in the order of the enumeration.
inline constexpr std::array<std::string_view, 16> kBlendNames{
    "normal",      "multiply",   "screen",     "overlay",    "darken",     "lighten",
    "color-dodge", "color-burn", "hard-light", "soft-light", "difference", "exclusion",
    "hue",         "saturation", "color",      "luminosity"};

inline std::string_view blend_name(BlendMode mode) {
  return kBlendNames[static_cast<std::size_t>(mode)];
}

/// The names of InterpolationSpace's spaces in files and options, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> kSpaceNames{"srgb", "linear", "oklab"};

inline std::string_view space_name(InterpolationSpace space) {
  return kSpaceNames[static_cast<std::size_t>(space)];
}

}  // namespace sfumato
