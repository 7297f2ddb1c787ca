#pragma once

#include <algorithm>
#include <cmath>

#include "gather/reference_weights.hpp"
#include "gather/rows/rows.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// The part of an edge that a point sees, between two fractions of the way from a to b, which are
/// relative to the point.
struct SeenPart {
  Vec2 a, b;
  double from, to;

  double distance() const { return cross(a, b) / length(b - a); }
};

/// Weight of a part, with k = 1, and the weight's mean place on the edge, times the weight.
struct PartMoment {
  double weight;
  double moment;
};

inline PartMoment part_moment(const SeenPart& part) {
  const ReferenceWeights ends =
      reference_weights(lerp(part.a, part.b, part.from), lerp(part.a, part.b, part.to));
  return {ends.right + ends.left, ends.right * part.from + ends.left * part.to};
}

/// Gauss's nodes in [0, 1].
struct RowNode {
  double place, weight;
};
inline constexpr RowNode kRowNode[] = {
    {0.0052995325041750307, 0.013576229705877029}, {0.0277124884633837, 0.031126761969323888},
    {0.067184398806084122, 0.047579255841246448},  {0.1222977958224985, 0.062314485627766973},
    {0.19106187779867811, 0.07479799440828841},    {0.27099161117138632, 0.084578259697501282},
    {0.35919822461037054, 0.091301707522461806},   {0.45249374508118129, 0.094725305227534237},
    {0.54750625491881877, 0.094725305227534237},   {0.64080177538962946, 0.091301707522461806},
    {0.72900838882861363, 0.084578259697501282},   {0.80893812220132189, 0.07479799440828841},
    {0.87770220417750155, 0.062314485627766973},   {0.93281560119391593, 0.047579255841246448},
    {0.9722875115366163, 0.031126761969323888},    {0.99470046749582497, 0.013576229705877029}};

/// Returns whether one term is enough for a source: its radius is the same everywhere, or so small
/// that the side behind gives nothing at that distance.
inline bool is_one_term(const RowSource& source, double distance) {
  return source.blur_from == source.blur_to || !source.back.has_value ||
         std::max(source.blur_from, source.blur_to) <= distance;
}

/// Splits a part of a source whose radius varies into terms of about one radius each. A sharp part
/// is one term; where the radius is above the distance, the terms are the nodes of the quadrature
/// of back_means() in kernels/blur_kernel.hpp, with more of them.
///
/// emit   called with PartMoment
template <class Emit>
void split_by_radius(const RowSource& source, const SeenPart& part, Emit emit) {
  const double radius = source.blur_from, change = double{source.blur_to} - radius;
  const double reached = std::clamp((part.distance() - radius) / change, part.from, part.to);
  const bool grows = change > 0;  // from a to b
  const SeenPart sharp{part.a, part.b, grows ? part.from : reached, grows ? reached : part.to};
  const SeenPart soft{part.a, part.b, grows ? reached : part.from, grows ? part.to : reached};
  if (sharp.from < sharp.to) emit(part_moment(sharp));
  const PartMoment all = part_moment(soft);
  if (!(all.weight > 0)) return;
  const Vec2 near = lerp(part.a, part.b, grows ? soft.from : soft.to);
  const Vec2 far = lerp(part.a, part.b, grows ? soft.to : soft.from);
  const double near_length = length(near), far_length = length(far);
  const double quarter = 0.25 * std::atan2(std::fabs(cross(near, far)), dot(near, far));
  const double k = std::tan(quarter) * std::tan(quarter);
  PartMoment node[std::size(kRowNode)];
  double sum = 0;
  for (std::size_t i = 0; i < std::size(kRowNode); ++i) {
    const double tau = 2 * kRowNode[i].place * kRowNode[i].place - 1;
    const double a = far_length * (1 - tau) * (1 + k * tau);
    const double b = near_length * (1 + tau) * (1 - k * tau);
    const double stretch = 1 + k * tau * tau;
    const double weight =
        kRowNode[i].weight * kRowNode[i].place * (a + b) * (a + b) / (stretch * stretch * stretch);
    const double along = b / (a + b);  // from the near end
    const double place =
        grows ? std::lerp(soft.from, soft.to, along) : std::lerp(soft.to, soft.from, along);
    node[i] = {weight, weight * place};
    sum += weight;
  }
  const double scale = all.weight / sum;
  for (const PartMoment& n : node) emit(PartMoment{scale * n.weight, scale * n.moment});
}

}  // namespace sfumato::gather
