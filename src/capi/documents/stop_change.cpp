#include "capi/documents/stop_change.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sfumato::capi {
namespace {

/// The largest difference that counts as zero: less than a hundredth of a code value.
constexpr float kSame = 1e-5f;

Rgb in_space(const Rgb& color, InterpolationSpace space) {
  return from_srgb(space, color);
}
float in_space(float number, InterpolationSpace) {
  return number;
}

bool is_zero(const Rgb& shift) {
  return std::max({std::fabs(shift.r), std::fabs(shift.g), std::fabs(shift.b)}) <= kSame;
}
bool is_zero(float shift) {
  return std::fabs(shift) <= kSame;
}

Rgb difference(const Rgb& a, const Rgb& b) {
  return {a.r - b.r, a.g - b.g, a.b - b.b};
}
float difference(float a, float b) {
  return a - b;
}

/// Returns whether both differ at most in the values of their stops.
template <class Value>
bool have_the_same_offsets(const SideShader<Value>& a, const SideShader<Value>& b) {
  return a.kind == b.kind && a.shader == b.shader && a.stops.space == b.stops.space &&
         std::ranges::equal(a.stops.stops, b.stops.stops, {}, &Stop<Value>::offset,
                            &Stop<Value>::offset);
}

template <class Value>
bool is_shifted(const StopList<Value>& from, const StopList<Value>& to, InterpolationSpace space) {
  const auto shift = [&](std::size_t i) {
    return difference(in_space(to.stops[i].value, space), in_space(from.stops[i].value, space));
  };
  for (std::size_t i = 1; i < from.stops.size(); ++i) {
    if (!is_zero(difference(shift(i), shift(0)))) return false;
  }
  return true;
}

/// Collects the differences between the sides of two curves.
class Comparison {
 public:
  Comparison(const StopPlace& at, InterpolationSpace space) : at_(at), space_(space) {}

  void compare(const Side& from, const Side& to, CurveSide side) {
    is_more_ = is_more_ || !(from.blur_radius == to.blur_radius);
    compare(from.color, to.color, side, StopAttribute::color);
    compare(from.opacity, to.opacity, side, StopAttribute::opacity);
  }

  std::optional<StopChange> result() const { return is_more_ ? std::nullopt : change_; }

 private:
  template <class Value>
  void compare(const SideShader<Value>& from, const SideShader<Value>& to, CurveSide side,
               StopAttribute attribute) {
    if (is_more_ || from == to) return;
    is_more_ = change_.has_value() || !have_the_same_offsets(from, to);
    if (is_more_) return;
    const auto &was = from.stops.stops, &is = to.stops.stops;
    const auto differ = std::ranges::mismatch(was, is).in1;
    const auto first = static_cast<std::uint32_t>(differ - was.begin());
    StopPlace place{at_.layer, at_.curve, side, attribute, first};
    if (std::equal(differ + 1, was.end(), is.begin() + first + 1)) {
      change_ = {place, is[first].value};
    } else if (is_shifted(from.stops, to.stops, space_)) {
      place.index.reset();
      change_ = {place, is[0].value};
    } else {
      is_more_ = true;
    }
  }

  StopPlace at_;
  InterpolationSpace space_;
  std::optional<StopChange> change_;
  bool is_more_ = false;
};

}  // namespace

std::optional<StopChange> find_stop_change(const Curve& from, const Curve& to, const StopPlace& at,
                                           InterpolationSpace space) {
  if (from.id != to.id || from.control_points != to.control_points || from.weight != to.weight) {
    return std::nullopt;
  }
  Comparison comparison(at, space);
  comparison.compare(from.left, to.left, CurveSide::left);
  comparison.compare(from.right, to.right, CurveSide::right);
  return comparison.result();
}

}  // namespace sfumato::capi
