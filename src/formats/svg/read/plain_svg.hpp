#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::svg {

/// The paint of a fill or stroke in an ordinary SVG.
struct PlainPaint {
  std::optional<Rgb> color;  ///< none: Document::shaders[shader]
  std::uint32_t shader = 0;
  float opacity = 1;
};

/// The paints of a <use>, or of the shape that has a marker, without `fill-opacity` and
/// `stroke-opacity`.
struct ContextPaints {
  std::optional<PlainPaint> fill{};
  std::optional<PlainPaint> stroke{};
};

enum class StrokeCap : std::uint8_t { butt, round, square };
enum class StrokeJoin : std::uint8_t { miter, round, bevel };

struct StrokeStyle {
  /// Whether lengths are in user units of the shape and the outline is in its user space; else both
  /// are of the artboard.
  bool is_scaled = true;
  double width = 1;  ///< above 0
  StrokeCap cap = StrokeCap::butt;
  StrokeJoin join = StrokeJoin::miter;
  double miter_limit = 4;
  std::vector<double> dashes{};  ///< an even number of lengths; empty: none
  double dash_offset = 0;
  /// The value of `pathLength`: the author's length of the whole path, which is the unit of dashes.
  /// 0: not given.
  double path_length = 0;
  /// The subpaths that end where they begin and are open still: caps meet there, no join. In order.
  std::vector<std::uint32_t> open_loops{};

  bool is_closed(std::uint32_t index, const std::vector<Vec2>& subpath) const {
    return subpath.front() == subpath.back() && !std::ranges::binary_search(open_loops, index);
  }
};

/// A region that limits where shapes are painted: its parts are added to it or removed from it, one
/// after another.
struct PlainClip {
  struct Part {
    std::vector<std::vector<Vec2>> contours{};  ///< artboard frame, 3 n + 1 control points each
    bool even_odd = false;
    std::optional<std::uint32_t> clip{};  ///< an earlier clip of this part
    bool is_hole = false;                 ///< taken out of the parts before it
    std::optional<StrokeStyle> stroke{};  ///< the contours are stroked, not filled
    Affine artboard_from_stroke{};        ///< of the contours, where they are stroked
  };
  std::vector<Part> parts{};
  std::optional<std::uint32_t> outer{};  ///< an earlier clip around this one
};

/// A paint of PlainContent::mask_shaders; its alpha × luminance is an opacity of shapes.
struct PlainMask {
  std::uint32_t shader = 0;
  std::optional<std::uint32_t> outer{};  ///< an earlier mask, which multiplies this one
};

/// A shape of an ordinary SVG. It is painted where the LayerInstances of its layers are in the
/// stack.
struct PlainShape {
  std::string id{};
  std::size_t offset = 0;  ///< of its element in the text; 0 where that is not known
  Affine artboard_from_user{};
  std::vector<std::vector<Vec2>> subpaths{};  ///< user space, 3 n + 1 control points each
  bool even_odd = false;
  std::optional<PlainPaint> fill{};
  std::uint32_t fill_layer = 0;  ///< an empty layer of the document, for the fill's curves
  std::optional<PlainPaint> stroke{};
  std::uint32_t stroke_layer = 0;
  std::optional<std::uint32_t> clip{};  ///< of PlainContent::clips
  std::optional<std::uint32_t> mask{};  ///< of PlainContent::masks
  StrokeStyle style{};
  double blur =
      0;  ///< standard deviation of a Gaussian over the fill or the stroke, artboard units
};

/// The size of an <svg> that has no viewBox and lacks a length.
struct OpenSize {
  std::optional<double> width{};  ///< user units; none: that of the box of all shapes
  std::optional<double> height{};
};

/// The content of a document's layers.
struct PlainContent {
  std::vector<PlainShape> shapes{};  ///< bottom first
  std::vector<PlainClip> clips{};
  std::vector<Shader> mask_shaders{};
  std::vector<PlainMask> masks{};
};

/// The meaning of a tile's texels.
enum class TileUse : std::uint8_t {
  paint,              ///< colours
  luminance_mask,     ///< an opacity: alpha × luminance of code values
  linear_light_mask,  ///< an opacity: alpha × luminance of linear light
  inverted_mask,      ///< an opacity: alpha × (1 - luminance of code values)
  alpha_mask          ///< an opacity: alpha
};

/// The content of a mask, of a masked group, or of a pattern that holds more than one image, in
/// texels of its texture.
struct PlainTile {
  std::size_t owner = 0;  ///< 0: the drawing has the texture; n: PlainSvg::tiles[n - 1], before it
  /// A clear texture of the tile's size: of the owner's document, or of its mask_shaders.
  std::uint32_t shader = 0;
  TileUse use = TileUse::paint;
  Document document{};  ///< its artboard is the tile
  PlainContent content{};
};

/// An ordinary SVG. Layers that it already has, from Sfumato's own attributes, are kept.
struct PlainSvg {
  Document document;  ///< with an empty layer, instanced once, for each fill and each stroke
  PlainContent content;
  std::string title;
  std::vector<Diagnostic> warnings;
  /// If set, the artboard only stands for the viewport of percentages; the shapes decide on it.
  std::optional<OpenSize> open_size{};
  std::vector<PlainTile> tiles{};
  double units_per_px = 1;  ///< of the picture's own size
};

/// Reads fills and strokes of an ordinary SVG. Unsupported content (text, filters, faulty elements)
/// is left out with one warning for each kind. `file`, `loader`: as in read_svg. `with_tiles`:
/// whether patterns of vector content, and masks that are neither clips nor one paint, are read;
/// they too are left out otherwise. Errors: bad_input, limit, cancelled, out_of_memory.
Result<PlainSvg> read_plain_svg(Context& context, std::string_view text, const std::string& file,
                                const ResourceLoader* loader = nullptr, bool with_tiles = false);

}  // namespace sfumato::svg
