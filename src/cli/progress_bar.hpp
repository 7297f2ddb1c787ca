#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"

namespace sfumato::cli {

/// Returns a line that shows the progress: "gather       [#########           ]  45%".
std::string progress_line(std::string_view stage, double fraction);

/// Redraws progress_line on one line of a terminal, at most ten times a second, beginning `delay`
/// after its construction. The destructor erases the line. Reports may come from any thread.
class ProgressBar : public Progress {
 public:
  ProgressBar(std::FILE* terminal, std::chrono::milliseconds delay);
  ~ProgressBar() override;

  void report(std::string_view stage, double fraction) override;

  /// Makes the bar show how many of `count` jobs are done, at present `index`. If count is 1 it
  /// shows the progress of the stage. Must not be called while another thread reports.
  void set_job(std::size_t index, std::size_t count);

  /// Sets the text after the bar: "27.6 dB". Any thread may call this.
  void set_note(std::string note);

  /// Erases the line until the next report, so that a message can be printed.
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  std::mutex mutex_;  ///< guards all members below; a thread that finds it locked does not wait
  std::FILE* terminal_;
  Clock::time_point next_drawing_;
  std::size_t drawn_length_ = 0;
  std::string note_;
  std::size_t job_index_ = 0;
  std::size_t job_count_ = 1;
};

}  // namespace sfumato::cli
