#pragma once

#include <cstddef>

#include "formats/svg/paint/paint_attributes.hpp"
#include "formats/svg/paint/texture_files.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::svg {

/// The tile of a pattern of vector content.
struct VectorPattern {
  Element content;  ///< the pattern that has the content
  Box tile;         ///< pattern frame: the user space before patternTransform
  Affine pattern_from_content;
  Affine layer_from_pattern;
};

/// The texture that shows a tile.
struct TilePlace {
  int width = 1;           ///< texels
  int height = 1;          ///< texels
  bool is_coarse = false;  ///< a side has fewer texels than were asked for
  Affine pattern_from_texture{};
  Affine layer_from_texture{};
  Affine texture_from_content{};

  std::size_t texels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Returns the grid of texels of this size, in units of the layer's frame. The texels are larger if
/// a side of the tile has more than `side`, which is at least 1.
TilePlace tile_place(const VectorPattern& pattern, double units_per_texel, double side);

/// Returns whether a tile is upright and has whole texels of this size along both sides.
bool is_whole_in(const VectorPattern& pattern, double units_per_texel);

/// Returns whether the pattern holds something, and not exactly one <image>.
bool holds_vectors(const PaintAttributes& attributes);

/// Errors: bad_input.
Result<VectorPattern> read_vector_pattern(Input& input, TextureFiles& files,
                                          const PaintAttributes& attributes,
                                          const PaintedShape& shape);

/// Reads a pattern (SVG 1.1, section 13.3) that holds exactly one <image>, upright in its tile.
/// `sf:repeats="false"` extends the image's edge everywhere.
/// If the image does not fill its tile, its edge is extended, with a warning.
/// Errors: bad_input, limit, out_of_memory.
Result<TexturePlace> read_pattern(Input& input, TextureFiles& files,
                                  const PaintAttributes& attributes, const PaintedShape& shape);

}  // namespace sfumato::svg
