#include "curves/attributes.hpp"

#include <algorithm>

#include "curves/stop_parameters.hpp"

namespace sfumato::curves {
namespace {

/// A stop list laid along the flattened curve; asked for segments in ascending order.
template <class Value>
class StopSampler {
 public:
  StopSampler(const FlatCurves& flat, const Curve& curve, std::uint32_t curve_index,
              const StopList<Value>& list)
      : flat_(flat), list_(list), parameters_(stop_parameters(curve.control_points, list)) {
    if (list.space == StopSpace::arc_length) measure_stops(curve_index);
  }

  /// Precondition: the list is not empty.
  SegmentValues<Value> values(std::uint32_t segment) {
    const double start = flat_.parameter[segment], end = flat_.parameter[segment + 1];
    // The middle decides between which stops the segment lies: its ends may stand on a step.
    const double middle = 0.5 * (start + end);
    while (next_ < parameters_.size() && parameters_[next_] <= middle) ++next_;
    if (next_ == 0) return {list_.stops.front().value, list_.stops.front().value};
    if (next_ == parameters_.size()) return {list_.stops.back().value, list_.stops.back().value};
    if (list_.space == StopSpace::parameter) return between(parameters_, start, end);
    return between(lengths_, flat_.arc_length[segment], flat_.arc_length[segment + 1]);
  }

 private:
  SegmentValues<Value> between(const std::vector<double>& position, double start, double end) {
    const double low = position[next_ - 1], high = position[next_];
    const auto at = [&](double x) {
      const double fraction = high > low ? std::clamp((x - low) / (high - low), 0.0, 1.0) : 0.0;
      return lerp(list_.stops[next_ - 1].value, list_.stops[next_].value,
                  static_cast<float>(fraction));
    };
    return {at(start), at(end)};
  }

  /// Lengths along the polyline at the stops, which are vertices of it.
  void measure_stops(std::uint32_t curve_index) {
    const auto begin = flat_.parameter.begin() + flat_.curve_begin[curve_index];
    const auto end = flat_.parameter.begin() + flat_.curve_begin[curve_index + 1];
    for (double parameter : parameters_) {
      auto vertex = std::lower_bound(begin, end, parameter);
      if (vertex == end) --vertex;
      lengths_.push_back(
          flat_.arc_length[static_cast<std::size_t>(vertex - flat_.parameter.begin())]);
    }
  }

  const FlatCurves& flat_;
  const StopList<Value>& list_;
  std::vector<double> parameters_;
  std::vector<double> lengths_;
  std::size_t next_ = 0;
};

void sample_side(const FlatCurves& flat, const Curve& curve, std::uint32_t index,
                 const SideShader<Rgb>& side, std::vector<SegmentColor>& out) {
  StopSampler<Rgb> sampler(flat, curve, index, side.stops);
  for (std::uint32_t v = flat.curve_begin[index]; v + 1 < flat.curve_begin[index + 1]; ++v) {
    out[v].kind = side.kind;
    out[v].shader = side.shader;
    if (side.kind == ShaderKind::curve_domain) out[v].color = sampler.values(v);
  }
}

}  // namespace

SegmentAttributes sample_colors(const FlatCurves& flat, std::span<const Curve> curves) {
  SegmentAttributes attributes;
  attributes.left.resize(flat.vertex.size());
  attributes.right.resize(flat.vertex.size());
  attributes.weight.resize(flat.vertex.size(), 1.0f);
  attributes.curve = flat.vertex_curve;
  attributes.vertex = flat.vertex;
  for (std::uint32_t i = 0; i < flat.curve_count(); ++i) {
    sample_side(flat, curves[i], i, curves[i].left.color, attributes.left);
    sample_side(flat, curves[i], i, curves[i].right.color, attributes.right);
    std::fill(attributes.weight.begin() + flat.curve_begin[i],
              attributes.weight.begin() + flat.curve_begin[i + 1],
              static_cast<float>(curves[i].weight));
  }
  return attributes;
}

}  // namespace sfumato::curves
