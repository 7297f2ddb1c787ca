#include "formats/svg/shapes/clip_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "formats/css/value.hpp"
#include "formats/svg/shapes/element_transform.hpp"
#include "formats/svg/style/plain_style.hpp"
#include "formats/svg/style/vocabulary.hpp"

namespace sfumato::svg {
namespace {

using css::BasicShape;

class OutlineReader {
 public:
  OutlineReader(Input& input, Element element, const BasicShape& shape, const Box& reference,
                TableMemory& memory)
      : shape_(shape),
        reference_(reference),
        sizes_(input.unit_sizes(element)),
        builder_(input.context(), memory) {}

  Result<std::vector<Subpath>> read(Input& input, std::string_view text, bool needs_unit);

 private:
  double along_x(const css::Length& length) const {
    return css::in_pixels(length, sizes_, reference_.width());
  }
  double along_y(const css::Length& length) const {
    return css::in_pixels(length, sizes_, reference_.height());
  }
  Vec2 center() const;
  double extent_of(const BasicShape::Radius& radius, double low, double high, double whole) const;
  void add_ellipse();
  void add_rounded(const Box& box);
  Box inset_box() const;
  Box placed_box() const;

  const BasicShape& shape_;
  const Box& reference_;
  css::UnitSizes sizes_;
  PathBuilder builder_;
};

Vec2 OutlineReader::center() const {
  const double x = along_x(shape_.center[0].length), y = along_y(shape_.center[1].length);
  return {shape_.center[0].from_end ? reference_.max.x - x : reference_.min.x + x,
          shape_.center[1].from_end ? reference_.max.y - y : reference_.min.y + y};
}

/// low, high   the distances of the two sides
double OutlineReader::extent_of(const BasicShape::Radius& radius, double low, double high,
                                double whole) const {
  switch (radius.extent) {
    case BasicShape::Extent::closest_side:
      return std::min(low, high);
    case BasicShape::Extent::farthest_side:
      return std::max(low, high);
    case BasicShape::Extent::length:
      break;
  }
  return css::in_pixels(radius.length, sizes_, whole);
}

/// An ellipse, or a circle, whose radius is the closest or the farthest of four sides.
void OutlineReader::add_ellipse() {
  const Vec2 middle = center();
  const std::array<double, 4> sides{
      std::abs(middle.x - reference_.min.x), std::abs(reference_.max.x - middle.x),
      std::abs(middle.y - reference_.min.y), std::abs(reference_.max.y - middle.y)};
  const double width = reference_.width(), height = reference_.height();
  Vec2 radii;
  if (shape_.kind == BasicShape::Kind::circle) {
    const double diagonal = length(Vec2{width, height}) / std::numbers::sqrt2;
    radii.x = radii.y = extent_of(shape_.radius[0], *std::ranges::min_element(sides),
                                  *std::ranges::max_element(sides), diagonal);
  } else {
    radii = {extent_of(shape_.radius[0], sides[0], sides[1], width),
             extent_of(shape_.radius[1], sides[2], sides[3], height)};
  }
  if (!(radii.x > 0 && radii.y > 0)) return;
  builder_.move_to(middle + Vec2{radii.x, 0});
  for (const Vec2 end : {Vec2{0, radii.y}, Vec2{-radii.x, 0}, Vec2{0, -radii.y}}) {
    builder_.arc_to(radii, 0, false, true, middle + end);
  }
  builder_.arc_to(radii, 0, false, true, middle + Vec2{radii.x, 0});
  builder_.close();
}

Box OutlineReader::inset_box() const {
  const auto& [top, right, bottom, left] = shape_.edges;
  const double x = along_x(right.length), y = along_y(bottom.length);
  const Vec2 low = reference_.min + Vec2{along_x(left.length), along_y(top.length)};
  return {low,
          {right.from_end ? reference_.max.x - x : std::max(reference_.min.x + x, low.x),
           bottom.from_end ? reference_.max.y - y : std::max(reference_.min.y + y, low.y)}};
}

Box OutlineReader::placed_box() const {
  const auto& [x, y, width, height] = shape_.edges;
  const Vec2 low = reference_.min + Vec2{along_x(x.length), along_y(y.length)};
  return {low, low + Vec2{along_x(width.length), along_y(height.length)}};
}

/// Radii that do not fit are scaled together (CSS Backgrounds 3, 4.5).
void OutlineReader::add_rounded(const Box& box) {
  if (box.empty() || !(box.width() > 0 && box.height() > 0)) return;
  std::array<Vec2, 4> radii;
  for (std::size_t i = 0; i < 4; ++i) {
    radii[i] = {css::in_pixels(shape_.corners[i], sizes_, reference_.width()),
                css::in_pixels(shape_.corners[i + 4], sizes_, reference_.height())};
  }
  double scale = 1;
  const auto limit = [&scale](double side, double sum) {
    if (sum > side) scale = std::min(scale, side / sum);
  };
  limit(box.width(), radii[0].x + radii[1].x);
  limit(box.width(), radii[2].x + radii[3].x);
  limit(box.height(), radii[1].y + radii[2].y);
  limit(box.height(), radii[3].y + radii[0].y);
  for (Vec2& radius : radii) radius = radius * scale;
  const auto [x0, y0] = box.min;
  const auto [x1, y1] = box.max;
  const auto corner = [&](Vec2 radius, Vec2 from, Vec2 to) {
    builder_.line_to(from);
    if (radius.x > 0 && radius.y > 0) builder_.arc_to(radius, 0, false, true, to);
  };
  const auto& [a, b, c, d] = radii;
  builder_.move_to({x0 + a.x, y0});
  corner(b, {x1 - b.x, y0}, {x1, y0 + b.y});
  corner(c, {x1, y1 - c.y}, {x1 - c.x, y1});
  corner(d, {x0 + d.x, y1}, {x0, y1 - d.y});
  corner(a, {x0, y0 + a.y}, {x0 + a.x, y0});
  builder_.close();
}

Result<std::vector<Subpath>> OutlineReader::read(Input& input, std::string_view text,
                                                 bool needs_unit) {
  bool is_first = true;
  switch (shape_.kind) {
    case BasicShape::Kind::box:
      add_rounded(reference_);
      break;
    case BasicShape::Kind::circle:
    case BasicShape::Kind::ellipse:
      add_ellipse();
      break;
    case BasicShape::Kind::inset:
      add_rounded(inset_box());
      break;
    case BasicShape::Kind::xywh:
      add_rounded(placed_box());
      break;
    case BasicShape::Kind::polygon:
      css::read_basic_shape(text, needs_unit, input.text_poll(),
                            [&](const css::Length& x, const css::Length& y) {
                              const Vec2 point = reference_.min + Vec2{along_x(x), along_y(y)};
                              is_first ? builder_.move_to(point) : builder_.line_to(point);
                              is_first = false;
                            });
      builder_.close();
      break;
    case BasicShape::Kind::path:
      break;
  }
  return builder_.take();
}

/// Half of the width of the element's stroke; 0: none.
double stroke_margin(Input& input, Element element, const Box& viewport) {
  const auto stroke = input.property(element, css::Property::stroke);
  if (!stroke || css::keyword_of(*stroke, input.text_poll()) == "none") return 0;
  StyleLevels levels(input);
  const Result<double> width = PlainStyle(input, element, levels, viewport).stroke_width();
  return width ? *width / 2 : 0;
}

}  // namespace

Result<Box> reference_box(Input& input, Element element, css::ReferenceBox box,
                          const Box& viewport) {
  if (box == css::ReferenceBox::view) return view_box_of(input, element, viewport);
  Result<Box> content = content_box(input, element, viewport);
  if (!content || content->empty() || box == css::ReferenceBox::fill) return content;
  const std::string_view name = element.name();
  const double margin = is_shape(name) ? stroke_margin(input, element, viewport) : 0;
  const bool is_smooth = name == "rect" || name == "circle" || name == "ellipse";
  const bool is_rough = is_shape(name) ? margin > 0 && !is_smooth : name != "image";
  if (is_rough) {
    input.warn("/stroke-box", element,
               "clip-path of " + tag(element) +
                   " refers to the stroke-box, whose corners are not known exactly; use "
                   "fill-box or view-box");
  }
  return content->grown_by(margin);
}

Result<std::vector<Subpath>> basic_shape_outline(Input& input, Element element,
                                                 std::string_view text, bool needs_unit,
                                                 const BasicShape& shape, const Box& reference,
                                                 TableMemory& memory) {
  if (shape.kind != BasicShape::Kind::path) {
    auto outline =
        OutlineReader(input, element, shape, reference, memory).read(input, text, needs_unit);
    return outline ? std::move(outline) : input.placed(element, outline.status());
  }
  auto subpaths = parse_path(input.context(), shape.path, memory);
  if (!subpaths) return input.in(element, "clip-path", subpaths.status());
  for (Subpath& subpath : *subpaths) {
    for (Vec2& point : subpath.control_points) point = point + reference.min;
  }
  return subpaths;
}

}  // namespace sfumato::svg
