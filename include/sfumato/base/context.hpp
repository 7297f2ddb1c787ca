#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Runs independent tasks, possibly at the same time. This base class, which is also what
/// WebAssembly uses, runs them one after another in the calling thread; ThreadPool
/// (base/native/thread_pool.hpp) has threads. Derive from it to run the library's work on threads
/// of your own.
class Executor {
 public:
  virtual ~Executor() = default;

  /// Calls task(i) exactly once for every i in [0, task_count), in any order, and returns when all
  /// calls have returned. The library's tasks never throw.
  ///
  /// A task may call run() of the same executor in its turn: layers are solved side by side, the
  /// fields of each too, and all of them run loops. So a call must not wait for threads to become
  /// free, which may all wait in calls of their own. Where the calling thread takes tasks, too, and
  /// waits only for those that other threads have begun, every call ends.
  virtual void run(std::size_t task_count, FunctionRef<void(std::size_t)> task);

  /// How many tasks may run at the same time, from 1 to limits::kThreads. Some working memory is
  /// charged for each.
  virtual int thread_count() const { return 1; }
};

/// An account of memory: what an input's size decides on is charged here before it is allocated,
/// so that a limit error takes the place of exhausted memory. Thread-safe.
class Budget {
 public:
  /// An account of at most `limit_bytes`, with nothing charged yet.
  explicit Budget(std::size_t limit_bytes = limits::kMemoryBytes) : limit_(limit_bytes) {}
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Charges `bytes`, all or nothing. `purpose` says in the error's message what they were for, as
  /// in "textures". Error: limit, where less than that is left.
  Status charge(std::size_t bytes, std::string_view purpose);
  /// Gives back `bytes` that were charged; more than is charged counts as all of it.
  void release(std::size_t bytes);

  /// Bytes that are charged now.
  std::size_t used() const;
  /// Bytes that can be charged in all.
  std::size_t limit() const { return limit_; }
  /// Bytes that can still be charged.
  std::size_t room() const { return limit_ - used(); }

 private:
  std::size_t limit_;
  mutable std::size_t used_ = 0;  // by std::atomic_ref: <atomic> is large
};

/// Receives reports on how far work has come. Called from any thread, also from several at once.
class Progress {
 public:
  virtual ~Progress() = default;
  /// Called now and then during a stage. `stage` is one short word, "gather" for the solver or
  /// "rasterise" for pixels, and `fraction` is the part of it that is done, from 0 to 1. The solver
  /// counts all layers as one whole, whose fraction never falls and may end below 1.
  virtual void report(std::string_view stage, double fraction) = 0;
};

/// Notified at every check of the cancel flag, so that tests can measure how often work checks it.
/// Internal: defined in src/base/poll.hpp.
class PollWatch;

/// Who gathers at many points in the CPU's place. Internal: defined in src/gather/point_source.hpp.
class PointSource;

/// A flag that stops work in progress. It may be set from any thread, and from a signal handler.
class CancelFlag {
 public:
  CancelFlag() = default;
  CancelFlag(const CancelFlag&) = delete;
  CancelFlag& operator=(const CancelFlag&) = delete;

  /// The same as store(is_set).
  CancelFlag& operator=(bool is_set) {
    store(is_set);
    return *this;
  }
  /// The same as load().
  operator bool() const { return load(); }

  /// Sets the flag, or clears it before the Context is used again.
  void store(bool is_set);
  /// Whether the flag is set.
  bool load() const;

 private:
  mutable bool is_set_ = false;  // by std::atomic_ref: <atomic> is large
};

/// A point in time after which work is given up.
struct Deadline {
  std::int64_t at_ns = 0;  ///< nanoseconds of std::chrono::steady_clock since its epoch
  double seconds = 0;      ///< the duration that was asked for, for the error's message

  /// The time `seconds` from now. A billion seconds or more means never, and a negative number has
  /// passed already; NaN makes a deadline that validate(const Context&) refuses.
  static Deadline in(double seconds);
};

/// Instruction sets that the inner loops are compiled for. All give the same bits.
enum class SimdLevel : std::uint8_t {
  sse2,   ///< what every x86-64 machine has; portable code on other machines and in WebAssembly
  avx2,   ///< AVX2
  avx512  ///< AVX-512 with F, DQ, BW and VL
};

/// The best level of the machine that runs this.
SimdLevel detected_simd_level();

/// The resources and bounds of a computation. Every verb of the library takes one.
///
/// The caller owns what the pointers refer to and keeps it alive. Use a Context for one call at a
/// time; several Contexts may be at work at once and may share an Executor. After a call, also one
/// that failed, the Context can be used again.
///
/// Work checks cancelled() on every thread, so that it ends within about 50 ms of CPU time once it
/// is to stop, and returns cancel_status(). docs/limits.md has measurements, and the exception: the
/// passes of libwebp over a large image.
struct Context {
  Executor* executor = nullptr;  ///< null: the calling thread alone
  Progress* progress = nullptr;  ///< null: nobody is told
  mutable Budget budget{};  ///< memory that the computation may take, charged by const work too
  Limits limits{};          ///< how large inputs and intermediate results may be
  CancelFlag cancel{};      ///< set it to stop the work
  std::optional<Deadline> deadline{};      ///< none: no limit on time
  SimdLevel simd = detected_simd_level();  ///< at most what the machine has
  /// Gathers at many points at once: a GPU, as GpuGather has it; null: the executor does.
  PointSource* point_source = nullptr;
  PollWatch* poll_watch = nullptr;  ///< for tests
  /// The Context of the work that contains this work; its flag and its deadline stop this too.
  const Context* outer = nullptr;

  /// Whether to stop, because of the flag or the deadline, here or in `outer`. It reads the clock
  /// where there is a deadline, which is too slow for every turn of a short loop.
  bool cancelled() const;
  /// Ok, or if work is to stop the reason, as cancel_status() gives it.
  Status check() const { return cancelled() ? cancel_status() : ok_status(); }
  /// The reason why cancelled() is true: StatusCode::cancelled for the flag, StatusCode::limit with
  /// Status::limit "time" for the deadline.
  Status cancel_status() const;

  /// The executor's number of threads; 1 without an executor.
  int thread_count() const { return executor ? executor->thread_count() : 1; }

 private:
  bool is_late() const;
};

/// What every verb checks before it begins.
///
/// Errors: bad_input (a limit above its LimitName::highest, a deadline that is NaN, an executor
/// whose thread_count() is out of range, a chain of `outer` that has a cycle or is too long),
/// unavailable (the machine lacks the instruction set `simd`).
Status validate(const Context& context);

}  // namespace sfumato
