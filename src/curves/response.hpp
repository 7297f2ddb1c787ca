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

/// Whether the place is there: a side with stops, and one of them.
bool has_stop(std::span<const Curve> curves, const StopPlace& place);

/// Adds a base channel: by how much the field's value grows where that of the stop, or those of all
/// stops of the side, grow by 1, in the space of the values. It is gathered as these are, and so is
/// the response of the whole field, for all that the gather does with values is linear in them.
///
/// attributes   of place.attribute, on `flat`
/// Precondition: has_stop, and that the attributes have no more than three base channels.
/// Errors       limit (memory), cancelled
Status add_response(const Context& context, const FlatCurves& flat, std::span<const Curve> curves,
                    const StopPlace& place, SegmentAttributes& attributes);

}  // namespace sfumato::curves
