#pragma once

#include "formats/svg/paint_attributes.hpp"
#include "formats/svg/texture_files.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::svg {

/// The placement of a pattern's single <image>.
struct PatternPlace {
  const TextureFile* file = nullptr;
  Affine layer_from_texture;
  Vec2 period;  ///< as in Texture
};

/// Reads a pattern (SVG 1.1, section 13.3) that holds exactly one <image>, upright in its tile.
/// If the image does not fill its tile, its edge is extended, with a warning.
/// Errors: bad_input, limit, out_of_memory.
Result<PatternPlace> read_pattern(Input& input, TextureFiles& files,
                                  const PaintAttributes& attributes, const PaintedShape& shape,
                                  const Box& viewport);

}  // namespace sfumato::svg
