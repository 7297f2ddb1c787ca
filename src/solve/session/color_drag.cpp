#include "solve/session/color_drag.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "document/rules.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::solve {
namespace {

constexpr std::size_t kNodesPerTask = 1 << 15;

template <class AnyCurve>
auto& side_of(AnyCurve& curve, const StopPlace& place) {
  return place.side == CurveSide::left ? curve.left : curve.right;
}

Status not_within() {
  return make_error(StatusCode::bad_input, "the value of a stop is not within 0 to 1");
}

/// Shifts one stop of `first`, or all, by the difference that brings the first of them to `value`.
Status shift_colors(const ColorStops& first, std::optional<std::uint32_t> index, const Rgb& value,
                    InterpolationSpace space, ColorStops& next, std::array<float, 3>& shift) {
  if (!rules::is_color(value)) return not_within();
  const Rgb from = from_srgb(space, first.stops[index.value_or(0)].value);
  const Rgb to = from_srgb(space, value);
  shift = {to.r - from.r, to.g - from.g, to.b - from.b};
  next.stops[index.value_or(0)].value = value;
  for (std::size_t i = 1; !index && i < first.stops.size(); ++i) {
    const Rgb old = from_srgb(space, first.stops[i].value);
    const Rgb shifted = to_srgb(space, {old.r + shift[0], old.g + shift[1], old.b + shift[2]});
    if (!rules::is_color(shifted)) return not_within();
    next.stops[i].value = shifted;
  }
  return ok_status();
}

Status shift_opacities(const ScalarStops& first, std::optional<std::uint32_t> index, float value,
                       ScalarStops& next, std::array<float, 3>& shift) {
  shift = {value - first.stops[index.value_or(0)].value, 0, 0};
  next.stops[index.value_or(0)].value = value;
  for (std::size_t i = 1; !index && i < first.stops.size(); ++i) {
    next.stops[i].value = first.stops[i].value + shift[0];
  }
  for (const Stop<float>& s : next.stops) {
    if (!rules::is_share(s.value)) return not_within();
  }
  return ok_status();
}

}  // namespace

ColorDrag::ColorDrag(const StopPlace& place, InterpolationSpace space, const Curve& curve)
    : place_(place), space_(space), first_(side_of(curve, place)), next_(first_) {}

Result<ColorDrag> ColorDrag::begin(Context& context, const Document& document,
                                   const StopPlace& place, const LayerSight& sight,
                                   const DiffuseOptions& options,
                                   std::optional<RefinedLayer>& refined) {
  const Curve& curve = document.layers[place.layer].curves[place.curve];
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, 2 * bytes_of(curve), "the stops of a side"));
  ColorDrag drag(place, document.interpolation, curve);
  drag.side_charge_ = std::move(charge);
  if (sight.views.empty()) return drag;
  SFUMATO_TRY_ASSIGN(drag.response_, respond(context, document, place, sight, options, refined));
  SFUMATO_TRY(drag.hold(context));
  return drag;
}

/// Copies the values that frames begin from. The response's layer keeps a table of values for the
/// first frame.
Status ColorDrag::hold(const Context& context) {
  PatchField& values = field(response_.layer);
  channels_ = values.channel_count;
  SFUMATO_TRY(memory_.append(context, values.node_value, base_));
  SFUMATO_TRY(list_answering(context));
  std::vector<float>().swap(values.node_value);
  Status status = charge_.add(context, bytes_of(response_.layer), "the response of a layer");
  return status ? layer_memory_.append(context, base_, values.node_value) : status;
}

Status ColorDrag::list_answering(const Context& context) {
  const std::vector<float>& factor = response_.factor;
  const auto silent = static_cast<std::size_t>(std::ranges::count(factor, 0.0f));
  SFUMATO_TRY(memory_.reserve(context, answering_, factor.size() - silent));
  RarePoll<65536> poll(context);
  for (std::uint32_t node = 0; node < factor.size(); ++node) {
    if (poll.cancelled()) return context.cancel_status();
    if (factor[node] != 0) answering_.push_back(node);
  }
  return ok_status();
}

Status ColorDrag::prepare(Context& context, const StopValue& value) {
  SFUMATO_TRY(context.check());
  std::array<float, 3> shift{};
  Status status = shift_stops(value, shift);
  if (!status || base_.empty()) return status;
  if (!is_shown_) return shift_values(context, shift, field(response_.layer).node_value);
  if (values_.empty()) status = memory_.append(context, base_, values_);
  if (status) return shift_values(context, shift, values_);
  memory_.free(values_);
  return status;
}

Status ColorDrag::shift_stops(const StopValue& value, std::array<float, 3>& shift) {
  const auto* color = std::get_if<Rgb>(&value);
  if ((color != nullptr) != (place_.attribute == StopAttribute::color)) {
    return make_error(StatusCode::bad_input, "a colour for an opacity, or an opacity for a colour");
  }
  if (color) {
    return shift_colors(first_.color.stops, place_.index, *color, space_, next_.color.stops, shift);
  }
  return shift_opacities(first_.opacity.stops, place_.index, std::get<float>(value),
                         next_.opacity.stops, shift);
}

/// Computes Z(c) = Z(c₀) + φ (c - c₀) at the nodes whose φ is not 0.
Status ColorDrag::shift_values(const Context& context, const std::array<float, 3>& shift,
                               std::vector<float>& values) const {
  const auto channels = static_cast<std::size_t>(channels_);
  const std::size_t shifted = place_.attribute == StopAttribute::color ? 3 : 1;
  return parallel_for(context, answering_.size(), kNodesPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) {
                          const std::uint32_t node = answering_[i];
                          const float factor = response_.factor[node];
                          for (std::size_t c = 0; c < shifted; ++c) {
                            const std::size_t at = channels * node + c;
                            values[at] = base_[at] + factor * shift[c];
                          }
                        }
                      });
}

bool ColorDrag::keeps(const Curve& curve) const {
  const Side& side = side_of(curve, place_);
  return side.color == next_.color && side.opacity == next_.opacity;
}

std::optional<PatchLayer> ColorDrag::show(Curve& curve, PatchLayer& layer) noexcept {
  Side& side = side_of(curve, place_);
  std::swap(side.color.stops.stops, next_.color.stops.stops);
  std::swap(side.opacity.stops.stops, next_.opacity.stops.stops);
  if (std::exchange(is_shown_, true)) {
    std::swap(field(layer).node_value, values_);
    return std::nullopt;
  }
  std::swap(response_.layer, layer);
  charge_ = {};
  layer_memory_ = TableMemory("the response of a layer");
  return std::exchange(response_.layer, {});
}

}  // namespace sfumato::solve
