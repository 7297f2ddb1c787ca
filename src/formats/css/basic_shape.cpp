#include "formats/css/basic_shape.hpp"

#include <algorithm>

#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;
using ShapeKind = BasicShape::Kind;
using ShapeExtent = BasicShape::Extent;

struct BoxName {
  std::string_view name;
  ReferenceBox box;
};

constexpr std::array<BoxName, 7> kBoxes{{{"fill-box", ReferenceBox::fill},
                                         {"content-box", ReferenceBox::fill},
                                         {"padding-box", ReferenceBox::fill},
                                         {"stroke-box", ReferenceBox::stroke},
                                         {"border-box", ReferenceBox::stroke},
                                         {"margin-box", ReferenceBox::stroke},
                                         {"view-box", ReferenceBox::view}}};

std::optional<ReferenceBox> box_named(const Token& token) {
  const BoxName* known = token.is(ident) ? find_named(kBoxes, token.value) : nullptr;
  return known ? std::optional(known->box) : std::nullopt;
}

/// Reads the arguments of one function. `token` is the next one to be read.
class ShapeParser {
 public:
  ShapeParser(Tokenizer& tokens, bool needs_unit,
              FunctionRef<void(const Length&, const Length&)> point)
      : tokens_(tokens), needs_unit_(needs_unit), point_(point) {}

  /// Everything behind the function's name. False if it is invalid.
  bool read(std::string_view name, BasicShape& shape);

 private:
  void step() { token_ = next_solid(tokens_); }
  bool at_end() const { return token_.is(close_paren) || token_.is(end); }
  bool is_word(std::string_view word) const {
    return token_.is(ident) && is_named(token_.value, word);
  }
  bool take_word(std::string_view word);
  std::optional<Length> take_length();
  bool take_size(Length& length);
  bool take_radius(BasicShape::Radius& radius);
  bool take_center(BasicShape& shape);
  bool take_place(std::array<BoxOffset, 2>& center);
  bool take_round(BasicShape& shape);
  bool take_corners(std::array<Length, 8>& corners, std::size_t first);
  bool read_circle(BasicShape& shape);
  bool read_ellipse(BasicShape& shape);
  bool read_inset(BasicShape& shape);
  bool read_rect(BasicShape& shape);
  bool read_xywh(BasicShape& shape);
  bool take_rule(BasicShape& shape);
  bool read_polygon(BasicShape& shape);
  bool read_path(BasicShape& shape);

  Tokenizer& tokens_;
  bool needs_unit_;
  FunctionRef<void(const Length&, const Length&)> point_;
  Token token_;
};

bool ShapeParser::take_word(std::string_view word) {
  if (!is_word(word)) return false;
  step();
  return true;
}

std::optional<Length> ShapeParser::take_length() {
  const auto length = length_of(token_);
  const bool is_bare = length && length->unit == Unit::number && length->value != 0;
  if (!length || (is_bare && needs_unit_)) return std::nullopt;
  step();
  return length;
}

/// A length of 0 or more.
bool ShapeParser::take_size(Length& length) {
  const auto taken = take_length();
  if (!taken || taken->value < 0) return false;
  length = *taken;
  return true;
}

bool ShapeParser::take_radius(BasicShape::Radius& radius) {
  if (take_word("closest-side")) {
    radius.extent = ShapeExtent::closest_side;
    return true;
  }
  if (take_word("farthest-side")) {
    radius.extent = ShapeExtent::farthest_side;
    return true;
  }
  radius.extent = ShapeExtent::length;
  return take_size(radius.length);
}

/// Reads `at` and a position, if there is one.
bool ShapeParser::take_center(BasicShape& shape) {
  return !take_word("at") || take_place(shape.center);
}

/// One part of a position: a word, with a length behind it or not, or a length.
struct PositionPart {
  bool is_x = true, is_y = true;  ///< which of the two it may be
  bool is_word = false, has_length = false;
  BoxOffset offset{{50, Unit::percent}, false};
};

struct SideName {
  std::string_view name;
  bool is_x, is_y, is_end;
};

constexpr std::array<SideName, 5> kSides{{{"left", true, false, false},
                                          {"right", true, false, true},
                                          {"top", false, true, false},
                                          {"bottom", false, true, true},
                                          {"center", true, true, false}}};

std::optional<PositionPart> side_named(const Token& token) {
  const SideName* side = token.is(ident) ? find_named(kSides, token.value) : nullptr;
  if (!side) return std::nullopt;
  PositionPart part{side->is_x, side->is_y, true};
  if (!(side->is_x && side->is_y)) part.offset = {{0, Unit::percent}, side->is_end};
  return part;
}

/// A position: one or two words or lengths, or two words with a length behind each.
bool ShapeParser::take_place(std::array<BoxOffset, 2>& center) {
  std::array<PositionPart, 4> parts{};
  std::size_t count = 0;
  for (; !at_end() && !is_word("round"); ++count) {
    if (count == parts.size()) return false;
    PositionPart& part = parts[count];
    if (const auto side = side_named(token_)) {
      part = *side;
      step();
    } else if (const auto length = take_length()) {
      part.offset.length = *length;
    } else {
      return false;
    }
  }
  if (count == 4) {
    for (const std::size_t i : {0U, 2U}) {
      const bool is_pair =
          parts[i].is_word && !parts[i + 1].is_word && parts[i].is_x != parts[i].is_y;
      if (!is_pair) return false;
      parts[i].offset.length = parts[i + 1].offset.length;
    }
    parts[1] = parts[2];
  } else if (count == 0 || count == 3) {
    return false;
  }
  PositionPart first = parts[0], second = count == 1 ? PositionPart{} : parts[1];
  const bool both_words = first.is_word && second.is_word;
  const bool is_swapped = !first.is_x || (!second.is_y && (both_words || count == 1));
  if (is_swapped) std::swap(first, second);
  center = {first.offset, second.offset};
  // With a length, x comes first.
  if (is_swapped && count == 2 && !both_words) return false;
  return first.is_x && second.is_y;
}

/// Reads `round` and the radii of corners, if there are any.
bool ShapeParser::take_round(BasicShape& shape) {
  if (!take_word("round")) return true;
  if (!take_corners(shape.corners, 0)) return false;
  if (!token_.is_delim('/')) {
    std::copy_n(shape.corners.begin(), 4, shape.corners.begin() + 4);
    return true;
  }
  step();
  return take_corners(shape.corners, 4);
}

/// Reads one to four radii; a missing radius equals the opposite one.
bool ShapeParser::take_corners(std::array<Length, 8>& corners, std::size_t first) {
  std::size_t count = 0;
  while (count < 4 && !at_end() && !token_.is(delim)) {
    if (!take_size(corners[first + count])) return false;
    ++count;
  }
  if (count == 0) return false;
  if (count < 2) corners[first + 1] = corners[first];
  if (count < 3) corners[first + 2] = corners[first];
  if (count < 4) corners[first + 3] = corners[first + 1];
  return true;
}

bool ShapeParser::read_circle(BasicShape& shape) {
  shape.kind = ShapeKind::circle;
  if (!at_end() && !is_word("at") && !take_radius(shape.radius[0])) return false;
  return take_center(shape);
}

bool ShapeParser::read_ellipse(BasicShape& shape) {
  shape.kind = ShapeKind::ellipse;
  const bool has_radii = !at_end() && !is_word("at");
  if (has_radii && !(take_radius(shape.radius[0]) && take_radius(shape.radius[1]))) return false;
  return take_center(shape);
}

bool ShapeParser::read_inset(BasicShape& shape) {
  shape.kind = ShapeKind::inset;
  std::size_t count = 0;
  for (; count < 4 && !at_end() && !is_word("round"); ++count) {
    const auto length = take_length();
    if (!length) return false;
    shape.edges[count].length = *length;
  }
  if (count == 0) return false;
  auto& [top, right, bottom, left] = shape.edges;
  if (count < 2) right = top;
  if (count < 3) bottom = top;
  if (count < 4) left = right;
  right.from_end = bottom.from_end = true;
  return take_round(shape);
}

bool ShapeParser::read_rect(BasicShape& shape) {
  shape.kind = ShapeKind::inset;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_far = i == 1 || i == 2;
    if (take_word("auto")) {
      shape.edges[i] = {{0, Unit::px}, is_far};
      continue;
    }
    const auto length = take_length();
    if (!length) return false;
    shape.edges[i].length = *length;
  }
  return take_round(shape);
}

bool ShapeParser::read_xywh(BasicShape& shape) {
  shape.kind = ShapeKind::xywh;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto length = take_length();
    if (!length || (i >= 2 && length->value < 0)) return false;
    shape.edges[i].length = *length;
  }
  return take_round(shape);
}

/// Reads a fill rule and its comma, if there are any.
bool ShapeParser::take_rule(BasicShape& shape) {
  if (!token_.is(ident)) return true;
  shape.even_odd = is_word("evenodd");
  if (!shape.even_odd && !is_word("nonzero")) return false;
  step();
  if (!token_.is(comma)) return false;
  step();
  return true;
}

bool ShapeParser::read_polygon(BasicShape& shape) {
  shape.kind = ShapeKind::polygon;
  if (!take_rule(shape)) return false;
  for (;;) {
    const auto x = take_length();
    const auto y = x ? take_length() : std::nullopt;
    if (!y) return false;
    point_(*x, *y);
    if (!token_.is(comma)) return true;
    step();
  }
}

bool ShapeParser::read_path(BasicShape& shape) {
  shape.kind = ShapeKind::path;
  if (!take_rule(shape)) return false;
  if (!token_.is(string) || token_.value.find('\\') != std::string_view::npos) return false;
  shape.path = token_.value;
  step();
  return true;
}

bool ShapeParser::read(std::string_view name, BasicShape& shape) {
  using Read = bool (ShapeParser::*)(BasicShape&);
  struct Function {
    std::string_view name;
    Read read;
  };
  constexpr std::array<Function, 7> kFunctions{{{"circle", &ShapeParser::read_circle},
                                                {"ellipse", &ShapeParser::read_ellipse},
                                                {"inset", &ShapeParser::read_inset},
                                                {"rect", &ShapeParser::read_rect},
                                                {"xywh", &ShapeParser::read_xywh},
                                                {"polygon", &ShapeParser::read_polygon},
                                                {"path", &ShapeParser::read_path}}};
  const Function* known = find_named(kFunctions, name);
  if (!known) return false;
  step();
  return (this->*known->read)(shape) && at_end();
}

}  // namespace

std::optional<BasicShape> read_basic_shape(std::string_view text, bool needs_unit, TextPoll& poll,
                                           FunctionRef<void(const Length&, const Length&)> point) {
  Tokenizer tokens(text, poll);
  BasicShape shape;
  bool has_box = false, has_shape = false;
  Token token = next_solid(tokens);
  for (; !token.is(end); token = next_solid(tokens)) {
    if (const auto box = has_box ? std::nullopt : box_named(token)) {
      shape.box = *box;
      has_box = true;
      continue;
    }
    if (has_shape || !token.is(function)) return std::nullopt;
    has_shape = true;
    if (!ShapeParser(tokens, needs_unit, point).read(token.value, shape)) return std::nullopt;
  }
  if (!has_box && !has_shape) return std::nullopt;
  return shape;
}

bool is_clip_path(std::string_view text, bool needs_unit, TextPoll& poll) {
  if (keyword_of(text, poll) == "none") return true;
  Tokenizer tokens(text, poll);
  if (take_url(tokens, next_solid(tokens))) return true;
  return read_basic_shape(text, needs_unit, poll, [](const Length&, const Length&) {}).has_value();
}

}  // namespace sfumato::css
