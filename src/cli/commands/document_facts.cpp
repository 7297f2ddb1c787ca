#include "cli/commands/document_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "curves/attributes.hpp"
#include "curves/bezier.hpp"

namespace sfumato::cli {
namespace {

/// Returns the parameters where the derivative of one coordinate of a cubic, given by its control
/// values, is 0. A missing parameter is 2, which lies outside [0, 1], so the caller's range check
/// drops it.
std::array<double, 2> still_parameters(double p0, double p1, double p2, double p3) {
  const double a = p3 - 3 * p2 + 3 * p1 - p0;
  const double half_b = p2 - 2 * p1 + p0;
  const double c = p1 - p0;
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return {2, 2};
  // The stable form subtracts no nearly equal numbers and is correct if a is 0.
  const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  return {a != 0 ? q / a : 2, q != 0 ? c / q : 2};
}

bool leaves(const curves::Cubic& cubic, const Box& box) {
  const auto inside = [&box](Vec2 p) { return box.contains(p); };
  if (std::all_of(cubic.begin(), cubic.end(), inside)) return false;  // so is its convex hull
  if (!inside(cubic.front()) || !inside(cubic.back())) return true;
  const auto x = still_parameters(cubic[0].x, cubic[1].x, cubic[2].x, cubic[3].x);
  const auto y = still_parameters(cubic[0].y, cubic[1].y, cubic[2].y, cubic[3].y);
  for (const double t : {x[0], x[1], y[0], y[1]}) {
    if (t > 0 && t < 1 && !inside(curves::point_at(cubic, t))) return true;
  }
  return false;
}

bool has_barrier(const Side& side) {
  return side.color.kind == ShaderKind::barrier || side.opacity.kind == ShaderKind::barrier;
}

void count_kind(const Curve& curve, DocumentFacts& facts) {
  const bool color = curves::has_value(curve.left.color) || curves::has_value(curve.right.color);
  const bool opacity =
      curves::has_value(curve.left.opacity) || curves::has_value(curve.right.opacity);
  if (color || opacity) {
    ++(color && opacity ? facts.both_curves : color ? facts.color_curves : facts.opacity_curves);
  } else {
    ++(has_barrier(curve.left) || has_barrier(curve.right) ? facts.barrier_curves
                                                           : facts.bare_curves);
  }
}

void count_points(const std::vector<Vec2>& points, DocumentFacts& facts) {
  facts.bezier_pieces += points.empty() ? 0 : (points.size() - 1) / 3;
  facts.control_points += points.size();
}

void count_curve(const Curve& curve, DocumentFacts& facts) {
  const std::vector<Vec2>& points = curve.control_points;
  ++facts.curves;
  facts.closed_curves += !points.empty() && points.front() == points.back();
  count_kind(curve, facts);
  count_points(points, facts);
  for (const Side* side : {&curve.left, &curve.right}) {
    facts.color_stops += side->color.stops.stops.size();
    facts.opacity_stops += side->opacity.stops.stops.size();
  }
  facts.blurred_curves += curves::is_blurred(curve.left) || curves::is_blurred(curve.right);
  facts.weighted_curves += curve.weight != 1;
}

/// Counts the items of the stack, and finds where each layer is painted first.
class StackCounter {
 public:
  StackCounter(DocumentFacts& facts, std::vector<const LayerInstance*>& first)
      : facts_(facts), first_(first) {}

  void operator()(const LayerInstance& instance) const {
    ++facts_.instances;
    const LayerInstance*& first = first_[instance.layer];
    if (!first) first = &instance;
  }
  void operator()(const LocalStroke& stroke) const {
    ++facts_.local_curves;
    count_points(stroke.curve.control_points, facts_);
    facts_.color_stops +=
        stroke.curve.left_color.stops.size() + stroke.curve.right_color.stops.size();
  }
  void operator()(const GroupBegin&) const { ++facts_.groups; }
  void operator()(const GroupEnd&) const {}

 private:
  DocumentFacts& facts_;
  std::vector<const LayerInstance*>& first_;
};

void count_shader(const Shader& shader, DocumentFacts& facts) {
  if (const auto* texture = std::get_if<Texture>(&shader.paint)) {
    facts.textures.push_back(texture);
    return;
  }
  const auto& fill = std::get<GradientFill>(shader.paint);
  ++(std::holds_alternative<LinearGradient>(fill.shape) ? facts.linear_gradients
                                                        : facts.radial_gradients);
}

}  // namespace

bool leaves(const Curve& curve, const Box& box) {
  for (std::size_t i = 0; i < curve.piece_count(); ++i) {
    if (leaves(curves::piece(curve.control_points, i), box)) return true;
  }
  return false;
}

DocumentFacts count_facts(const Document& document) {
  DocumentFacts facts;
  facts.layers = document.layers.size();
  std::vector<const LayerInstance*> first(document.layers.size(), nullptr);
  for (const StackItem& item : document.stack) std::visit(StackCounter(facts, first), item);
  for (std::size_t i = 0; i < document.layers.size(); ++i) {
    for (const Curve& curve : document.layers[i].curves) {
      count_curve(curve, facts);
      if (!first[i]) continue;
      Curve painted;
      for (const Vec2 p : curve.control_points) {
        painted.control_points.push_back(first[i]->artboard_from_layer(p));
      }
      facts.leaving_curves += leaves(painted, document.artboard);
    }
  }
  for (const Shader& shader : document.shaders) count_shader(shader, facts);
  return facts;
}

}  // namespace sfumato::cli
