#include "sfumato/base/native/file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string_view>
#include <thread>
#include <vector>

#include "base/bytes_of.hpp"
#include "base/native/atomic_file.hpp"
#include "base/stopwatch.hpp"
#include "sfumato/base/context.hpp"
#include "support/temporary_folder.hpp"

namespace sfumato {
namespace {

using test::bytes_of;

std::string content_of(const std::string& path) {
  const Result<std::string> content = read_file(path, 1 << 28);
  EXPECT_TRUE(content.ok()) << to_string(content.status());
  return content ? *content : std::string();
}

unsigned mode_of(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

/// Runs `body` in a separate process. Returns its exit status, or minus the signal that ended it.
template <class Body>
int in_a_child(Body body) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body());
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

class File : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(File, what_is_written_is_read) {
  const std::string path = folder_.file("a.bin");
  const std::string content("a\0b\xff\n", 5);
  ASSERT_TRUE(write_file(path, bytes_of(content)).ok());
  EXPECT_EQ(content_of(path), content);
  EXPECT_EQ(folder_.entry_count(), 1u);
}

TEST_F(File, empty_file_is_written_and_read) {
  ASSERT_TRUE(write_file(folder_.file("a"), {}).ok());
  EXPECT_EQ(content_of(folder_.file("a")), "");
}

TEST_F(File, long_file_is_written_and_read) {
  const std::string content(3'000'001, 'x');
  ASSERT_TRUE(write_file(folder_.file("a"), bytes_of(content)).ok());
  EXPECT_EQ(content_of(folder_.file("a")), content);
}

TEST_F(File, reading_takes_as_many_bytes_as_the_limit_and_no_more) {
  const std::string path = folder_.file("a");
  ASSERT_TRUE(write_file(path, bytes_of("12345")).ok());
  EXPECT_TRUE(read_file(path, 5).ok());
  const Status status = read_file(path, 4).status();
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status), path + ": is longer than the limit of 4 bytes");
}

TEST_F(File, endless_device_is_read_up_to_the_limit) {
  EXPECT_EQ(read_file("/dev/zero", 100'000).status().code, StatusCode::limit);
}

TEST_F(File, missing_file_cannot_be_read) {
  const Status status = read_file(folder_.file("none"), 100).status();
  EXPECT_EQ(status.code, StatusCode::io);
  EXPECT_EQ(to_string(status),
            folder_.file("none") + ": cannot be read: No such file or directory");
}

TEST_F(File, folder_can_be_neither_read_nor_written) {
  EXPECT_EQ(read_file(folder_.path(), 100).status().code, StatusCode::io);
  EXPECT_EQ(write_file(folder_.path(), bytes_of("a")).code, StatusCode::io);
  EXPECT_EQ(write_file(folder_.path() + "/", bytes_of("a")).code, StatusCode::io);
  EXPECT_EQ(folder_.entry_count(), 0u);
}

TEST_F(File, folder_that_does_not_exist_is_an_error) {
  const Status status = write_file(folder_.file("none/a.png"), bytes_of("a"));
  EXPECT_EQ(status.code, StatusCode::io);
  EXPECT_EQ(to_string(status),
            folder_.file("none/a.png") + ": cannot be written: No such file or directory");
  EXPECT_EQ(write_file(folder_.file("none/"), bytes_of("a")).code, StatusCode::io);
  EXPECT_EQ(write_file("", bytes_of("a")).code, StatusCode::io);
}

TEST_F(File, file_used_as_a_folder_is_an_error) {
  ASSERT_TRUE(write_file(folder_.file("a"), {}).ok());
  EXPECT_EQ(write_file(folder_.file("a/b"), bytes_of("a")).code, StatusCode::io);
}

TEST_F(File, existing_file_is_replaced_and_keeps_its_mode) {
  const std::string path = folder_.file("a");
  ASSERT_TRUE(write_file(path, bytes_of("old and longer")).ok());
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  ASSERT_TRUE(write_file(path, bytes_of("new")).ok());
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(mode_of(path), 0640u);
}

TEST_F(File, new_file_has_the_mode_of_the_umask) {
  const mode_t before = ::umask(027);
  ASSERT_TRUE(write_file(folder_.file("a"), {}).ok());
  ::umask(before);
  EXPECT_EQ(mode_of(folder_.file("a")), 0640u);
}

TEST_F(File, symbolic_link_is_followed_and_stays) {
  std::filesystem::create_directory(folder_.file("sub"));
  ASSERT_TRUE(write_file(folder_.file("sub/a"), bytes_of("old")).ok());
  std::filesystem::create_symlink("sub/a", folder_.file("link"));
  std::filesystem::create_symlink("link", folder_.file("link_to_link"));
  ASSERT_TRUE(write_file(folder_.file("link_to_link"), bytes_of("new")).ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.file("link")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.file("link_to_link")));
  EXPECT_EQ(content_of(folder_.file("sub/a")), "new");
}

TEST_F(File, symbolic_link_to_nothing_makes_the_file_it_names) {
  std::filesystem::create_symlink("b", folder_.file("link"));
  ASSERT_TRUE(write_file(folder_.file("link"), bytes_of("new")).ok());
  EXPECT_EQ(content_of(folder_.file("b")), "new");
}

TEST_F(File, symbolic_link_to_itself_is_an_error) {
  std::filesystem::create_symlink("loop", folder_.file("loop"));
  EXPECT_EQ(write_file(folder_.file("loop"), bytes_of("a")).code, StatusCode::io);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.file("loop")));
}

TEST_F(File, device_is_written_in_place) {
  EXPECT_TRUE(write_file("/dev/null", bytes_of("a")).ok());
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(File, full_device_is_an_error) {
  const Status status = write_file("/dev/full", bytes_of("a"));
  EXPECT_EQ(status.code, StatusCode::io);
  EXPECT_EQ(to_string(status), "/dev/full: cannot be written: No space left on device");
}

TEST_F(File, disk_that_is_full_leaves_the_old_file_and_nothing_else) {
  const std::string path = folder_.file("a");
  ASSERT_TRUE(write_file(path, bytes_of("old")).ok());
  const int status = in_a_child([&] {
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    return write_file(path, bytes_of(std::string(100'000, 'x'))).code == StatusCode::io ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(folder_.entry_count(), 1u);
}

/// Calls body as a user who owns nothing here, because root would be allowed everything.
template <class Body>
int as_a_stranger(Body body) {
  return in_a_child([&] {
    if (::geteuid() == 0 && ::setuid(65534) != 0) return 2;
    return body();
  });
}

TEST_F(File, folder_without_permission_is_an_error) {
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0555), 0);
  const int status = as_a_stranger(
      [&] { return write_file(folder_.file("a"), bytes_of("a")).code == StatusCode::io ? 0 : 1; });
  EXPECT_EQ(status, 0);
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0755), 0);
  EXPECT_EQ(folder_.entry_count(), 0u);
}

TEST_F(File, file_that_may_not_be_written_is_not_replaced) {
  const std::string path = folder_.file("a");
  ASSERT_TRUE(write_file(path, bytes_of("old")).ok());
  ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0777), 0);
  const int status = as_a_stranger(
      [&] { return write_file(path, bytes_of("new")).code == StatusCode::io ? 0 : 1; });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(content_of(path), "old");
}

TEST_F(File, longest_file_name_can_be_written) {
  const std::string path = folder_.file(std::string(255, 'n'));
  ASSERT_TRUE(write_file(path, bytes_of("a")).ok());
  EXPECT_EQ(content_of(path), "a");
}

TEST_F(File, what_a_killed_process_left_is_removed_by_the_next) {
  const std::string path = folder_.file("a");
  const int status = in_a_child([&] {
    AtomicFile file(path);
    if (!file.open(std::nullopt).ok() || !file.write(bytes_of("half")).ok()) return 1;
    return ::raise(SIGKILL);
  });
  ASSERT_EQ(status, -SIGKILL);
  ASSERT_EQ(folder_.entry_count(), 1u);
  EXPECT_FALSE(std::filesystem::exists(path));
  ASSERT_TRUE(write_file(path, bytes_of("whole")).ok());
  EXPECT_EQ(content_of(path), "whole");
  EXPECT_EQ(folder_.entry_count(), 1u);
}

TEST_F(File, what_a_living_process_writes_is_left_alone) {
  const std::string path = folder_.file("a");
  AtomicFile first(path);
  ASSERT_TRUE(first.open(std::nullopt).ok());
  ASSERT_TRUE(first.write(bytes_of("first")).ok());
  ASSERT_TRUE(write_file(path, bytes_of("second")).ok());
  EXPECT_EQ(content_of(path), "second");
  ASSERT_TRUE(first.commit().ok());
  EXPECT_EQ(content_of(path), "first");
  EXPECT_EQ(folder_.entry_count(), 1u);
}

TEST_F(File, file_that_is_not_committed_vanishes) {
  {
    AtomicFile file(folder_.file("a"));
    ASSERT_TRUE(file.open(std::nullopt).ok());
    EXPECT_EQ(folder_.entry_count(), 1u);
  }
  EXPECT_EQ(folder_.entry_count(), 0u);
}

TEST_F(File, many_writers_of_one_name_leave_one_whole_file) {
  const std::string path = folder_.file("a");
  std::vector<std::thread> writers;
  for (char letter = 'a'; letter < 'g'; ++letter) {
    writers.emplace_back([&path, letter] {
      const std::string content(100'000, letter);
      for (int i = 0; i < 20; ++i) EXPECT_TRUE(write_file(path, bytes_of(content)).ok());
    });
  }
  for (std::thread& writer : writers) writer.join();
  const std::string content = content_of(path);
  EXPECT_EQ(content, std::string(100'000, content.at(0)));
  EXPECT_EQ(folder_.entry_count(), 1u);
}

TEST_F(File, names_of_the_temporary_that_folders_have_are_no_other_writer) {
  for (int slot = 0; slot < 8; ++slot) {
    std::filesystem::create_directory(folder_.file(".sfumato-a." + std::to_string(slot) + ".tmp"));
  }
  const Status status = write_file(folder_.file("a"), bytes_of("a"));
  EXPECT_EQ(status.code, StatusCode::io);
  EXPECT_EQ(status.message.find("processes"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find(".sfumato-a.0.tmp"), std::string::npos) << status.message;
}

TEST(StandardOutput, closed_reader_is_an_error_and_no_signal) {
  const int status = in_a_child([] {
    int ends[2];
    if (::pipe(ends) != 0 || ::dup2(ends[1], STDOUT_FILENO) < 0) return 2;
    ::close(ends[0]);
    ::close(ends[1]);
    return write_file("-", bytes_of("a")).code == StatusCode::io ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
}

TEST(StandardOutput, closed_descriptor_is_an_error) {
  const int status = in_a_child([] {
    ::close(STDOUT_FILENO);
    const Status written = write_file("-", bytes_of("a"));
    return to_string(written) == "standard output: cannot be written: Bad file descriptor" ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
}

TEST_F(File, is_never_opened_as_a_closed_standard_stream) {
  const std::string path = folder_.file("a");
  const int status = in_a_child([&] {
    ::close(STDOUT_FILENO);
    AtomicFile file(path);
    if (!file.open(std::nullopt).ok()) return 2;
    return ::fcntl(STDOUT_FILENO, F_GETFD) == -1 ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
}

TEST(StandardOutput, takes_all_bytes_through_a_narrow_pipe) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string content(1'000'000, 'x');
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::_exit(write_file("-", bytes_of(content)).ok() ? 0 : 1);
  }
  ::close(ends[1]);
  std::string received(2'000'000, '\0');
  std::size_t size = 0;
  while (const ssize_t count = ::read(ends[0], received.data() + size, received.size() - size)) {
    ASSERT_GT(count, 0);
    size += static_cast<std::size_t>(count);
  }
  received.resize(size);
  EXPECT_EQ(received, content);
  int status = 1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  ::close(ends[0]);
}

TEST(StandardOutput, takes_all_bytes_through_a_pipe_that_does_not_block) {
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
  const std::string content(1'000'000, 'x');
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::_exit(write_file("-", bytes_of(content)).ok() ? 0 : 1);
  }
  ::close(ends[1]);
  ::dup2(ends[0], STDIN_FILENO);
  ::close(ends[0]);
  ::usleep(20'000);  // the pipe is full, then empty
  const Result<std::string> received = read_file("-", 2'000'000);
  int status = 1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  ASSERT_TRUE(received.ok()) << to_string(received.status());
  EXPECT_EQ(*received, content);
}

TEST(StandardInput, is_read_to_its_end) {
  const int status = in_a_child([] {
    int ends[2];
    if (::pipe(ends) != 0 || ::write(ends[1], "abc", 3) != 3) return 2;
    ::close(ends[1]);
    ::dup2(ends[0], STDIN_FILENO);
    const Result<std::string> content = read_file("-", 10);
    return content.ok() && *content == "abc" ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
}

/// A FIFO that no other process has open.
class Fifo : public File {
 protected:
  void SetUp() override { ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0); }

  const std::string path_ = folder_.file("fifo");
};

/// A busy machine lengthens some waits, but hardly five in a row.
TEST_F(Fifo, without_a_writer_is_waited_for_until_the_deadline) {
  constexpr double kSeconds = 0.1;
  constexpr double kMostWait = 20 * kSeconds;
  double waited = kMostWait;
  for (int i = 0; i < 5 && waited >= kMostWait; ++i) {
    const Stopwatch watch;
    const Context context{.deadline = Deadline::in(kSeconds)};
    EXPECT_EQ(read_file(path_, 100, &context).status().code, StatusCode::limit);
    waited = watch.seconds();
    EXPECT_GE(waited, kSeconds);
  }
  EXPECT_LT(waited, kMostWait);
}

TEST_F(Fifo, without_a_reader_is_waited_for_until_the_deadline) {
  const Context context{.deadline = Deadline::in(0.1)};
  EXPECT_EQ(write_file(path_, bytes_of("a"), &context).code, StatusCode::limit);
}

TEST_F(Fifo, that_gives_no_end_is_waited_for_until_the_work_is_cancelled) {
  Context context;
  const int writer = ::open(path_.c_str(), O_RDWR);
  ASSERT_EQ(::write(writer, "abc", 3), 3);
  std::thread other([&] {
    ::usleep(50'000);
    context.cancel = true;
  });
  EXPECT_EQ(read_file(path_, 100, &context).status().code, StatusCode::cancelled);
  other.join();
  ::close(writer);
}

TEST_F(Fifo, that_nobody_empties_is_waited_for_until_the_deadline) {
  const int reader = ::open(path_.c_str(), O_RDWR);
  const Context context{.deadline = Deadline::in(0.1)};
  const std::string large(1'000'000, 'x');
  EXPECT_EQ(write_file(path_, bytes_of(large), &context).code, StatusCode::limit);
  ::close(reader);
}

TEST_F(Fifo, hands_on_all_bytes_whoever_comes_first) {
  const std::string content(300'000, 'x');
  for (const int writer_waits : {0, 30'000}) {
    for (const int reader_waits : {0, 60'000}) {
      const Context context{.deadline = Deadline::in(600)};
      std::thread writer([&] {
        ::usleep(static_cast<useconds_t>(writer_waits));
        EXPECT_TRUE(write_file(path_, bytes_of(content), &context).ok());
      });
      ::usleep(static_cast<useconds_t>(reader_waits));
      const Result<std::string> received = read_file(path_, 1'000'000, &context);
      writer.join();
      ASSERT_TRUE(received.ok()) << to_string(received.status());
      EXPECT_EQ(*received, content);
    }
  }
}

TEST_F(Fifo, that_is_closed_unwritten_is_empty) {
  std::thread writer([&] {
    ::usleep(20'000);
    ::close(::open(path_.c_str(), O_WRONLY));
  });
  const Result<std::string> received = read_file(path_, 100);
  writer.join();
  ASSERT_TRUE(received.ok());
  EXPECT_EQ(*received, "");
}

TEST(StandardStreams, are_waited_for_until_the_deadline) {
  const int status = in_a_child([] {
    int ends[2];
    if (::pipe(ends) != 0) return 2;
    ::dup2(ends[0], STDIN_FILENO);
    ::dup2(ends[1], STDOUT_FILENO);
    const Context reading{.deadline = Deadline::in(0.1)};
    if (read_file("-", 10, &reading).status().code != StatusCode::limit) return 3;
    const Context writing{.deadline = Deadline::in(0.1)};
    const std::string large(1'000'000, 'x');
    return write_file("-", bytes_of(large), &writing).code == StatusCode::limit ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace sfumato
