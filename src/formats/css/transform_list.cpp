#include "formats/css/transform_list.hpp"

#include <algorithm>

#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;
using FunctionKind = TransformFunction::Kind;

/// The kinds of a function's arguments.
enum class ArgumentSort : std::uint8_t { number, length, angle };

struct FunctionRule {
  std::string_view name;
  FunctionKind kind;
  ArgumentSort sort;
  std::size_t least, most;  ///< arguments
  std::uint8_t axes;        ///< 1: x, 2: y, 3: both in order, 4: none
};

constexpr std::array<FunctionRule, 16> kRules{
    {{"matrix", FunctionKind::matrix, ArgumentSort::number, 6, 6, 3},
     {"translate", FunctionKind::translate, ArgumentSort::length, 1, 2, 3},
     {"translatex", FunctionKind::translate, ArgumentSort::length, 1, 1, 1},
     {"translatey", FunctionKind::translate, ArgumentSort::length, 1, 1, 2},
     {"translatez", FunctionKind::translate, ArgumentSort::length, 1, 1, 4},
     {"translate3d", FunctionKind::translate, ArgumentSort::length, 3, 3, 3},
     {"scale", FunctionKind::scale, ArgumentSort::number, 1, 2, 3},
     {"scalex", FunctionKind::scale, ArgumentSort::number, 1, 1, 1},
     {"scaley", FunctionKind::scale, ArgumentSort::number, 1, 1, 2},
     {"scalez", FunctionKind::scale, ArgumentSort::number, 1, 1, 4},
     {"scale3d", FunctionKind::scale, ArgumentSort::number, 3, 3, 3},
     {"rotate", FunctionKind::rotate, ArgumentSort::angle, 1, 1, 1},
     {"rotatez", FunctionKind::rotate, ArgumentSort::angle, 1, 1, 1},
     {"skew", FunctionKind::skew, ArgumentSort::angle, 1, 2, 3},
     {"skewx", FunctionKind::skew, ArgumentSort::angle, 1, 1, 1},
     {"skewy", FunctionKind::skew, ArgumentSort::angle, 1, 1, 2}}};

struct TransformArguments {
  std::array<Length, 6> value{};
  std::size_t count = 0;
};

/// Returns a length with its unit, or 0.
std::optional<Length> offset_of(const Token& token, bool needs_unit) {
  const auto length = length_of(token);
  if (!length || !needs_unit || length->unit != Unit::number || length->value == 0) return length;
  return std::nullopt;
}

std::optional<Length> argument_of(const Token& token, const FunctionRule& rule) {
  if (rule.sort == ArgumentSort::length) return offset_of(token, true);
  if (rule.sort == ArgumentSort::angle) {
    const auto degrees = degrees_of(token);
    if (!degrees || (token.is(number) && *degrees != 0)) return std::nullopt;
    return Length{*degrees};
  }
  const bool is_share = token.is(percentage) && rule.kind == FunctionKind::scale;
  const auto value = token.is(number) || is_share ? number_of(token) : std::nullopt;
  if (!value) return std::nullopt;
  return Length{is_share ? *value / 100 : *value};
}

/// Everything behind the function's name, its parenthesis included.
bool take_arguments(Tokenizer& tokens, const FunctionRule& rule, TransformArguments& arguments) {
  for (;;) {
    const auto argument = argument_of(next_solid(tokens), rule);
    if (!argument || arguments.count == rule.most) return false;
    arguments.value[arguments.count++] = *argument;
    const Token next = next_solid(tokens);
    if (next.is(close_paren) || next.is(end)) return arguments.count >= rule.least;
    if (!next.is(comma)) return false;
  }
}

TransformFunction function_of(const FunctionRule& rule, const TransformArguments& arguments) {
  TransformFunction function{rule.kind};
  for (std::size_t i = 0; i < arguments.count; ++i) {
    function.number[i] = arguments.value[i].value;
    if (i < 2) function.offset[i] = arguments.value[i];
  }
  const bool is_one = arguments.count == 1;
  if (rule.kind == FunctionKind::scale && is_one) function.number[1] = function.number[0];
  const double neutral = rule.kind == FunctionKind::scale ? 1 : 0;
  if (rule.axes == 1 && rule.kind != FunctionKind::rotate) function.number[1] = neutral;
  if (rule.axes == 2) {
    function.number[1] = function.number[0];
    function.number[0] = neutral;
    function.offset = {Length{}, function.offset[0]};
  }
  if (rule.axes == 4) {
    function.number = {neutral, neutral};
    function.offset = {};
  }
  return function;
}

const FunctionRule* rule_of(const Token& token) {
  return token.is(function) ? find_named(kRules, token.value) : nullptr;
}

const FunctionRule* rule_of(Property property) {
  const std::string_view name = property_name(property);
  const auto rule = std::ranges::find(kRules, name, &FunctionRule::name);
  return rule == kRules.end() ? nullptr : &*rule;
}

/// Returns whether a token is the axis of a `rotate` within the plane. The axis stands before or
/// after the angle.
bool is_plane_axis(const Token& token) {
  return token.is(ident) && is_named(token.value, "z");
}

/// Reads the value of `rotate`: an angle, alone or with the axis z. No value for other axes.
std::optional<Length> turn_of(Tokenizer& tokens, const FunctionRule& rule) {
  Token token = next_solid(tokens);
  const bool has_axis = is_plane_axis(token);
  if (has_axis) token = next_solid(tokens);
  const auto angle = argument_of(token, rule);
  const Token after = next_solid(tokens);
  if (after.is(end)) return angle;
  const bool is_axis_last = !has_axis && is_plane_axis(after) && next_solid(tokens).is(end);
  return is_axis_last ? angle : std::nullopt;
}

/// A word or a length of `transform-origin`.
struct OriginPart {
  bool is_x = true, is_y = true;  ///< which of the two it may be
  Length length{50, Unit::percent};
};

std::optional<OriginPart> origin_part(const Token& token, bool needs_unit) {
  if (!token.is(ident)) {
    const auto length = offset_of(token, needs_unit);
    if (!length) return std::nullopt;
    return OriginPart{true, true, *length};
  }
  const auto is = [&](std::string_view word) { return is_named(token.value, word); };
  if (is("center")) return OriginPart{};
  if (is("left") || is("right")) {
    return OriginPart{true, false, {is("left") ? 0.0 : 100.0, Unit::percent}};
  }
  if (is("top") || is("bottom")) {
    return OriginPart{false, true, {is("top") ? 0.0 : 100.0, Unit::percent}};
  }
  return std::nullopt;
}

}  // namespace

bool read_transform_list(std::string_view text, TextPoll& poll,
                         FunctionRef<void(const TransformFunction&)> sink) {
  Tokenizer tokens(text, poll);
  Token token = next_solid(tokens);
  if (token.is(ident)) return is_named(token.value, "none") && next_solid(tokens).is(end);
  if (token.is(end)) return false;
  for (; !token.is(end); token = next_solid(tokens)) {
    const FunctionRule* rule = rule_of(token);
    TransformArguments arguments;
    if (!rule || !take_arguments(tokens, *rule, arguments)) return false;
    sink(function_of(*rule, arguments));
  }
  return true;
}

std::optional<TransformFunction> transform_step_of(Property property, std::string_view text,
                                                   TextPoll& poll) {
  const FunctionRule* rule = rule_of(property);
  if (!rule) return std::nullopt;
  if (keyword_of(text, poll) == "none") return TransformFunction{FunctionKind::translate};
  Tokenizer tokens(text, poll);
  TransformArguments arguments;
  if (property == Property::rotate) {
    const auto angle = turn_of(tokens, *rule);
    if (!angle) return std::nullopt;
    arguments.value[arguments.count++] = *angle;
    return function_of(*rule, arguments);
  }
  constexpr std::size_t kMost = 3;  // the third is a depth
  for (Token token = next_solid(tokens); !token.is(end); token = next_solid(tokens)) {
    const auto argument = argument_of(token, *rule);
    const bool is_depth = arguments.count + 1 == kMost;
    if (!argument || arguments.count == kMost) return std::nullopt;
    if (is_depth && argument->unit == Unit::percent) return std::nullopt;
    arguments.value[arguments.count++] = *argument;
  }
  if (arguments.count == 0) return std::nullopt;
  return function_of(*rule, arguments);
}

std::optional<std::array<Length, 2>> transform_origin_of(std::string_view text, bool needs_unit,
                                                         TextPoll& poll) {
  Tokenizer tokens(text, poll);
  const auto first = origin_part(next_solid(tokens), needs_unit);
  if (!first) return std::nullopt;
  const Token token = next_solid(tokens);
  if (token.is(end)) {
    if (!first->is_x) return std::array{Length{50, Unit::percent}, first->length};
    return std::array{first->length, Length{50, Unit::percent}};
  }
  const auto second = origin_part(token, needs_unit);
  if (!second) return std::nullopt;
  // The third is a depth, which moves nothing in the plane.
  const Token depth = next_solid(tokens);
  const auto z =
      depth.is(end) ? Length{} : offset_of(depth, needs_unit).value_or(Length{0, Unit::percent});
  if (z.unit == Unit::percent || !next_solid(tokens).is(end)) return std::nullopt;
  if (first->is_x && second->is_y) return std::array{first->length, second->length};
  if (first->is_y && second->is_x) return std::array{second->length, first->length};
  return std::nullopt;
}

}  // namespace sfumato::css
