#include "sfumato/trace/trace.hpp"

#include <cmath>
#include <string>

#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "trace/sized_trace.hpp"
#include "trace/tracer.hpp"

namespace sfumato {
namespace {

Status wrong(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

bool is_amount(double number) {
  return std::isfinite(number) && number >= 0;
}

Status check(const TraceOptions& options) {
  if (options.points < 0) return wrong("the number of control points is negative");
  if (options.max_curves < 0) return wrong("the number of curves is negative");
  if (!is_amount(options.psnr_db)) return wrong("the PSNR to reach is not a number of at least 0");
  if (!is_amount(options.max_seconds)) return wrong("the time is not a number of at least 0");
  if (!is_amount(options.smooth_px) || options.smooth_px > TraceOptions::kMostSmooth) {
    return wrong("the smoothing is not a number from 0 to " +
                 std::to_string(static_cast<int>(TraceOptions::kMostSmooth)));
  }
  if (options.max_side < 1) return wrong("the longer side to look at is below 1");
  return ok_status();
}

}  // namespace

namespace tracing {

Result<Document> trace_sized(Context& context, const Image& smaller, int width, int height,
                             const TraceOptions& options, TraceStats* stats) {
  return public_verb(context, [&]() -> Result<Document> {
    SFUMATO_TRY(check(options));
    SFUMATO_TRY(validate(context.limits, smaller));
    Tracer tracer(context, smaller, width, height, options);
    Result<Document> drawing = tracer.run();
    if (drawing && stats) *stats = tracer.stats();
    return drawing;
  });
}

}  // namespace tracing

Result<Document> trace(Context& context, const Image& picture, const TraceOptions& options,
                       TraceStats* stats) {
  return tracing::trace_sized(context, picture, picture.width, picture.height, options, stats);
}

}  // namespace sfumato
