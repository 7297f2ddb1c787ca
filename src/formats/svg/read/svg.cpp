#include "sfumato/formats/svg/svg.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "base/limit_error.hpp"
#include "base/public_verb.hpp"
#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "document/names.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/paint/background.hpp"
#include "formats/svg/paint/picture_size.hpp"
#include "formats/svg/read/bare.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/read/plain_reader.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "formats/svg/read/stack_reader.hpp"
#include "formats/svg/shapes/element_transform.hpp"
#include "formats/svg/style/color.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato {
namespace {

constexpr std::string_view kVersion = "1";
/// The viewport of an ordinary SVG whose size is open, in px: that of browsers.
constexpr Vec2 kViewport{300, 150};

using svg::Axis;
using svg::Element;
using svg::Input;

/// viewBox, else width and height.
Result<Box> read_artboard(Input& input) {
  const Element root = input.root();
  SFUMATO_TRY_ASSIGN(const std::optional<Box>& view_box, svg::read_view_box(input));
  if (view_box) return *view_box;
  if (!root.attribute("width") || !root.attribute("height")) {
    return input.error(root, "<svg> has no size; add viewBox, or width and height");
  }
  Vec2 size;
  for (const auto& [name, axis, value] :
       {std::tuple("width", Axis::x, &size.x), std::tuple("height", Axis::y, &size.y)}) {
    const std::string_view text = root.attribute(name).value();
    if (ascii_trimmed(text).ends_with('%')) {
      return input.error(root, std::string(name) + " of <svg> is " + text::quoted(text) +
                                   ", a share of nothing known; add a viewBox");
    }
    const Result<double> length = svg::parse_length(text, {{0, 0}, {1, 1}}, axis);
    if (!length) return input.in(root, name, length.status());
    *value = *length;
  }
  if (!(size.x > 0 && size.y > 0)) {
    return input.error(root, "<svg> has no area; use width and height above 0");
  }
  return Box{{0, 0}, size};
}

Status read_version(Input& input) {
  const auto version = input.sf(input.root(), "version");
  if (!version) {
    input.warn("/version", input.root(), "<svg> has no sf:version; it is read as version 1");
    return ok_status();
  }
  if (ascii_trimmed(*version) == kVersion) return ok_status();
  return input.error(input.root(), "sf:version is " + text::quoted(*version) +
                                       "; use 1, the version that is read here");
}

Status read_interpolation(Input& input, Document& document) {
  const auto text = input.sf(input.root(), "interpolation");
  if (!text) return ok_status();
  const auto found = std::ranges::find(kSpaceNames, ascii_trimmed(*text));
  if (found == kSpaceNames.end()) {
    return input.error(
        input.root(), "sf:interpolation is " + text::quoted(*text) + "; use srgb, linear or oklab");
  }
  document.interpolation = static_cast<InterpolationSpace>(found - kSpaceNames.begin());
  return ok_status();
}

/// Reads sf:background. A <rect> counts only if this attribute is absent.
Status read_background(Input& input, Document& document) {
  const auto text = input.sf(input.root(), "background");
  if (!text || css::keyword_of(*text, input.text_poll()) == "none") return ok_status();
  const Result<css::Color> color = svg::parse_color(input, input.root(), "sf:background", *text);
  if (!color) return input.in(input.root(), "sf:background", color.status());
  if (color->alpha < 1) {
    return input.error(input.root(), "sf:background is " + text::quoted(*text) +
                                         "; use an opaque colour, or none");
  }
  document.background = color->color;
  return ok_status();
}

/// The background that a style of an ordinary <svg> says, where sf:background says none: one that
/// is not opaque is the lowest shape.
Status paint_root_background(Input& input, const svg::PictureFrame& frame, bool is_size_open,
                             svg::PlainReader& reader, Document& document) {
  if (input.sf(input.root(), "background")) return ok_status();
  const Result<std::optional<css::Color>> color = svg::read_root_background(input);
  if (!color || !*color) return color.status();
  const css::Color& found = **color;
  if (found.alpha >= 1) {
    document.background = found.color;
    return ok_status();
  }
  if (is_size_open) {
    input.warn("/background", input.root(),
               "background of <svg> is left out: it is not opaque, and <svg> has no size");
    return ok_status();
  }
  const Affine view_box_from_artboard = inverse(frame.artboard_from_view_box);
  const Box& shown = frame.artboard;
  return reader.paint_backdrop(
      {view_box_from_artboard(shown.min), view_box_from_artboard(shown.max)},
      {found.color, 0, found.alpha});
}

/// The transform of an ordinary <svg>.
Status place_root(Input& input, const svg::PictureFrame& frame, bool is_size_open,
                  svg::PlainReader& reader) {
  if (!svg::has_transform(input, input.root())) return ok_status();
  if (is_size_open) {
    input.warn("/transform of svg", input.root(),
               "transform of <svg> is left out: <svg> has no size; add a viewBox");
    return ok_status();
  }
  const Result<Affine> map = svg::root_map(input, frame);
  if (!map) return input.ignore(input.root(), map.status());
  reader.place_root(*map);
  return ok_status();
}

/// Returns whether nothing in the document is of Sfumato.
bool warn_of_nothing(Input& input, const Document& document) {
  std::string message = document.stack.empty()
                            ? "the document has no layer and no local curve: the picture is empty"
                            : "no curve of the document bears a colour: the picture is empty";
  const svg::EmptyCause why = svg::why_empty(input);
  if (!why.text.empty()) message += "; " + why.text;
  input.warn("/no layers", input.root(), std::move(message));
  return why.is_foreign;
}

/// A document without content, and how it is shown.
struct Begun {
  Document document;
  svg::PictureFrame frame;
};

Status parse(Input& input) {
  SFUMATO_TRY(input.parse());
  if (std::string_view(input.root().name()) == "svg") return ok_status();
  return input.error(input.root(), "the document is a " + svg::tag(input.root()) + "; use <svg>");
}

Begun shown(Input& input, const Box& artboard, bool has_view_box) {
  Begun begun{{}, {artboard, {}, {}}};
  begun.document.artboard = artboard;
  if (has_view_box) begun.frame = svg::read_picture_frame(input, artboard);
  const Box& box = begun.frame.artboard;
  const Vec2 size_px = begun.frame.size_px.value_or(Vec2{box.width(), box.height()});
  input.set_picture(size_px, box.width() / size_px.x);
  return begun;
}

/// Parses, and finds the artboard and its frame.
Result<Begun> begin(Input& input) {
  SFUMATO_TRY(parse(input));
  SFUMATO_TRY_ASSIGN(const Box& artboard, read_artboard(input));
  return shown(input, artboard, input.attribute(input.root(), "viewBox").has_value());
}

/// begin() for an ordinary SVG, whose size may be open.
Result<Begun> begin_plain(Input& input, std::optional<svg::OpenSize>& open_size) {
  SFUMATO_TRY(parse(input));
  const Result<std::optional<Box>> view_box = svg::read_view_box(input);
  if (view_box && *view_box) return shown(input, **view_box, true);
  if (!view_box) {
    input.warn("/viewBox", input.root(), view_box.status().message + "; it is ignored");
  }
  const svg::OpenSize size = svg::read_open_size(input);
  if (!size.width || !size.height) {
    open_size = size;
    input.warn("/size", input.root(),
               "<svg> has no viewBox and no size; the picture is the box of its shapes");
  }
  const Vec2 viewport{size.width.value_or(kViewport.x), size.height.value_or(kViewport.y)};
  return shown(input, {{0, 0}, viewport}, false);
}

Result<ReadDocument> read_layers(Input& input, const ResourceLoader* loader) {
  SFUMATO_TRY_ASSIGN(auto&& begun, begin(input));
  Document& document = begun.document;
  SFUMATO_TRY(read_version(input));
  SFUMATO_TRY(read_interpolation(input, document));
  SFUMATO_TRY(read_background(input, document));
  svg::StackReader reader(input, document, loader);
  SFUMATO_TRY(reader.read());
  svg::show_in_frame(begun.frame, document);
  const bool is_empty = document.stack.empty() || !svg::gives_color(document);
  const bool is_foreign = is_empty && warn_of_nothing(input, document);
  SFUMATO_TRY(input.context().check());
  SFUMATO_TRY(validate(input.context(), document));
  ReadDocument result{std::move(document), input.take_warnings(), DocumentFormat::svg, is_foreign};
  result.curve_sources = reader.take_sources();
  return result;
}

/// A tile with more shapes than there may be stays clear; such a mask is left out.
void leave_tile_out(Input& input, const svg::TileRequest& request, svg::PlainSvg& plain,
                    svg::PlainTile& tile) {
  const bool is_mask = tile.use != svg::TileUse::paint;
  input.warn(
      "/tiles", request.content,
      "there are more than the limit of " +
          limit_text(input.limits(), &Limits::pattern_shapes, "shapes in patterns and masks") +
          "; " +
          (is_mask
               ? "the mask " + svg::hash_id(request.content) + " is left out"
               : svg::tag(request.content) + " " + svg::hash_id(request.content) + " stays clear") +
          "; raise the limit pattern-shapes");
  tile.content.shapes.clear();
  tile.document.stack.clear();
  tile.document.layers.clear();
  if (!is_mask) return;
  svg::PlainContent& owner = tile.owner == 0 ? plain.content : plain.tiles[tile.owner - 1].content;
  auto& texture = std::get<Texture>(owner.mask_shaders[tile.shader].paint);
  std::ranges::fill(texture.rgba, std::uint8_t{255});
}

/// Reads the patterns of vector content, masks and masked groups; nested ones come last.
Status read_tiles(Input& input, const ResourceLoader* loader, svg::TileQueue& queue,
                  svg::PlainSvg& plain) {
  std::size_t shapes = 0;
  for (std::size_t i = 0; i < queue.requests().size(); ++i) {
    const svg::TileRequest request = queue.requests()[i];
    svg::PlainTile tile{request.owner, request.shader, request.use};
    tile.document.artboard = plain.document.artboard;  // for percentages
    tile.document.interpolation = plain.document.interpolation;
    const Box texels{{0, 0},
                     {static_cast<double>(request.width), static_cast<double>(request.height)}};
    queue.set_owner(i + 1, request.depth);
    svg::PlainReader reader(input, tile.document, loader, tile.content);
    reader.use_tiles(queue, 1 / svg::TileQueue::kTexelsPerPx);
    reader.expect_picture(texels);
    SFUMATO_TRY(reader.read_tile(request));
    shapes += tile.content.shapes.size();
    if (shapes > input.limits().pattern_shapes) leave_tile_out(input, request, plain, tile);
    tile.document.artboard = texels;
    plain.tiles.push_back(std::move(tile));
  }
  return ok_status();
}

Result<svg::PlainSvg> read_plain(Input& input, const ResourceLoader* loader, bool with_tiles) {
  input.read_as_ordinary();
  std::optional<svg::OpenSize> open_size;
  SFUMATO_TRY_ASSIGN(auto&& begun, begin_plain(input, open_size));
  svg::PlainSvg plain{std::move(begun.document), {}, {}, {}, open_size};
  plain.units_per_px = input.units_per_px();
  SFUMATO_TRY(read_interpolation(input, plain.document));
  SFUMATO_TRY(read_background(input, plain.document));
  svg::PlainReader reader(input, plain.document, loader, plain.content);
  if (open_size) {
    reader.expect_no_background();
  } else {
    const Affine view_box_from_artboard = inverse(begun.frame.artboard_from_view_box);
    const Box& shown = begun.frame.artboard;
    reader.expect_picture({view_box_from_artboard(shown.min), view_box_from_artboard(shown.max)});
  }
  svg::TileQueue queue;
  if (with_tiles) reader.use_tiles(queue, input.units_per_px() / svg::TileQueue::kTexelsPerPx);
  SFUMATO_TRY(place_root(input, begun.frame, open_size.has_value(), reader));
  SFUMATO_TRY(
      paint_root_background(input, begun.frame, open_size.has_value(), reader, plain.document));
  SFUMATO_TRY(reader.read());
  SFUMATO_TRY(read_tiles(input, loader, queue, plain));
  svg::show_in_frame(begun.frame, plain.document);
  plain.title = ascii_trimmed(input.root().child("title").child_value());
  plain.warnings = input.take_warnings();
  return plain;
}

/// Returns the result of `read_input` for the text. A failure names the file.
template <class Read>
auto read_text(Context& context, std::string_view text, const std::string& file,
               const ResourceLoader* loader, Read read_input) {
  Input input(context, text, file);
  auto result = read_input(input, loader);
  if (result) return result;
  Status status = result.status();
  status.where.file = file;
  return decltype(result)(status);
}

}  // namespace

Result<ReadDocument> read_svg(Context& context, std::string_view text, const std::string& file,
                              const ResourceLoader* loader) {
  return public_verb(context, [&] { return read_text(context, text, file, loader, read_layers); });
}

Result<svg::PlainSvg> svg::read_plain_svg(Context& context, std::string_view text,
                                          const std::string& file, const ResourceLoader* loader,
                                          bool with_tiles) {
  const auto read = [with_tiles](Input& input, const ResourceLoader* of_input) {
    return read_plain(input, of_input, with_tiles);
  };
  return public_verb(context, [&] { return read_text(context, text, file, loader, read); });
}

}  // namespace sfumato
