#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Runs independent tasks, perhaps at the same time. Native code injects a thread pool
/// (base/native/thread_pool.hpp); the default, and WebAssembly, run in the calling thread.
class Executor {
 public:
  virtual ~Executor() = default;

  /// Calls task(i) once for every i in [0, task_count), in any order; returns when all are done.
  virtual void run(std::size_t task_count, FunctionRef<void(std::size_t)> task);

  virtual int thread_count() const { return 1; }
};

/// Memory charged before it is allocated. Thread-safe.
class Budget {
 public:
  explicit Budget(std::size_t limit_bytes = limits::kMemoryBytes) : limit_(limit_bytes) {}
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Takes `bytes`, or nothing and a limit error that says what they were for.
  Status charge(std::size_t bytes, std::string_view purpose);
  /// Gives back what was charged, and never more than that.
  void release(std::size_t bytes);

  std::size_t used() const;
  std::size_t limit() const { return limit_; }
  std::size_t room() const { return limit_ - used(); }

 private:
  std::size_t limit_;
  mutable std::size_t used_ = 0;  // by std::atomic_ref: <atomic> is large
};

/// What a caller may want to be told while work goes on. Called from any thread.
class Progress {
 public:
  virtual ~Progress() = default;
  /// stage: a short word ("gather"); fraction: 0 to 1 of that stage.
  virtual void report(std::string_view stage, double fraction) = 0;
};

/// Told of every look at the cancel flag: how tests learn how often work looks (base/poll.hpp).
class PollWatch;

/// A flag that any thread, or a handler of signals, sets to end work in others.
class CancelFlag {
 public:
  CancelFlag() = default;
  CancelFlag(const CancelFlag&) = delete;
  CancelFlag& operator=(const CancelFlag&) = delete;

  CancelFlag& operator=(bool is_set) {
    store(is_set);
    return *this;
  }
  operator bool() const { return load(); }

  void store(bool is_set);
  bool load() const;

 private:
  mutable bool is_set_ = false;  // by std::atomic_ref: <atomic> is large
};

/// Wall-clock time after which work is given up.
struct Deadline {
  std::int64_t at_ns = 0;  ///< of std::chrono::steady_clock
  double seconds = 0;      ///< what was given, for the message

  /// Never, where that is too far away to be counted. Not a number: see validate().
  static Deadline in(double seconds);
};

/// Instruction sets that kernels are compiled for. All give the same bits.
enum class SimdLevel : std::uint8_t { sse2, avx2, avx512 };

/// The best level of the machine that runs this.
SimdLevel detected_simd_level();

/// Everything that travels with a computation. The caller keeps executor, progress and poll_watch
/// alive.
///
/// Work looks at cancelled() at least every few milliseconds of each thread, and then ends with
/// cancel_status(). tests/limits holds it to that.
struct Context {
  Executor* executor = nullptr;  ///< null: the calling thread alone
  Progress* progress = nullptr;
  Budget budget{};
  Limits limits{};
  CancelFlag cancel{};
  std::optional<Deadline> deadline{};  ///< none: no limit on time
  SimdLevel simd = detected_simd_level();
  PollWatch* poll_watch = nullptr;  ///< for tests
  const Context* outer = nullptr;   ///< of work within work: what stops it stops this too

  /// Whether to stop, by the flag or the deadline. Cheap, but not for every turn of a short loop.
  bool cancelled() const;
  /// Ok, or why to stop: cancelled, or limit for the deadline.
  Status check() const { return cancelled() ? cancel_status() : ok_status(); }
  /// Why cancelled() was true.
  Status cancel_status() const;

  int thread_count() const { return executor ? executor->thread_count() : 1; }

 private:
  bool is_late() const;
};

/// What every public verb checks before it begins: limits within their highest values, a deadline
/// that is a number, `outer` without a circle (bad_input), and instructions that this machine has
/// (unavailable).
Status validate(const Context& context);

}  // namespace sfumato
