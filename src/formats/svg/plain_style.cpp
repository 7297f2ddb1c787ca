#include "formats/svg/plain_style.hpp"

#include <algorithm>
#include <string>

#include "base/ascii.hpp"
#include "base/number.hpp"
#include "formats/css/color.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/length.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

constexpr std::size_t kDashes = 64;  ///< of one list; more are left out

}  // namespace

std::string_view PlainStyle::property(css::Property which, std::string_view initial) const {
  const Input::Cascaded own = input_.cascaded(shape_, which);
  if (own.value) return *own.value;
  if (own.keyword == css::WideKeyword::initial) return initial;
  for (std::size_t i = around_.size(); i-- > 0;) {
    const Input::Cascaded outer = input_.cascaded(around_[i], which);
    if (outer.value) return *outer.value;
    if (outer.keyword == css::WideKeyword::initial) break;
  }
  return initial;
}

std::string PlainStyle::keyword(css::Property which) const {
  return css::keyword_of(property(which, ""), input_.text_poll()).value_or("");
}

bool PlainStyle::stroke_first() const {
  const std::string_view text = property(css::Property::paint_order, "normal");
  const std::optional<css::PaintOrder> order = css::paint_order_of(text, input_.text_poll());
  if (!order) {
    input_.warn("/plain paint-order", shape_,
                "paint-order of " + tag(shape_) + " is " + text::quoted(text.substr(0, 64)) +
                    "; expected normal, or fill, stroke and markers in an order; normal is used");
  }
  return order == css::PaintOrder::stroke_first;
}

float PlainStyle::opacity(css::Property which) const {
  return static_cast<float>(css::share_of(property(which, "1"), input_.text_poll()).value_or(1));
}

Result<std::optional<PlainPaint>> PlainStyle::color_paint(css::Property which,
                                                          std::string_view text) {
  const std::string word = css::keyword_of(text, input_.text_poll()).value_or("");
  if (ascii_trimmed(text).empty() || word == "none") return std::optional<PlainPaint>();
  if (word == "currentcolor") text = property(css::Property::color, "black");
  const Result<css::Color> color = css::parse_color(text, input_.text_poll());
  if (!color && !can_be_left_out(color.status())) return color.status();
  if (!color) {
    const std::string name = css::property_name(which);
    input_.warn("/plain " + name, shape_,
                name + " of " + tag(shape_) + " is left out: " + color.status().message);
    return std::optional<PlainPaint>();
  }
  return std::optional(PlainPaint{color->color, 0, color->alpha});
}

Result<std::optional<PlainPaint>> PlainStyle::server_paint(css::Property which,
                                                           std::string_view url,
                                                           std::string_view fallback,
                                                           Paints& paints,
                                                           const PaintedShape& shape) {
  if (url.size() < 2 || url.front() != '#') return color_paint(which, fallback);
  const Result<std::uint32_t> shader = paints.shader(shape, url.substr(1));
  if (shader) return std::optional(PlainPaint{std::nullopt, *shader, 1});
  if (!can_be_left_out(shader.status())) return shader.status();
  if (!ascii_trimmed(fallback).empty()) return color_paint(which, fallback);
  input_.warn("/plain paint", shape_,
              std::string(css::property_name(which)) + " of " + tag(shape_) +
                  " is left out: " + shader.status().message);
  return std::optional<PlainPaint>();
}

Result<std::optional<PlainPaint>> PlainStyle::paint(css::Property which, Paints& paints,
                                                    const PaintedShape& shape) {
  const bool is_fill = which == css::Property::fill;
  const std::string_view text = property(which, is_fill ? "black" : "none");
  css::Tokenizer tokens(text, input_.text_poll());
  const css::Token first = next_solid(tokens);
  const std::optional<std::string> url = css::take_url(tokens, first);
  Result<std::optional<PlainPaint>> result =
      url ? server_paint(which, *url, text.substr(tokens.position()), paints, shape)
          : color_paint(which, text);
  if (!result || !*result) return result;
  (*result)->opacity *=
      opacity(is_fill ? css::Property::fill_opacity : css::Property::stroke_opacity);
  if ((*result)->opacity <= 0) return std::optional<PlainPaint>();
  return result;
}

Result<double> PlainStyle::length(css::Property which, std::string_view text) const {
  Result<double> value = parse_length(text, viewport_, Axis::diagonal);
  return value ? value : input_.in(shape_, css::property_name(which), value.status());
}

Result<StrokeStyle> PlainStyle::stroke_style() const {
  StrokeStyle style;
  const Result<double> width =
      length(css::Property::stroke_width, property(css::Property::stroke_width, "1"));
  if (!width) return width.status();
  style.width = *width;
  const std::string cap = keyword(css::Property::stroke_linecap);
  const std::string join = keyword(css::Property::stroke_linejoin);
  if (cap == "round") style.cap = StrokeCap::round;
  if (cap == "square") style.cap = StrokeCap::square;
  if (join == "round") style.join = StrokeJoin::round;
  if (join == "bevel") style.join = StrokeJoin::bevel;
  const auto limit = parse_number(property(css::Property::stroke_miterlimit, "4"));
  if (limit && *limit >= 1) style.miter_limit = *limit;
  if (Status status = read_dashes(style); !status) return status;
  return style;
}

Status PlainStyle::read_dashes(StrokeStyle& style) const {
  std::string_view text = property(css::Property::stroke_dasharray, "none");
  if (text == "none") return ok_status();
  double sum = 0;
  while (!text.empty() && style.dashes.size() < kDashes) {
    const std::size_t end = std::min(text.find_first_of(", \t\n\r"), text.size());
    if (end > 0) {
      const Result<double> dash = length(css::Property::stroke_dasharray, text.substr(0, end));
      if (!dash) return dash.status();
      if (*dash < 0) return ok_status();
      style.dashes.push_back(*dash);
      sum += *dash;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!(sum > 0)) style.dashes.clear();
  const std::size_t count = style.dashes.size();
  if (count % 2 == 1) {
    for (std::size_t i = 0; i < count; ++i) style.dashes.push_back(style.dashes[i]);
  }
  const Result<double> offset =
      length(css::Property::stroke_dashoffset, property(css::Property::stroke_dashoffset, "0"));
  if (!offset) return offset.status();
  style.dash_offset = *offset;
  return ok_status();
}

}  // namespace sfumato::svg
