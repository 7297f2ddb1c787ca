#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/document/stop_place.hpp"
#include "sfumato/picture/picture.hpp"
#include "solve/session/layer_response.hpp"

namespace sfumato::solve {

/// A stop whose value changes while all else stays. A frame costs a multiplication and an addition
/// for each channel of each node that answers to the stop, but the first of each of two tables a
/// copy of all values; it depends on the value alone, not on the frames before it.
///
/// Memory stays charged to the Budget of the Context that begin() was given, which must outlive
/// this; frames have a Context of their own.
class ColorDrag {
 public:
  /// Parameters, errors and cost of respond(), except that an empty `sight` is good, too: nothing
  /// shows the layer then.
  static Result<ColorDrag> begin(Context& context, const Document& document, const StopPlace& place,
                                 const LayerSight& sight, const DiffuseOptions& options,
                                 std::optional<RefinedLayer>& refined);

  const StopPlace& place() const { return place_; }

  /// LayerResponse::factor; the nodes are those of the layer after the first show().
  std::span<const float> factor() const { return response_.factor; }

  /// Prepares show(), in the place of what was prepared before. Where all stops are meant, the
  /// value is that of the first, and the others change by the same difference in the space of the
  /// interpolation.
  /// Errors   bad_input (a value of another attribute, or a stop's would not be within 0 to 1),
  ///          limit (memory), cancelled; no show() may follow then
  Status prepare(Context& context, const StopValue& value);

  /// What show() will put in the place of a layer; none after the first.
  const PatchLayer* new_layer() const { return is_shown_ ? nullptr : &response_.layer; }

  /// Whether show() leaves the curve as it is.
  bool keeps(const Curve& curve) const;

  /// Puts the stops into the curve and the values into the layer. The first time all of the layer
  /// is new, and what was there is returned.
  std::optional<PatchLayer> show(Curve& curve, PatchLayer& layer) noexcept;

 private:
  ColorDrag(const StopPlace& place, InterpolationSpace space, const Curve& curve);

  PatchField& field(PatchLayer& layer) const {
    return place_.attribute == StopAttribute::color ? layer.color : layer.opacity;
  }
  Status hold(const Context& context);
  Status list_answering(const Context& context);
  Status shift_stops(const StopValue& value, std::array<float, 3>& shift);
  Status shift_values(const Context& context, const std::array<float, 3>& shift,
                      std::vector<float>& values) const;

  StopPlace place_;
  InterpolationSpace space_;
  Side first_;  ///< at the begin
  Side next_;   ///< for show()
  LayerResponse response_;
  bool is_shown_ = false;
  int channels_ = 0;                      ///< of the field
  std::vector<float> base_;               ///< its node values at the begin
  std::vector<std::uint32_t> answering_;  ///< nodes whose factor is not 0
  std::vector<float> values_;             ///< for show(), but the first
  ScopedCharge charge_;  ///< of the response's layer without those, until it is shown
  TableMemory layer_memory_{"the response of a layer"};  ///< of its values, until then
  TableMemory memory_{"the response of a layer"};        ///< of the tables above
  ScopedCharge side_charge_;                             ///< of both sides
};

}  // namespace sfumato::solve
