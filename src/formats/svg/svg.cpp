#include "sfumato/formats/svg/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/ascii.hpp"
#include "base/public_verb.hpp"
#include "formats/css/color.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/bare.hpp"
#include "formats/svg/input.hpp"
#include "formats/svg/picture_size.hpp"
#include "formats/svg/plain_svg.hpp"
#include "formats/svg/shapes.hpp"
#include "formats/svg/stack_reader.hpp"
#include "formats/svg/view_box.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato {
namespace {

constexpr std::string_view kVersion = "1";

using svg::Axis;
using svg::Element;
using svg::Input;

/// In the order of InterpolationSpace.
constexpr std::array<std::string_view, 3> kSpaces{"srgb", "linear", "oklab"};

bool is_within_limits(const Box& box) {
  const double largest = std::max(
      {std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
  return largest <= limits::kCoordinate;
}

/// viewBox, else width and height.
Result<Box> read_artboard(Input& input) {
  const Element root = input.root();
  if (const auto text = input.attribute(root, "viewBox")) {
    Result<Box> box = svg::parse_view_box(*text);
    if (!box) return input.in(root, "viewBox", box.status());
    if (is_within_limits(*box)) return box;
    return input.error(root, "viewBox of <svg> reaches farther than " +
                                 std::to_string(static_cast<long>(limits::kCoordinate)) +
                                 " from the origin; expected coordinates within that");
  }
  if (!root.attribute("width") || !root.attribute("height")) {
    return input.error(root, "<svg> has no size; expected viewBox, or width and height");
  }
  Vec2 size;
  for (const auto& [name, axis, value] :
       {std::tuple("width", Axis::x, &size.x), std::tuple("height", Axis::y, &size.y)}) {
    const std::string_view text = root.attribute(name).value();
    if (ascii_trimmed(text).ends_with('%')) {
      return input.error(root, std::string(name) + " of <svg> is " + text::quoted(text) +
                                   ", a share of nothing known; expected a viewBox");
    }
    const Result<double> length = svg::parse_length(text, {{0, 0}, {1, 1}}, axis);
    if (!length) return input.in(root, name, length.status());
    *value = *length;
  }
  if (!(size.x > 0 && size.y > 0)) {
    return input.error(root, "<svg> has no area; expected width and height above 0");
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
                                       "; expected 1, the version that is read here");
}

Status read_interpolation(Input& input, Document& document) {
  const auto text = input.sf(input.root(), "interpolation");
  if (!text) return ok_status();
  const auto found = std::ranges::find(kSpaces, ascii_trimmed(*text));
  if (found == kSpaces.end()) {
    return input.error(input.root(), "sf:interpolation is " + text::quoted(*text) +
                                         "; expected srgb, linear or oklab");
  }
  document.interpolation = static_cast<InterpolationSpace>(found - kSpaces.begin());
  return ok_status();
}

/// sf:background. What a <rect> says counts only where this is absent.
Status read_background(Input& input, Document& document) {
  const auto text = input.sf(input.root(), "background");
  if (!text || css::keyword_of(*text, input.text_poll()) == "none") return ok_status();
  const Result<css::Color> color = css::parse_color(*text, input.text_poll());
  if (!color) return input.in(input.root(), "sf:background", color.status());
  if (color->alpha < 1) {
    return input.error(input.root(), "sf:background is " + text::quoted(*text) +
                                         "; expected an opaque colour, or none");
  }
  document.background = color->color;
  return ok_status();
}

/// Whether nothing in the document is of Sfumato.
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

/// Parses, and finds the artboard and its frame.
Result<Begun> begin(Input& input) {
  if (Status status = input.parse(); !status) return status;
  if (std::string_view(input.root().name()) != "svg") {
    return input.error(input.root(),
                       "the document is a " + svg::tag(input.root()) + "; expected <svg>");
  }
  const Result<Box> artboard = read_artboard(input);
  if (!artboard) return artboard.status();
  Begun begun{{}, {*artboard, {}, {}}};
  begun.document.artboard = *artboard;
  if (input.attribute(input.root(), "viewBox")) {
    begun.frame = svg::read_picture_frame(input, *artboard);
  }
  return begun;
}

Result<ReadDocument> read_layers(Input& input, const ResourceLoader* loader) {
  Result<Begun> begun = begin(input);
  if (!begun) return begun.status();
  Document& document = begun->document;
  Status status = read_version(input);
  if (status) status = read_interpolation(input, document);
  if (status) status = read_background(input, document);
  svg::StackReader reader(input, document, loader);
  if (status) status = reader.read();
  if (!status) return status;
  svg::show_in_frame(begun->frame, document);
  const bool is_empty = document.stack.empty() || !svg::gives_color(document);
  const bool is_foreign = is_empty && warn_of_nothing(input, document);
  if (Status cancelled = input.context().check(); !cancelled) return cancelled;
  if (Status valid = validate(input.context(), document); !valid) return valid;
  ReadDocument result{std::move(document), input.take_warnings(), DocumentFormat::svg, is_foreign};
  result.curve_sources = reader.take_sources();
  return result;
}

Result<svg::PlainSvg> read_plain(Input& input, const ResourceLoader* loader) {
  Result<Begun> begun = begin(input);
  if (!begun) return begun.status();
  svg::PlainSvg plain{std::move(begun->document), {}, {}, {}};
  Status status = read_interpolation(input, plain.document);
  if (status) status = read_background(input, plain.document);
  if (status) status = svg::StackReader(input, plain.document, loader, &plain.shapes).read();
  if (!status) return status;
  svg::show_in_frame(begun->frame, plain.document);
  plain.title = ascii_trimmed(input.root().child("title").child_value());
  plain.warnings = input.take_warnings();
  return plain;
}

/// What `read_input` makes of the text; a failure names the file.
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
                                          const std::string& file, const ResourceLoader* loader) {
  return public_verb(context, [&] { return read_text(context, text, file, loader, read_plain); });
}

}  // namespace sfumato
