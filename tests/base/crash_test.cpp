// write_file under kill -9 and under system errors: the complete old file or the complete new one
// remains, and nothing else after a successful run.
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <random>
#include <set>
#include <string>

#include "base/traced_child.hpp"
#include "sfumato/base/native/file.hpp"
#include "support/temporary_folder.hpp"

namespace sfumato {
namespace {

using test::Mishap;
using test::run_traced;
using test::TracedEnd;

constexpr int kWritten = 0;
constexpr int kRefused = 1;
constexpr int kOtherError = 2;

Status write_text(const std::string& path, const std::string& text) {
  return write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// A file of 100,000 bytes that is written repeatedly, over nothing or over an old file.
class Crash : public testing::TestWithParam<bool> {
 protected:
  /// Restores the state before a run.
  void lay_out() {
    std::filesystem::remove_all(folder_.path());
    std::filesystem::create_directory(folder_.path());
    if (GetParam()) {
      ASSERT_TRUE(write_text(path_, old_).ok());
    }
  }

  int write_new() const {
    const Status status = write_text(path_, new_);
    return status ? kWritten : status.code == StatusCode::io ? kRefused : kOtherError;
  }

  TracedEnd run(const Mishap& mishap) {
    const auto end = run_traced([this] { return write_new(); }, mishap);
    return end ? *end : TracedEnd{};
  }

  bool can_trace() {
    lay_out();
    return run_traced([this] { return write_new(); }, {}).has_value();
  }

  bool is_new() const { return content() == new_; }
  bool is_old_or_new() const {
    const bool is_old = GetParam() ? content() == old_ : !std::filesystem::exists(path_);
    return is_old || is_new();
  }

  /// The next run leaves only the file in its folder.
  void expect_next_run_cleans_up(const std::string& what) {
    ASSERT_EQ(write_new(), kWritten) << what;
    ASSERT_TRUE(is_new()) << what;
    ASSERT_EQ(folder_.entry_count(), 1u) << what;
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("picture.png");
  std::string old_ = std::string(70'000, 'o');
  std::string new_ = std::string(100'000, 'n');

 private:
  std::string content() const {
    const Result<std::string> read = read_file(path_, 1 << 20);
    return read ? *read : std::string();
  }
};

INSTANTIATE_TEST_SUITE_P(Of, Crash, testing::Bool(), [](const auto& instance) {
  return instance.param ? "an_existing_name" : "a_new_name";
});

TEST_P(Crash, a_kill_at_every_system_call_leaves_a_whole_file) {
  if (!can_trace()) GTEST_SKIP() << "ptrace is not allowed here";
  std::size_t call = 0;
  for (TracedEnd end;; ++call) {
    lay_out();
    end = run({Mishap::Kind::kill, call});
    if (end.status != -SIGKILL) break;
    const std::string what =
        "call " + std::to_string(call) + ", number " + std::to_string(end.call);
    ASSERT_TRUE(is_old_or_new()) << what;
    ASSERT_LE(folder_.entry_count(), 2u) << what;
    expect_next_run_cleans_up(what);
  }
  EXPECT_GE(call, 10u) << "hardly anything was traced";
  RecordProperty("system_calls", static_cast<int>(call));
}

/// Returns whether the file cannot be written if this call fails with this error.
bool is_needed(long call, int error_number) {
  if (error_number == EINTR && call == SYS_write) return false;
  return call == SYS_write || call == SYS_fsync || call == SYS_rename;
}

TEST_P(Crash, an_error_of_any_system_call_is_told_and_leaves_a_whole_file) {
  if (!can_trace()) GTEST_SKIP() << "ptrace is not allowed here";
  std::set<long> needed;
  for (const int error_number : {EIO, ENOSPC, EDQUOT, EROFS, EACCES, EINTR, EMFILE}) {
    for (std::size_t call = 0;; ++call) {
      lay_out();
      const TracedEnd end = run({Mishap::Kind::error, call, error_number});
      if (end.call < 0) break;
      const std::string what = "call " + std::to_string(call) + ", number " +
                               std::to_string(end.call) + ", error " + std::to_string(error_number);
      ASSERT_TRUE(end.status == kWritten || end.status == kRefused) << what << ": " << end.status;
      ASSERT_TRUE(end.status == kWritten ? is_new() : is_old_or_new()) << what;
      if (is_needed(end.call, error_number)) {
        ASSERT_EQ(end.status, kRefused) << what;
        needed.insert(end.call);
      }
      expect_next_run_cleans_up(what);
    }
  }
  EXPECT_EQ(needed, (std::set<long>{SYS_write, SYS_fsync, SYS_rename}));
}

TEST_P(Crash, short_writes_are_gone_on_with) {
  if (!can_trace()) GTEST_SKIP() << "ptrace is not allowed here";
  std::size_t shortened = 0;
  for (std::size_t call = 0;; ++call) {
    lay_out();
    const TracedEnd end = run({Mishap::Kind::short_write, call});
    if (end.call < 0) break;
    shortened += end.call == SYS_write;
    ASSERT_EQ(end.status, kWritten);
    ASSERT_TRUE(is_new());
  }
  EXPECT_GE(shortened, 1u);
}

TEST_P(Crash, kills_at_random_times_leave_a_whole_file) {
  std::mt19937 random(1);
  for (int round = 0; round < 100; ++round) {
    lay_out();
    const pid_t child = ::fork();
    if (child == 0) {
      while (write_new() == kWritten) continue;
      ::_exit(kRefused);
    }
    ::usleep(std::uniform_int_distribution<useconds_t>(0, 3000)(random));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "writing failed";
    ASSERT_TRUE(is_old_or_new());
    ASSERT_LE(folder_.entry_count(), 2u);
    expect_next_run_cleans_up("round " + std::to_string(round));
  }
}

}  // namespace
}  // namespace sfumato
