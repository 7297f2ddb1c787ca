#pragma once

#include "formats/svg/paint_attributes.hpp"
#include "formats/svg/texture_files.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::svg {

/// Where a pattern puts its one <image>.
struct PatternPlace {
  const TextureFile* file = nullptr;
  Affine layer_from_texture;
  Vec2 period;  ///< as Texture has it
};

/// Reads a pattern (SVG 1.1, section 13.3) that holds exactly one <image>, upright in its tile.
/// Where the image leaves a part of its tile free, its edge goes on there, with a warning.
/// Errors: bad_input, limit, out_of_memory.
Result<PatternPlace> read_pattern(Input& input, TextureFiles& files,
                                  const PaintAttributes& attributes, const PaintedShape& shape,
                                  const Box& viewport);

}  // namespace sfumato::svg
