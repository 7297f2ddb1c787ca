#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/trace/trace.hpp"

namespace sfumato::tracing {

/// trace() of a picture of width × height pixels that was made smaller already, to no less than
/// TraceOptions::max_side. The drawing has the size of the picture.
/// Errors: as trace().
Result<Document> trace_sized(Context& context, const Image& smaller, int width, int height,
                             const TraceOptions& options, TraceStats* stats);

}  // namespace sfumato::tracing
