#include "curves/response.hpp"

#include <vector>

#include "base/try.hpp"

namespace sfumato::curves {
namespace {

const Side& side_of(std::span<const Curve> curves, const StopPlace& place) {
  const Curve& curve = curves[place.curve];
  return place.side == CurveSide::left ? curve.left : curve.right;
}

template <class Value>
bool has_stop(const SideShader<Value>& shader, const StopPlace& place) {
  return shader.kind == ShaderKind::curve_domain &&
         place.index.value_or(0) < shader.stops.stops.size();
}

/// Returns 1 at the stop, or at all of them, and 0 at the others.
template <class Value>
ScalarStops weights_of(const StopList<Value>& list, const StopPlace& place) {
  ScalarStops weights{list.space, {}};
  weights.stops.reserve(list.stops.size());
  for (std::size_t i = 0; i < list.stops.size(); ++i) {
    const bool is_meant = !place.index || *place.index == i;
    weights.stops.push_back({list.stops[i].offset, is_meant ? 1.0f : 0.0f});
  }
  return weights;
}

/// Returns the curve with only these weights as the opacities of the side.
Curve weighted(std::span<const Curve> curves, const StopPlace& place) {
  const Side& side = side_of(curves, place);
  Curve curve;
  curve.control_points = curves[place.curve].control_points;
  SideShader<float>& opacity = (place.side == CurveSide::left ? curve.left : curve.right).opacity;
  opacity.kind = ShaderKind::curve_domain;
  opacity.stops = place.attribute == StopAttribute::color ? weights_of(side.color.stops, place)
                                                          : weights_of(side.opacity.stops, place);
  return curve;
}

void add_channel(const std::vector<SegmentSide>& from, int channel,
                 std::vector<SegmentSide>& sides) {
  const auto c = static_cast<std::size_t>(channel);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    sides[i].value.start.channel[c] = from[i].value.start.channel[0];
    sides[i].value.end.channel[c] = from[i].value.end.channel[0];
  }
}

}  // namespace

bool has_stop(std::span<const Curve> curves, const StopPlace& place) {
  const bool is_known = place.side <= CurveSide::right && place.attribute <= StopAttribute::opacity;
  if (!is_known || place.curve >= curves.size()) return false;
  const Side& side = side_of(curves, place);
  return place.attribute == StopAttribute::color ? has_stop(side.color, place)
                                                 : has_stop(side.opacity, place);
}

Status add_response(const Context& context, const FlatCurves& flat, std::span<const Curve> curves,
                    const StopPlace& place, SegmentAttributes& attributes) {
  TableMemory scratch("attributes");
  std::vector<Curve> weights;
  SFUMATO_TRY(scratch.resize(context, weights, curves.size()));
  weights[place.curve] = weighted(curves, place);
  SFUMATO_TRY_ASSIGN(const SegmentAttributes& sampled,
                     sample_opacities(context, flat, weights, scratch));
  const int channel = attributes.base_channels++;
  add_channel(sampled.left, channel, attributes.left);
  add_channel(sampled.right, channel, attributes.right);
  attributes.has_response = true;
  return ok_status();
}

}  // namespace sfumato::curves
