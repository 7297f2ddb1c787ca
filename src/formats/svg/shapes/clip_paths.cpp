#include "formats/svg/shapes/clip_paths.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "document/rules.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/shapes/clip_shape.hpp"
#include "formats/svg/shapes/element_transform.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "formats/svg/style/conditional.hpp"
#include "formats/svg/style/vocabulary.hpp"

namespace sfumato::svg {
namespace {

bool is_in_range(Vec2 p) {
  return rules::is_coordinate(p);
}

/// Returns the outline of a box, control points in steps of a third.
std::vector<Vec2> outline_of(const Box& box, const Affine& map) {
  const Vec2 corners[] = {
      box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}, box.min};
  std::vector<Vec2> points{map(corners[0])};
  for (int i = 0; i < 4; ++i) {
    const Vec2 from = map(corners[i]), to = map(corners[i + 1]);
    points.insert(points.end(), {lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to});
  }
  return points;
}

}  // namespace

/// Returns the element's clip-path; none after a warning where it cannot be read.
std::optional<ClipPaths::Named> ClipPaths::named_by(Element element) {
  const auto text = input_.property(element, css::Property::clip_path);
  if (!text || ascii_trimmed(*text).empty()) return std::nullopt;
  if (css::keyword_of(*text, input_.text_poll()) == "none") return std::nullopt;
  css::Tokenizer tokens(*text, input_.text_poll());
  Named named;
  if (const auto url = css::take_url(tokens, css::next_solid(tokens))) {
    const auto clip_path = clip_path_of(element, *url);
    if (!clip_path) return std::nullopt;
    named.clip_path = *clip_path;
    return named;
  }
  named.text = *text;
  named.needs_unit = !input_.cascaded(element, css::Property::clip_path).is_attribute;
  named.shape = css::read_basic_shape(*text, named.needs_unit, input_.text_poll(),
                                      [](const css::Length&, const css::Length&) {});
  if (named.shape) return named;
  input_.warn("/clip-path", element,
              "clip-path of " + tag(element) +
                  " is not read; use none, url(#id) or a shape such as circle()");
  return std::nullopt;
}

std::optional<Element> ClipPaths::clip_path_of(Element element, std::string_view url) {
  const auto ignore = [&](const std::string& why) {
    input_.warn("/clip-path", element, "clip-path of " + tag(element) + " is ignored: " + why);
    return std::nullopt;
  };
  if (url.size() < 2 || url.front() != '#') return ignore("its url is not in this file");
  const Result<Element> target = input_.element_of(element, url.substr(1));
  if (!target) return ignore(target.status().message);
  if (std::string_view(target->name()) != "clipPath") {
    return ignore(hash_id(*target) + " is not a <clipPath>");
  }
  if (std::ranges::find(active_, *target) != active_.end()) {
    return ignore(hash_id(*target) + " clips itself");
  }
  return *target;
}

Result<ClipPaths::Index> ClipPaths::read(Element element, const Affine& artboard_from_user,
                                         Index outer) {
  const std::optional<Named> named = named_by(element);
  if (!named) return outer;
  if (named->shape) return read_shape_function(element, *named, artboard_from_user, outer);
  const Element clip_path = named->clip_path;
  const bool in_user_space =
      input_.attribute(clip_path, "clipPathUnits").value_or("") != "objectBoundingBox";
  const Affine& m = artboard_from_user;
  const Key key{clip_path.internal_object(), m.a, m.b, m.c, m.d, m.e, m.f, outer};
  if (in_user_space) {
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
  }
  Result<Index> clip = read_clip_path(element, clip_path, artboard_from_user, outer);
  if (clip && in_user_space) known_.emplace(key, *clip);
  return clip;
}

/// The clip of a basic shape of CSS. A shape that cannot be read clips nothing.
Result<ClipPaths::Index> ClipPaths::read_shape_function(Element element, const Named& named,
                                                        const Affine& artboard_from_user,
                                                        Index outer) {
  SFUMATO_TRY(input_.charge_reading(element, "clip-path"));
  SFUMATO_TRY_ASSIGN(const Box& box, reference_box(input_, element, named.shape->box, viewport_));
  TableMemory memory("control points"), kept("shapes");
  const Box reference = box.empty() ? Box{{0, 0}, {0, 0}} : box;
  const auto outline = basic_shape_outline(input_, element, named.text, named.needs_unit,
                                           *named.shape, reference, memory);
  PlainClip clip;
  clip.outer = outer;
  PlainClip::Part part;
  part.even_odd = named.shape->even_odd;
  Status status = outline.status();
  if (status) status = add_contours(element, *outline, artboard_from_user, kept, part);
  if (!status && can_be_left_out(status)) {
    input_.warn("/clip-path", element,
                "clip-path of " + tag(element) + " is ignored: " + status.message);
    return outer;
  }
  if (status) status = input_.push_back(element, kept, clip.parts, std::move(part));
  if (!status) return status;
  input_.memory().shapes.take(std::move(kept));
  return keep(element, std::move(clip));
}

Result<ClipPaths::Index> ClipPaths::read_clip_path(Element element, Element clip_path,
                                                   const Affine& artboard_from_user, Index outer) {
  if (active_.size() >= input_.limits().xml_depth) {
    return input_.over_limit(element, &Limits::xml_depth, "clip paths within each other");
  }
  active_.push_back(clip_path);
  PlainClip clip;
  Result<Index> around = read(clip_path, artboard_from_user, outer);
  Status status = around.status();
  if (around) clip.outer = *around;
  const Result<Affine> frame =
      around ? content_frame(element, clip_path, artboard_from_user) : Result<Affine>(Affine{});
  if (status) status = frame.status();
  for (const Element child : clip_path.children()) {
    if (status && child.type() == pugi::node_element) status = read_child(child, *frame, clip);
  }
  active_.pop_back();
  if (!status) return status;
  return keep(element, std::move(clip));
}

/// Returns the map from the content of a <clipPath> to the artboard.
Result<Affine> ClipPaths::content_frame(Element element, Element clip_path,
                                        const Affine& artboard_from_user) {
  SFUMATO_TRY_ASSIGN(const Affine& own, element_transform(input_, clip_path, viewport_));
  if (input_.attribute(clip_path, "clipPathUnits").value_or("") != "objectBoundingBox") {
    return artboard_from_user * own;
  }
  SFUMATO_TRY_ASSIGN(const Box& box, content_box(input_, element, viewport_));
  if (box.empty()) return Affine{0, 0, 0, 0, 0, 0};
  const Affine user_from_box{box.width(), 0, 0, box.height(), box.min.x, box.min.y};
  return artboard_from_user * own * user_from_box;
}

/// Shapes, and <use> of a shape.
Status ClipPaths::read_child(Element child, const Affine& artboard_from_user, PlainClip& clip) {
  SFUMATO_TRY(input_.charge_reading(child, "clip-path"));
  if (!meets_conditions(input_, child)) return ok_status();
  const std::string_view visibility =
      input_.property(child, css::Property::visibility).value_or("visible");
  if (input_.keyword(child, css::Property::display) == "none" || visibility != "visible") {
    return ok_status();
  }
  SFUMATO_TRY_ASSIGN(const Affine& own, element_transform(input_, child, viewport_));
  Affine map = artboard_from_user * own;
  PlainClip::Part part;
  SFUMATO_TRY_ASSIGN(const Index& inner, read(child, map, std::nullopt));
  part.clip = inner;
  Element shape = child;
  if (std::string_view(child.name()) == "use") {
    const Result<Element> target = input_.referred(child);
    if (!target) return ok_status();
    const Result<double> x = length_of(input_, child, "x", viewport_, Axis::x, 0);
    const Result<double> y = length_of(input_, child, "y", viewport_, Axis::y, 0);
    const Result<Affine> inside = element_transform(input_, *target, viewport_);
    if (!x || !y || !inside) return !x ? x.status() : !y ? y.status() : inside.status();
    shape = *target;
    map = map * Affine{1, 0, 0, 1, *x, *y} * *inside;
  }
  if (!is_shape(shape.name())) {
    input_.warn("/in clip-path", child,
                tag(shape) + " in a <clipPath> is not read; use shapes and their <use>");
    return ok_status();
  }
  TableMemory memory("control points"), kept("shapes");
  SFUMATO_TRY_ASSIGN(const auto& subpaths, read_shape(input_, shape, viewport_, memory));
  SFUMATO_TRY(add_contours(child, subpaths, map, kept, part));
  part.even_odd = input_.keyword(shape, css::Property::clip_rule) == "evenodd";
  SFUMATO_TRY(input_.push_back(child, kept, clip.parts, std::move(part)));
  input_.memory().shapes.take(std::move(kept));
  return ok_status();
}

Status ClipPaths::add_contours(Element element, const std::vector<Subpath>& subpaths,
                               const Affine& map, TableMemory& memory, PlainClip::Part& part) {
  for (const Subpath& subpath : subpaths) {
    std::vector<Vec2>& points = part.contours.emplace_back();
    SFUMATO_TRY(
        input_.placed(element, memory.append(input_.context(), subpath.control_points, points)));
    for (Vec2& point : points) point = map(point);
    if (!std::ranges::all_of(points, is_in_range)) {
      return input_.error(element, tag(element) +
                                       " of a clip reaches too far; use coordinates of the "
                                       "usual size");
    }
  }
  return ok_status();
}

Result<ClipPaths::Index> ClipPaths::add_box(Element element, const Box& box,
                                            const Affine& artboard_from_user, Index outer,
                                            Index inner) {
  PlainClip clip;
  clip.outer = outer;
  if (!box.empty() && box.width() > 0 && box.height() > 0) {
    clip.parts.push_back({{outline_of(box, artboard_from_user)}, false, inner});
    if (!std::ranges::all_of(clip.parts[0].contours[0], is_in_range)) return outer;
  }
  return keep(element, std::move(clip));
}

Result<ClipPaths::Index> ClipPaths::keep(Element element, PlainClip clip) {
  const auto index = static_cast<std::uint32_t>(clips_.size());
  SFUMATO_TRY(input_.push_back(element, input_.memory().shapes, clips_, std::move(clip)));
  return Index(index);
}

}  // namespace sfumato::svg
