#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/color.hpp"

namespace sfumato {

/// The content of a gradient beyond its ends, as in SVG's `spreadMethod`.
enum class SpreadMethod : std::uint8_t {
  pad,      ///< the colour of the nearer end
  reflect,  ///< the gradient back and forth
  repeat    ///< the gradient repeated
};

/// A colour and an alpha at one place of a gradient.
struct GradientStop {
  double offset = 0;  ///< 0 to 1, not below the offset of the stop before
  Rgb color;          ///< not premultiplied
  float alpha = 1;    ///< 0 to 1
};

/// The shape of a linear gradient. Offsets are 0 at `start`, 1 at `end`, and constant across the
/// line between them.
struct LinearGradient {
  Vec2 start;      ///< gradient frame
  Vec2 end{1, 0};  ///< gradient frame
};

/// The shape of a radial gradient (SVG 2, 14.2.3). Offsets are 0 on the focal circle and 1 on the
/// circle. If the focal circle lies neither in the circle nor around it, the gradient fills the
/// cone that both touch; outside of the cone its alpha is 0.
struct RadialGradient {
  Vec2 center;              ///< of the circle, gradient frame
  Vec2 focus;               ///< the centre of the focal circle, gradient frame
  double radius = 1;        ///< of the circle, above 0, gradient frame
  double focal_radius = 0;  ///< of the focal circle, 0 or more, gradient frame
};

/// A gradient. It is linear in colour and alpha between stops, in sRGB code values whatever
/// Document::interpolation is.
struct GradientFill {
  std::variant<LinearGradient, RadialGradient> shape;  ///< where each offset lies
  SpreadMethod spread = SpreadMethod::pad;             ///< beyond offsets 0 and 1
  Affine layer_from_gradient;                          ///< invertible
  std::vector<GradientStop> stops;                     ///< at least one, sorted by offset
};

/// A raster texture. Texel (i, j) covers [i, i+1) × [j, j+1) of the texture frame.
struct Texture {
  int width = 0;                   ///< texels
  int height = 0;                  ///< texels
  std::vector<std::uint8_t> rgba;  ///< row by row, 4 × width × height, not premultiplied
  Affine layer_from_texture;       ///< invertible
  /// Whether it repeats, every `period` texels counted from the texture frame's origin. Otherwise
  /// the nearest texel of its edges shows beyond them.
  bool repeats = true;
  Vec2 period;  ///< texels, both above 0; 0 × 0 stands for width × height
  /// The PNG or JPEG file that it was read from, if any. write_svg() embeds it unchanged.
  std::vector<std::uint8_t> file;
};

/// An image-domain shader (paper section 3): its value depends only on the shaded point, not on
/// where a ray hit the curve. As an opacity it gives alpha × luminance.
struct Shader {
  std::string id;                             ///< for messages and files
  std::variant<GradientFill, Texture> paint;  ///< its content
};

}  // namespace sfumato
