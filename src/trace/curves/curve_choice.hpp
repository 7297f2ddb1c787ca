#pragma once

#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/trace/trace.hpp"

namespace sfumato::tracing {

/// Errors: bad_input (a drawing has no such curve), limit, cancelled.
Status check_curves(const Context& context, const Document& drawing,
                    std::span<const CurveOfLayer> curves);

}  // namespace sfumato::tracing
