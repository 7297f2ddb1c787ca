#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/color.hpp"

namespace sfumato {

enum class SpreadMethod : std::uint8_t { pad, reflect, repeat };

struct GradientStop {
  double offset = 0;  ///< 0 to 1, never falling
  Rgb color;
  float alpha = 1;
};

/// z(p) of a linear gradient, gradient frame: from `start` to `end`.
struct LinearGradient {
  Vec2 start;
  Vec2 end{1, 0};
};

/// z(p) of a radial gradient, gradient frame; `focus` lies inside the circle.
struct RadialGradient {
  Vec2 center;
  Vec2 focus;
  double radius = 1;
};

struct GradientFill {
  std::variant<LinearGradient, RadialGradient> shape;
  SpreadMethod spread = SpreadMethod::pad;
  Affine layer_from_gradient;
  std::vector<GradientStop> stops;
};

/// A raster texture; texel (i, j) covers [i, i+1) × [j, j+1) of the texture frame. Beyond its edges
/// their nearest texel shows. A texture that repeats does so every `period` texels, counted from
/// the texture frame's origin.
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< row by row, 4 × width × height, not premultiplied
  Affine layer_from_texture;
  bool repeats = true;
  Vec2 period;                     ///< texels; 0 × 0 is width × height
  std::vector<std::uint8_t> file;  ///< the PNG or JPEG that it came from, if any: what is saved
};

/// An image-domain shader (paper section 3): its value depends on the shaded point alone.
struct Shader {
  std::string id;
  std::variant<GradientFill, Texture> paint;
};

}  // namespace sfumato
