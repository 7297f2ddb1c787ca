#include "formats/svg/gradient.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/number.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/color.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// A focus on the circle or beyond it is moved to this share of the radius.
constexpr double kFocusShare = 0.999;

/// Read again, what comes out stays where it is: it is inside in the numbers that are written.
void keep_focus_inside(RadialGradient& shape) {
  const Vec2 from_center = shape.focus - shape.center;
  const double largest = kFocusShare * shape.radius;
  if (length(from_center) <= largest) return;
  double share = largest / length(from_center);
  double step = 0x1p-53;
  do {
    shape.focus = shape.center + from_center * share;
    share *= 1 - step;
    step *= 2;
  } while (length(shape.focus - shape.center) > largest);
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
  Status status = read_spread();
  if (status) status = read_stops();
  const bool is_linear = std::string_view(attributes_.paint().name()) == "linearGradient";
  if (status) status = is_linear ? read_linear() : read_radial();
  if (!status) return status;
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
    return input_.error(
        attributes_.bearer("spreadMethod"),
        "spreadMethod is " + text::quoted(spread) + "; expected pad, reflect or repeat");
  }
  return ok_status();
}

Status GradientReader::length(const char* name, Axis axis, double share_by_default, double& value) {
  const Result<double> read = attributes_.length(name, in_box_, viewport_, axis, share_by_default);
  if (read) value = *read;
  return read.status();
}

Status GradientReader::read_linear() {
  LinearGradient shape;
  Status status = length("x1", Axis::x, 0, shape.start.x);
  if (status) status = length("y1", Axis::y, 0, shape.start.y);
  if (status) status = length("x2", Axis::x, 1, shape.end.x);
  if (status) status = length("y2", Axis::y, 0, shape.end.y);
  if (!status) return status;
  fill_.shape = shape;
  if (shape.start == shape.end) make_solid();
  return status;
}

Status GradientReader::read_radial() {
  RadialGradient shape;
  Status status = length("cx", Axis::x, 0.5, shape.center.x);
  if (status) status = length("cy", Axis::y, 0.5, shape.center.y);
  if (status) status = length("r", Axis::diagonal, 0.5, shape.radius);
  shape.focus = shape.center;
  if (status && attributes_.bearer("fx", true)) status = length("fx", Axis::x, 0, shape.focus.x);
  if (status && attributes_.bearer("fy", true)) status = length("fy", Axis::y, 0, shape.focus.y);
  if (!status) return status;
  if (shape.radius < 0) {
    return input_.error(attributes_.bearer("r", true), "r is negative; expected 0 or more");
  }
  if (const Element bearer = attributes_.bearer("fr", true)) {
    input_.warn("/fr", bearer, "fr is ignored: the focus is a point");
  }
  keep_focus_inside(shape);
  fill_.shape = shape;
  if (shape.radius == 0) make_solid();
  return status;
}

void GradientReader::make_solid() {
  fill_.shape = LinearGradient{};
  fill_.stops.erase(fill_.stops.begin(), fill_.stops.end() - 1);
}

Status GradientReader::read_stops() {
  const Element parent =
      attributes_.first_with([](Element paint) { return static_cast<bool>(paint.child("stop")); });
  if (!parent) {
    return input_.error(attributes_.paint(), "the gradient has no stops; expected one at least");
  }
  Status status = parent == last_.parent ? totals_.count_stops(parent, last_.stops.size())
                                         : read_all_stops(parent);
  if (!status) return status;
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
    Status status = totals_.count_stops(element, 1);
    if (status) status = input_.push_back(element, last_.memory, last_.stops, {});
    if (status) status = input_.charge_text(element);
    if (status) status = read_stop(element, last_.stops.back());
    if (!status) return status;
    double& offset = last_.stops.back().offset;
    offset = largest = std::max(largest, offset);
  }
  last_.parent = parent;
  return ok_status();
}

Status GradientReader::read_stop(Element element, GradientStop& stop) {
  const std::string_view offset = input_.attribute(element, "offset").value_or("0");
  if (Status status = read_share(element, "offset", offset, stop.offset); !status) return status;
  const Result<css::Color> color = read_color(input_, element, css::Property::stop_color);
  if (!color) return color.status();
  const std::string_view text = input_.property(element, css::Property::stop_opacity).value_or("1");
  const auto opacity = css::share_of(text, input_.text_poll());
  if (!opacity) return bad_share(element, "stop-opacity", text);
  stop.color = color->color;
  stop.alpha = color->alpha * static_cast<float>(*opacity);
  return ok_status();
}

Status GradientReader::bad_share(Element element, const char* name, std::string_view text) {
  return input_.error(element, std::string(name) + " of <stop> is " + text::quoted(text) +
                                   "; expected a number from 0 to 1 or a percentage");
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
  const Result<bool> in_box = attributes.in_bounding_box("gradientUnits", true);
  if (!in_box) return in_box.status();
  const Result<Affine> transform = attributes.transform("gradientTransform");
  if (!transform) return transform.status();
  GradientFrame frame{*in_box, shape.layer_from_user * *transform};
  if (*in_box) {
    const Result<Affine> user_from_box = user_from_bounds(input, shape, attributes.paint());
    if (!user_from_box) return user_from_box.status();
    frame.layer_from_gradient = shape.layer_from_user * *user_from_box * *transform;
  }
  if (is_usable(frame.layer_from_gradient)) return frame;
  return input.error(attributes.paint(),
                     "the gradient's place cannot be computed; expected a "
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
