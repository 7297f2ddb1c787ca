#include "hostile/crew.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

#include "hostile/pace.hpp"
#include "hostile/verdict.hpp"

namespace sfumato::hostile {
namespace {

/// Memory that this process and those that it starts see alike.
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

/// How often a case may run that takes too long: what else the machine does only lengthens a run.
constexpr int kMostRuns = 3;

/// False where the case took too long, and nothing else is wrong.
bool run_once(const Case& attack, const std::string& binary, double slowness, Result& result) {
  const Sandbox sandbox;
  if (!sandbox.prepare(attack)) {
    note(result, "its files cannot be made");
    return true;
  }
  const std::vector<std::string> before = sandbox.names();
  const Ended ended = sandbox.run(binary, attack.arguments, attack.input);
  result.exit_code = ended.exit_code;
  result.cpu_seconds = ended.cpu_seconds;
  result.peak_bytes = ended.peak_bytes;
  const std::string found = complaint(attack, ended, before, sandbox.names(), slowness);
  note(result, found);
  return ended.cpu_seconds <= slowness * kMostSeconds ||
         found != complaint_of_cost(ended, slowness);
}

/// The machine is measured only where a case took too long for a quiet one.
void run_one(const Case& attack, const std::string& binary, Result& result) {
  if (run_once(attack, binary, 1, result)) return;
  for (int i = 1; i < kMostRuns; ++i) {
    if (run_once(attack, binary, slowness(), result)) return;
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
      for (std::size_t k = next[0]++; k < jobs.size(); k = next[0]++) {
        try {
          run_one(*jobs[k].attack, binary, results[k]);
        } catch (const std::exception& error) {
          note(results[k], error.what());
        }
      }
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
