#include <string_view>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/svg/read/stack_reader.hpp"
#include "formats/svg/shapes/overflow.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "formats/svg/shapes/view_box.hpp"

/// The part of StackReader that reads the viewports of nested <svg> and <symbol>.
namespace sfumato::svg {

/// Returns the box of a nested <svg> or a <symbol>. The <use> gives its size where it is set.
Result<Box> StackReader::shown_box(Element element, const Place& place) {
  const Box& viewport = viewport_in(place);
  const Element use = place.use;
  const auto size_of = [&](const char* name, Axis axis) -> Result<double> {
    const Element bearer = use && use.attribute(name) ? use : element;
    if (ascii_trimmed(bearer.attribute(name).value()) == "auto") return extent(viewport, axis);
    return length_of(input_, bearer, name, viewport, axis, extent(viewport, axis));
  };
  Vec2 corner;
  if (std::string_view(element.name()) == "svg") {
    SFUMATO_TRY_ASSIGN(const double x, length_of(input_, element, "x", viewport, Axis::x, 0));
    SFUMATO_TRY_ASSIGN(const double y, length_of(input_, element, "y", viewport, Axis::y, 0));
    corner = {x, y};
  }
  const bool needs_size = is_ordinary(place) || input_.attribute(element, "viewBox");
  if (!needs_size) return Box{corner, corner};
  SFUMATO_TRY_ASSIGN(const double width, size_of("width", Axis::x));
  SFUMATO_TRY_ASSIGN(const double height, size_of("height", Axis::y));
  return Box{corner, corner + Vec2{width, height}};
}

Result<StackReader::Viewport> StackReader::viewport_of(Element element, const Place& place) {
  SFUMATO_TRY_ASSIGN(const Box& shown, shown_box(element, place));
  const bool is_clipped = hides_overflow(input_, element);
  Viewport made;
  if (is_ordinary(place) && is_clipped) made.clip = shown;
  const auto view_box = input_.attribute(element, "viewBox");
  if (!view_box) {
    made.user_from_view = {1, 0, 0, 1, shown.min.x, shown.min.y};
    made.content = Box{{0, 0}, shown.max - shown.min};
    return made;
  }
  const Result<Box> box = parse_view_box(*view_box);
  if (!box) return input_.in(element, "viewBox", box.status());
  AspectRatio ratio;
  if (const auto text = input_.attribute(element, "preserveAspectRatio")) {
    const Result<AspectRatio> parsed = parse_aspect_ratio(*text);
    if (!parsed) return input_.in(element, "preserveAspectRatio", parsed.status());
    ratio = *parsed;
  }
  if (!is_ordinary(place) && is_clipped) {
    input_.warn("/overflow", element,
                tag(element) + " is not clipped to its viewport; use overflow=\"visible\"");
  }
  made.user_from_view = fit(*box, shown, ratio);
  made.content = *box;
  return made;
}

Status StackReader::visit_nested_svg(Element element, Place place) {
  const Result<Viewport> viewport = viewport_of(element, place);
  if (!viewport) return leave_out(element, place, viewport.status());
  if (viewport->clip) {
    SFUMATO_TRY(clip_to_box(element, *viewport->clip, place));
  }
  if (is_ordinary(place)) place.viewport = viewport->content;
  place.frame_from_user = place.frame_from_user * viewport->user_from_view;
  if (Status status = check_map(element, place.frame_from_user); !status) {
    return leave_out(element, place, std::move(status));
  }
  return visit_group(element, place);
}

Status StackReader::visit_symbol(Element symbol, Place place) {
  SFUMATO_TRY(count_visit(symbol, place));
  if (!is_ordinary(place)) return visit_nested_svg(symbol, place);
  SFUMATO_TRY_ASSIGN(const Affine& own, own_transform(symbol, place));
  place.frame_from_user = place.frame_from_user * own;
  return visit_effects(symbol, place);
}

}  // namespace sfumato::svg
