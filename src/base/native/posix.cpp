#include "base/native/posix.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace sfumato {
namespace {

constexpr int kFirstFreeDescriptor = 3;
constexpr int kGuardedSignals[] = {SIGPIPE, SIGXFSZ};

/// Some systems refuse larger writes.
constexpr std::size_t kWriteBytes = std::size_t{1} << 30;

int above_standard_streams(int descriptor) {
  if (descriptor < 0 || descriptor >= kFirstFreeDescriptor) return descriptor;
  const int moved = ::fcntl(descriptor, F_DUPFD_CLOEXEC, kFirstFreeDescriptor);
  const int error_number = errno;
  ::close(descriptor);
  errno = error_number;
  return moved;
}

}  // namespace

FileDescriptor::FileDescriptor(const std::string& path, int flags, unsigned mode) {
  do {
    number_ = ::open(path.c_str(), flags | O_CLOEXEC, mode);
  } while (number_ < 0 && errno == EINTR);
  number_ = above_standard_streams(number_);
}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

FileDescriptor::~FileDescriptor() {
  if (is_open()) ::close(number_);
}

int FileDescriptor::release() {
  return std::exchange(number_, -1);
}

bool FileDescriptor::close() {
  // Linux closes the descriptor even where it reports EINTR.
  return ::close(release()) == 0 || errno == EINTR;
}

WriteSignalGuard::WriteSignalGuard() {
  sigset_t pending;
  ::sigpending(&pending);
  ::sigemptyset(&guarded_);
  for (const int signal_number : kGuardedSignals) {
    if (!::sigismember(&pending, signal_number)) ::sigaddset(&guarded_, signal_number);
  }
  ::pthread_sigmask(SIG_BLOCK, &guarded_, &previous_mask_);
}

WriteSignalGuard::~WriteSignalGuard() {
  // What a write of ours raised is taken away; then nothing is pending that was not before.
  const timespec no_wait{};
  while (::sigtimedwait(&guarded_, nullptr, &no_wait) > 0 || errno == EINTR) continue;
  ::pthread_sigmask(SIG_SETMASK, &previous_mask_, nullptr);
}

bool wait_until_ready(int descriptor, short event) {
  pollfd asked{descriptor, event, 0};
  int ready = 0;
  do {
    ready = ::poll(&asked, 1, -1);
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

bool write_all(int descriptor, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), kWriteBytes));
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR && !(errno == EAGAIN && wait_until_ready(descriptor, POLLOUT))) {
      return false;
    }
  }
  return true;
}

Status io_error(const std::string& path, const char* what, int error_number) {
  return make_error(StatusCode::io,
                    std::string(what) + ": " + std::generic_category().message(error_number),
                    {path});
}

}  // namespace sfumato
