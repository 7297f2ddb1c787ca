#include "hostile/crew.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <exception>
#include <new>
#include <optional>

#include "hostile/pace.hpp"
#include "hostile/verdict.hpp"

namespace sfumato::hostile {
namespace {

/// Memory shared by this process and its children.
template <class T>
class Shared {
 public:
  explicit Shared(std::size_t count) : bytes_(sizeof(T) * count) {
    void* memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    data_ = static_cast<T*>(memory);
  }
  ~Shared() { munmap(data_, bytes_); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  T& operator[](std::size_t i) const { return data_[i]; }

 private:
  std::size_t bytes_;
  T* data_ = nullptr;
};

void note(Result& result, const std::string& complaint) {
  const std::size_t length = std::min(complaint.size(), sizeof(result.complaint) - 1);
  std::memcpy(result.complaint, complaint.data(), length);
  result.complaint[length] = '\0';
}

/// Limit for the runs of a case that takes too long; other work of the machine only lengthens a
/// run.
constexpr int kMostRuns = 3;

/// One run of a case.
struct Run {
  std::vector<std::string> before, after;  ///< names in its folder
  Ended ended;
};

/// Returns nothing if the case's files cannot be made.
std::optional<Run> run_once(const Case& attack, const std::string& binary) {
  const Sandbox sandbox;
  if (!sandbox.prepare(attack)) return std::nullopt;
  Run run;
  run.before = sandbox.names();
  run.ended = sandbox.run(binary, attack.arguments, attack.input);
  run.after = sandbox.names();
  return run;
}

/// Records the faults of a run. Returns false if its only fault is the time.
bool judge(const Case& attack, const Run& run, double granted_seconds, Result& result) {
  result.exit_code = run.ended.exit_code;
  result.cpu_seconds = run.ended.cpu_seconds;
  result.peak_bytes = run.ended.peak_bytes;
  const std::string found = complaint(attack, run.ended, run.before, run.after, granted_seconds);
  note(result, found);
  return run.ended.cpu_seconds <= granted_seconds ||
         found != complaint_of_cost(run.ended, granted_seconds);
}

void run_one(const Case& attack, const std::string& binary, Pace& pace, Result& result) {
  for (int i = 0; i < kMostRuns; ++i) {
    const std::optional<Run> run = run_once(attack, binary);
    if (!run) return note(result, "its files cannot be made");
    if (judge(attack, *run, pace.granted_seconds(run->ended.cpu_seconds), result)) return;
  }
}

/// Runs jobs from the next one on, until none are left.
void work(const std::vector<Job>& jobs, const std::string& binary, std::atomic<std::size_t>& next,
          const Shared<Result>& results) {
  Pace pace(binary);
  for (std::size_t k = next++; k < jobs.size(); k = next++) {
    try {
      run_one(*jobs[k].attack, binary, pace, results[k]);
    } catch (const std::exception& error) {
      note(results[k], error.what());
    }
  }
}

}  // namespace

std::vector<Result> run_all(const std::vector<Job>& jobs, const std::string& binary,
                            int worker_count) {
  const Shared<Result> results(jobs.size() + 1);
  const Shared<std::atomic<std::size_t>> next(1);
  for (std::size_t i = 0; i < jobs.size(); ++i) note(results[i], "was not run");
  std::vector<pid_t> workers;
  for (int i = 0; i < worker_count; ++i) {
    const pid_t id = fork();
    if (id == 0) {
      work(jobs, binary, next[0], results);
      _exit(0);
    }
    workers.push_back(id);
  }
  for (const pid_t id : workers) waitpid(id, nullptr, 0);
  std::vector<Result> all;
  for (std::size_t i = 0; i < jobs.size(); ++i) all.push_back(results[i]);
  return all;
}

}  // namespace sfumato::hostile
