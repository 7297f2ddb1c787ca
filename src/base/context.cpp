#include "sfumato/base/context.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/limit_error.hpp"
#include "base/poll.hpp"
#include "base/text/json.hpp"
#include "base/try.hpp"

namespace sfumato {
namespace {

std::int64_t now_ns() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

}  // namespace

void Executor::run(std::size_t task_count, FunctionRef<void(std::size_t)> task) {
  for (std::size_t i = 0; i < task_count; ++i) task(i);
}

void CancelFlag::store(bool is_set) {
  std::atomic_ref(is_set_).store(is_set, std::memory_order_release);
}

bool CancelFlag::load() const {
  return std::atomic_ref(is_set_).load(std::memory_order_relaxed);
}

std::size_t Budget::used() const {
  return std::atomic_ref(used_).load(std::memory_order_relaxed);
}

Status Budget::charge(std::size_t bytes, std::string_view purpose) {
  const std::atomic_ref taken(used_);
  std::size_t used = taken.load(std::memory_order_relaxed);
  do {
    if (bytes > limit_ || used > limit_ - bytes) {
      return make_limit_error("memory", "memory limit of " + std::to_string(limit_ >> 20) +
                                            " MiB reached: " + std::string(purpose) + " needs " +
                                            std::to_string((bytes >> 20) + 1) + " MiB more");
    }
  } while (!taken.compare_exchange_weak(used, used + bytes, std::memory_order_relaxed));
  return ok_status();
}

void Budget::release(std::size_t bytes) {
  const std::atomic_ref taken(used_);
  std::size_t used = taken.load(std::memory_order_relaxed);
  while (
      !taken.compare_exchange_weak(used, used - std::min(used, bytes), std::memory_order_relaxed)) {
  }
}

Deadline Deadline::in(double seconds) {
  constexpr double kFarAway = 1e9;  // some thirty years: the clock counts nanoseconds in 64 bits
  if (!(seconds < kFarAway)) return {std::numeric_limits<std::int64_t>::max(), seconds};
  if (seconds < -kFarAway) return {std::numeric_limits<std::int64_t>::min(), seconds};
  return {now_ns() + static_cast<std::int64_t>(seconds * 1e9), seconds};
}

bool Context::cancelled() const {
  if (poll_watch) poll_watch->polled();
  return cancel || (deadline && is_late()) || (outer && outer->cancelled());
}

bool Context::is_late() const {
  return now_ns() >= deadline->at_ns;
}

Status Context::cancel_status() const {
  if (outer && outer->cancelled()) return outer->cancel_status();
  if (cancel || !deadline) {
    return make_error(StatusCode::cancelled, "cancelled");
  }
  return make_limit_error(
      "time", "the time limit of " + JsonWriter().value(deadline->seconds).text() + " s is over");
}

namespace {

/// The deepest nesting of Contexts; the library makes one within the caller's.
constexpr int kDeepestContext = 64;

bool ends(const Context* context) {
  int depth = 0;
  while (context && depth < kDeepestContext) {
    context = context->outer;
    ++depth;
  }
  return context == nullptr;
}

}  // namespace

Status validate(const Context& context) {
  const auto bad = [](const char* what) { return make_error(StatusCode::bad_input, what); };
  SFUMATO_TRY(validate(context.limits));
  if (context.simd > SimdLevel::avx512) return bad("a context with an unknown instruction set");
  if (context.simd > detected_simd_level()) {
    return make_error(StatusCode::unavailable, "this machine lacks the context's instruction set");
  }
  if (context.deadline && std::isnan(context.deadline->seconds)) {
    return bad("a deadline that is not a number");
  }
  if (context.executor && (context.thread_count() < 1 || context.thread_count() > limits::kThreads))
    return bad("an executor with no threads, or with too many");
  if (!ends(&context)) return bad("a context that lies within itself, or within too many others");
  return ok_status();
}

SimdLevel detected_simd_level() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl")) {
    return SimdLevel::avx512;
  }
  if (__builtin_cpu_supports("avx2")) return SimdLevel::avx2;
#endif
  return SimdLevel::sse2;
}

}  // namespace sfumato
