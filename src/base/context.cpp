#include "sfumato/base/context.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/json.hpp"
#include "base/no_throw.hpp"

namespace sfumato {
namespace {

Status named_limit(std::string_view limit, std::string message) {
  Status status = make_error(StatusCode::limit, std::move(message));
  status.limit = limit;
  return status;
}

}  // namespace

void Executor::run(std::size_t task_count, FunctionRef<void(std::size_t)> task) {
  for (std::size_t i = 0; i < task_count; ++i) task(i);
}

Status Budget::charge(std::size_t bytes, std::string_view purpose) {
  std::size_t used = used_.load(std::memory_order_relaxed);
  do {
    if (bytes > limit_ || used > limit_ - bytes) {
      return named_limit("memory", "memory limit of " + std::to_string(limit_ >> 20) +
                                       " MiB reached: " + std::string(purpose) + " needs " +
                                       std::to_string((bytes >> 20) + 1) + " MiB more");
    }
  } while (!used_.compare_exchange_weak(used, used + bytes, std::memory_order_relaxed));
  return ok_status();
}

void Budget::release(std::size_t bytes) {
  std::size_t used = used_.load(std::memory_order_relaxed);
  while (
      !used_.compare_exchange_weak(used, used - std::min(used, bytes), std::memory_order_relaxed)) {
  }
}

Deadline Deadline::in(double seconds) {
  using Clock = std::chrono::steady_clock;
  constexpr double kFarAway = 1e9;  // some thirty years: the clock counts nanoseconds in 64 bits
  if (!(seconds < kFarAway)) return {Clock::time_point::max(), seconds};
  if (seconds < -kFarAway) return {Clock::time_point::min(), seconds};
  const std::chrono::duration<double> span(seconds);
  return {Clock::now() + std::chrono::duration_cast<Clock::duration>(span), seconds};
}

bool Context::is_late() const {
  return std::chrono::steady_clock::now() >= deadline->at;
}

Status Context::cancel_status() const {
  if (outer && outer->cancelled()) return outer->cancel_status();
  if (cancel.load(std::memory_order_relaxed) || !deadline) {
    return make_error(StatusCode::cancelled, "cancelled");
  }
  return named_limit(
      "time", "the time limit of " + JsonWriter().value(deadline->seconds).text() + " s is over");
}

namespace {

/// Contexts within each other; the library makes one within the caller's.
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
  if (Status status = validate(context.limits); !status) return status;
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

ScopedCharge& ScopedCharge::operator=(ScopedCharge&& other) noexcept {
  std::swap(budget_, other.budget_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

ScopedCharge::~ScopedCharge() {
  if (budget_) budget_->release(bytes_);
}

Status ScopedCharge::add(Context& context, std::size_t bytes, std::string_view purpose) {
  Budget& budget = budget_ ? *budget_ : context.budget;
  Status status = budget.charge(bytes, purpose);
  if (!status) return status;
  budget_ = &budget;
  bytes_ += bytes;
  return status;
}

Status try_parallel_for(Context& context, std::size_t count, std::size_t grain,
                        FunctionRef<Status(std::size_t, std::size_t)> body) {
  const std::size_t task_count = (count + grain - 1) / grain;
  Status failure;
  std::atomic<bool> has_failed{false};
  std::atomic<bool> goes_on{true};  // quicker to ask than the clock, where many ranges are left
  const auto task = [&](std::size_t i) {
    if (!goes_on.load(std::memory_order_relaxed)) return;
    if (context.cancelled()) {
      goes_on.store(false, std::memory_order_relaxed);
      return;
    }
    // Nothing is thrown at an executor: a thread pool without memory cannot hand an exception on.
    Status status = no_throw([&] { return body(i * grain, std::min(count, (i + 1) * grain)); });
    if (status) return;
    if (!has_failed.exchange(true)) failure = std::move(status);
    goes_on.store(false, std::memory_order_relaxed);
  };
  if (context.executor && task_count > 1) {
    context.executor->run(task_count, task);
  } else {
    for (std::size_t i = 0; i < task_count && goes_on; ++i) task(i);
  }
  if (context.cancelled()) return context.cancel_status();
  return failure;
}

Status parallel_for(Context& context, std::size_t count, std::size_t grain,
                    FunctionRef<void(std::size_t, std::size_t)> body) {
  return try_parallel_for(context, count, grain, [&](std::size_t begin, std::size_t end) {
    body(begin, end);
    return ok_status();
  });
}

}  // namespace sfumato
