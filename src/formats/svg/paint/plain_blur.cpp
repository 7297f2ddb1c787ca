#include "formats/svg/paint/plain_blur.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/text/ascii.hpp"
#include "base/text/number.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "formats/svg/style/length.hpp"

namespace sfumato::svg {
namespace {

/// The distance from an edge, in standard deviations, at which 2 % of its jump are left.
constexpr double kSeen = 2;

/// Reads one standard deviation, or two equal ones.
std::optional<double> deviation_of(std::string_view text) {
  text = ascii_trimmed(text);
  const std::size_t end = std::min(text.find_first_of(", \t\n\r"), text.size());
  const auto first = parse_number(text.substr(0, end));
  std::string_view rest = text.substr(end);
  while (!rest.empty() && std::string_view(", \t\n\r").find(rest.front()) != rest.npos) {
    rest.remove_prefix(1);
  }
  if (!first || !(*first > 0)) return std::nullopt;
  if (!rest.empty() && parse_number(rest) != first) return std::nullopt;
  return first;
}

std::optional<double> of_element(Input& input, Element filter) {
  if (std::string_view(filter.name()) != "filter") return std::nullopt;
  if (input.attribute(filter, "primitiveUnits").value_or("") == "objectBoundingBox") {
    return std::nullopt;
  }
  Element only;
  for (const Element child : filter.children()) {
    if (child.type() != pugi::node_element) continue;
    if (only || std::string_view(child.name()) != "feGaussianBlur") return std::nullopt;
    only = child;
  }
  if (!only) return std::nullopt;
  const std::string_view in = input.attribute(only, "in").value_or("SourceGraphic");
  if (!in.empty() && in != "SourceGraphic") return std::nullopt;
  return deviation_of(input.attribute(only, "stdDeviation").value_or(""));
}

/// Reads `blur(LENGTH)` as the only function.
std::optional<double> of_function(std::string_view text) {
  const std::string lower = ascii_lower(ascii_trimmed(text).substr(0, 64));
  if (!lower.starts_with("blur(") || lower.find(')') != lower.size() - 1) return std::nullopt;
  const std::string_view inside = std::string_view(lower).substr(5, lower.size() - 6);
  const Result<double> length = parse_length(ascii_trimmed(inside), {}, Axis::diagonal);
  if (!length || !(*length > 0)) return std::nullopt;
  return *length;
}

/// Returns the element of a value that is one url(#…); none for other values.
Element filter_of(Input& input, Element element, std::string_view text) {
  css::Tokenizer tokens(text, input.text_poll());
  const std::optional<std::string> url = css::take_url(tokens, css::next_solid(tokens));
  if (!url || url->size() < 2 || url->front() != '#') return {};
  if (!ascii_trimmed(text.substr(tokens.position())).empty()) return {};
  const Result<Element> filter = input.element_of(element, url->substr(1));
  return filter ? *filter : Element();
}

/// Returns the filter region in the shape's user space; no value if it is malformed.
std::optional<Box> region_of(Input& input, Element filter, const PaintedShape& shape) {
  const bool is_of_user = input.attribute(filter, "filterUnits").value_or("") == "userSpaceOnUse";
  const Box frame = is_of_user ? shape.viewport : Box{{0, 0}, {1, 1}};
  const auto length = [&](const char* name, Axis axis, double share) {
    const double side = axis == Axis::x ? frame.width() : frame.height();
    return length_of(input, filter, name, frame, axis, share * side);
  };
  const Result<double> x = length("x", Axis::x, -0.1), y = length("y", Axis::y, -0.1);
  const Result<double> width = length("width", Axis::x, 1.2);
  const Result<double> height = length("height", Axis::y, 1.2);
  if (!x || !y || !width || !height) return std::nullopt;
  const Box region{{*x, *y}, {*x + *width, *y + *height}};
  if (is_of_user) return region;
  const Vec2 size{shape.bounds.width(), shape.bounds.height()};
  return Box{shape.bounds.min + Vec2{region.min.x * size.x, region.min.y * size.y},
             shape.bounds.min + Vec2{region.max.x * size.x, region.max.y * size.y}};
}

}  // namespace

std::optional<double> gaussian_blur(Input& input, Element element) {
  const auto text = input.property(element, css::Property::filter);
  if (!text) return std::nullopt;
  if (const Element filter = filter_of(input, element, *text)) return of_element(input, filter);
  return of_function(*text);
}

bool cuts_blur(Input& input, const PaintedShape& shape, double around, double deviation) {
  const auto text = input.property(shape.element, css::Property::filter);
  const Element filter = text ? filter_of(input, shape.element, *text) : Element();
  if (!filter) return false;
  const auto region = region_of(input, filter, shape);
  if (!region) return false;
  const Box seen = shape.bounds.grown_by(around + kSeen * deviation);
  return !(region->contains(seen.min) && region->contains(seen.max));
}

}  // namespace sfumato::svg
