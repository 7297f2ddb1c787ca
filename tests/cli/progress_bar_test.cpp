#include "cli/progress_bar.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

namespace sfumato::cli {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;

std::string all_of(std::FILE* file) {
  std::string text(4096, '\0');
  std::rewind(file);
  text.resize(std::fread(text.data(), 1, text.size(), file));
  return text;
}

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

TEST(ProgressLine, shows_stage_bar_and_percentage) {
  EXPECT_EQ(progress_line("gather", 0.5), "gather        [###############               ]  50%");
}

TEST(ProgressLine, has_one_length_whatever_it_is_told) {
  const std::size_t length = progress_line("", 0).size();
  EXPECT_EQ(progress_line("a stage with a very long name", 1).size(), length);
  EXPECT_EQ(progress_line("x", 7).size(), length);
  EXPECT_EQ(progress_line("x", -7).size(), length);
  EXPECT_EQ(progress_line("x", 0.0 / 0.0), progress_line("x", 0));
}

TEST(ProgressBar, draws_a_report_and_takes_it_away_at_the_end) {
  const File file(std::tmpfile());
  const std::string line = progress_line("gather", 0.25);
  { ProgressBar(file.get(), milliseconds(0)).report("gather", 0.25); }
  EXPECT_EQ(all_of(file.get()), "\r" + line + "\r" + std::string(line.size(), ' ') + "\r");
}

TEST(ProgressBar, of_many_jobs_says_how_many_are_done) {
  const File file(std::tmpfile());
  const std::string line = progress_line("2/4 gather", 0.25);
  {
    ProgressBar bar(file.get(), milliseconds(0));
    bar.set_job(1, 4);
    bar.report("gather", 0.9);
    bar.erase();
    bar.erase();
  }
  EXPECT_EQ(all_of(file.get()), "\r" + line + "\r" + std::string(line.size(), ' ') + "\r");
}

TEST(ProgressBar, note_stands_behind_the_bar_and_leaves_nothing_of_a_longer_one) {
  const File file(std::tmpfile());
  const std::string line = progress_line("trace", 0.25);
  {
    ProgressBar bar(file.get(), milliseconds(0));
    bar.set_note("100.0 dB");
    bar.report("trace", 0.25);
    bar.set_note("9.0 dB");
    std::this_thread::sleep_for(milliseconds(150));  // it redraws ten times a second
    bar.report("trace", 0.25);
  }
  EXPECT_EQ(all_of(file.get()), "\r" + line + "  100.0 dB\r" + line + "  9.0 dB  \r" +
                                    std::string(line.size() + 8, ' ') + "\r");
}

TEST(ProgressBar, draws_nothing_for_short_work) {
  const File file(std::tmpfile());
  { ProgressBar(file.get(), hours(1)).report("gather", 0.25); }
  EXPECT_EQ(all_of(file.get()), "");
}

TEST(ProgressBar, writes_whole_lines_from_many_threads) {
  const File file(std::tmpfile());
  const std::string line = progress_line("gather", 0.5);
  {
    ProgressBar bar(file.get(), milliseconds(0));
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&bar] {
        for (int k = 0; k < 1000; ++k) bar.report("gather", 0.5);
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  std::string text = all_of(file.get());
  ASSERT_TRUE(text.starts_with("\r" + line));
  while (text.starts_with("\r" + line)) text.erase(0, line.size() + 1);
  EXPECT_EQ(text, "\r" + std::string(line.size(), ' ') + "\r");
}

}  // namespace
}  // namespace sfumato::cli
