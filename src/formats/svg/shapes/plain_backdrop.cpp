#include "formats/svg/shapes/plain_backdrop.hpp"

#include <array>
#include <string_view>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/style/color.hpp"

namespace sfumato::svg {
namespace {

using Backdrop = std::optional<BackdropFilter>;

using FilterKind = BackdropFilter::Kind;

constexpr std::array<double, 20> kIdentity{1, 0, 0, 0, 0, 0, 1, 0, 0, 0,
                                           0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
constexpr std::array<double, 20> kInverse{-1, 0, 0,  0, 1, 0, -1, 0, 0, 1,
                                          0,  0, -1, 0, 1, 0, 0,  0, 1, 0};

/// Returns the numbers of a list; no value if there are not as many as a matrix of colours has.
std::optional<std::array<double, 20>> matrix_of(Input& input, std::string_view text) {
  std::array<double, 20> matrix{};
  css::Tokenizer tokens(text, input.text_poll());
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    css::Token token = css::next_solid(tokens);
    if (i > 0 && token.is(css::TokenType::comma)) token = css::next_solid(tokens);
    const auto number = token.is(css::TokenType::number) ? css::number_of(token) : std::nullopt;
    if (!number) return std::nullopt;
    matrix[i] = *number;
  }
  if (!css::next_solid(tokens).is(css::TokenType::end)) return std::nullopt;
  return matrix;
}

/// The matrix of a <feColorMatrix>; a missing matrix changes nothing.
std::optional<FilterKind> kind_of(Input& input, Element filter, Element primitive) {
  if (input.attribute(primitive, "type").value_or("matrix") != "matrix") return std::nullopt;
  const std::string_view values = input.attribute(primitive, "values").value_or("");
  if (ascii_trimmed(values).empty()) return FilterKind::none;
  const auto matrix = matrix_of(input, values);
  if (matrix == kIdentity) return FilterKind::none;
  const auto space = [&](Element element) {
    return ascii_lower(input.attribute(element, "color-interpolation-filters").value_or(""));
  };
  const bool is_of_code = space(primitive) == "srgb" || space(filter) == "srgb";
  if (matrix == kInverse && is_of_code) return FilterKind::inverted;
  return std::nullopt;
}

/// Returns whether a blend puts the element on the flood.
bool covers(Input& input, Element blend, std::string_view flood) {
  return std::string_view(blend.name()) == "feBlend" && !flood.empty() &&
         input.attribute(blend, "mode").value_or("normal") == "normal" &&
         input.attribute(blend, "in").value_or("") == "SourceGraphic" &&
         input.attribute(blend, "in2").value_or("") == flood;
}

Result<Backdrop> backdrop_of(Input& input, Element filter) {
  std::array<Element, 2> parts;
  std::size_t count = 0;
  for (const Element child : filter.children()) {
    if (child.type() != pugi::node_element) continue;
    if (count == parts.size()) return Backdrop{};
    parts[count++] = child;
  }
  const std::string_view first = count > 0 ? parts[0].name() : "";
  if (count == 1 && first == "feColorMatrix") {
    const auto kind = kind_of(input, filter, parts[0]);
    return kind ? Backdrop(BackdropFilter{*kind, filter}) : Backdrop{};
  }
  const bool is_flood = count == 2 && first == "feFlood" &&
                        covers(input, parts[1], input.attribute(parts[0], "result").value_or(""));
  if (!is_flood) return Backdrop{};
  SFUMATO_TRY_ASSIGN(auto&& color, read_color(input, parts[0], css::Property::flood_color));
  const std::string_view opacity =
      input.property(parts[0], css::Property::flood_opacity).value_or("1");
  color.alpha *= static_cast<float>(css::share_of(opacity, input.text_poll()).value_or(1));
  return Backdrop(BackdropFilter{FilterKind::flood, filter, color});
}

}  // namespace

Result<std::optional<BackdropFilter>> backdrop_filter(Input& input, Element element) {
  const auto text = input.property(element, css::Property::filter);
  const auto url = text ? css::url_of(*text, input.text_poll()) : std::nullopt;
  if (!url || url->size() < 2 || url->front() != '#') return Backdrop{};
  const Result<Element> filter = input.element_of(element, url->substr(1));
  if (!filter || std::string_view(filter->name()) != "filter") return Backdrop{};
  return backdrop_of(input, *filter);
}

Result<bool> is_inverted_mask(Input& input, Element mask) {
  Element only;
  for (const Element child : mask.children()) {
    if (child.type() != pugi::node_element) continue;
    if (only || std::string_view(child.name()) != "g") return false;
    only = child;
  }
  if (!only) return false;
  SFUMATO_TRY_ASSIGN(const auto& filter, backdrop_filter(input, only));
  return filter && filter->kind == FilterKind::inverted;
}

}  // namespace sfumato::svg
