#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Runs independent tasks, possibly at the same time. This base class runs them one after another
/// in the calling thread; WebAssembly uses it too. ThreadPool (base/native/thread_pool.hpp) has
/// threads. Derive from Executor to run the library's work on threads of your own.
class Executor {
 public:
  virtual ~Executor() = default;

  /// Calls task(i) exactly once for every i in [0, task_count), in any order, and returns when all
  /// calls have returned. The library's tasks never throw.
  ///
  /// A task may itself call run() of the same executor: layers are solved in parallel, so are the
  /// fields of each layer, and all of them run loops. A call must therefore not wait for free
  /// threads, because all of these may wait in calls of their own. Every call ends if the calling
  /// thread takes tasks, too, and waits only for tasks that other threads have begun.
  virtual void run(std::size_t task_count, FunctionRef<void(std::size_t)> task);

  /// Returns the largest number of tasks that run at the same time, from 1 to limits::kThreads.
  /// Some working memory is charged for each.
  virtual int thread_count() const { return 1; }
};

/// An account of memory. Allocations whose size depends on the input are charged here first, so
/// that memory is never exhausted: a limit error comes before. Thread-safe.
class Budget {
 public:
  /// Makes an account of at most `limit_bytes`, with nothing charged yet.
  explicit Budget(std::size_t limit_bytes = limits::kMemoryBytes) : limit_(limit_bytes) {}
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Charges `bytes`, all or nothing. `purpose` names their use in the error's message, such as
  /// "textures". Error: limit, where less than that is left.
  Status charge(std::size_t bytes, std::string_view purpose);
  /// Releases `bytes` that were charged; more than is charged counts as all of it.
  void release(std::size_t bytes);

  /// Returns the bytes that are charged now.
  std::size_t used() const;
  /// Returns the bytes that can be charged in all.
  std::size_t limit() const { return limit_; }
  /// Returns the bytes that can still be charged.
  std::size_t room() const { return limit_ - used(); }

 private:
  std::size_t limit_;
  mutable std::size_t used_ = 0;  // accessed by std::atomic_ref: <atomic> is large
};

/// Receives reports of progress. Any thread may call it, also several at once.
class Progress {
 public:
  virtual ~Progress() = default;
  /// Reports a part of a stage. `stage` is one short word, "gather" for the solver or "rasterise"
  /// for pixels, and `fraction` is the completed part, from 0 to 1. The solver counts all layers as
  /// one whole; its fraction never falls and may end below 1.
  virtual void report(std::string_view stage, double fraction) = 0;
};

/// Observes every poll of the cancel flag, so that tests can measure how often work polls it.
/// Internal: defined in src/base/poll.hpp.
class PollWatch;

/// Gathers at many points instead of the CPU. Internal: defined in src/gather/point_source.hpp.
class PointSource;

/// A flag that stops work in progress. Any thread, and a signal handler, may set it.
class CancelFlag {
 public:
  CancelFlag() = default;
  CancelFlag(const CancelFlag&) = delete;
  CancelFlag& operator=(const CancelFlag&) = delete;

  /// Does store(is_set).
  CancelFlag& operator=(bool is_set) {
    store(is_set);
    return *this;
  }
  /// Does load().
  operator bool() const { return load(); }

  /// Sets the flag. Clear it before the Context is used again.
  void store(bool is_set);
  /// Returns whether the flag is set.
  bool load() const;

 private:
  mutable bool is_set_ = false;  // accessed by std::atomic_ref: <atomic> is large
};

/// A point in time at which work ends with an error.
struct Deadline {
  std::int64_t at_ns = 0;  ///< nanoseconds of std::chrono::steady_clock since its epoch
  double seconds = 0;      ///< the requested duration, for the error's message

  /// Returns the time `seconds` from now. A billion seconds or more means never, and a negative
  /// number has already passed. NaN makes a deadline that validate(const Context&) refuses.
  static Deadline in(double seconds);
};

/// Instruction sets for the inner loops. All give the same bits.
enum class SimdLevel : std::uint8_t {
  sse2,   ///< what every x86-64 machine has; portable code on other machines and in WebAssembly
  avx2,   ///< AVX2
  avx512  ///< AVX-512 with F, DQ, BW and VL
};

/// Returns the best level of the machine that runs this.
SimdLevel detected_simd_level();

/// The resources and bounds of a computation. Every verb of the library takes one.
///
/// The caller owns the objects behind the pointers and keeps them alive. Use a Context for one call
/// at a time; several Contexts may be at work at once and may share an Executor. A Context can be
/// used again after a call, also after an error.
///
/// Work polls cancelled() on every thread. It ends with cancel_status() within about 50 ms of CPU
/// time. docs/limits.md has measurements, and the exception: libwebp's passes over a large image.
struct Context {
  Executor* executor = nullptr;  ///< null: only the calling thread
  Progress* progress = nullptr;  ///< null: no reports
  mutable Budget budget{};  ///< memory that the computation may take; const work charges it, too
  Limits limits{};          ///< largest sizes of inputs and intermediate results
  CancelFlag cancel{};      ///< set it to stop the work
  std::optional<Deadline> deadline{};      ///< none: no time limit
  SimdLevel simd = detected_simd_level();  ///< at most the level of the machine
  /// Gathers at many points at once, on a GPU: see GpuGather; null: the executor does it.
  PointSource* point_source = nullptr;
  PollWatch* poll_watch = nullptr;  ///< for tests
  /// The Context of the work that contains this work. Its flag and its deadline also stop this
  /// work.
  const Context* outer = nullptr;

  /// Returns whether to stop, because of the flag or the deadline, here or in `outer`. Reads the
  /// clock where there is a deadline, which is too slow for each iteration of a short loop.
  bool cancelled() const;
  /// Returns cancel_status() if work has to stop, else ok.
  Status check() const { return cancelled() ? cancel_status() : ok_status(); }
  /// Returns the reason why cancelled() is true: StatusCode::cancelled for the flag,
  /// StatusCode::limit with Status::limit "time" for the deadline.
  Status cancel_status() const;

  /// Returns the executor's number of threads; 1 without an executor.
  int thread_count() const { return executor ? executor->thread_count() : 1; }

 private:
  bool is_late() const;
};

/// Checks a context, as every verb does first.
///
/// Errors: bad_input (a limit above its LimitName::highest, a deadline that is NaN, an executor
/// whose thread_count() is out of range, a chain of `outer` that has a cycle or is too long),
/// unavailable (the machine lacks the instruction set `simd`).
Status validate(const Context& context);

}  // namespace sfumato
