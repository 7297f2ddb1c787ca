#include "sfumato/base/native/file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <utility>

#include "base/native/atomic_file.hpp"
#include "base/native/posix.hpp"
#include "base/no_throw.hpp"
#include "base/try.hpp"

namespace sfumato {
namespace {

constexpr int kLinkDepth = 40;
constexpr std::size_t kReadBytes = std::size_t{1} << 16;

Status too_long(const std::string& path, std::size_t max_bytes) {
  return make_error(StatusCode::limit,
                    "is longer than the limit of " + std::to_string(max_bytes) + " bytes", {path});
}

/// Reads to the end. Errors: io, limit, as Context::cancel_status().
template <class Bytes>
Result<Bytes> read_all(int descriptor, const std::string& path, std::size_t max_bytes,
                       const Context* context) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return io_error(path, "cannot be read", errno);
  Bytes content;
  const bool is_regular = S_ISREG(status.st_mode);
  if (is_regular && status.st_size > 0) {
    if (static_cast<std::uintmax_t>(status.st_size) > max_bytes) return too_long(path, max_bytes);
    content.reserve(static_cast<std::size_t>(status.st_size) + kReadBytes);
  }
  while (true) {
    // A pipe opened without blocking that has no writer yet would seem to be at its end.
    if (!is_regular && !wait_until_ready(descriptor, POLLIN, context)) {
      return io_error(path, "cannot be read", errno, context);
    }
    const std::size_t size = content.size();
    content.resize(std::max(size + kReadBytes, content.capacity()));
    const ssize_t count = ::read(descriptor, content.data() + size, content.size() - size);
    const int error_number = errno;
    content.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0 && error_number != EINTR && error_number != EAGAIN) {
      return io_error(path, "cannot be read", error_number);
    }
    if (content.size() > max_bytes) return too_long(path, max_bytes);
    if (count == 0) return content;
  }
}

Status write_in_place(int descriptor, const std::string& path, std::span<const std::uint8_t> bytes,
                      const Context* context) {
  const WriteSignalGuard guard;
  if (write_all(descriptor, bytes, context)) return ok_status();
  return io_error(path, "cannot be written", errno, context);
}

Status write_device(const std::string& path, bool is_fifo, std::span<const std::uint8_t> bytes,
                    const Context* context) {
  FileDescriptor file = open_device(path, is_fifo, context);
  if (!file.is_open()) return io_error(path, "cannot be written", errno, context);
  SFUMATO_TRY(write_in_place(file.number(), path, bytes, context));
  if (!file.close()) return io_error(path, "cannot be written", errno);
  return ok_status();
}

template <class Bytes>
Result<Bytes> read(const std::string& path, std::size_t max_bytes, const Context* context) {
  if (path == "-") return read_all<Bytes>(STDIN_FILENO, "standard input", max_bytes, context);
  // Without O_NONBLOCK this would wait for a writer of a FIFO, or for the carrier of a line.
  const FileDescriptor file(path, O_RDONLY | O_NOCTTY | O_NONBLOCK);
  if (!file.is_open()) return io_error(path, "cannot be read", errno);
  return read_all<Bytes>(file.number(), path, max_bytes, context);
}

Status write(const std::string& path, std::span<const std::uint8_t> bytes, const Context* context) {
  if (path == "-") return write_in_place(STDOUT_FILENO, "standard output", bytes, context);
  std::string target = without_links(path);
  struct stat existing {};
  const bool exists = ::stat(target.c_str(), &existing) == 0;
  if (!exists && errno != ENOENT) return io_error(path, "cannot be written", errno);
  if (exists && S_ISDIR(existing.st_mode)) return io_error(path, "cannot be written", EISDIR);
  if (exists && !S_ISREG(existing.st_mode)) {
    return write_device(target, S_ISFIFO(existing.st_mode), bytes, context);
  }
  // Renaming over a file does not check whether the file is writable, so this does.
  if (exists && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
    return io_error(path, "cannot be written", errno);
  }
  AtomicFile file(std::move(target));
  SFUMATO_TRY(file.open(exists ? std::optional<unsigned>(existing.st_mode) : std::nullopt));
  SFUMATO_TRY(file.write(bytes));
  return file.commit();
}

}  // namespace

std::string without_links(std::string path) {
  for (int depth = 0; depth < kLinkDepth; ++depth) {
    std::string target(4096, '\0');
    const ssize_t size = ::readlink(path.c_str(), target.data(), target.size());
    if (size < 0) break;  // no link
    target.resize(static_cast<std::size_t>(size));
    const std::size_t slash = path.rfind('/');
    if (!target.starts_with('/') && slash != std::string::npos) {
      target.insert(0, path, 0, slash + 1);
    }
    path = std::move(target);
  }
  return path;
}

Result<std::string> read_file(const std::string& path, std::size_t max_bytes,
                              const Context* context) {
  return no_throw([&] { return read<std::string>(path, max_bytes, context); });
}

Result<std::vector<std::uint8_t>> read_bytes(const std::string& path, std::size_t max_bytes,
                                             const Context* context) {
  return no_throw([&] { return read<std::vector<std::uint8_t>>(path, max_bytes, context); });
}

Status write_file(const std::string& path, std::span<const std::uint8_t> bytes,
                  const Context* context) {
  return no_throw([&] { return write(path, bytes, context); });
}

}  // namespace sfumato
