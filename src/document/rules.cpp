#include "document/rules.hpp"

#include <cmath>

#include "base/limit_error.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::rules {
namespace {

Status bad(const char* message) {
  return make_error(StatusCode::bad_input, message);
}

}  // namespace

bool is_coordinate(double value) {
  return std::abs(value) <= limits::kCoordinate;  // false for NaN
}

bool is_coordinate(Vec2 p) {
  return is_coordinate(p.x) && is_coordinate(p.y);
}

bool is_share(double value) {
  return value >= 0 && value <= 1;
}

bool is_color(const Rgb& color) {
  return is_share(color.r) && is_share(color.g) && is_share(color.b);
}

bool has_area(const Box& box) {
  return is_coordinate(box.min) && is_coordinate(box.max) && box.width() > 0 && box.height() > 0;
}

bool is_usable(const Affine& m) {
  return is_coordinate(m.a) && is_coordinate(m.b) && is_coordinate(m.c) && is_coordinate(m.d) &&
         is_coordinate({m.e, m.f}) && std::isfinite(1 / m.determinant());
}

Status check_interpolation(InterpolationSpace space) {
  return space <= InterpolationSpace::oklab ? ok_status() : bad("an unknown interpolation space");
}

Status check_background(const std::optional<Rgb>& background) {
  return !background || is_color(*background) ? ok_status()
                                              : bad("the background is not within 0 to 1");
}

Status check_compositing(float opacity, BlendMode blend) {
  if (!is_share(opacity)) return bad("the opacity is not within 0 to 1");
  return blend <= BlendMode::luminosity ? ok_status() : bad("an unknown blend mode");
}

Status inside(const std::string& place, Status status) {
  if (!status) status.message = place + ": " + status.message;
  return status;
}

Status StackChecker::operator()(const GroupBegin& group) {
  SFUMATO_TRY(check_compositing(group.opacity, group.blend));
  if (++open_groups_ <= context_.limits.group_depth) return ok_status();
  return limit_error(context_.limits, &Limits::group_depth, "groups within each other");
}

Status StackChecker::operator()(const GroupEnd&) {
  if (open_groups_ == 0) return bad("a group ends that was not begun");
  --open_groups_;
  return ok_status();
}

Status StackChecker::finish() const {
  return open_groups_ == 0 ? ok_status() : bad("a group has no end");
}

Status StackChecker::check_instance(std::size_t layer, const Affine& artboard_from_layer,
                                    float opacity, BlendMode blend) const {
  if (layer >= layer_count_) {
    return make_error(StatusCode::bad_input, "there is no layer " + std::to_string(layer));
  }
  if (!is_usable(artboard_from_layer)) return bad("the transform cannot be inverted");
  return check_compositing(opacity, blend);
}

Status check_stack_size(const Context& context, std::size_t item_count) {
  if (item_count <= context.limits.stack_items) return ok_status();
  return limit_error(context.limits, &Limits::stack_items, "stack items");
}

}  // namespace sfumato::rules
