#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/table_memory.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato::svg_import {

/// Turns the colours of a drawn mask into opacities: alpha × luminance of a shader. Errors:
/// cancelled.
Status make_opacity(const Context& context, svg::TileUse use, Texture& texture);

/// Textures of products of opacities, for masks on paints that are not opaque and masks within
/// masks. Their number and size are limited.
class MaskProducts {
 public:
  /// Draws the product of the document's shaders over a box. Returns no value if there are too
  /// many, or without a painter.
  ///
  /// units_per_texel   of the document's frame
  /// memory            the texels are allocated from it
  /// Errors: limit (memory), cancelled, and as the painter.
  Result<std::optional<Shader>> draw(Context& context, Document& document,
                                     const std::vector<std::uint32_t>& factors, const Box& box,
                                     double units_per_texel,
                                     const std::optional<TilePainter>& painter,
                                     TableMemory& memory);

 private:
  std::size_t drawn_ = 0, texels_ = 0;
};

}  // namespace sfumato::svg_import
