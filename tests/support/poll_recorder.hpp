#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <functional>

#include "base/poll.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::test {

/// Returns the CPU time of the calling thread, so that other work on the machine does not count.
inline double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Measures how long the only working thread runs without a poll of the cancel flag.
class PollRecorder : public PollWatch {
 public:
  /// Called after every gap longer than all earlier ones, at the place of its end.
  std::function<void(double seconds)> on_longest;
  /// The flag is set after this poll; 0: never.
  std::uint64_t cancel_at = 0;
  CancelFlag* cancel = nullptr;

  void start() { last_ = thread_seconds(); }

  void polled() override {
    end_gap();
    last_ = thread_seconds();
    if (++polls_ != cancel_at) return;
    cancel->store(true);
    cancelled_at_ = last_;
  }

  /// Ends the last gap: the work is done.
  void stop() { end_gap(); }

  double longest_seconds() const { return longest_; }
  std::uint64_t polls() const { return polls_; }
  /// Returns the CPU time of the thread when the flag was set.
  double cancelled_at() const { return cancelled_at_; }

 private:
  void end_gap() {
    const double gap = thread_seconds() - last_;
    if (gap <= longest_) return;
    longest_ = gap;
    if (on_longest) on_longest(gap);
  }

  double last_ = 0;
  double longest_ = 0;
  double cancelled_at_ = 0;
  std::uint64_t polls_ = 0;
};

}  // namespace sfumato::test
