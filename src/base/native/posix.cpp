#include "base/native/posix.hpp"

#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <pthread.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "sfumato/base/context.hpp"

namespace sfumato {
namespace {

constexpr int kFirstFreeDescriptor = 3;
constexpr int kGuardedSignals[] = {SIGPIPE, SIGXFSZ};

/// Some systems refuse larger writes.
constexpr std::size_t kWriteBytes = std::size_t{1} << 30;

/// The interval between two polls of a context during a wait.
constexpr int kWaitMilliseconds = 20;

int above_standard_streams(int descriptor) {
  if (descriptor < 0 || descriptor >= kFirstFreeDescriptor) return descriptor;
  const int moved = ::fcntl(descriptor, F_DUPFD_CLOEXEC, kFirstFreeDescriptor);
  const int error_number = errno;
  ::close(descriptor);
  errno = error_number;
  return moved;
}

bool is_regular(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/// Polls the context. Returns false, with ECANCELED, if it is cancelled.
bool goes_on(const Context* context) {
  if (!context || !context->cancelled()) return true;
  errno = ECANCELED;
  return false;
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

/// A FIFO opened without blocking is refused until a process reads it.
FileDescriptor open_device(const std::string& path, bool is_fifo, const Context* context) {
  while (true) {
    FileDescriptor file(path, O_WRONLY | O_NOCTTY | O_NONBLOCK);
    if (file.is_open() || !is_fifo || errno != ENXIO || !wait_a_moment(context)) return file;
  }
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
  // Consumes the signal that this write raised. Afterwards only signals are pending that were
  // pending before.
  const timespec no_wait{};
  while (::sigtimedwait(&guarded_, nullptr, &no_wait) > 0 || errno == EINTR) continue;
  ::pthread_sigmask(SIG_SETMASK, &previous_mask_, nullptr);
}

bool wait_until_ready(int descriptor, short event, const Context* context) {
  pollfd asked{descriptor, event, 0};
  int ready = 0;
  do {
    if (!goes_on(context)) return false;
    ready = ::poll(&asked, 1, context ? kWaitMilliseconds : -1);
  } while (ready == 0 || (ready < 0 && errno == EINTR));
  return ready > 0;
}

bool wait_a_moment(const Context* context) {
  ::poll(nullptr, 0, kWaitMilliseconds);
  return goes_on(context);
}

bool write_all(int descriptor, std::span<const std::uint8_t> bytes, const Context* context) {
  // A writable pipe accepts PIPE_BUF bytes without blocking.
  const bool may_block = context && !is_regular(descriptor);
  const std::size_t most = may_block ? std::size_t{PIPE_BUF} : kWriteBytes;
  while (!bytes.empty()) {
    if (may_block && !wait_until_ready(descriptor, POLLOUT, context)) return false;
    const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), most));
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR &&
               !(errno == EAGAIN && wait_until_ready(descriptor, POLLOUT, context))) {
      return false;
    }
  }
  return true;
}

Status io_error(const std::string& path, const char* what, int error_number,
                const Context* context) {
  if (context && error_number == ECANCELED) return context->cancel_status();
  return make_error(StatusCode::io,
                    std::string(what) + ": " + std::generic_category().message(error_number),
                    {path});
}

}  // namespace sfumato
