#pragma once

#include <atomic>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Runs independent tasks, perhaps at the same time. Native code injects a thread pool
/// (base/native/tbb_executor.hpp); the default, and WebAssembly, run in the calling thread.
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

  /// Takes `bytes`, or nothing and a limit error that says what they were for.
  Status charge(std::size_t bytes, std::string_view purpose);
  /// Gives back what was charged, and never more than that.
  void release(std::size_t bytes);

  std::size_t used() const { return used_.load(std::memory_order_relaxed); }
  std::size_t limit() const { return limit_; }
  std::size_t room() const { return limit_ - used(); }

 private:
  std::size_t limit_;
  std::atomic<std::size_t> used_{0};
};

/// What a caller may want to be told while work goes on. Called from any thread.
class Progress {
 public:
  virtual ~Progress() = default;
  /// stage: a short word ("gather"); fraction: 0 to 1 of that stage.
  virtual void report(std::string_view stage, double fraction) = 0;
};

/// Told of every look at the cancel flag: how tests learn how often work looks. Called from any
/// thread.
class PollWatch {
 public:
  virtual ~PollWatch() = default;
  virtual void polled() = 0;
  /// Whether loops of short turns look at every turn: each may then be the first to see the flag.
  virtual bool wants_every_turn() const { return false; }
};

/// Wall-clock time after which work is given up.
struct Deadline {
  std::chrono::steady_clock::time_point at;
  double seconds = 0;  ///< what was given, for the message

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
  std::atomic<bool> cancel{false};
  std::optional<Deadline> deadline{};  ///< none: no limit on time
  SimdLevel simd = detected_simd_level();
  PollWatch* poll_watch = nullptr;
  const Context* outer = nullptr;  ///< of work within work: what stops it stops this too

  /// Whether to stop, by the flag or the deadline. Cheap, but not for every turn of a short loop.
  bool cancelled() const {
    if (poll_watch) poll_watch->polled();
    return cancel.load(std::memory_order_relaxed) || (deadline && is_late()) ||
           (outer && outer->cancelled());
  }
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

/// Looks at the cancel flag once in `kTurns` calls, for loops of short turns. What it has seen once
/// it says at every later call: a loop that was ended early does not go on as the next one.
template <std::uint32_t kTurns>
class RarePoll {
  static_assert(std::has_single_bit(kTurns));

 public:
  explicit RarePoll(const Context& context) : context_(context) {
    if (context.poll_watch && context.poll_watch->wants_every_turn()) mask_ = 0;
  }
  bool cancelled() {
    if ((++turn_ & mask_) == 0) has_seen_ = has_seen_ || context_.cancelled();
    return has_seen_;
  }

 private:
  const Context& context_;
  std::uint32_t turn_ = 0;
  std::uint32_t mask_ = kTurns - 1;
  bool has_seen_ = false;
};

/// A charge that gives itself back at the end of its scope. It belongs to one Budget, that of the
/// first Context that it is charged to, which must outlive it. Movable.
class ScopedCharge {
 public:
  ScopedCharge() = default;
  ScopedCharge(ScopedCharge&& other) noexcept : budget_(other.budget_), bytes_(other.bytes_) {
    other.budget_ = nullptr;
  }
  ScopedCharge& operator=(ScopedCharge&& other) noexcept;
  ~ScopedCharge();

  /// Charges `bytes` more; on failure nothing changes. What has a Budget already stays with it,
  /// whichever Context does the work now.
  Status add(Context& context, std::size_t bytes, std::string_view purpose);

 private:
  Budget* budget_ = nullptr;
  std::size_t bytes_ = 0;
};

/// Calls body(begin, end) for consecutive ranges of [0, count) of `grain` items (the last may be
/// shorter). The cut does not depend on the number of threads; a body writes only its own slots.
/// After cancellation remaining ranges are skipped and the status is cancelled; so they are where
/// an allocation of a body fails, which is out_of_memory.
Status parallel_for(Context& context, std::size_t count, std::size_t grain,
                    FunctionRef<void(std::size_t begin, std::size_t end)> body);

/// parallel_for() of a body that may fail: after a failure remaining ranges are skipped, and it is
/// the status. Where several ranges fail, which of them that is depends on the threads.
Status try_parallel_for(Context& context, std::size_t count, std::size_t grain,
                        FunctionRef<Status(std::size_t begin, std::size_t end)> body);

}  // namespace sfumato
