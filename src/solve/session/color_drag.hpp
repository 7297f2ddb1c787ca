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

/// A stop whose value changes while everything else stays. A frame costs one multiplication and one
/// addition for each channel of each node that responds to the stop. Each of the two tables of
/// values also costs one copy of all values. A frame depends on the value, not on earlier frames.
///
/// Memory stays charged to the Budget of begin()'s Context, which must outlive this. Frames may use
/// another Context.
class ColorDrag {
 public:
  /// Prepares a stop for other values. Parameters, errors and cost: as respond(). `sight` may also
  /// be empty: nothing shows the layer then.
  static Result<ColorDrag> begin(Context& context, const Document& document, const StopPlace& place,
                                 const LayerSight& sight, const DiffuseOptions& options,
                                 std::optional<RefinedLayer>& refined);

  const StopPlace& place() const { return place_; }

  /// Returns LayerResponse::factor. Its nodes are the nodes of the layer after the first show().
  std::span<const float> factor() const { return response_.factor; }

  /// Prepares show() for a value; replaces an earlier preparation. With all stops of a list, the
  /// first gets the value, and the others change by the same difference in the interpolation space.
  /// Errors   bad_input (a value of another attribute, or a stop's value outside 0 to 1), limit
  ///          (memory), cancelled; show() must not follow then
  Status prepare(Context& context, const StopValue& value);

  /// Returns the layer that the first show() will put into the picture; null afterwards.
  const PatchLayer* new_layer() const { return is_shown_ ? nullptr : &response_.layer; }

  /// Returns whether show() leaves the curve unchanged.
  bool keeps(const Curve& curve) const;

  /// Puts the stops into the curve and the values into the layer. The first call replaces the whole
  /// layer, and returns the old one.
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
  Side first_;  ///< the side at begin()
  Side next_;   ///< the side for show()
  LayerResponse response_;
  bool is_shown_ = false;
  int channels_ = 0;                      ///< of the field
  std::vector<float> base_;               ///< node values of the field at begin()
  std::vector<std::uint32_t> answering_;  ///< nodes whose factor is not 0
  std::vector<float> values_;             ///< node values for show(), except the first
  ScopedCharge charge_;  ///< of the response's layer without node values, until the first show()
  TableMemory layer_memory_{"the response of a layer"};  ///< of its node values, until then
  TableMemory memory_{"the response of a layer"};        ///< of the tables above
  ScopedCharge side_charge_;                             ///< of both sides
};

}  // namespace sfumato::solve
