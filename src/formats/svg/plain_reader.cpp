#include <utility>

#include "formats/svg/plain_style.hpp"
#include "formats/svg/shapes.hpp"
#include "formats/svg/stack_reader.hpp"

/// The part of StackReader that reads shapes of ordinary SVG.
namespace sfumato::svg {

/// Leaves out what is faulty.
Status StackReader::visit_plain(Element element, const Place& place) {
  Status status = read_plain(element, place);
  if (status || !can_be_left_out(status)) return status;
  input_.warn("/plain shape", element, tag(element) + " is left out: " + status.message);
  return ok_status();
}

Status StackReader::read_plain(Element element, const Place& place) {
  Result<std::vector<Subpath>> subpaths = read_shape(input_, element, document_.artboard);
  if (!subpaths) return subpaths.status();
  if (subpaths->empty()) return ok_status();
  std::vector<Element> around;
  for (const OpenElement& open : open_) around.push_back(open.element);
  PlainStyle style(input_, element, around, document_.artboard);
  PlainShape shape;
  shape.id = id_for(element, place);
  shape.artboard_from_user = place.frame_from_user;
  shape.even_odd = style.even_odd();
  shape.stroke_first = style.stroke_first();
  const PaintedShape painted{element, place.frame_from_user, bounds(*subpaths)};
  auto fill = style.paint(css::Property::fill, paints_, painted);
  if (!fill) return fill.status();
  auto stroke = style.paint(css::Property::stroke, paints_, painted);
  if (!stroke) return stroke.status();
  shape.fill = *fill;
  if (*stroke) {
    Result<StrokeStyle> stroke_style = style.stroke_style();
    if (!stroke_style) return stroke_style.status();
    shape.style = std::move(*stroke_style);
    if (shape.style.width > 0) shape.stroke = *stroke;
  }
  if (!shape.fill && !shape.stroke) return ok_status();
  for (Subpath& subpath : *subpaths) {
    const std::size_t points = subpath.control_points.size();
    if (Status status = totals_.add_curve(element, points, 2 * sizeof(Curve)); !status) {
      return status;
    }
    shape.subpaths.push_back(std::move(subpath.control_points));
  }
  return add_plain(element, place, std::move(shape));
}

/// Stands for the shape in the stack.
Status StackReader::add_plain(Element element, const Place& place, PlainShape shape) {
  const Result<OpenGroup> group = open_group(element, place);
  if (!group) return group.status();
  const auto add_layer = [&](const std::optional<PlainPaint>& paint, std::uint32_t& layer) {
    if (!paint) return ok_status();
    if (Status status = totals_.add_stack_item(element); !status) return status;
    layer = static_cast<std::uint32_t>(document_.layers.size());
    document_.layers.emplace_back();
    document_.stack.emplace_back(LayerInstance{layer, {}, paint->opacity, BlendMode::normal});
    return ok_status();
  };
  Status status = ok_status();
  if (shape.stroke_first) status = add_layer(shape.stroke, shape.stroke_layer);
  if (status) status = add_layer(shape.fill, shape.fill_layer);
  if (status && !shape.stroke_first) status = add_layer(shape.stroke, shape.stroke_layer);
  if (status) status = input_.charge(element, 2 * sizeof(PlainShape), "shapes");
  if (!status) return status;
  plain_->push_back(std::move(shape));
  return close_group(element, *group);
}

}  // namespace sfumato::svg
