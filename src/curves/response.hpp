#pragma once

#include <span>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"
#include "sfumato/document/stop_place.hpp"

namespace sfumato::curves {

/// Returns whether the place exists: a side with stops, and one of them.
bool has_stop(std::span<const Curve> curves, const StopPlace& place);

/// Adds a base channel: the growth of the field's value where the value of the stop, or of all
/// stops of the side, grows by 1, in the space of the values. The channel is gathered like the
/// values, and the result is the response of the whole field, because the gather is linear in the
/// values.
///
/// attributes   of place.attribute, on `flat`
///
/// Precondition: has_stop, and the attributes have no more than three base channels.
/// Errors: limit (memory), cancelled.
Status add_response(const Context& context, const FlatCurves& flat, std::span<const Curve> curves,
                    const StopPlace& place, SegmentAttributes& attributes);

}  // namespace sfumato::curves
