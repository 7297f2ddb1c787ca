#include "formats/svg/shapes/element_transform.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/angle.hpp"
#include "base/boxes.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "formats/css/transform_list.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/paint/image_place.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "formats/svg/shapes/transform.hpp"
#include "formats/svg/shapes/view_box.hpp"
#include "formats/svg/style/vocabulary.hpp"

namespace sfumato::svg {
namespace {

using css::TransformFunction;

/// The value of a property that is not inherited but where it says so.
struct OwnValue {
  std::string_view text{};
  bool is_attribute = false;
};

std::optional<OwnValue> own_value(Input& input, Element element, css::Property property) {
  for (StyleScope scope = element; scope; scope = scope.outer()) {
    const Input::Cascaded own = input.cascaded(scope, property);
    if (own.value) return OwnValue{*own.value, own.is_attribute};
    if (own.keyword != css::WideKeyword::inherit) break;
  }
  return std::nullopt;
}

class TransformReader {
 public:
  TransformReader(Input& input, const Box& viewport) : input_(input), viewport_(viewport) {}

  Result<Affine> read(Element element);
  Result<Affine> read_paint(Element paint, const char* attribute);
  Result<Box> content(Element element);
  Box view_box(Element element);

 private:
  /// A transform and, if requested, the bounding box of the content that it maps.
  struct Mapped {
    Affine map;
    std::optional<Box> content{};
  };

  Result<Mapped> mapped(Element element, bool needs_content);
  Result<Affine> functions(Element element, const OwnValue& value, const Box& reference,
                           const char* attribute = "transform");
  Affine function(const TransformFunction& function, const css::UnitSizes& sizes,
                  const Box& reference);
  Affine steps(Element element, const Box& reference);
  Vec2 origin(Element element, const std::optional<OwnValue>& value, const Box& reference);
  Result<Box> shape_box(Element element);
  Result<Box> image_box(Element image);
  Result<Box> used_box(Element use);
  Status extend(Element child, Box& box);
  Affine moved(Element element);

  Input& input_;
  const Box& viewport_;
  int depth_ = 0;
  std::vector<Element> used_;  ///< the targets of the <use>s around, outermost first
};

Affine translation(Vec2 offset) {
  return {1, 0, 0, 1, offset.x, offset.y};
}

Vec2 center(const Box& box) {
  return lerp(box.min, box.max, 0.5);
}

/// Returns the transform that applies `map` about another point than the origin.
Affine about(Vec2 point, const Affine& map) {
  const bool is_moved = point.x != 0 || point.y != 0;
  return is_moved ? translation(point) * map * translation({-point.x, -point.y}) : map;
}

double slope(double degrees) {
  const SinCos angle = sin_cos_degrees(degrees);
  return angle.sin / angle.cos;
}

Affine TransformReader::function(const TransformFunction& function, const css::UnitSizes& sizes,
                                 const Box& reference) {
  const std::array<double, 6>& v = function.number;
  switch (function.kind) {
    case TransformFunction::Kind::matrix:
      return {v[0], v[1], v[2], v[3], v[4], v[5]};
    case TransformFunction::Kind::translate:
      return translation({css::in_pixels(function.offset[0], sizes, reference.width()),
                          css::in_pixels(function.offset[1], sizes, reference.height())});
    case TransformFunction::Kind::scale:
      return {v[0], 0, 0, v[1], 0, 0};
    case TransformFunction::Kind::rotate: {
      const SinCos turn = sin_cos_degrees(v[0]);
      return {turn.cos, turn.sin, -turn.sin, turn.cos, 0, 0};
    }
    case TransformFunction::Kind::skew:
      return {1, slope(v[1]), slope(v[0]), 1, 0, 0};
  }
  return {};
}

Result<Affine> TransformReader::functions(Element element, const OwnValue& value,
                                          const Box& reference, const char* attribute) {
  if (value.is_attribute) {
    if (css::keyword_of(value.text, input_.text_poll()) == "none") return Affine{};
    Result<Affine> map = parse_transform(input_.context(), value.text);
    return map ? map : input_.in(element, attribute, map.status());
  }
  const css::UnitSizes sizes = input_.unit_sizes(element);
  Affine map;
  css::read_transform_list(value.text, input_.text_poll(), [&](const TransformFunction& each) {
    map = map * function(each, sizes, reference);
  });
  return map;
}

/// The properties that CSS applies before `transform`, in this order.
constexpr css::Property kTransformSteps[] = {css::Property::translate, css::Property::rotate,
                                             css::Property::scale};

bool has_steps(Input& input, Element element) {
  return std::ranges::any_of(kTransformSteps, [&](css::Property property) {
    const auto value = own_value(input, element, property);
    return value && !value->is_attribute;
  });
}

/// Returns the transform of `translate`, `rotate` and `scale` together.
Affine TransformReader::steps(Element element, const Box& reference) {
  const css::UnitSizes sizes = input_.unit_sizes(element);
  Affine map;
  for (const css::Property property : kTransformSteps) {
    const auto value = own_value(input_, element, property);
    if (!value || value->is_attribute) continue;
    const auto step = css::transform_step_of(property, value->text, input_.text_poll());
    if (step) map = map * function(*step, sizes, reference);
  }
  return map;
}

Vec2 TransformReader::origin(Element element, const std::optional<OwnValue>& value,
                             const Box& reference) {
  if (!value) return element == input_.root() ? center(reference) : reference.min;
  const auto offset =
      css::transform_origin_of(value->text, !value->is_attribute, input_.text_poll());
  if (!offset) return reference.min;
  const css::UnitSizes sizes = input_.unit_sizes(element);
  return reference.min + Vec2{css::in_pixels((*offset)[0], sizes, reference.width()),
                              css::in_pixels((*offset)[1], sizes, reference.height())};
}

/// Returns a box at the origin of the nearest viewport, with the size of its viewBox.
Box TransformReader::view_box(Element element) {
  for (Element around = element.parent(); around; around = around.parent()) {
    const std::string_view name = around.name();
    if (name != "svg" && name != "symbol") continue;
    const auto text = input_.attribute(around, "viewBox");
    const auto box = text ? parse_view_box(*text) : Result<Box>(viewport_);
    if (text && box) return {{0, 0}, {box->width(), box->height()}};
  }
  return {{0, 0}, {viewport_.width(), viewport_.height()}};
}

Result<TransformReader::Mapped> TransformReader::mapped(Element element, bool needs_content) {
  Mapped result;
  const auto transform = own_value(input_, element, css::Property::transform);
  const auto origin_value = own_value(input_, element, css::Property::transform_origin);
  const auto box = own_value(input_, element, css::Property::transform_box);
  const std::string box_word =
      box ? css::keyword_of(box->text, input_.text_poll()).value_or("") : "";
  const bool is_stepped = has_steps(input_, element);
  const bool has_map = transform || is_stepped;
  const bool is_of_content =
      has_map && !box_word.empty() && box_word != "view-box" && element != input_.root();
  if (needs_content || is_of_content) {
    SFUMATO_TRY_ASSIGN(const Box& found, content(element));
    result.content = found;
  }
  if (!has_map) return result;
  if (box_word == "stroke-box" || box_word == "border-box") {
    input_.warn("/stroke-box", element,
                "transform-box of " + tag(element) +
                    " is read as fill-box: the width of the stroke does not count");
  }
  Box reference = is_of_content ? *result.content : view_box(element);
  if (reference.empty()) reference = {{0, 0}, {0, 0}};
  SFUMATO_TRY_ASSIGN(const Affine& map, transform ? functions(element, *transform, reference)
                                                  : Result<Affine>(Affine{}));
  const Affine own = is_stepped ? steps(element, reference) * map : map;
  result.map = about(origin(element, origin_value, reference), own);
  return result;
}

Result<Box> TransformReader::shape_box(Element element) {
  TableMemory memory("control points");
  SFUMATO_TRY_ASSIGN(const auto& subpaths, read_shape(input_, element, viewport_, memory));
  if (subpaths.empty()) return Box{};
  return bounds(input_.context(), subpaths);
}

/// Returns the box of an <image>; empty if the size comes from the file, which is not read here.
Result<Box> TransformReader::image_box(Element image) {
  SFUMATO_TRY_ASSIGN(const Box& box, read_image_box(input_, image, viewport_, {}));
  const bool has_area = box.width() > 0 && box.height() > 0;
  return has_area ? box : Box{};
}

/// Returns the shift of <use> and of a nested <svg>. Other effects of a viewport are ignored.
Affine TransformReader::moved(Element element) {
  const Result<double> x = length_of(input_, element, "x", viewport_, Axis::x, 0);
  const Result<double> y = length_of(input_, element, "y", viewport_, Axis::y, 0);
  return translation({x ? *x : 0, y ? *y : 0});
}

Result<Box> TransformReader::used_box(Element use) {
  const Result<Element> target = input_.referred(use);
  if (!target) return Box{};
  for (Element around = use.parent(); around; around = around.parent()) {
    if (around == *target) return Box{};  // it goes round in a circle, and is not drawn
  }
  if (std::ranges::find(used_, *target) != used_.end()) return Box{};
  used_.push_back(*target);
  Box box;
  Status status = extend(*target, box);
  used_.pop_back();
  if (!status) return status;
  return box;
}

/// Returns the bounding box of the element's fill, in its user space, without its own transform.
Result<Box> TransformReader::content(Element element) {
  if (static_cast<std::size_t>(depth_) >= input_.limits().xml_depth) {
    return input_.over_limit(element, &Limits::xml_depth, "elements within each other");
  }
  SFUMATO_TRY(input_.charge_reading(element, "transform-box"));
  const std::string_view name = element.name();
  if (is_shape(name)) return shape_box(element);
  if (name == "image") return image_box(element);
  ++depth_;
  Box inside;
  Status status;
  if (name == "use") {
    Result<Box> used = used_box(element);
    status = used.status();
    if (used) inside = *used;
  } else {
    for (const Element child : element.children()) {
      if (child.type() == pugi::node_element && status) status = extend(child, inside);
    }
  }
  --depth_;
  if (!status) return status;
  const bool is_moved = name == "use" || name == "svg";
  if (!is_moved || inside.empty()) return inside;
  const Affine shift = moved(element);
  return Box{shift(inside.min), shift(inside.max)};
}

/// Extends a box by the box of a child. Ignores a faulty child, because it is not drawn.
Status TransformReader::extend(Element child, Box& box) {
  const std::string_view name = child.name();
  const bool is_drawn = is_shape(name) || name == "g" || name == "a" || name == "use" ||
                        name == "svg" || name == "symbol" || name == "switch" || name == "image";
  if (!is_drawn || input_.keyword(child, css::Property::display) == "none") return ok_status();
  const Result<Mapped> inner = mapped(child, true);
  if (!inner) return inner.status().code == StatusCode::bad_input ? ok_status() : inner.status();
  const Box& content = *inner->content;
  if (content.empty()) return ok_status();
  box = united(box, mapped_box(inner->map, content));
  return ok_status();
}

/// Precondition: it has the attribute, or the property in a style.
Result<Affine> TransformReader::read_paint(Element paint, const char* attribute) {
  const bool is_styled = has_transform_style(input_, paint);
  const OwnValue value{is_styled ? *input_.cascaded(paint, css::Property::transform).value
                                 : std::string_view(paint.attribute(attribute).value()),
                       !is_styled};
  const Box reference{{0, 0}, {viewport_.width(), viewport_.height()}};
  SFUMATO_TRY_ASSIGN(const Affine& map, functions(paint, value, reference, attribute));
  const auto origin_value = own_value(input_, paint, css::Property::transform_origin);
  return about(origin(paint, origin_value, reference), map);
}

Result<Affine> TransformReader::read(Element element) {
  SFUMATO_TRY_ASSIGN(const Mapped& own, mapped(element, false));
  return own.map;
}

}  // namespace

Result<Affine> element_transform(Input& input, Element element, const Box& viewport) {
  return TransformReader(input, viewport).read(element);
}

Result<Affine> root_transform(Input& input, Vec2 size_px) {
  return TransformReader(input, {{0, 0}, size_px}).read(input.root());
}

bool has_transform(Input& input, Element element) {
  return own_value(input, element, css::Property::transform) || has_steps(input, element);
}

bool has_transform_style(Input& input, Element paint) {
  const Input::Cascaded own = input.cascaded(paint, css::Property::transform);
  return own.value && !own.is_attribute;
}

Result<Affine> paint_transform(Input& input, Element paint, const char* attribute,
                               const Box& viewport) {
  return TransformReader(input, viewport).read_paint(paint, attribute);
}

Result<Box> content_box(Input& input, Element element, const Box& viewport) {
  return TransformReader(input, viewport).content(element);
}

Box view_box_of(Input& input, Element element, const Box& viewport) {
  return TransformReader(input, viewport).view_box(element);
}

}  // namespace sfumato::svg
