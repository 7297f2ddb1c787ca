#pragma once

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

enum class StrokeCap : std::uint8_t { butt, round, square };
enum class StrokeJoin : std::uint8_t { miter, round, bevel };

struct StrokeStyle {
  double width = 1;  ///< user units of the shape, above 0
  StrokeCap cap = StrokeCap::butt;
  StrokeJoin join = StrokeJoin::miter;
  double miter_limit = 4;
  std::vector<double> dashes{};  ///< an even number of lengths; empty: none
  double dash_offset = 0;
};

/// A shape of an ordinary SVG. It is painted where the LayerInstances of its layers are in the
/// stack.
struct PlainShape {
  std::string id{};
  Affine artboard_from_user{};
  std::vector<std::vector<Vec2>> subpaths{};  ///< user space, 3 n + 1 control points each
  bool even_odd = false;
  std::optional<PlainPaint> fill{};
  std::uint32_t fill_layer = 0;  ///< an empty layer of the document, for the fill's curves
  std::optional<PlainPaint> stroke{};
  std::uint32_t stroke_layer = 0;
  bool stroke_first = false;  ///< the stroke is painted below the fill
  StrokeStyle style{};
};

/// An ordinary SVG. Layers that it already has, from Sfumato's own attributes, are kept.
struct PlainSvg {
  Document document;  ///< with an empty layer, instanced once, for each fill and each stroke
  std::vector<PlainShape> shapes;  ///< bottom first
  std::string title;
  std::vector<Diagnostic> warnings;
};

/// Reads fills and strokes of an ordinary SVG. Unsupported content (text, images, clip paths,
/// masks, filters, patterns of vector content, faulty shapes) is left out with one warning for each
/// kind. `file`, `loader`: as in read_svg.
/// Errors: bad_input, limit, cancelled, out_of_memory.
Result<PlainSvg> read_plain_svg(Context& context, std::string_view text, const std::string& file,
                                const ResourceLoader* loader = nullptr);

}  // namespace sfumato::svg
