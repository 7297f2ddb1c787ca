#include "formats/svg/read/curve_attributes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/text/ascii.hpp"
#include "base/text/number.hpp"
#include "base/try.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/style/color.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// An attribute of Sfumato's namespace as it was found.
struct Found {
  std::string name;  ///< "sf:left-blur", for messages
  std::string_view text;
};

class AttributeReader {
 public:
  AttributeReader(Input& input, Element element, TableMemory& memory)
      : input_(input), element_(element), memory_(memory) {}

  /// Returns the attribute of that name, else the one for both sides, if there is one.
  std::optional<Found> find(const char* name, const char* for_both = nullptr) const;
  Status read_colors(const Found& found, std::vector<WrittenStop<Rgb>>& stops);
  Status read_numbers(const Found& found, double largest, const char* what,
                      std::vector<WrittenStop<float>>& stops);
  Status read_lengths(const Found& found, const char* what, std::vector<WrittenStop<float>>& stops);
  Status read_number(const char* name, const char* expected, bool zero_allowed, double& number);

 private:
  template <class Value>
  Status make_room(const Found& found, std::vector<WrittenStop<Value>>& stops);

  Input& input_;
  Element element_;
  TableMemory& memory_;
};

std::optional<Found> AttributeReader::find(const char* name, const char* for_both) const {
  for (const char* candidate : {name, for_both}) {
    if (candidate == nullptr) continue;
    if (const auto text = input_.sf(element_, candidate)) {
      input_.text_poll().go_on(text->size());  // the caller checks the result
      return Found{std::string("sf:") + candidate, ascii_trimmed(*text)};
    }
  }
  return std::nullopt;
}

template <class Value>
Status AttributeReader::make_room(const Found& found, std::vector<WrittenStop<Value>>& stops) {
  const std::size_t count = stop_bound(found.text);
  if (count > input_.limits().stops_per_list) {
    return input_.in(element_, found.name,
                     input_.over_limit(element_, &Limits::stops_per_list, "stops in one list"));
  }
  return input_.placed(element_, memory_.reserve(input_.context(), stops, count));
}

Status AttributeReader::read_colors(const Found& found, std::vector<WrittenStop<Rgb>>& stops) {
  SFUMATO_TRY(make_room(found, stops));
  std::string_view mapped;
  Status status = parse_color_stops(found.text, input_.text_poll(), stops, mapped);
  if (status && !mapped.empty()) warn_of_mapped(input_, element_, found.name, mapped);
  return input_.in(element_, found.name, std::move(status));
}

Status AttributeReader::read_numbers(const Found& found, double largest, const char* what,
                                     std::vector<WrittenStop<float>>& stops) {
  SFUMATO_TRY(make_room(found, stops));
  return input_.in(element_, found.name,
                   parse_scalar_stops(found.text, largest, what, input_.text_poll(), stops));
}

Status AttributeReader::read_lengths(const Found& found, const char* what,
                                     std::vector<WrittenStop<float>>& stops) {
  SFUMATO_TRY(make_room(found, stops));
  return input_.in(element_, found.name,
                   parse_length_stops(found.text, what, input_.text_poll(), stops));
}

/// `number` stays where the attribute is absent.
Status AttributeReader::read_number(const char* name, const char* expected, bool zero_allowed,
                                    double& number) {
  const auto found = find(name);
  if (!found) return ok_status();
  const auto value = parse_number(found->text);
  const bool in_range = value && std::abs(*value) <= limits::kCoordinate &&
                        (*value > 0 || (zero_allowed && *value == 0));
  if (!in_range) {
    const std::string hint =
        zero_allowed ? share_hint(found->text, limits::kCoordinate) : std::string();
    return input_.error(element_, found->name + " of " + tag(element_) + " is " +
                                      text::quoted(found->text) + "; use " + expected + hint);
  }
  number = *value;
  return ok_status();
}

/// Reads "none" and url(#id); false where the text is a stop list.
template <class Value>
Result<bool> read_whole(Input& input, Paints& paints, const PaintedShape& shape, const Found& found,
                        WrittenShader<Value>& shader) {
  // The beginning distinguishes most texts from "none" and an url.
  constexpr std::string_view kBeginnings = "nNuU\\/";
  if (kBeginnings.find(found.text.substr(0, 1)) == std::string_view::npos) return false;
  if (css::keyword_of(found.text, input.text_poll()) == "none") {
    shader.kind = ShaderKind::barrier;
    return true;
  }
  const auto url = css::url_of(found.text, input.text_poll());
  if (!url) return false;
  if (!url->starts_with('#') || url->size() == 1) {
    return input.error(shape.element, found.name + " of " + tag(shape.element) + " is " +
                                          text::quoted(found.text) + "; use url(#id)");
  }
  SFUMATO_TRY_ASSIGN(const std::uint32_t index,
                     paints.shader(shape, std::string_view(*url).substr(1)));
  shader.kind = ShaderKind::image_domain;
  shader.shader = index;
  return true;
}

struct SideNames {
  const char* color;
  const char* opacity;
  const char* blur;
};

constexpr SideNames kLeft{"left", "left-opacity", "left-blur"};
constexpr SideNames kRight{"right", "right-opacity", "right-blur"};

Status read_side(Input& input, Paints& paints, const PaintedShape& shape, const SideNames& names,
                 TableMemory& memory, WrittenSide& side) {
  AttributeReader reader(input, shape.element, memory);
  if (const auto found = reader.find(names.color)) {
    SFUMATO_TRY_ASSIGN(const bool whole, read_whole(input, paints, shape, *found, side.color));
    if (!whole) {
      side.color.kind = ShaderKind::curve_domain;
      SFUMATO_TRY(reader.read_colors(*found, side.color.stops));
    }
  }
  if (const auto found = reader.find(names.opacity, "opacity")) {
    SFUMATO_TRY_ASSIGN(const bool whole, read_whole(input, paints, shape, *found, side.opacity));
    if (!whole) {
      side.opacity.kind = ShaderKind::curve_domain;
      SFUMATO_TRY(reader.read_numbers(*found, 1, "opacity", side.opacity.stops));
    }
  }
  const auto found = reader.find(names.blur, "blur");
  if (!found) return ok_status();
  return reader.read_lengths(*found, "blur radius", side.blur_radius);
}

Status no_color_list(Input& input, Element element, const Found& found) {
  return input.error(element, found.name + " of " + tag(element) + " is " +
                                  text::quoted(found.text) +
                                  "; a local curve takes a list of colours only");
}

}  // namespace

std::size_t CurveAttributes::stop_count() const {
  const auto count = [](const WrittenSide& side) {
    return side.color.stops.size() + side.opacity.stops.size() + side.blur_radius.size();
  };
  return count(left) + count(right);
}

std::size_t LocalAttributes::stop_count() const {
  return left_color.size() + right_color.size() + blur_radius.size() + influence_radius.size();
}

Result<CurveAttributes> read_curve_attributes(Input& input, Paints& paints,
                                              const PaintedShape& shape, TableMemory& memory) {
  CurveAttributes attributes;
  SFUMATO_TRY(read_side(input, paints, shape, kLeft, memory, attributes.left));
  SFUMATO_TRY(read_side(input, paints, shape, kRight, memory, attributes.right));
  {
    AttributeReader reader(input, shape.element, memory);
    SFUMATO_TRY(reader.read_number("weight", "a number above 0", false, attributes.weight));
  }
  return attributes;
}

Result<LocalAttributes> read_local_attributes(Input& input, Element shape, TableMemory& memory) {
  LocalAttributes attributes;
  AttributeReader reader(input, shape, memory);
  const auto read_side_colors = [&](const char* name, std::vector<WrittenStop<Rgb>>& stops) {
    const auto found = reader.find(name);
    if (!found) return ok_status();
    css::TextPoll& poll = input.text_poll();
    const bool is_list =
        css::keyword_of(found->text, poll) != "none" && !css::url_of(found->text, poll).has_value();
    return is_list ? reader.read_colors(*found, stops) : no_color_list(input, shape, *found);
  };
  SFUMATO_TRY(read_side_colors("left", attributes.left_color));
  SFUMATO_TRY(read_side_colors("right", attributes.right_color));
  if (attributes.left_color.empty() && attributes.right_color.empty()) {
    return input.error(shape, "the local curve has no colour; add sf:left, sf:right or both");
  }
  std::vector<WrittenStop<Rgb>>&left = attributes.left_color, &right = attributes.right_color;
  Status status;
  if (left.empty()) status = memory.append(input.context(), right, left);
  if (right.empty()) status = memory.append(input.context(), left, right);
  if (!status) return input.placed(shape, std::move(status));
  if (const auto found = reader.find("radius")) {
    SFUMATO_TRY(reader.read_lengths(*found, "radius of influence", attributes.influence_radius));
  }
  if (const auto found = reader.find("blur")) {
    SFUMATO_TRY(reader.read_lengths(*found, "blur radius", attributes.blur_radius));
  }
  SFUMATO_TRY(reader.read_number("alpha", "0 or more", true, attributes.alpha));
  const auto is_wide = [](const WrittenStop<float>& stop) { return stop.value > 0; };
  if (std::ranges::none_of(attributes.influence_radius, is_wide)) {
    return input.error(shape, "sf:radius of " + tag(shape) + " is nowhere above 0");
  }
  return attributes;
}

}  // namespace sfumato::svg
