#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "capi/call.hpp"
#include "capi/pictures/images.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::capi {

/// Holds the state that a context shares with its handles, so that any of them may be freed first.
struct Workshop {
  Workshop(int threads, std::size_t memory_bytes, const Limits& limits)
      : pool(threads),
        context{.executor = &pool, .budget = Budget(memory_bytes), .limits = limits} {}

  ThreadPool pool;
  Context context;
  std::optional<double> seconds{};  ///< seconds that each call may take
};

/// Passes reports on to a function of C.
struct ToldProgress final : Progress {
  void report(std::string_view stage, double fraction) override;

  sfumato_progress_fn function = nullptr;
  void* user = nullptr;
};

/// Runs body(workshop), which returns an Outcome, for a call with a context: keeps the error in the
/// context and returns the code.
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

/// Does the same for calls that return an object through `out`, which is NULL if they fail.
template <class Handle, class Body>
std::int32_t make(sfumato_context* context, Handle** out, Body&& body) noexcept {
  if (out) *out = nullptr;
  return call(context, [&](Workshop& workshop) -> Outcome {
    if (!out) return bad_usage("NULL given for the result; pass a pointer");
    return body(workshop);
  });
}

}  // namespace sfumato::capi
