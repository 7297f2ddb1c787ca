#include "raster/shaders/gradient.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/try.hpp"

namespace sfumato::raster {
namespace {

/// A focus on the rim would leave half of the plane without a colour. At this distance from it the
/// gradient has a colour everywhere and looks the same.
constexpr double kLargestFocus = 1 - 1.0 / 1024;
constexpr double kOnRim = 1 + 1e-9;  ///< a focus is on the rim up to this distance, in radii

/// Offsets beyond this look the same; NaN becomes its negative.
constexpr double kLargestOffset = 1e9;

double bounded(double t) {
  return t > -kLargestOffset ? (t < kLargestOffset ? t : kLargestOffset) : -kLargestOffset;
}

void set_channels(const GradientStop& stop, double (&value)[4]) {
  value[0] = stop.color.r;
  value[1] = stop.color.g;
  value[2] = stop.color.b;
  value[3] = stop.alpha;
}

/// Adds the integral over `width` from the segment's begin: of alpha c for the colours (a cubic),
/// of alpha for alpha.
void add_integral(const GradientSegment& s, double width, double (&sum)[4]) {
  const double a0 = s.value[3], a1 = s.slope[3];
  for (int c = 0; c < 3; ++c) {
    const double c0 = s.value[c], c1 = s.slope[c];
    sum[c] += width * (a0 * c0 + width * ((a0 * c1 + a1 * c0) / 2 + width * (a1 * c1) / 3));
  }
  sum[3] += width * (a0 + width * a1 / 2);
}

void add_constant(const double (&value)[4], double width, double (&sum)[4]) {
  for (int c = 0; c < 3; ++c) sum[c] += value[c] * value[3] * width;
  sum[3] += value[3] * width;
}

}  // namespace

Result<Gradient> Gradient::create(Context& context, const GradientFill& fill) {
  Gradient gradient;
  SFUMATO_TRY(gradient.memory_.reserve(context, gradient.segments_, fill.stops.size() + 1));
  gradient.spread_ = fill.spread;
  gradient.add_segments(fill);
  std::visit([&](const auto& shape) { gradient.set_shape(shape); }, fill.shape);
  gradient.frame_from_layer_ = gradient.frame_from_layer_ * inverse(fill.layer_from_gradient);
  return gradient;
}

void Gradient::add_segments(const GradientFill& fill) {
  set_channels(fill.stops.front(), first_);
  set_channels(fill.stops.back(), last_);
  double low = 0;
  double low_value[4];
  std::copy_n(first_, 4, low_value);
  const auto add = [&](double high, const double(&high_value)[4]) {
    if (high > low) {
      GradientSegment segment;
      segment.begin = low;
      segment.end = high;
      for (int c = 0; c < 4; ++c) {
        segment.value[c] = low_value[c];
        segment.slope[c] = (high_value[c] - low_value[c]) / (high - low);
        segment.before[c] = total_[c];
      }
      add_integral(segment, high - low, total_);
      segments_.push_back(segment);
    }
    low = high;
    std::copy_n(high_value, 4, low_value);
  };
  for (const GradientStop& stop : fill.stops) {
    double value[4];
    set_channels(stop, value);
    add(stop.offset, value);
  }
  add(1, last_);
}

void Gradient::set_shape(const LinearGradient& shape) {
  const Vec2 axis = shape.end - shape.start;
  const double squared = length_squared(axis);
  if (!(squared > 0)) {
    // SVG paints the whole area with the last stop.
    spread_ = SpreadMethod::pad;
    frame_from_layer_ = {0, 0, 0, 0, 2, 0};
    return;
  }
  const Vec2 unit = axis / squared;
  frame_from_layer_ = {unit.x, 0, unit.y, 0, -dot(unit, shape.start), 0};
}

void Gradient::set_shape(const RadialGradient& shape) {
  is_radial_ = true;
  const double k = 1 / shape.radius;
  Vec2 offset = (shape.center - shape.focus) * k;
  const double distance = length(offset);
  focal_radius_ = shape.focal_radius * k;
  is_cone_ = focal_radius_ > 0 || distance > kOnRim;
  if (!is_cone_ && distance > kLargestFocus) offset = offset * (kLargestFocus / distance);
  center_from_focus_ = offset;
  const Vec2 focus = shape.center * k - offset;
  frame_from_layer_ = {k, 0, 0, k, -focus.x, -focus.y};
}

/// Returns the offset of a radial gradient: p lies on the circle of radius t around focus + t e, so
/// |p - t e| = t with e from focus to centre, in radii. That is (1 - e²) t² + 2 (p·e) t - p² = 0,
/// whose positive root is written so that nothing cancels; its derivative is (p - t e) /
/// sqrt((p·e)² + (1 - e²) p²).
Gradient::Offset Gradient::offset_at(const Affine& frame_from_image, Vec2 point) const {
  const Vec2 p = frame_from_image(point);
  const Affine& m = frame_from_image;
  if (!is_radial_) return {bounded(p.x), 0.5 * length({m.a, m.c})};
  if (is_cone_) return cone_offset(frame_from_image, point);
  const Vec2 e = center_from_focus_;
  const double a = 1 - length_squared(e), b = dot(p, e), q = length_squared(p);
  const double root = std::sqrt(b * b + a * q);
  const double t = b > 0 ? q / (b + root) : (root - b) / a;
  const Vec2 slope = root > 0 ? (p - e * t) / root : Vec2{1, 0};
  const Vec2 in_image{m.a * slope.x + m.b * slope.y, m.c * slope.x + m.d * slope.y};
  return {bounded(t), 0.5 * length(in_image)};
}

/// Returns the offset in the general case: p lies on the circle of radius f + t (1 - f) around t e,
/// f the focal radius. That is a t² + 2 b t - q = 0 with a = (1 - f)² - e², b = p·e + f (1 - f), q
/// = p² - f². The largest root with a radius above 0 counts (HTML, createRadialGradient). Where b²
/// + a q is negative there is none: outside of the cone. Its border is smooth over a pixel, and t
/// varies by the root of the distance from it.
Gradient::Offset Gradient::cone_offset(const Affine& m, Vec2 point) const {
  const auto in_image = [&](Vec2 v) {
    return length({m.a * v.x + m.b * v.y, m.c * v.x + m.d * v.y});
  };
  const Vec2 p = m(point), e = center_from_focus_;
  const double f = focal_radius_, grows = 1 - f;
  const double a = grows * grows - length_squared(e);
  const double b = dot(p, e) + f * grows, q = length_squared(p) - f * f;
  const double under_root = b * b + a * q;
  const double change = in_image(e * (2 * b) + p * (2 * a));  // of under_root, over a pixel
  const double coverage =
      change > 0 ? std::clamp(under_root / change + 0.5, 0.0, 1.0) : (under_root > 0 ? 1.0 : 0.0);
  const double root = std::sqrt(std::max(under_root, 0.0));
  // Both roots, without cancellation: their product is -q / a.
  const double sum = b > 0 ? b + root : b - root;
  double t = sum != 0 ? q / sum : 0, other = a != 0 ? -sum / a : t;
  if (t < other) std::swap(t, other);
  if (!(f + t * grows >= 0)) t = other;
  if (!(f + t * grows >= 0) || coverage == 0) return {kLargestOffset, 0, 0};
  const double slope = root > 0 ? in_image(p - e * t) / root : kLargestOffset;
  const double most = a != 0 ? std::sqrt(change / 2) / std::abs(a) : kLargestOffset;
  return {bounded(t), std::min(slope / 2, most), coverage};
}

void Gradient::evaluate(const Affine& layer_from_image, Vec2 first, int count,
                        const ShaderRow& row) const {
  const Affine frame_from_image = frame_from_layer_ * layer_from_image;
  std::size_t hint = 0;
  for (int i = 0; i < count; ++i) {
    float rgba[4];
    const Offset offset = offset_at(frame_from_image, {first.x + i, first.y});
    hint = sample(offset, hint, rgba);
    rgba[3] *= static_cast<float>(offset.coverage);
    row.set(i, rgba);
  }
}

/// Writes the sample's colour; returns the segment where it lies, the hint for its neighbour.
std::size_t Gradient::sample(Offset offset, std::size_t hint, float (&rgba)[4]) const {
  const double t = folded(offset.t);
  const double half = offset.half_width < kLargestOffset ? offset.half_width : kLargestOffset;
  const double low = t - half, high = t + half;
  if (low >= 0 && high <= 1) {
    hint = segment_at(low, hint);
    const GradientSegment& s = segments_[hint];
    if (high <= s.end) {
      const double along = t - s.begin;
      for (int c = 0; c < 4; ++c) rgba[c] = static_cast<float>(s.value[c] + s.slope[c] * along);
      return hint;
    }
  }
  mean(low, high, rgba);
  return hint;
}

/// Returns the offset with the same colour, from 0 to 1, except for pad.
double Gradient::folded(double t) const {
  if (spread_ == SpreadMethod::pad || (t >= 0 && t < 1)) return t;
  if (spread_ == SpreadMethod::repeat) return t - std::floor(t);
  const double u = t - 2 * std::floor(t / 2);
  return u <= 1 ? u : 2 - u;
}

/// Returns the segment that contains t from 0 to 1; at a border the later one.
std::size_t Gradient::segment_at(double t, std::size_t hint) const {
  if (t >= segments_[hint].begin && t < segments_[hint].end) return hint;
  const auto after =
      std::upper_bound(segments_.begin(), segments_.end(), t,
                       [](double x, const GradientSegment& s) { return x < s.begin; });
  return static_cast<std::size_t>(after - segments_.begin()) - 1;
}

/// Computes the integral from 0 to t, 0 ≤ t ≤ 1.
void Gradient::unit_integral(double t, double (&sum)[4]) const {
  const GradientSegment& s = segments_[segment_at(t, 0)];
  std::copy_n(s.before, 4, sum);
  add_integral(s, t - s.begin, sum);
}

/// Computes the integral from 0 to any t of the gradient as it spreads.
void Gradient::integral(double t, double (&sum)[4]) const {
  const double inside = std::clamp(t, 0.0, 1.0);
  if (spread_ == SpreadMethod::pad) {
    unit_integral(inside, sum);
    add_constant(t < 0 ? first_ : last_, t - inside, sum);
    return;
  }
  const double rounds = std::floor(t);
  const bool backwards = spread_ == SpreadMethod::reflect && std::fmod(rounds, 2) != 0;
  unit_integral(backwards ? 1 - (t - rounds) : t - rounds, sum);
  for (int c = 0; c < 4; ++c) {
    sum[c] = rounds * total_[c] + (backwards ? total_[c] - sum[c] : sum[c]);
  }
}

/// Computes the mean of the premultiplied colour over [low, high], divided by the mean of alpha.
void Gradient::mean(double low, double high, float (&rgba)[4]) const {
  if (spread_ == SpreadMethod::pad && (high <= 0 || low >= 1)) {
    for (int c = 0; c < 4; ++c) rgba[c] = static_cast<float>(high <= 0 ? first_[c] : last_[c]);
    return;
  }
  double from[4], to[4];
  integral(low, from);
  integral(high, to);
  const double alpha = to[3] - from[3];
  for (int c = 0; c < 3; ++c) {
    rgba[c] = alpha > 0 ? static_cast<float>(std::clamp((to[c] - from[c]) / alpha, 0.0, 1.0)) : 0;
  }
  rgba[3] = static_cast<float>(std::clamp(alpha / (high - low), 0.0, 1.0));
}

}  // namespace sfumato::raster
