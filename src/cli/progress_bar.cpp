#include "cli/progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sfumato::cli {
namespace {

constexpr std::size_t kBarLength = 30;
constexpr std::size_t kStageLength = 14;
constexpr std::chrono::milliseconds kDrawingInterval{100};

}  // namespace

std::string progress_line(std::string_view stage, double fraction) {
  const double done = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
  const auto filled = static_cast<std::size_t>(done * kBarLength);
  std::string line(stage.substr(0, kStageLength));
  line.resize(kStageLength, ' ');
  line += '[' + std::string(filled, '#') + std::string(kBarLength - filled, ' ') + ']';
  char percent[8];
  std::snprintf(percent, sizeof percent, " %3d%%", static_cast<int>(done * 100));
  return line + percent;
}

ProgressBar::ProgressBar(std::FILE* terminal, std::chrono::milliseconds delay)
    : terminal_(terminal), next_drawing_(Clock::now() + delay) {}

ProgressBar::~ProgressBar() {
  erase();
}

void ProgressBar::erase() {
  const std::lock_guard lock(mutex_);
  if (drawn_length_ == 0) return;
  std::fprintf(terminal_, "\r%s\r", std::string(drawn_length_, ' ').c_str());
  std::fflush(terminal_);
  drawn_length_ = 0;
}

void ProgressBar::set_job(std::size_t index, std::size_t count) {
  job_index_ = index;
  job_count_ = count;
}

void ProgressBar::set_note(std::string note) {
  const std::lock_guard lock(mutex_);
  note_ = std::move(note);
}

void ProgressBar::report(std::string_view stage, double fraction) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock || Clock::now() < next_drawing_) return;
  std::string label(stage);
  if (job_count_ > 1) {
    label = std::to_string(job_index_ + 1) + '/' + std::to_string(job_count_) + ' ' + label;
    fraction = static_cast<double>(job_index_) / static_cast<double>(job_count_);
  }
  std::string line = progress_line(label, fraction);
  if (!note_.empty()) line += "  " + note_;
  const std::size_t length = line.size();
  line.resize(std::max(length, drawn_length_), ' ');  // over what a longer note has left
  std::fprintf(terminal_, "\r%s", line.c_str());
  std::fflush(terminal_);
  drawn_length_ = length;
  next_drawing_ = Clock::now() + kDrawingInterval;
}

}  // namespace sfumato::cli
