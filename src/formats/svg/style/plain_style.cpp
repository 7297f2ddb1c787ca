#include "formats/svg/style/plain_style.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include "base/limit_error.hpp"
#include "base/text/ascii.hpp"
#include "base/text/number.hpp"
#include "base/try.hpp"
#include "formats/svg/style/color.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

/// The values of image-rendering and shape-rendering, in lower case.
constexpr std::string_view kHardEdges[] = {"crisp-edges", "crispedges", "optimizespeed",
                                           "pixelated"};

}  // namespace

double stroke_reach(const StrokeStyle& style) {
  const double corner = style.join == StrokeJoin::miter ? style.miter_limit : 1;
  return style.width / 2 * std::max(corner, std::numbers::sqrt2);
}

std::string_view PlainStyle::property(css::Property which, std::string_view initial) const {
  const Input::Cascaded own = input_.cascaded(scope(), which);
  if (own.value) return *own.value;
  const bool goes_up = own.keyword == css::WideKeyword::inherit ||
                       (own.keyword != css::WideKeyword::initial && css::is_inherited(which));
  return goes_up ? levels_.value(which).value_or(initial) : initial;
}

std::string PlainStyle::keyword(css::Property which) const {
  return css::keyword_of(property(which, ""), input_.text_poll()).value_or("");
}

css::PaintOrder PlainStyle::paint_order() const {
  const std::string_view text = property(css::Property::paint_order, "normal");
  const std::optional<css::PaintOrder> order = css::paint_order_of(text, input_.text_poll());
  if (!order) {
    input_.warn("/plain paint-order", shape_,
                "paint-order of " + tag(shape_) + " is " + text::quoted(text.substr(0, 64)) +
                    "; use normal, or fill, stroke and markers in an order; normal is used");
  }
  return order.value_or(css::kNormalPaintOrder);
}

float PlainStyle::opacity(css::Property which) const {
  return static_cast<float>(css::share_of(property(which, "1"), input_.text_poll()).value_or(1));
}

/// Returns no value for other words than the context's.
std::optional<std::optional<PlainPaint>> PlainStyle::context_paint(std::string_view word) const {
  if (word == "context-fill") return context_.fill;
  if (word == "context-stroke") return context_.stroke;
  return std::nullopt;
}

bool PlainStyle::asks_for_context() const {
  const auto is_context = [this](css::Property which) {
    css::Tokenizer tokens(property(which, ""), input_.text_poll());
    css::Token first = css::next_solid(tokens);
    if (css::take_url(tokens, first)) first = css::next_solid(tokens);  // the fallback
    return first.is(css::TokenType::ident) && (css::is_named(first.value, "context-fill") ||
                                               css::is_named(first.value, "context-stroke"));
  };
  return is_context(css::Property::fill) || is_context(css::Property::stroke);
}

Result<std::optional<PlainPaint>> PlainStyle::color_paint(css::Property which,
                                                          std::string_view text) {
  const std::string word = css::keyword_of(text, input_.text_poll()).value_or("");
  if (ascii_trimmed(text).empty() || word == "none") return std::optional<PlainPaint>();
  if (const auto context = context_paint(word)) return *context;
  if (word == "currentcolor") text = property(css::Property::color, "black");
  const std::string name = css::property_name(which);
  const Result<css::Color> color = parse_color(input_, shape_, name, text);
  if (!color && !can_be_left_out(color.status())) return color.status();
  if (!color) {
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

Result<std::optional<PlainPaint>> PlainStyle::bare_paint(css::Property which, Paints& paints,
                                                         const PaintedShape& shape) {
  const std::string_view text = property(which, which == css::Property::fill ? "black" : "none");
  css::Tokenizer tokens(text, input_.text_poll());
  const css::Token first = next_solid(tokens);
  const std::optional<std::string> url = css::take_url(tokens, first);
  return url ? server_paint(which, *url, text.substr(tokens.position()), paints, shape)
             : color_paint(which, text);
}

Result<std::optional<PlainPaint>> PlainStyle::paint(css::Property which, Paints& paints,
                                                    const PaintedShape& shape) {
  Result<std::optional<PlainPaint>> result = bare_paint(which, paints, shape);
  if (!result || !*result) return result;
  (*result)->opacity *= opacity(which == css::Property::fill ? css::Property::fill_opacity
                                                             : css::Property::stroke_opacity);
  if ((*result)->opacity <= 0) return std::optional<PlainPaint>();
  return result;
}

Result<double> PlainStyle::length(css::Property which, std::string_view text) const {
  Result<double> value = input_.length(scope(), text, viewport_, Axis::diagonal);
  return value ? value : input_.in(shape_, css::property_name(which), value.status());
}

Result<double> PlainStyle::stroke_width() const {
  return length(css::Property::stroke_width, property(css::Property::stroke_width, "1"));
}

std::string_view PlainStyle::marker(css::Property which) const {
  return property(which, "none");
}

Result<StrokeStyle> PlainStyle::stroke_style() const {
  StrokeStyle style;
  SFUMATO_TRY_ASSIGN(const double width, stroke_width());
  style.width = width;
  const std::string cap = keyword(css::Property::stroke_linecap);
  const std::string join = keyword(css::Property::stroke_linejoin);
  if (cap == "round") style.cap = StrokeCap::round;
  if (cap == "square") style.cap = StrokeCap::square;
  if (join == "round") style.join = StrokeJoin::round;
  if (join == "bevel") style.join = StrokeJoin::bevel;
  const auto limit = parse_number(property(css::Property::stroke_miterlimit, "4"));
  if (limit && *limit >= 1) style.miter_limit = *limit;
  SFUMATO_TRY(read_dashes(style));
  if (keyword(css::Property::vector_effect) == "non-scaling-stroke") fix_scale(style);
  warn_of_vector_effect();
  return style;
}

/// Lengths are px of the picture then.
void PlainStyle::fix_scale(StrokeStyle& style) const {
  const double scale = input_.units_per_px();
  style.is_scaled = false;
  style.width *= scale;
  style.dash_offset *= scale;
  style.path_length *= scale;
  for (double& dash : style.dashes) dash *= scale;
}

void PlainStyle::warn_of_rendering(css::Property which) const {
  const std::string word = keyword(which);
  if (std::ranges::find(kHardEdges, word) == std::end(kHardEdges)) return;
  const std::string name = css::property_name(which);
  input_.warn("/plain " + name, shape_,
              name + " of " + tag(shape_) + " is not followed: what should be hard is smooth");
}

void PlainStyle::warn_of_vector_effect() const {
  const std::string effect = keyword(css::Property::vector_effect);
  if (effect.empty() || effect == "none" || effect == "non-scaling-stroke") return;
  input_.warn("/plain vector-effect", shape_,
              "vector-effect of " + tag(shape_) + " is not read; use non-scaling-stroke");
}

/// The attribute `pathLength`; 0 where it is missing or not above 0.
double PlainStyle::said_path_length() const {
  const auto text = input_.attribute(shape_, "pathLength");
  if (!text) return 0;
  const auto length = parse_number(ascii_trimmed(*text));
  if (length && *length > 0) return *length;
  input_.warn("/plain pathLength", shape_,
              "pathLength of " + tag(shape_) +
                  " is ignored: dashes keep their lengths; expected a number above 0");
  return 0;
}

Status PlainStyle::read_dashes(StrokeStyle& style) const {
  const std::string_view text = property(css::Property::stroke_dasharray, "none");
  css::Tokenizer tokens(text, input_.text_poll());
  double sum = 0;
  for (css::Token token = next_solid(tokens); !token.is(css::TokenType::end);
       token = next_solid(tokens)) {
    if (token.is(css::TokenType::ident)) return ok_status();  // none
    if (token.is(css::TokenType::comma)) continue;
    if (style.dashes.size() >= input_.limits().dash_lengths) {
      input_.warn("/plain dashes", shape_,
                  "stroke-dasharray of " + tag(shape_) + " has more than the limit of " +
                      limit_text(input_.limits(), &Limits::dash_lengths, "lengths") +
                      "; the rest is left out; raise the limit dash-lengths");
      break;
    }
    SFUMATO_TRY_ASSIGN(const double dash, length(css::Property::stroke_dasharray, token.text));
    style.dashes.push_back(dash);
    sum += dash;
  }
  if (!(sum > 0)) style.dashes.clear();
  const std::size_t count = style.dashes.size();
  if (count % 2 == 1) {
    for (std::size_t i = 0; i < count; ++i) style.dashes.push_back(style.dashes[i]);
  }
  SFUMATO_TRY_ASSIGN(const double offset, length(css::Property::stroke_dashoffset,
                                                 property(css::Property::stroke_dashoffset, "0")));
  style.dash_offset = offset;
  style.path_length = said_path_length();
  return ok_status();
}

}  // namespace sfumato::svg
