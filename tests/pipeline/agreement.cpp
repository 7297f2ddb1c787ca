#include "pipeline/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "curves/bezier.hpp"

namespace sfumato::test {
namespace {

constexpr double kNearPx = 1.5;     ///< limit of the effects of antialiasing, flattening and weld
constexpr double kNearPointPx = 4;  ///< around ends and joints
constexpr float kSoftRadiusPx = 4;  ///< curves with at least this radius everywhere are compared
constexpr int kTolerance = 3;

class Mask {
 public:
  Mask(int width, int height)
      : width_(width),
        height_(height),
        is_set_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  void add_disc(Vec2 center, double radius) {
    const auto first = [&](double x) { return std::max(0.0, std::floor(x - radius)); };
    const auto last = [&](double x, int end) { return std::min(end - 1.0, std::ceil(x + radius)); };
    for (double y = first(center.y); y <= last(center.y, height_); ++y) {
      for (double x = first(center.x); x <= last(center.x, width_); ++x) {
        if (length(Vec2{x + 0.5, y + 0.5} - center) > radius) continue;
        is_set_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x)] = 1;
      }
    }
  }

  std::vector<std::uint8_t> take() { return std::move(is_set_); }

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> is_set_;
};

double smallest_scale(const Affine& m) {
  const double squares = m.a * m.a + m.b * m.b + m.c * m.c + m.d * m.d;
  const double rest =
      std::sqrt(std::max(0.0, squares * squares / 4 - m.determinant() * m.determinant()));
  return std::sqrt(std::max(0.0, squares / 2 - rest));
}

bool has_value(ShaderKind kind) {
  return kind == ShaderKind::curve_domain || kind == ShaderKind::image_domain;
}

/// Returns whether an attribute with these kinds of sides is continuous across a blurred curve.
bool is_mixed(ShaderKind left, ShaderKind right) {
  const bool is_absent = left == ShaderKind::open && right == ShaderKind::open;
  return is_absent || (has_value(left) && has_value(right));
}

bool is_soft(const Side& side, double scale) {
  const auto& stops = side.blur_radius.stops;
  return !stops.empty() && std::ranges::all_of(stops, [&](const Stop<float>& stop) {
    return stop.value * scale >= kSoftRadiusPx;
  });
}

void add_curve(const Curve& curve, const Affine& image_from_layer, Mask& mask) {
  const double scale = smallest_scale(image_from_layer);
  const bool is_sharp = !is_soft(curve.left, scale) || !is_soft(curve.right, scale) ||
                        !is_mixed(curve.left.color.kind, curve.right.color.kind) ||
                        !is_mixed(curve.left.opacity.kind, curve.right.opacity.kind);
  for (std::size_t i = 0; i < curve.piece_count(); ++i) {
    curves::Cubic cubic = curves::piece(curve.control_points, i);
    double reach = 0;
    for (Vec2& p : cubic) {
      p = image_from_layer(p);
      reach += length(p - cubic[0]);
    }
    mask.add_disc(cubic[0], kNearPointPx);
    mask.add_disc(cubic[3], kNearPointPx);
    const int steps = static_cast<int>(std::min(4 * reach, 1e5)) + 1;
    for (int step = 0; is_sharp && step <= steps; ++step) {
      mask.add_disc(curves::point_at(cubic, 1.0 * step / steps), kNearPx);
    }
  }
}

}  // namespace

std::vector<std::uint8_t> sharp_pixels(const Document& document, int width, int height) {
  Mask mask(width, height);
  const Vec2 origin = document.artboard.min;
  const Affine image_from_artboard{1, 0, 0, 1, -origin.x, -origin.y};
  for (const StackItem& item : document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance) continue;
    for (const Curve& curve : document.layers[instance->layer].curves) {
      add_curve(curve, image_from_artboard * instance->artboard_from_layer, mask);
    }
  }
  return mask.take();
}

Agreement compare_pictures(const Document& document, const Image& a, const Image& b) {
  const std::vector<std::uint8_t> is_sharp = sharp_pixels(document, a.width, a.height);
  Agreement agreement;
  std::vector<int> misses;
  for (std::size_t i = 0; i < is_sharp.size(); ++i) {
    if (is_sharp[i]) continue;
    int miss = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      miss = std::max(miss, std::abs(int{a.bytes[c]} - int{b.bytes[c]}));
    }
    misses.push_back(miss);
    if (miss <= agreement.worst) continue;
    agreement.worst = miss;
    agreement.worst_x = static_cast<int>(i) % a.width;
    agreement.worst_y = static_cast<int>(i) / a.width;
  }
  if (misses.empty()) return agreement;
  std::ranges::sort(misses);
  agreement.compared = static_cast<int>(misses.size());
  agreement.differing =
      static_cast<int>(std::ranges::count_if(misses, [](int miss) { return miss > kTolerance; }));
  agreement.percentile_99 = misses[misses.size() * 99 / 100];
  return agreement;
}

}  // namespace sfumato::test
