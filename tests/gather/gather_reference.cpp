#include "gather/gather_reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gather/reference_weights.hpp"
#include "gather/scene/scene.hpp"

namespace sfumato::gather {
namespace {

using mesh::TriangleMesh;

/// The number of parts of an edge whose radius varies.
constexpr int kBlurParts = 512;

/// A window of directions through a half-edge: from `right` to `left`, counter-clockwise.
struct ReferenceWindow {
  std::uint32_t half_edge;
  Vec2 right;
  Vec2 left;
};

class ReferenceGather {
 public:
  ReferenceGather(const TriangleMesh& mesh, const curves::SegmentAttributes& attributes, Vec2 p)
      : mesh_(mesh), attributes_(attributes), p_(p) {
    sums_.shader_weight.resize(attributes.shader.size());
  }

  ReferenceSums run(std::uint32_t triangle, std::span<const FreeEnd> ends) {
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
      waiting_.push_back({h, seen(mesh_.origin(h)), seen(mesh_.target(h))});
    }
    while (!waiting_.empty()) {
      const ReferenceWindow window = waiting_.back();
      waiting_.pop_back();
      follow(window);
    }
    for (const FreeEnd& end : ends) add_end(end);
    return sums_;
  }

 private:
  /// Adds the term of docs/mathematics.md, by the angle itself.
  void add_end(const FreeEnd& end) {
    const Vec2 d = p_ - end.position;
    const double r = length(d), x = r * r / (end.reach * end.reach);
    if (!(r > 0 && x < 1)) return;
    const double weight = 0.8 * end.weight / (r * r) * (1 - x) * (1 - x) / (1 + 25 * x);
    const double off_line = std::atan2(cross(end.direction, d), dot(end.direction, d));
    const double angle = std::remainder(off_line - std::asin(end.bend * r), 2 * std::numbers::pi);
    const double radius = angle > 0 ? end.blur_positive : end.blur_negative;
    const double front = front_share(r * std::fabs(std::sin(angle)), radius);
    const double share = 0.5 + 0.5 * std::sin(angle / 2) * (2 * front - 1);
    sums_.weight += weight;
    for (std::size_t c = 0; c < 3; ++c) {
      sums_.color[c] += weight * std::lerp(double{end.negative.channel[c]},
                                           double{end.positive.channel[c]}, share);
    }
  }

  Vec2 seen(std::uint32_t vertex) const { return mesh_.vertex_position[vertex] - p_; }

  void follow(const ReferenceWindow& window) {
    if (mesh_.half_edge_constraint[window.half_edge] != mesh::kNone) {
      const Facing facing = facing_side(mesh_, attributes_, window.half_edge);
      if (facing.kind == ShaderKind::barrier) return;
      if (facing.kind != ShaderKind::open) return integrate(window, facing);
    }
    const std::int32_t twin = mesh_.half_edge_twin[window.half_edge];
    if (twin != mesh::kNone) pass(window, static_cast<std::uint32_t>(twin));
  }

  void pass(const ReferenceWindow& window, std::uint32_t twin) {
    const Vec2 apex = seen(mesh_.apex(twin));
    const bool reaches_right = cross(window.right, apex) > 0;
    const bool reaches_left = cross(apex, window.left) > 0;
    if (reaches_right) {
      waiting_.push_back({next_half_edge(twin), window.right, reaches_left ? apex : window.left});
    }
    if (reaches_left) {
      waiting_.push_back(
          {previous_half_edge(twin), reaches_right ? apex : window.right, window.left});
    }
  }

  void integrate(const ReferenceWindow& window, const Facing& facing) {
    const Vec2 a = seen(mesh_.origin(window.half_edge));
    const Vec2 b = seen(mesh_.target(window.half_edge));
    const double t1 = window.right == a ? 0 : cut(a, b, window.right);
    const double t2 = window.left == b ? 1 : cut(a, b, window.left);
    const Facing back = back_side(mesh_, attributes_, window.half_edge);
    const bool varies = back.has_value() && facing.blur_from != facing.blur_to;
    if (!varies) return integrate_part({a, b, t1, t2}, facing, back);
    // In parts of one angle each, where the radius hardly varies.
    const Vec2 right = lerp(a, b, t1), left = lerp(a, b, t2);
    const double angle = std::atan2(cross(right, left), dot(right, left));
    double from = t1;
    for (int i = 1; i <= kBlurParts; ++i) {
      const double turn = angle * i / kBlurParts;
      const Vec2 ray = std::cos(turn) * right + std::sin(turn) * Vec2{-right.y, right.x};
      const double to = i == kBlurParts ? t2 : std::clamp(cut(a, b, ray), from, t2);
      integrate_part({a, b, from, to}, facing, back);
      from = to;
    }
  }

  /// The visible part of the edge from a to b.
  struct Part {
    Vec2 a, b;
    double from, to;  ///< fractions of the way
  };

  void integrate_part(const Part& part, const Facing& facing, const Facing& back) {
    const auto& [a, b, from, to] = part;
    const ReferenceWeights ends = reference_weights(lerp(a, b, from), lerp(a, b, to));
    const double weight = (ends.right + ends.left) * facing.weight;
    const double moment = (ends.right * from + ends.left * to) * facing.weight;
    sums_.weight += weight;
    if (!(weight > 0)) return;
    const double distance = cross(a, b) / length(b - a);
    const double radius = facing.blur_from + moment / weight * (facing.blur_to - facing.blur_from);
    const double front = back.has_value() ? front_share(distance, radius) : 1;
    add_side(facing, front * weight, front * moment);
    if (front < 1) add_side(back, (1 - front) * weight, (1 - front) * moment);
  }

  /// Returns β of eq. 8, written a second time to test curves::front_share.
  static double front_share(double distance, double radius) {
    if (!(radius > distance)) return 1;
    const double x = std::clamp((distance + radius) / (2 * radius), 0.0, 1.0);
    return x * x * (3 - 2 * x);
  }

  void add_side(const Facing& side, double weight, double moment) {
    if (side.kind == ShaderKind::image_domain) {
      sums_.shader_weight[side.shader] += weight;
      return;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const double from = side.from.channel[c], to = side.to.channel[c];
      sums_.color[c] += weight * from + moment * (to - from);
    }
  }

  /// Returns where the ray cuts the edge, as a fraction from a to b.
  static double cut(Vec2 a, Vec2 b, Vec2 ray) {
    const double along = cross(ray, b - a);
    if (along == 0) return 0;
    return std::clamp(-cross(ray, a) / along, 0.0, 1.0);
  }

  const TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  Vec2 p_;
  std::vector<ReferenceWindow> waiting_;
  ReferenceSums sums_;
};

}  // namespace

std::array<double, 3> ReferenceSums::value() const {
  if (!(weight > 0)) return {};
  return {color[0] / weight, color[1] / weight, color[2] / weight};
}

std::vector<double> ReferenceSums::shares() const {
  std::vector<double> shares = shader_weight;
  for (double& share : shares) share = weight > 0 ? share / weight : 0;
  return shares;
}

ReferenceSums gather_reference(const TriangleMesh& mesh,
                               const curves::SegmentAttributes& attributes, Vec2 p,
                               std::uint32_t triangle, std::span<const FreeEnd> ends) {
  return ReferenceGather(mesh, attributes, p).run(triangle, ends);
}

std::int32_t find_triangle(const TriangleMesh& mesh, Vec2 p) {
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    bool inside = true;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const Vec2 a = mesh.vertex_position[mesh.origin(h)];
      const Vec2 b = mesh.vertex_position[mesh.target(h)];
      inside = inside && cross(b - a, p - a) >= 0;
    }
    if (inside) return static_cast<std::int32_t>(t);
  }
  return mesh::kNone;
}

}  // namespace sfumato::gather
