#include "formats/svg/read/plain_reader.hpp"

#include <cmath>
#include <utility>

#include "base/try.hpp"
#include "formats/svg/paint/background.hpp"
#include "formats/svg/paint/plain_blur.hpp"
#include "formats/svg/shapes/element_transform.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "formats/svg/style/conditional.hpp"

namespace sfumato::svg {

/// Warns if it is not.
bool PlainReader::is_root_drawn() {
  const Element root = input_.root();
  if (!meets_conditions(input_, root)) {
    input_.warn(
        "/language", root,
        "the picture is empty: <svg> is not for readers of English, or requires extensions");
    return false;
  }
  if (input_.keyword(root, css::Property::display) != "none") return true;
  input_.warn("/display", root, "the picture is empty: display of <svg> is none");
  return false;
}

Status PlainReader::read() {
  if (!is_root_drawn()) return ok_status();
  Place place;
  place.frame_from_user = artboard_from_root_;
  const Element root = input_.root();
  Status status = clip_to(root, place);
  SFUMATO_TRY_ASSIGN(const Masking& masking, status ? mask_to(root, place) : status);
  if (masking.is_soft) status = draw_as_one(root, place).status();
  if (status && !masking.hides) status = visit_root(place);
  document_.shaders = paints_.take();
  return status;
}

bool PlainReader::is_shown(Element element, const Place& place) {
  if (is_ordinary(place) && !meets_conditions(input_, element)) return false;
  return StackReader::is_shown(element, place);
}

/// An unreadable value changes nothing, as in browsers.
Result<Affine> PlainReader::own_transform(Element element, const Place& place) {
  Result<Affine> map = StackReader::own_transform(element, place);
  if (map) return map;
  Status status = map.status();
  const bool is_ignored =
      status.code == StatusCode::bad_input && is_ordinary(place) && input_.forgives(element);
  if (!is_ignored) return status;
  input_.warn("/transform", element, status.message + "; the transform is ignored");
  return Affine{};
}

/// The clip-path of an ordinary element.
Status PlainReader::clip_to(Element element, Place& place) {
  if (!is_ordinary(place)) return ok_status();
  SFUMATO_TRY_ASSIGN(place.clip, clips_.read(element, place.frame_from_user, place.clip));
  return ok_status();
}

Status PlainReader::clip_to_box(Element element, const Box& box, Place& place) {
  SFUMATO_TRY_ASSIGN(place.clip, clips_.add_box(element, box, place.frame_from_user, place.clip));
  return ok_status();
}

/// Its clip, its mask, and warnings of other effects.
Status PlainReader::visit_effects(Element element, Place place) {
  const bool is_plain = is_ordinary(place);
  Status status = clip_to(element, place);
  const Result<Masking> masking = status ? mask_to(element, place) : status;
  if (!masking) return leave_out(element, place, masking.status());
  warn_of_effects(
      input_, element,
      {.clip_path = is_plain, .mask = is_plain, .filter = reads_filter(element, place)});
  if (masking->hides) return ok_status();
  if (masking->is_soft) {
    const Result<bool> is_drawn = draw_as_one(element, place);
    if (!is_drawn) return leave_out(element, place, is_drawn.status());
    if (*is_drawn) return ok_status();
  }
  return visit_known(element, place);
}

/// An import continues without an ordinary element that is faulty.
Status PlainReader::leave_out(Element element, const Place& place, Status status) {
  return is_ordinary(place) && !is_refused_ ? input_.leave_out(element, std::move(status)) : status;
}

Status PlainReader::visit_known(Element element, const Place& place) {
  const std::string_view name = element.name();
  if (is_ordinary(place) && name == "switch") return visit_switch(element, place);
  if (is_ordinary(place) && name == "image" && !input_.has_sf(element)) {
    return visit_image(element, place);
  }
  return StackReader::visit_known(element, place);
}

Status PlainReader::visit_switch(Element element, const Place& place) {
  const std::size_t open_around = open_.size();
  Status status = visit_group(element, place);
  if (open_.size() > open_around) open_.back().is_switch = true;
  return status;
}

/// Only one child of a <switch> is visited.
Status PlainReader::visit_child(Element child, OpenElement& parent) {
  if (parent.is_switch) {
    SFUMATO_TRY(count_visit(child, parent.inside));
    if (!meets_conditions(input_, child)) return ok_status();
    if (!can_be_chosen(child.name())) {
      if (!paints_nothing(child.name())) warn_of_unread(child);
      return ok_status();
    }
    parent.next = {};
  }
  return StackReader::visit_child(child, parent);
}

Status PlainReader::visit_bare(Element element, const Place& place) {
  Result<BackgroundRect> rect = BackgroundRect{};
  if (!place.clip && document_.stack.empty()) rect = background_rect(element, place);
  // Where the shape is read, its mistakes are named.
  if (!rect && can_be_left_out(rect.status())) rect = BackgroundRect{};
  SFUMATO_TRY(rect);
  may_be_background_ = false;
  if (!rect->color) return visit_plain(element, place);
  set_background(*rect);
  return ok_status();
}

/// Leaves out a faulty element.
Status PlainReader::visit_plain(Element element, const Place& place) {
  return leave_out(element, place, read_plain(element, place));
}

/// Returns the ancestors whose styles an element inherits, outermost first.
/// open_end   the number of open elements around the element
std::vector<Element> PlainReader::elements_around(std::size_t open_end) const {
  std::vector<Element> around = marker_ ? marker_->around : around_;
  const auto open = std::span(open_).first(open_end).subspan(scope_.open_begin);
  for (const OpenElement& each : open) around.push_back(each.element);
  return around;
}

/// Returns the paints of `context-fill` and `context-stroke` here (SVG 2, 13.2): the paints of the
/// innermost <use> or marker; no value if there is none.
Result<std::optional<ContextPaints>> PlainReader::context_around(std::size_t open_end) {
  using Context = std::optional<ContextPaints>;
  const std::size_t begin = scope_.open_begin;
  for (std::size_t i = open_end; i-- > begin;) {
    if (!open_[i].is_use) continue;
    if (!open_[i].paints) {
      SFUMATO_TRY_ASSIGN(const ContextPaints& paints, paints_of_use(i));
      open_[i].paints = paints;
    }
    return Context(open_[i].paints);
  }
  return marker_ ? Context(marker_->context) : Context();
}

Result<ContextPaints> PlainReader::paints_of_use(std::size_t open_index) {
  const Element use = open_[open_index].element;
  const Place outside = open_[open_index].outside;
  SFUMATO_TRY_ASSIGN(const Box& box, content_box(input_, use, viewport_in(outside)));
  StyleLevels levels(input_);  // the requesting shape's own levels are in use
  levels.set(elements_around(open_index));
  PlainStyle style(input_, use, levels, viewport_in(outside));
  if (style.asks_for_context()) {
    SFUMATO_TRY_ASSIGN(const auto& context, context_around(open_index));
    style.set_context(context);
  }
  const PaintedShape painted{use, outside.frame_from_user, box, viewport_in(outside)};
  SFUMATO_TRY_ASSIGN(const auto& fill, style.bare_paint(css::Property::fill, paints_, painted));
  SFUMATO_TRY_ASSIGN(const auto& stroke, style.bare_paint(css::Property::stroke, paints_, painted));
  return ContextPaints{fill, stroke};
}

Result<PlainReader::ShapeMarkers> PlainReader::read_markers(PlainStyle& style,
                                                            const PaintedShape& shape,
                                                            std::span<const Subpath> subpaths) {
  Result<ShapeMarkers> markers = markers_of(shape.element, style);
  if (!markers || !markers->any) return markers;
  markers->subpaths = subpaths;
  SFUMATO_TRY_ASSIGN(const double width, style.stroke_width());
  markers->stroke_width = width;
  SFUMATO_TRY_ASSIGN(const auto& fill, style.bare_paint(css::Property::fill, paints_, shape));
  SFUMATO_TRY_ASSIGN(const auto& stroke, style.bare_paint(css::Property::stroke, paints_, shape));
  markers->context = {fill, stroke};
  return markers;
}

/// Returns the shape's clip, and the viewports of the markers around it that do not show all of it.
/// box   of the shape without its stroke, user space
Result<ClipPaths::Index> PlainReader::clip_to_markers(const PlainShape& shape, const Box& box) {
  ClipPaths::Index clip = shape.clip;
  const Box painted = box.grown_by(shape.stroke ? stroke_reach(shape.style) : 0);
  const bool is_unknown = shape.stroke && !shape.style.is_scaled;
  for (const DrawnMarker* each = marker_; each; each = each->outer) {
    if (!each->clip || !(is_unknown || cuts(*each, shape.artboard_from_user, painted))) continue;
    SFUMATO_TRY_ASSIGN(const auto& inner,
                       clips_.add_box(each->element, *each->clip, each->frame_from_viewport, clip));
    clip = inner;
  }
  return clip;
}

PlainShape PlainReader::unpainted(Element element, const Place& place) {
  PlainShape shape;
  shape.id = id_for(element, place);
  shape.offset = input_.offset(element);
  shape.artboard_from_user = place.frame_from_user;
  shape.clip = place.clip;
  shape.mask = place.mask;
  return shape;
}

Status PlainReader::read_plain(Element element, const Place& place) {
  TableMemory memory("control points");
  levels_.set(elements_around(open_.size()));
  const StyleScope scope(element, levels_.around());
  SFUMATO_TRY_ASSIGN(const auto& subpaths, read_shape(input_, scope, viewport_in(place), memory));
  if (subpaths.empty()) return ok_status();
  PlainStyle style(input_, element, levels_, viewport_in(place));
  if (style.asks_for_context()) {
    SFUMATO_TRY_ASSIGN(const auto& context, context_around(open_.size()));
    style.set_context(context);
  }
  PlainShape shape = unpainted(element, place);
  shape.even_odd = style.even_odd();
  SFUMATO_TRY_ASSIGN(const Box& box, bounds(input_.context(), subpaths));
  const PaintedShape painted{element, place.frame_from_user, box, viewport_in(place)};
  SFUMATO_TRY_ASSIGN(auto&& fill, style.paint(css::Property::fill, paints_, painted));
  SFUMATO_TRY_ASSIGN(auto&& stroke, style.paint(css::Property::stroke, paints_, painted));
  shape.fill = fill;
  if (stroke) {
    SFUMATO_TRY_ASSIGN(shape.style, style.stroke_style());
    if (shape.style.width > 0) shape.stroke = stroke;
    SFUMATO_TRY(note_open_loops(element, subpaths, shape.style));
  }
  SFUMATO_TRY_ASSIGN(const ShapeMarkers& markers, read_markers(style, painted, subpaths));
  const bool is_painted = shape.fill || shape.stroke;
  if (!is_painted && place.is_copy) {
    // <use> and markers multiply the content that is read; this memory is not counted where it is
    // kept.
    SFUMATO_TRY(totals_.count_curves(element, subpaths.size(), 0));
  }
  if (!is_painted && !markers.any) return ok_status();
  style.warn_of_rendering(css::Property::shape_rendering);
  SFUMATO_TRY_ASSIGN(shape.clip, clip_to_markers(shape, box));
  read_blur(painted, shape, markers.any);
  const std::span<const Subpath> painted_subpaths =
      is_painted ? std::span<const Subpath>(subpaths) : std::span<const Subpath>();
  return keep_plain(element, place, std::move(shape), painted_subpaths, style.paint_order(),
                    markers);
}

Status PlainReader::note_open_loops(Element element, std::span<const Subpath> subpaths,
                                    StrokeStyle& style) {
  for (std::uint32_t i = 0; i < subpaths.size(); ++i) {
    const std::vector<Vec2>& points = subpaths[i].control_points;
    if (subpaths[i].is_closed || points.front() != points.back()) continue;
    SFUMATO_TRY(input_.push_back(element, input_.memory().shapes, style.open_loops, i));
  }
  return ok_status();
}

/// Adds a shape with these subpaths.
Status PlainReader::keep_plain(Element element, const Place& place, PlainShape shape,
                               std::span<const Subpath> subpaths, const css::PaintOrder& order,
                               const ShapeMarkers& markers) {
  TableMemory memory("shapes");
  SFUMATO_TRY(keep_subpaths(element, subpaths, memory, shape.subpaths));
  SFUMATO_TRY(add_plain(element, place, std::move(shape), order, markers));
  input_.memory().shapes.take(std::move(memory));
  return ok_status();
}

void PlainReader::read_blur(const PaintedShape& painted, PlainShape& shape, bool has_markers) {
  const Element element = painted.element;
  const std::optional<double> deviation = gaussian_blur(input_, element);
  if (!deviation) return;
  if (has_markers) {
    input_.warn("/filter", element, "filter of " + tag(element) + " does not blur its markers");
  }
  if (shape.fill && shape.stroke) {
    input_.warn(
        "/filter", element,
        "filter of " + tag(element) + " is not read: it blurs a fill and a stroke together");
    return;
  }
  if (cuts_blur(input_, painted, shape.stroke ? shape.style.width / 2 : 0, *deviation)) {
    input_.warn("/filter region", element,
                "the region of the filter of " + tag(element) +
                    " is not followed: it cuts off a part of the blur");
  }
  shape.blur = *deviation * std::sqrt(std::abs(shape.artboard_from_user.determinant()));
}

/// Copies the control points to tables that are as long as they are.
Status PlainReader::keep_subpaths(Element element, std::span<const Subpath> subpaths,
                                  TableMemory& memory, std::vector<std::vector<Vec2>>& kept) {
  const Context& context = input_.context();
  SFUMATO_TRY(input_.placed(element, memory.reserve(context, kept, subpaths.size())));
  for (const Subpath& subpath : subpaths) {
    SFUMATO_TRY(totals_.count_curves(element, 1, subpath.control_points.size()));

    std::vector<Vec2>& points = kept.emplace_back();
    SFUMATO_TRY(input_.placed(element, memory.append(context, subpath.control_points, points)));
  }
  return ok_status();
}

/// Stands for the shape in the stack.
Status PlainReader::add_plain(Element element, const Place& place, PlainShape shape,
                              const css::PaintOrder& order, const ShapeMarkers& markers) {
  SFUMATO_TRY_ASSIGN(const OpenGroup& group, open_group(element, place));
  for (const css::PaintPart part : order) {
    SFUMATO_TRY(add_part(part, element, place, shape, markers));
  }
  Status status = ok_status();
  if (shape.fill || shape.stroke) {
    status = input_.push_back(element, input_.memory().shapes, plain_.shapes, std::move(shape));
  }
  return status ? close_group(element, group) : status;
}

Status PlainReader::add_part(css::PaintPart part, Element element, const Place& place,
                             PlainShape& shape, const ShapeMarkers& markers) {
  switch (part) {
    case css::PaintPart::fill:
      return add_plain_layer(element, shape.fill, shape.fill_layer);
    case css::PaintPart::stroke:
      return add_plain_layer(element, shape.stroke, shape.stroke_layer);
    case css::PaintPart::markers:
      break;
  }
  return draw_markers(element, place, markers);
}

Status PlainReader::add_plain_layer(Element element, const std::optional<PlainPaint>& paint,
                                    std::uint32_t& layer) {
  if (!paint) return ok_status();
  layer = static_cast<std::uint32_t>(document_.layers.size());
  SFUMATO_TRY(push_item(element, LayerInstance{layer, {}, paint->opacity, BlendMode::normal}));
  return input_.push_back(element, input_.memory().stack, document_.layers, {});
}

}  // namespace sfumato::svg
