#include "base/native/tbb_executor.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <semaphore>
#include <system_error>
#include <thread>
#include <vector>

#include "base/stopwatch.hpp"

namespace sfumato {
namespace {

/// Threads of the pool that have not started by then start later.
constexpr double kStartSeconds = 0.005;
constexpr double kStartSecondsPerThread = 0.001;

/// Address space that a new thread may take: its stack, and the mapping where glibc's malloc finds
/// an aligned arena. The arena may come late, or only sometimes, depending on the addresses.
constexpr std::size_t kStackBytes = std::size_t{8} << 20;
constexpr std::size_t kArenaBytes = std::size_t{128} << 20;

/// Returns how many of `wanted` threads, including the calling one, have room in the address space,
/// which `ulimit -v` limits.
int threads_with_room(int wanted) {
  for (; wanted > 1; --wanted) {
    const std::size_t bytes = static_cast<std::size_t>(wanted - 1) * (kStackBytes + kArenaBytes);
    void* const room =
        mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED) continue;
    munmap(room, bytes);
    break;
  }
  return wanted;
}

/// Makes the malloc of a new thread take its memory. Not optimised away.
void take_memory() {
  std::unique_ptr<char> memory(new (std::nothrow) char);
  if (memory) *static_cast<volatile char*>(memory.get()) = 0;
}

/// Returns how many of `wanted` threads, including the calling one, the system lets this process
/// have, as far as a trial can show: all of them, where there is room for some more, or half of the
/// threads that started. oneTBB does not report a refused thread: it ends the process. The work
/// needs memory, too.
int allowed_threads(int wanted) {
  wanted = threads_with_room(wanted);
  if (wanted == 1) return 1;
  const std::size_t tried = static_cast<std::size_t>(wanted) + static_cast<std::size_t>(wanted) / 8;
  std::mutex gate;
  std::binary_semaphore runs(0);
  std::vector<std::jthread> others;
  const std::scoped_lock all_wait(gate);
  try {
    others.reserve(tried);
    while (others.size() < tried) {
      others.emplace_back([&] {
        take_memory();
        runs.release();
        const std::scoped_lock through(gate);
      });
      runs.acquire();
    }
    return wanted;
  } catch (const std::system_error&) {  // the threads that started count
  } catch (const std::bad_alloc&) {
  }
  return std::min(wanted, 1 + static_cast<int>(others.size()) / 2);
}

/// Tasks with a common wait.
class Helpers : public tbb::task_group {
 public:
  /// Runs a task, or does nothing if there is no memory for it. oneTBB counts a task before it
  /// makes it: a task that could not be made would be waited for forever.
  template <class Work, class Group = Helpers>
  bool add(const Work& work) {
    try {
      run(work);
      return true;
    } catch (const std::bad_alloc&) {
      // Later versions of oneTBB do not have this member, and count the existing tasks.
      if constexpr (requires(Group & group) { group.m_wait_ctx.release(); }) {
        static_cast<Group*>(this)->m_wait_ctx.release();
      }
      return false;
    }
  }
};

class TbbExecutor final : public Executor {
 public:
  // The control lets an arena have more threads than cores: tests use 8 on 2 cores. The smallest of
  // several controls applies to all arenas: each executor sets the same.
  explicit TbbExecutor(int thread_count)
      : parallelism_(tbb::global_control::max_allowed_parallelism, limits::kThreads),
        arena_(thread_count) {
    start_threads();
  }

  /// Helpers take items one by one. Only the calling thread makes oneTBB allocate memory: a thread
  /// of the pool cannot pass an exception on, and would end the process.
  void run(std::size_t task_count, FunctionRef<void(std::size_t)> task) override {
    std::atomic<std::size_t> next{0};
    run_everywhere(std::min(task_count, static_cast<std::size_t>(thread_count())), [&] {
      for (std::size_t i = next++; i < task_count; i = next++) task(i);
    });
  }

  int thread_count() const override { return arena_.max_concurrency(); }

 private:
  /// Calls work() in this thread, and in free other threads up to a total of `count`.
  template <class Work>
  void run_everywhere(std::size_t count, const Work& work) {
    arena_.execute([&] {
      Helpers helpers;
      for (std::size_t i = 1; i < count && helpers.add(work); ++i) continue;
      work();
      helpers.wait();
    });
  }

  /// Starts the threads now, while the system allows them: later, memory may be short.
  void start_threads() {
    const Stopwatch watch;
    const int wanted = thread_count();
    const double most_seconds = kStartSeconds + kStartSecondsPerThread * wanted;
    std::atomic<int> started{0};
    run_everywhere(static_cast<std::size_t>(wanted), [&] {
      ++started;
      while (started < wanted && watch.seconds() < most_seconds) std::this_thread::yield();
    });
  }

  tbb::global_control parallelism_;
  tbb::task_arena arena_;
};

}  // namespace

std::unique_ptr<Executor> make_tbb_executor(int thread_count) {
  if (thread_count <= 0) thread_count = tbb::info::default_concurrency();
  thread_count = std::min(thread_count, limits::kThreads);
  try {
    // A single thread does not need oneTBB, which may wait forever where its own start lacks
    // memory.
    const int allowed = allowed_threads(thread_count);
    return allowed == 1 ? nullptr : std::make_unique<TbbExecutor>(allowed);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace sfumato
