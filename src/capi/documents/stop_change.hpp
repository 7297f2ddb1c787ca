#pragma once

#include <optional>

#include "capi/documents/edits.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/document/curve.hpp"
#include "sfumato/document/stop_place.hpp"

namespace sfumato::capi {

/// A stop, or all stops of a list, with the value that the stop, or the first of them, gets.
struct StopChange {
  StopPlace place;
  StopValue value;
};

/// What makes one curve of another, where that is another value of one stop of a colour or an
/// opacity, or of all stops of one list by the same difference in the space; none where it is
/// anything else, or nothing.
std::optional<StopChange> find_stop_change(const Curve& from, const Curve& to, CurvePlace at,
                                           InterpolationSpace space);

}  // namespace sfumato::capi
