#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "capi/call.hpp"
#include "capi/images.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::capi {

/// What the handles that a context made share with it, so that any of them may be freed first.
struct Workshop {
  Workshop(int threads, std::size_t memory_bytes, const Limits& limits)
      : pool(threads),
        context{.executor = &pool, .budget = Budget(memory_bytes), .limits = limits} {}

  ThreadPool pool;
  Context context;
  std::optional<double> seconds{};  ///< that each call may take
};

/// Hands reports on to a function of C.
struct ToldProgress final : Progress {
  void report(std::string_view stage, double fraction) override;

  sfumato_progress_fn function = nullptr;
  void* user = nullptr;
};

/// Runs body(workshop), which returns an Outcome, as every call with a context does: its error is
/// kept in the context, and its code returned.
template <class Body>
std::int32_t call(sfumato_context* context, Body&& body) noexcept;

}  // namespace sfumato::capi

struct sfumato_context {
  std::shared_ptr<sfumato::capi::Workshop> workshop;  ///< null: the options were wrong
  sfumato::capi::Outcome last;
  std::vector<std::string> warnings;
  sfumato::capi::Images images;  ///< charged to the workshop
  sfumato::capi::ToldProgress progress;
};

namespace sfumato::capi {

template <class Body>
std::int32_t call(sfumato_context* context, Body&& body) noexcept {
  if (!context) return SFUMATO_BAD_USAGE;
  if (!context->workshop) return context->last.code;
  context->last = caught([&]() -> Outcome {
    Workshop& workshop = *context->workshop;
    workshop.context.deadline.reset();
    if (workshop.seconds) workshop.context.deadline = Deadline::in(*workshop.seconds);
    return body(workshop);
  });
  return context->last.code;
}

/// The same for calls that hand something out through `out`, which is NULL where they fail.
template <class Handle, class Body>
std::int32_t make(sfumato_context* context, Handle** out, Body&& body) noexcept {
  if (out) *out = nullptr;
  return call(context, [&](Workshop& workshop) -> Outcome {
    if (!out) return bad_usage("NULL given in the place of the result");
    return body(workshop);
  });
}

}  // namespace sfumato::capi
