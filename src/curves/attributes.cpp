#include "curves/attributes.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "curves/stop_parameters.hpp"

namespace sfumato::curves {
namespace {

/// The place of a segment among the stops of a list: at fractions of the way from one to the next,
/// which are 0 before the first stop and behind the last.
struct StopInterval {
  std::size_t index = 0;  ///< index of the first of the two
  float start = 0;
  float end = 0;
};

/// A stop list laid along the flattened curve, queried for segments in ascending order.
template <class Value>
class StopSampler {
 public:
  StopSampler(const FlatCurves& flat, const Curve& curve, std::uint32_t curve_index,
              const StopList<Value>& list)
      : flat_(flat), list_(list), parameters_(stop_parameters(curve.control_points, list)) {
    if (list.space == StopSpace::arc_length) measure_stops(curve_index);
  }

  /// Precondition of both: the list is not empty.
  StopInterval interval(std::uint32_t segment) {
    const double start = flat_.parameter[segment], end = flat_.parameter[segment + 1];
    // The middle decides which stops the segment lies between: its ends may stand on a step.
    const double middle = 0.5 * (start + end);
    while (next_ < parameters_.size() && parameters_[next_] <= middle) ++next_;
    if (next_ == 0) return {};
    if (next_ == parameters_.size()) return {.index = next_ - 1};
    if (list_.space == StopSpace::parameter) return between(parameters_, start, end);
    return between(lengths_, flat_.arc_length[segment], flat_.arc_length[segment + 1]);
  }

  SegmentValues<Value> values(std::uint32_t segment) {
    const auto [index, start, end] = interval(segment);
    const Value& from = list_.stops[index].value;
    if (start == 0 && end == 0) return {from, from};
    const Value& to = list_.stops[index + 1].value;
    return {lerp(from, to, start), lerp(from, to, end)};
  }

 private:
  StopInterval between(const std::vector<double>& position, double start, double end) const {
    const double low = position[next_ - 1], high = position[next_];
    const auto at = [&](double x) {
      return high > low ? static_cast<float>(std::clamp((x - low) / (high - low), 0.0, 1.0)) : 0.0f;
    };
    return {next_ - 1, at(start), at(end)};
  }

  /// Measures lengths along the polyline at the stops, which are vertices of it.
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

/// Gives a side the values of its stops on a segment.
template <class Value>
struct GiveValues {
  SegmentValues<FieldValue> operator()(StopSampler<Value>& stops, std::uint32_t segment) const {
    const SegmentValues<Value> values = stops.values(segment);
    return {FieldValue(values.start), FieldValue(values.end)};
  }
  SegmentValues<FieldValue> without_stops(std::uint32_t) const { return {}; }
  void end_side(const StopList<Value>&) {}
};

/// Gives a side the place of a segment among its stops: see sample_stop_places().
template <class Value>
struct GivePlaces {
  std::span<const std::uint32_t> vertex_curve;
  std::size_t column = 0;  ///< of the side's first stop

  SegmentValues<FieldValue> operator()(StopSampler<Value>& stops, std::uint32_t segment) const {
    const StopInterval interval = stops.interval(segment);
    const auto place = [&](float fraction) {
      return FieldValue(Rgb{fraction, static_cast<float>(column + interval.index),
                            static_cast<float>(vertex_curve[segment])});
    };
    return {place(interval.start), place(interval.end)};
  }
  SegmentValues<FieldValue> without_stops(std::uint32_t segment) const {
    const FieldValue place(Rgb{0, 0, static_cast<float>(vertex_curve[segment])});
    return {place, place};
  }
  void end_side(const StopList<Value>& list) { column += list.stops.size(); }
};

const SideShader<Rgb>& color_of(const Side& side) {
  return side.color;
}
const SideShader<float>& opacity_of(const Side& side) {
  return side.opacity;
}

/// Samples one attribute, which `shader_of` finds on a side.
template <class Value, class Give = GiveValues<Value>>
class AttributeSampler {
 public:
  using ShaderOf = const SideShader<Value>&(const Side& side);

  AttributeSampler(const FlatCurves& flat, std::span<const Curve> curves, ShaderOf* shader_of,
                   InterpolationSpace space, Give give = {})
      : flat_(flat), curves_(curves), shader_of_(shader_of), give_(give) {
    attributes_.space = space;
  }

  Result<SegmentAttributes> run(const Context& context, TableMemory& memory) {
    SegmentAttributes& out = attributes_;
    const std::size_t count = flat_.vertex.size();
    SFUMATO_TRY(memory.resize_all(context, count, out.left, out.right));
    SFUMATO_TRY(memory.resize(context, out.weight, count, 1.0f));
    SFUMATO_TRY(memory.append(context, flat_.vertex_curve, out.curve));
    SFUMATO_TRY(memory.append(context, flat_.vertex, out.vertex));
    for (std::uint32_t i = 0; i < flat_.curve_count(); ++i) {
      sample_side(i, curves_[i].left, attributes_.left);
      sample_side(i, curves_[i].right, attributes_.right);
      std::fill(attributes_.weight.begin() + flat_.curve_begin[i],
                attributes_.weight.begin() + flat_.curve_begin[i + 1],
                static_cast<float>(curves_[i].weight));
    }
    return std::move(attributes_);
  }

 private:
  void sample_side(std::uint32_t index, const Side& side, std::vector<SegmentSide>& out) {
    const SideShader<Value>& shader = shader_of_(side);
    if (shader.kind == ShaderKind::open) return;
    const std::uint32_t slot = shader.kind == ShaderKind::image_domain ? slot_of(shader.shader) : 0;
    const StopList<Value> stops = in_space(shader.stops, attributes_.space);
    StopSampler<Value> values(flat_, curves_[index], index, stops);
    StopSampler<float> radii(flat_, curves_[index], index, side.blur_radius);
    for (std::uint32_t v = flat_.curve_begin[index]; v + 1 < flat_.curve_begin[index + 1]; ++v) {
      out[v].kind = shader.kind;
      out[v].shader = slot;
      out[v].value =
          shader.kind == ShaderKind::curve_domain ? give_(values, v) : give_.without_stops(v);
      if (!side.blur_radius.empty()) out[v].blur_radius = radii.values(v);
    }
    if (shader.kind == ShaderKind::curve_domain) give_.end_side(stops);
  }

  std::uint32_t slot_of(std::uint32_t shader) {
    auto& slots = attributes_.shader;
    const auto known = std::find(slots.begin(), slots.end(), shader);
    if (known != slots.end()) return static_cast<std::uint32_t>(known - slots.begin());
    slots.push_back(shader);
    return static_cast<std::uint32_t>(slots.size() - 1);
  }

  const FlatCurves& flat_;
  std::span<const Curve> curves_;
  ShaderOf* shader_of_;
  Give give_;
  SegmentAttributes attributes_;
};

}  // namespace

Result<SegmentAttributes> sample_colors(const Context& context, const FlatCurves& flat,
                                        std::span<const Curve> curves, InterpolationSpace space,
                                        TableMemory& memory) {
  return AttributeSampler<Rgb>(flat, curves, color_of, space).run(context, memory);
}

Result<SegmentAttributes> sample_opacities(const Context& context, const FlatCurves& flat,
                                           std::span<const Curve> curves, TableMemory& memory) {
  Result<SegmentAttributes> attributes =
      AttributeSampler<float>(flat, curves, opacity_of, InterpolationSpace::srgb)
          .run(context, memory);
  if (attributes) attributes->base_channels = 1;
  return attributes;
}

std::size_t stop_count(std::span<const Curve> curves, StopAttribute attribute) {
  const auto of_side = [&](const Side& side) {
    const auto of_shader = [](const auto& shader) {
      return shader.kind == ShaderKind::curve_domain ? shader.stops.stops.size() : std::size_t{0};
    };
    return attribute == StopAttribute::color ? of_shader(side.color) : of_shader(side.opacity);
  };
  std::size_t count = 0;
  for (const Curve& curve : curves) count += of_side(curve.left) + of_side(curve.right);
  return count;
}

Result<SegmentAttributes> sample_stop_places(const Context& context, const FlatCurves& flat,
                                             std::span<const Curve> curves, StopAttribute attribute,
                                             TableMemory& memory) {
  if (stop_count(curves, attribute) > kMostStopPlaces || curves.size() > kMostStopPlaces) {
    return make_limit_error(&Limits::stops, "places are given for at most " +
                                                std::to_string(kMostStopPlaces) + " stops");
  }
  const auto sample = [&]<class Value>(const SideShader<Value>& (*shader_of)(const Side&)) {
    return AttributeSampler<Value, GivePlaces<Value>>(flat, curves, shader_of,
                                                      InterpolationSpace::srgb, {flat.vertex_curve})
        .run(context, memory);
  };
  return attribute == StopAttribute::color ? sample(color_of) : sample(opacity_of);
}

bool is_blurred(const Side& side) {
  return std::ranges::any_of(side.blur_radius.stops,
                             [](const Stop<float>& stop) { return stop.value > 0; });
}

bool bears_opacity(const Curve& curve) {
  return curve.left.opacity.kind != ShaderKind::open ||
         curve.right.opacity.kind != ShaderKind::open;
}

bool opacity_goes_with_color(std::span<const Curve> curves) {
  return std::ranges::all_of(curves, [](const Curve& curve) {
    return std::ranges::all_of(std::array{&curve.left, &curve.right}, [](const Side* side) {
      return side->color.kind == side->opacity.kind && side->color.kind != ShaderKind::image_domain;
    });
  });
}

Result<SegmentAttributes> sample_colors_and_opacities(const Context& context,
                                                      const FlatCurves& flat,
                                                      std::span<const Curve> curves,
                                                      InterpolationSpace space,
                                                      TableMemory& memory) {
  SFUMATO_TRY_ASSIGN(auto&& colors, sample_colors(context, flat, curves, space, memory));
  SegmentAttributes& both = colors;
  TableMemory scratch("attributes");
  SFUMATO_TRY_ASSIGN(const SegmentAttributes& sampled,
                     sample_opacities(context, flat, curves, scratch));
  const SegmentAttributes& opacities = sampled;
  const auto join = [](std::vector<SegmentSide>& sides, const std::vector<SegmentSide>& from) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      sides[i].value.start.channel[3] = from[i].value.start.channel[0];
      sides[i].value.end.channel[3] = from[i].value.end.channel[0];
    }
  };
  join(both.left, opacities.left);
  join(both.right, opacities.right);
  both.base_channels = 4;
  return std::move(colors);
}

Status replace_tail(const Context& context, std::size_t first, std::uint32_t first_curve,
                    const SegmentAttributes& tail, TableMemory& memory,
                    SegmentAttributes& attributes) {
  Status status;
  const auto replace = [&](const auto& from, auto& to) {
    to.resize(first);
    if (status) status = memory.append(context, from, to);
  };
  replace(tail.left, attributes.left);
  replace(tail.right, attributes.right);
  replace(tail.weight, attributes.weight);
  replace(tail.vertex, attributes.vertex);
  replace(tail.curve, attributes.curve);
  if (!status) return status;
  for (std::size_t s = first; s < attributes.curve.size(); ++s) attributes.curve[s] += first_curve;
  return status;
}

void remove_blur(SegmentAttributes& attributes) {
  for (auto* sides : {&attributes.left, &attributes.right}) {
    for (SegmentSide& side : *sides) side.blur_radius = {};
  }
}

void set_fine_blur(SegmentAttributes& attributes, double radius) {
  // Where a radius grows beyond it, the segment ends there, apart from rounding.
  const double most = radius * (1 + 1e-4);
  for (auto* sides : {&attributes.left, &attributes.right}) {
    for (SegmentSide& side : *sides) {
      if (std::max(side.blur_radius.start, side.blur_radius.end) > most) continue;
      side.fine_radius = std::exchange(side.blur_radius, {});
    }
  }
}

}  // namespace sfumato::curves
