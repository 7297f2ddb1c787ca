#include "formats/svg/shapes/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/try.hpp"
#include "formats/svg/read/scanner.hpp"

namespace sfumato::svg {
namespace {

using Subpaths = std::vector<Subpath>;

/// A share of the coordinates: shorter sides are dropped.
constexpr double kNoSide = 1e-12;

/// Returns the value of a length that is an attribute and may be a property of CSS.
std::optional<std::string_view> geometry_of(Input& input, const StyleScope& scope,
                                            const char* name) {
  const auto property = css::property_of(name);
  return property ? input.cascaded(scope, *property).value : input.attribute(scope.element(), name);
}

class ShapeReader {
 public:
  ShapeReader(Input& input, const StyleScope& scope, const Box& viewport, TableMemory& memory)
      : input_(input),
        scope_(scope),
        element_(scope.element()),
        is_forgiven_(input.forgives(element_)),
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
  Status end_at(const char* name, Status mistake);
  Status read_point_list(std::string_view text);
  Status radius(const char* name, Axis axis, std::optional<double>& value);
  Result<Vec2> read_radii();
  Result<Subpaths> built();
  void add_ellipse(Vec2 center, Vec2 radii);
  void add_rounded_rect(const Box& box, Vec2 radii);
  bool is_auto(const char* name);

  Input& input_;
  StyleScope scope_;
  Element element_;
  bool is_forgiven_;
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
  SFUMATO_TRY_ASSIGN(value, length_of(input_, scope_, name, viewport_, axis, value));
  return ok_status();
}

Status ShapeReader::not_negative(const char* name, double value) {
  if (value >= 0) return ok_status();
  return input_.error(element_,
                      std::string(name) + " of " + tag(element_) + " is negative; use 0 or more");
}

Result<Subpaths> ShapeReader::built() {
  Result<Subpaths> subpaths = builder_.take();
  if (!subpaths) return input_.placed(element_, subpaths.status());
  return subpaths;
}

Result<Subpaths> ShapeReader::read_path() {
  const Input::Cascaded written = input_.cascaded(scope_, css::Property::d);
  const std::string_view data =
      written.is_attribute
          ? *input_.attribute(element_, "d")
          : css::path_data_of(written.value.value_or("none"), input_.text_poll()).value_or("");
  Status mistake;
  Result<Subpaths> subpaths =
      parse_path(input_.context(), data, memory_, is_forgiven_ ? &mistake : nullptr);
  if (!subpaths) return input_.in(element_, "d", subpaths.status());
  SFUMATO_TRY(end_at("d", mistake));
  return subpaths;
}

/// If a mistake is forgiven, the part before it is drawn, as in browsers.
Status ShapeReader::end_at(const char* name, Status mistake) {
  Status status = input_.in(element_, name, std::move(mistake));
  if (status.code != StatusCode::bad_input || !is_forgiven_) return status;
  input_.warn(std::string("/end of ") + name, element_,
              status.message + "; what follows is left out");
  return ok_status();
}

Result<Subpaths> ShapeReader::read_points(bool closed) {
  Status status = read_point_list(input_.attribute(element_, "points").value_or(""));
  if (status.code == StatusCode::bad_input) status = end_at("points", std::move(status));
  if (!status) return status;
  if (closed) builder_.close();
  return built();
}

/// Errors: bad_input, without a place; cancelled.
Status ShapeReader::read_point_list(std::string_view text) {
  Scanner scanner(text);
  bool first = true;
  for (scanner.skip_blanks(); !scanner.at_end(); scanner.skip_separator()) {
    const std::size_t begin = scanner.position();
    Vec2 point;
    Status status = scanner.take_number(point.x);
    scanner.skip_separator();
    if (status) status = scanner.take_number(point.y);
    if (!status) return status;
    if (!input_.text_poll().go_on(scanner.position() - begin)) return input_.text_poll().status();
    if (std::exchange(first, false)) {
      builder_.move_to(point);
    } else {
      builder_.line_to(point);
    }
    if (!builder_.status()) break;
  }
  return ok_status();
}

Result<Subpaths> ShapeReader::read_line() {
  Vec2 from, to;
  SFUMATO_TRY(length("x1", Axis::x, from.x));
  SFUMATO_TRY(length("y1", Axis::y, from.y));
  SFUMATO_TRY(length("x2", Axis::x, to.x));
  SFUMATO_TRY(length("y2", Axis::y, to.y));
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
  SFUMATO_TRY(length("cx", Axis::x, center.x));
  SFUMATO_TRY(length("cy", Axis::y, center.y));
  SFUMATO_TRY(length("r", Axis::diagonal, radius));
  SFUMATO_TRY(not_negative("r", radius));
  add_ellipse(center, {radius, radius});
  return built();
}

bool ShapeReader::is_auto(const char* name) {
  const auto text = geometry_of(input_, scope_, name);
  return !text || css::is_auto_size(*text, input_.text_poll());
}

/// No value where it is `auto`, or negative and forgiven.
Status ShapeReader::radius(const char* name, Axis axis, std::optional<double>& value) {
  if (is_auto(name)) return ok_status();
  double size = 0;
  SFUMATO_TRY(length(name, axis, size));
  if (size >= 0) value = size;
  return input_.ignore(element_, not_negative(name, size));
}

/// `rx` and `ry`; one that has no value is the other one.
Result<Vec2> ShapeReader::read_radii() {
  std::optional<double> x, y;
  SFUMATO_TRY(radius("rx", Axis::x, x));
  SFUMATO_TRY(radius("ry", Axis::y, y));
  return Vec2{x.value_or(y.value_or(0)), y.value_or(x.value_or(0))};
}

Result<Subpaths> ShapeReader::read_ellipse() {
  Vec2 center;
  SFUMATO_TRY(length("cx", Axis::x, center.x));
  SFUMATO_TRY(length("cy", Axis::y, center.y));
  SFUMATO_TRY_ASSIGN(const Vec2& radii, read_radii());
  add_ellipse(center, radii);
  return built();
}

/// Clockwise on the screen from the left end of the upper side.
void ShapeReader::add_rounded_rect(const Box& box, Vec2 radii) {
  const auto [x0, y0] = box.min;
  const auto [x1, y1] = box.max;
  // Corners of half the width leave no side between them, apart from rounding.
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
  SFUMATO_TRY_ASSIGN(const Box& box, read_rect(input_, scope_, viewport_));
  SFUMATO_TRY_ASSIGN(const Vec2& radii, read_radii());
  if (box.width() == 0 || box.height() == 0) return Subpaths();
  const bool is_round = radii.x != 0 && radii.y != 0;
  add_rounded_rect(
      box, is_round ? Vec2{std::min(radii.x, box.width() / 2), std::min(radii.y, box.height() / 2)}
                    : Vec2{});
  return built();
}

}  // namespace

Result<double> length_of(Input& input, const StyleScope& scope, const char* name,
                         const Box& viewport, Axis axis, double absent) {
  const auto text = geometry_of(input, scope, name);
  if (!text || css::is_auto_size(*text, input.text_poll())) return absent;
  Result<double> value = input.length(scope, *text, viewport, axis);
  if (!value) return input.in(scope.element(), name, value.status());
  return value;
}

Result<Box> read_rect(Input& input, const StyleScope& scope, const Box& viewport) {
  const Element element = scope.element();
  const Result<double> x = length_of(input, scope, "x", viewport, Axis::x, 0);
  SFUMATO_TRY(x);
  const Result<double> y = length_of(input, scope, "y", viewport, Axis::y, 0);
  SFUMATO_TRY(y);
  SFUMATO_TRY_ASSIGN(const double width, length_of(input, scope, "width", viewport, Axis::x, 0));
  SFUMATO_TRY_ASSIGN(const double height, length_of(input, scope, "height", viewport, Axis::y, 0));
  if (width < 0 || height < 0) {
    return input.error(element, "the size of " + tag(element) + " is negative; use 0 or more");
  }
  return Box{{*x, *y}, {*x + width, *y + height}};
}

Result<Subpaths> read_shape(Input& input, const StyleScope& scope, const Box& viewport,
                            TableMemory& memory) {
  return ShapeReader(input, scope, viewport, memory).read();
}

}  // namespace sfumato::svg
