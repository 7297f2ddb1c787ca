#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"

namespace sfumato::cli {

/// One line that says how far the work is: "gather       [#########           ]  45%".
std::string progress_line(std::string_view stage, double fraction);

/// Draws progress_line over and over on one line of a terminal, at most ten times a second, from
/// `delay` after it was made; takes the line away when it ends. Reports come from any thread.
class ProgressBar : public Progress {
 public:
  ProgressBar(std::FILE* terminal, std::chrono::milliseconds delay);
  ~ProgressBar() override;

  void report(std::string_view stage, double fraction) override;

  /// From now on the bar says how many of `count` jobs are done, and `index` of them are; 1: how
  /// far the stage is. Not while another thread reports.
  void set_job(std::size_t index, std::size_t count);

  /// Takes the line away, so that a message can stand there, until the next report.
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  std::mutex mutex_;  ///< guards all below; a thread that finds it taken goes on without drawing
  std::FILE* terminal_;
  Clock::time_point next_drawing_;
  std::size_t drawn_length_ = 0;
  std::size_t job_index_ = 0;
  std::size_t job_count_ = 1;
};

}  // namespace sfumato::cli
