#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::raster {

/// One resolution of a texture. Texel (i, j) covers [i, i + 1) × [j, j + 1) of the level's frame,
/// except that the last column and row of level 0 of a repeating texture end at the period.
struct TextureLevel {
  int width = 0;
  int height = 0;
  Vec2 level_from_texture;  ///< scale: texels of the level per texel of the texture
  Vec2 period;              ///< period of a repeating texture, texels of the level
  std::size_t offset = 0;   ///< of its first texel, in texels
};

/// A texture at all resolutions, each about half of the one before, down to one texel.
///
/// Texels are four 16-bit numbers, red, green, blue (sRGB code values) times alpha, and alpha:
/// 8-bit colours are exact. A level is the mean of the one before over the area of its texels;
/// levels of a repeating texture divide the period evenly, gaps and cut-off texels included.
class TexturePyramid {
 public:
  /// Makes a pyramid. Precondition: the texture was validated. Errors: limit (memory, nothing
  /// allocated), cancelled. Cost: O(texels), on the pool.
  static Result<TexturePyramid> create(Context& context, const Texture& texture);

  const std::vector<TextureLevel>& levels() const { return levels_; }
  const std::uint16_t* texels(const TextureLevel& level) const {
    return texels_.data() + 4 * level.offset;
  }
  const Affine& texture_from_layer() const { return texture_from_layer_; }
  bool repeats() const { return repeats_; }
  bool opaque() const { return opaque_; }
  SimdLevel simd() const { return simd_; }

 private:
  TexturePyramid() = default;

  void lay_out(const Texture& texture);
  Status fill_base(Context& context, const Texture& texture);
  Status fill_level(Context& context, std::size_t index);

  Affine texture_from_layer_;
  bool repeats_ = false;
  bool opaque_ = true;
  SimdLevel simd_ = SimdLevel::sse2;
  std::vector<TextureLevel> levels_;
  std::vector<std::uint16_t> texels_;
  TableMemory memory_{"a texture"};
};

}  // namespace sfumato::raster
