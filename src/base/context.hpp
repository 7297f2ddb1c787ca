#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/function_ref.hpp"
#include "base/limits.hpp"
#include "base/status.hpp"

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
  void release(std::size_t bytes) { used_.fetch_sub(bytes, std::memory_order_relaxed); }

  std::size_t used() const { return used_.load(std::memory_order_relaxed); }
  std::size_t limit() const { return limit_; }

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

/// Instruction sets that kernels are compiled for. All give the same bits.
enum class SimdLevel : std::uint8_t { sse2, avx2, avx512 };

/// The best level of the machine that runs this.
SimdLevel detected_simd_level();

/// Everything that travels with a computation. The caller keeps executor and progress alive.
struct Context {
  Executor* executor = nullptr;  ///< null: the calling thread alone
  Progress* progress = nullptr;
  Budget budget{};
  std::atomic<bool> cancel{false};
  SimdLevel simd = detected_simd_level();

  bool cancelled() const { return cancel.load(std::memory_order_relaxed); }
  int thread_count() const { return executor ? executor->thread_count() : 1; }
};

/// A charge that gives itself back at the end of its scope, to a Context that must outlive it.
/// Movable.
class ScopedCharge {
 public:
  ScopedCharge() = default;
  ScopedCharge(ScopedCharge&& other) noexcept : budget_(other.budget_), bytes_(other.bytes_) {
    other.budget_ = nullptr;
  }
  ScopedCharge& operator=(ScopedCharge&& other) noexcept;
  ~ScopedCharge();

  /// Charges `bytes` more to `context.budget`; on failure nothing changes.
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

}  // namespace sfumato
