#include "formats/svg/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "formats/svg/scanner.hpp"

namespace sfumato::svg {
namespace {

using Subpaths = std::vector<Subpath>;

/// Of the coordinates: shorter sides are none.
constexpr double kNoSide = 1e-12;

class ShapeReader {
 public:
  ShapeReader(Input& input, Element element, const Box& viewport, TableMemory& memory)
      : input_(input),
        element_(element),
        viewport_(viewport),
        memory_(memory),
        builder_(input.context(), memory) {}

  Result<Subpaths> read();

 private:
  Result<Subpaths> read_path();
  Result<Subpaths> read_points(bool closed);
  Result<Subpaths> read_line();
  Result<Subpaths> read_ellipse();
  Result<Subpaths> read_circle();
  Result<Subpaths> read_rounded_rect();
  Status length(const char* name, Axis axis, double& value);
  Status not_negative(const char* name, double value);
  Result<Subpaths> built();
  void add_ellipse(Vec2 center, Vec2 radii);
  void add_rounded_rect(const Box& box, Vec2 radii);
  bool is_auto(const char* name);

  Input& input_;
  Element element_;
  const Box& viewport_;
  TableMemory& memory_;
  PathBuilder builder_;
};

Result<Subpaths> ShapeReader::read() {
  const std::string_view name = element_.name();
  if (name == "path") return read_path();
  if (name == "line") return read_line();
  if (name == "circle") return read_circle();
  if (name == "ellipse") return read_ellipse();
  if (name == "rect") return read_rounded_rect();
  return read_points(name == "polygon");
}

/// `value` stays where the attribute is absent.
Status ShapeReader::length(const char* name, Axis axis, double& value) {
  const Result<double> read = length_of(input_, element_, name, viewport_, axis, value);
  if (read) value = *read;
  return read.status();
}

Status ShapeReader::not_negative(const char* name, double value) {
  if (value >= 0) return ok_status();
  return input_.error(
      element_, std::string(name) + " of " + tag(element_) + " is negative; expected 0 or more");
}

Result<Subpaths> ShapeReader::built() {
  Result<Subpaths> subpaths = builder_.take();
  if (!subpaths) return input_.placed(element_, subpaths.status());
  return subpaths;
}

Result<Subpaths> ShapeReader::read_path() {
  const std::string_view data = input_.attribute(element_, "d").value_or("");
  Result<Subpaths> subpaths = parse_path(input_.context(), data, memory_);
  if (!subpaths) return input_.in(element_, "d", subpaths.status());
  return subpaths;
}

Result<Subpaths> ShapeReader::read_points(bool closed) {
  const std::string_view text = input_.attribute(element_, "points").value_or("");
  Scanner scanner(text);
  bool first = true;
  for (scanner.skip_blanks(); !scanner.at_end(); scanner.skip_separator()) {
    const std::size_t begin = scanner.position();
    Vec2 point;
    Status status = scanner.take_number(point.x);
    scanner.skip_separator();
    if (status) status = scanner.take_number(point.y);
    if (!status) return input_.in(element_, "points", status);
    if (!input_.text_poll().go_on(scanner.position() - begin)) return input_.text_poll().status();
    if (std::exchange(first, false)) {
      builder_.move_to(point);
    } else {
      builder_.line_to(point);
    }
    if (!builder_.status()) break;
  }
  if (closed) builder_.close();
  return built();
}

Result<Subpaths> ShapeReader::read_line() {
  Vec2 from, to;
  Status status = length("x1", Axis::x, from.x);
  if (status) status = length("y1", Axis::y, from.y);
  if (status) status = length("x2", Axis::x, to.x);
  if (status) status = length("y2", Axis::y, to.y);
  if (!status) return status;
  builder_.move_to(from);
  builder_.line_to(to);
  return built();
}

/// Clockwise on the screen from its right end, in quarters.
void ShapeReader::add_ellipse(Vec2 center, Vec2 radii) {
  if (radii.x == 0 || radii.y == 0) return;
  builder_.move_to(center + Vec2{radii.x, 0});
  for (const Vec2 end : {Vec2{0, radii.y}, Vec2{-radii.x, 0}, Vec2{0, -radii.y}}) {
    builder_.arc_to(radii, 0, false, true, center + end);
  }
  builder_.arc_to(radii, 0, false, true, center + Vec2{radii.x, 0});
  builder_.close();
}

Result<Subpaths> ShapeReader::read_circle() {
  Vec2 center;
  double radius = 0;
  Status status = length("cx", Axis::x, center.x);
  if (status) status = length("cy", Axis::y, center.y);
  if (status) status = length("r", Axis::diagonal, radius);
  if (status) status = not_negative("r", radius);
  if (!status) return status;
  add_ellipse(center, {radius, radius});
  return built();
}

bool ShapeReader::is_auto(const char* name) {
  return input_.attribute(element_, name).value_or("auto") == "auto";
}

Result<Subpaths> ShapeReader::read_ellipse() {
  Vec2 center, radii;
  Status status = length("cx", Axis::x, center.x);
  if (status) status = length("cy", Axis::y, center.y);
  if (status && !is_auto("rx")) status = length("rx", Axis::x, radii.x);
  if (status && !is_auto("ry")) status = length("ry", Axis::y, radii.y);
  if (status) status = not_negative("rx", radii.x);
  if (status) status = not_negative("ry", radii.y);
  if (!status) return status;
  if (is_auto("rx")) radii.x = radii.y;
  if (is_auto("ry")) radii.y = radii.x;
  add_ellipse(center, radii);
  return built();
}

/// Clockwise on the screen from the left end of the upper side.
void ShapeReader::add_rounded_rect(const Box& box, Vec2 radii) {
  const auto [x0, y0] = box.min;
  const auto [x1, y1] = box.max;
  // Corners of half the width leave no side between them, but for rounding.
  const double extent = std::max({std::abs(x0), std::abs(x1), std::abs(y0), std::abs(y1)});
  const auto corner = [&](Vec2 point) {
    if (radii.x > 0 && radii.y > 0) builder_.arc_to(radii, 0, false, true, point);
  };
  const auto side = [&](Vec2 point) {
    if (sfumato::length(point - builder_.current()) > kNoSide * extent) builder_.line_to(point);
  };
  builder_.move_to({x0 + radii.x, y0});
  side({x1 - radii.x, y0});
  corner({x1, y0 + radii.y});
  side({x1, y1 - radii.y});
  corner({x1 - radii.x, y1});
  side({x0 + radii.x, y1});
  corner({x0, y1 - radii.y});
  side({x0, y0 + radii.y});
  corner({x0 + radii.x, y0});
  builder_.close();
}

Result<Subpaths> ShapeReader::read_rounded_rect() {
  const Result<Box> box = read_rect(input_, element_, viewport_);
  if (!box) return box.status();
  Vec2 radii;
  Status status = is_auto("rx") ? ok_status() : length("rx", Axis::x, radii.x);
  if (status && !is_auto("ry")) status = length("ry", Axis::y, radii.y);
  if (status) status = not_negative("rx", radii.x);
  if (status) status = not_negative("ry", radii.y);
  if (!status) return status;
  if (is_auto("rx")) radii.x = radii.y;
  if (is_auto("ry")) radii.y = radii.x;
  if (box->width() == 0 || box->height() == 0) return Subpaths();
  if (radii.x == 0 || radii.y == 0) radii = {};
  add_rounded_rect(*box,
                   {std::min(radii.x, box->width() / 2), std::min(radii.y, box->height() / 2)});
  return built();
}

}  // namespace

Result<double> length_of(Input& input, Element element, const char* name, const Box& viewport,
                         Axis axis, double absent) {
  const auto text = input.attribute(element, name);
  if (!text) return absent;
  Result<double> value = parse_length(*text, viewport, axis);
  if (!value) return input.in(element, name, value.status());
  return value;
}

Result<Box> read_rect(Input& input, Element element, const Box& viewport) {
  const Result<double> x = length_of(input, element, "x", viewport, Axis::x, 0);
  if (!x) return x.status();
  const Result<double> y = length_of(input, element, "y", viewport, Axis::y, 0);
  if (!y) return y.status();
  const Result<double> width = length_of(input, element, "width", viewport, Axis::x, 0);
  if (!width) return width.status();
  const Result<double> height = length_of(input, element, "height", viewport, Axis::y, 0);
  if (!height) return height.status();
  if (*width < 0 || *height < 0) {
    return input.error(element, "the size of " + tag(element) + " is negative; expected 0 or more");
  }
  return Box{{*x, *y}, {*x + *width, *y + *height}};
}

Result<Subpaths> read_shape(Input& input, Element element, const Box& viewport,
                            TableMemory& memory) {
  return ShapeReader(input, element, viewport, memory).read();
}

}  // namespace sfumato::svg
