#include "formats/svg/paint/gradient.hpp"

#include <algorithm>
#include <string_view>

#include "base/text/number.hpp"
#include "base/try.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/style/color.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// A focus on the circle is moved to this share of the radius.
constexpr double kFocusShare = 0.999;
/// A focus is on the circle up to this share of the radius: transforms round it.
constexpr double kOnCircle = 1 + 1e-9;

/// Moves a focus on the circle inside, where the gradient covers the whole plane. A document that
/// is written and read again keeps it: the focus is inside in the numbers that are written.
void move_focus_off_circle(RadialGradient& shape) {
  const Vec2 from_center = shape.focus - shape.center;
  const double largest = kFocusShare * shape.radius;
  if (shape.focal_radius > 0 || length(from_center) <= largest) return;
  if (length(from_center) > kOnCircle * shape.radius) return;
  double share = largest / length(from_center);
  double step = 0x1p-53;
  do {
    shape.focus = shape.center + from_center * share;
    share *= 1 - step;
    step *= 2;
  } while (length(shape.focus - shape.center) > largest);
}

/// Two equal circles are a step from the first stop to the last one.
void part_equal_circles(RadialGradient& shape) {
  if (shape.focus == shape.center && shape.focal_radius == shape.radius) {
    shape.focal_radius = kFocusShare * shape.radius;
  }
}

class GradientReader {
 public:
  GradientReader(Input& input, Totals& totals, const PaintAttributes& attributes, bool in_box,
                 const Box& viewport, GradientStops& last)
      : input_(input),
        totals_(totals),
        attributes_(attributes),
        in_box_(in_box),
        viewport_(viewport),
        last_(last) {}

  Result<GradientFill> read();

 private:
  Status read_spread();
  Status read_linear();
  Status read_radial();
  Status read_stops();
  Status read_all_stops(Element parent);
  Status read_stop(Element element, GradientStop& stop);
  Status read_share(Element element, const char* name, std::string_view text, double& share);
  Status bad_share(Element element, const char* name, std::string_view text);
  Status length(const char* name, Axis axis, double share_by_default, double& value);
  Status not_negative(const char* name, double& radius);
  void make_solid();

  Input& input_;
  Totals& totals_;
  const PaintAttributes& attributes_;
  bool in_box_;
  const Box& viewport_;
  GradientStops& last_;
  TableMemory memory_{"stops"};
  GradientFill fill_;
};

Result<GradientFill> GradientReader::read() {
  SFUMATO_TRY(read_spread());
  SFUMATO_TRY(read_stops());
  const bool is_linear = std::string_view(attributes_.paint().name()) == "linearGradient";
  SFUMATO_TRY(is_linear ? read_linear() : read_radial());
  input_.memory().stops.take(std::move(memory_));
  return std::move(fill_);
}

Status GradientReader::read_spread() {
  const std::string_view spread = attributes_.text("spreadMethod").value_or("pad");
  if (spread == "pad") {
    fill_.spread = SpreadMethod::pad;
  } else if (spread == "reflect") {
    fill_.spread = SpreadMethod::reflect;
  } else if (spread == "repeat") {
    fill_.spread = SpreadMethod::repeat;
  } else {
    const Element bearer = attributes_.bearer("spreadMethod");
    return input_.ignore(bearer, input_.error(bearer, "spreadMethod is " + text::quoted(spread) +
                                                          "; use pad, reflect or repeat"));
  }
  return ok_status();
}

Status GradientReader::length(const char* name, Axis axis, double share_by_default, double& value) {
  SFUMATO_TRY_ASSIGN(value, attributes_.length(name, in_box_, viewport_, axis, share_by_default));
  return ok_status();
}

/// A negative radius is 0 where it is forgiven, as in browsers.
Status GradientReader::not_negative(const char* name, double& radius) {
  if (radius >= 0) return ok_status();
  const Element bearer = attributes_.bearer(name, true);
  radius = 0;
  return input_.ignore(bearer,
                       input_.error(bearer, std::string(name) + " is negative; use 0 or more"));
}

Status GradientReader::read_linear() {
  LinearGradient shape;
  SFUMATO_TRY(length("x1", Axis::x, 0, shape.start.x));
  SFUMATO_TRY(length("y1", Axis::y, 0, shape.start.y));
  SFUMATO_TRY(length("x2", Axis::x, 1, shape.end.x));
  SFUMATO_TRY(length("y2", Axis::y, 0, shape.end.y));
  fill_.shape = shape;
  if (shape.start == shape.end) make_solid();
  return ok_status();
}

Status GradientReader::read_radial() {
  RadialGradient shape;
  SFUMATO_TRY(length("cx", Axis::x, 0.5, shape.center.x));
  SFUMATO_TRY(length("cy", Axis::y, 0.5, shape.center.y));
  SFUMATO_TRY(length("r", Axis::diagonal, 0.5, shape.radius));
  shape.focus = shape.center;
  if (attributes_.bearer("fx", true)) SFUMATO_TRY(length("fx", Axis::x, 0, shape.focus.x));
  if (attributes_.bearer("fy", true)) SFUMATO_TRY(length("fy", Axis::y, 0, shape.focus.y));
  if (attributes_.bearer("fr", true)) {
    SFUMATO_TRY(length("fr", Axis::diagonal, 0, shape.focal_radius));
  }
  SFUMATO_TRY(not_negative("r", shape.radius));
  SFUMATO_TRY(not_negative("fr", shape.focal_radius));
  move_focus_off_circle(shape);
  part_equal_circles(shape);
  fill_.shape = shape;
  if (shape.radius == 0) make_solid();
  return ok_status();
}

void GradientReader::make_solid() {
  fill_.shape = LinearGradient{};
  fill_.stops.erase(fill_.stops.begin(), fill_.stops.end() - 1);
}

Status GradientReader::read_stops() {
  const Element parent =
      attributes_.first_with([](Element paint) { return static_cast<bool>(paint.child("stop")); });
  if (!parent) {
    return input_.error(attributes_.paint(), "the gradient has no stops; add at least one");
  }
  SFUMATO_TRY(parent == last_.parent ? totals_.count_stops(parent, last_.stops.size())
                                     : read_all_stops(parent));
  return input_.placed(parent, memory_.append(input_.context(), last_.stops, fill_.stops));
}

/// Into `last_`, which has no parent where it fails.
Status GradientReader::read_all_stops(Element parent) {
  last_.parent = {};
  last_.stops.clear();
  double largest = 0;
  for (const Element element : parent.children("stop")) {
    if (last_.stops.size() == input_.limits().stops_per_list) {
      return input_.over_limit(element, &Limits::stops_per_list, "stops in one gradient");
    }
    SFUMATO_TRY(totals_.count_stops(element, 1));
    SFUMATO_TRY(input_.push_back(element, last_.memory, last_.stops, {}));
    SFUMATO_TRY(input_.charge_text(element));
    SFUMATO_TRY(read_stop(element, last_.stops.back()));
    double& offset = last_.stops.back().offset;
    offset = largest = std::max(largest, offset);
  }
  last_.parent = parent;
  return ok_status();
}

Status GradientReader::read_stop(Element element, GradientStop& stop) {
  const std::string_view offset = input_.attribute(element, "offset").value_or("0");
  SFUMATO_TRY(read_share(element, "offset", offset, stop.offset));
  SFUMATO_TRY_ASSIGN(const css::Color& color,
                     read_color(input_, element, css::Property::stop_color));
  const std::string_view text = input_.property(element, css::Property::stop_opacity).value_or("1");
  const auto opacity = css::share_of(text, input_.text_poll());
  stop.color = color.color;
  stop.alpha = color.alpha * static_cast<float>(opacity.value_or(1));
  return opacity ? ok_status() : bad_share(element, "stop-opacity", text);
}

Status GradientReader::bad_share(Element element, const char* name, std::string_view text) {
  return input_.ignore(
      element, input_.error(element, std::string(name) + " of <stop> is " + text::quoted(text) +
                                         "; use a number from 0 to 1 or a percentage"));
}

/// A number or a percentage, clamped to 0 to 1.
Status GradientReader::read_share(Element element, const char* name, std::string_view text,
                                  double& share) {
  const bool is_percentage = text.ends_with('%');
  const auto number = parse_number(is_percentage ? text.substr(0, text.size() - 1) : text);
  if (!number) return bad_share(element, name, text);
  share = std::clamp(is_percentage ? *number / 100 : *number, 0.0, 1.0);
  return ok_status();
}

}  // namespace

Result<GradientFrame> read_gradient_frame(Input& input, const PaintAttributes& attributes,
                                          const PaintedShape& shape) {
  SFUMATO_TRY_ASSIGN(const bool in_box, attributes.in_bounding_box("gradientUnits", true));
  SFUMATO_TRY_ASSIGN(const Affine& transform,
                     attributes.transform("gradientTransform", shape.viewport));
  GradientFrame frame{in_box, shape.layer_from_user * transform};
  if (in_box) {
    SFUMATO_TRY_ASSIGN(const Affine& user_from_box,
                       user_from_bounds(input, shape, attributes.paint()));
    frame.layer_from_gradient = shape.layer_from_user * user_from_box * transform;
  }
  if (is_usable(frame.layer_from_gradient)) return frame;
  return input.error(attributes.paint(),
                     "the gradient's place cannot be computed; use a "
                     "transform that can be inverted, of usual size");
}

Result<GradientFill> read_gradient(Input& input, Totals& totals, const PaintAttributes& attributes,
                                   const GradientFrame& frame, const Box& viewport,
                                   GradientStops& last) {
  Result<GradientFill> fill =
      GradientReader(input, totals, attributes, frame.in_box, viewport, last).read();
  if (fill) fill->layer_from_gradient = frame.layer_from_gradient;
  return fill;
}

}  // namespace sfumato::svg
