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
  TableMemory memory("control points");
  const auto subpaths = read_shape(input_, element, document_.artboard, memory);
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
  const Result<Box> box = bounds(input_.context(), *subpaths);
  if (!box) return box.status();
  const PaintedShape painted{element, place.frame_from_user, *box};
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
  TableMemory shape_memory("shapes");
  Status status = keep_subpaths(element, *subpaths, shape_memory, shape.subpaths);
  if (status) status = add_plain(element, place, std::move(shape));
  if (status) input_.memory().shapes.take(std::move(shape_memory));
  return status;
}

/// Copies the control points to tables that are as long as they are.
Status StackReader::keep_subpaths(Element element, std::span<const Subpath> subpaths,
                                  TableMemory& memory, std::vector<std::vector<Vec2>>& kept) {
  const Context& context = input_.context();
  Status status = input_.placed(element, memory.reserve(context, kept, subpaths.size()));
  for (const Subpath& subpath : subpaths) {
    if (status) status = totals_.count_curves(element, 1, subpath.control_points.size());
    if (!status) return status;
    std::vector<Vec2>& points = kept.emplace_back();
    status = input_.placed(element, memory.append(context, subpath.control_points, points));
  }
  return status;
}

/// Stands for the shape in the stack.
Status StackReader::add_plain(Element element, const Place& place, PlainShape shape) {
  const Result<OpenGroup> group = open_group(element, place);
  if (!group) return group.status();
  Status status = ok_status();
  if (shape.stroke_first) status = add_plain_layer(element, shape.stroke, shape.stroke_layer);
  if (status) status = add_plain_layer(element, shape.fill, shape.fill_layer);
  if (status && !shape.stroke_first) {
    status = add_plain_layer(element, shape.stroke, shape.stroke_layer);
  }
  if (status) {
    status = input_.push_back(element, input_.memory().shapes, *plain_, std::move(shape));
  }
  return status ? close_group(element, *group) : status;
}

Status StackReader::add_plain_layer(Element element, const std::optional<PlainPaint>& paint,
                                    std::uint32_t& layer) {
  if (!paint) return ok_status();
  layer = static_cast<std::uint32_t>(document_.layers.size());
  Status status = push_item(element, LayerInstance{layer, {}, paint->opacity, BlendMode::normal});
  if (!status) return status;
  return input_.push_back(element, input_.memory().stack, document_.layers, {});
}

}  // namespace sfumato::svg
