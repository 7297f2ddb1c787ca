#pragma once

#include <optional>

#include "sfumato/base/color_space.hpp"
#include "sfumato/document/curve.hpp"
#include "sfumato/document/stop_place.hpp"

namespace sfumato::capi {

/// A change of one stop, or of all stops of a list. `value` is the new value of the first of them.
struct StopChange {
  StopPlace place;
  StopValue value;
};

/// Returns the change that turns one curve into another, if it affects one stop of a colour or an
/// opacity, or all stops of one list by the same difference in `space`. Returns none if nothing
/// differs, or anything else does.
std::optional<StopChange> find_stop_change(const Curve& from, const Curve& to, const StopPlace& at,
                                           InterpolationSpace space);

}  // namespace sfumato::capi
