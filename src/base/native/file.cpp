#include "base/native/file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <utility>
#include <vector>

#include "base/native/atomic_file.hpp"
#include "base/native/posix.hpp"
#include "base/no_throw.hpp"

namespace sfumato {
namespace {

constexpr int kLinkDepth = 40;
constexpr std::size_t kReadBytes = std::size_t{1} << 16;

Status too_long(const std::string& path, std::size_t max_bytes) {
  return make_error(StatusCode::limit,
                    "is longer than the limit of " + std::to_string(max_bytes) + " bytes", {path});
}

/// Reads to the end. Errors: io, limit.
template <class Bytes>
Result<Bytes> read_all(int descriptor, const std::string& path, std::size_t max_bytes) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return io_error(path, "cannot be read", errno);
  Bytes content;
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    if (static_cast<std::uintmax_t>(status.st_size) > max_bytes) return too_long(path, max_bytes);
    content.reserve(static_cast<std::size_t>(status.st_size) + kReadBytes);
  }
  while (true) {
    const std::size_t size = content.size();
    content.resize(std::max(size + kReadBytes, content.capacity()));
    const ssize_t count = ::read(descriptor, content.data() + size, content.size() - size);
    const int error_number = errno;
    content.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0 && error_number != EINTR &&
        !(error_number == EAGAIN && wait_until_ready(descriptor, POLLIN))) {
      return io_error(path, "cannot be read", error_number);
    }
    if (content.size() > max_bytes) return too_long(path, max_bytes);
    if (count == 0) return content;
  }
}

/// The path behind symbolic links, which may name nothing yet.
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

Status write_in_place(int descriptor, const std::string& path,
                      std::span<const std::uint8_t> bytes) {
  const WriteSignalGuard guard;
  if (write_all(descriptor, bytes)) return ok_status();
  return io_error(path, "cannot be written", errno);
}

Status write_device(const std::string& path, std::span<const std::uint8_t> bytes) {
  FileDescriptor file(path, O_WRONLY | O_NOCTTY);
  if (!file.is_open()) return io_error(path, "cannot be written", errno);
  Status status = write_in_place(file.number(), path, bytes);
  if (status && !file.close()) status = io_error(path, "cannot be written", errno);
  return status;
}

template <class Bytes>
Result<Bytes> read(const std::string& path, std::size_t max_bytes) {
  if (path == "-") return read_all<Bytes>(STDIN_FILENO, "standard input", max_bytes);
  const FileDescriptor file(path, O_RDONLY | O_NOCTTY);
  if (!file.is_open()) return io_error(path, "cannot be read", errno);
  return read_all<Bytes>(file.number(), path, max_bytes);
}

Status write(const std::string& path, std::span<const std::uint8_t> bytes) {
  if (path == "-") return write_in_place(STDOUT_FILENO, "standard output", bytes);
  std::string target = without_links(path);
  struct stat existing {};
  const bool exists = ::stat(target.c_str(), &existing) == 0;
  if (!exists && errno != ENOENT) return io_error(path, "cannot be written", errno);
  if (exists && S_ISDIR(existing.st_mode)) return io_error(path, "cannot be written", EISDIR);
  if (exists && !S_ISREG(existing.st_mode)) return write_device(target, bytes);
  // Renaming over a file asks nobody whether the file may be written: we do.
  if (exists && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
    return io_error(path, "cannot be written", errno);
  }
  AtomicFile file(std::move(target));
  Status status = file.open(exists ? std::optional<unsigned>(existing.st_mode) : std::nullopt);
  if (status) status = file.write(bytes);
  if (status) status = file.commit();
  return status;
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::size_t max_bytes) {
  return no_throw([&] { return read<std::string>(path, max_bytes); });
}

Result<std::vector<std::uint8_t>> read_bytes(const std::string& path, std::size_t max_bytes) {
  return no_throw([&] { return read<std::vector<std::uint8_t>>(path, max_bytes); });
}

Status write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  return no_throw([&] { return write(path, bytes); });
}

}  // namespace sfumato
