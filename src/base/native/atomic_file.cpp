#include "base/native/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

namespace sfumato {
namespace {

/// As many processes may write one name at the same time.
constexpr int kSlotCount = 8;
constexpr std::size_t kNameBytes = 255 - 32;
constexpr unsigned kNewFileMode = 0666;
constexpr unsigned kPrivateMode = 0600;
constexpr unsigned kModeBits = 07777;

/// A writer holds this lock from the file's first moment until it has its name.
bool try_lock(int descriptor) {
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

bool has_a_name(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

/// Whether the path still names the open file.
bool is_at(int descriptor, const std::string& path) {
  struct stat open_file {};
  struct stat named_file {};
  return ::fstat(descriptor, &open_file) == 0 && ::lstat(path.c_str(), &named_file) == 0 &&
         open_file.st_dev == named_file.st_dev && open_file.st_ino == named_file.st_ino;
}

bool is_regular_file(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

void remove_if_abandoned(const std::string& path) {
  const FileDescriptor file(path, O_RDWR | O_NOFOLLOW | O_NONBLOCK);
  // Its writer may have put it in place, and another begun, since it was opened. Under the lock
  // nobody else moves it.
  if (file.is_open() && try_lock(file.number()) && is_at(file.number(), path)) {
    ::unlink(path.c_str());
  }
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  const std::size_t slash = path_.rfind('/');
  folder_ = slash == std::string::npos ? "." : path_.substr(0, slash + 1);
  name_ = slash == std::string::npos ? path_ : path_.substr(slash + 1);
}

AtomicFile::~AtomicFile() {
  if (!temporary_path_.empty()) ::unlink(temporary_path_.c_str());
}

std::string AtomicFile::slot_path(int slot) const {
  return folder_ + "/.sfumato-" + name_.substr(0, kNameBytes) + "." + std::to_string(slot) + ".tmp";
}

Status AtomicFile::open(std::optional<unsigned> mode) {
  if (name_.empty()) return io_error(path_, "cannot be written", EISDIR);
  for (int slot = 0; slot < kSlotCount; ++slot) remove_if_abandoned(slot_path(slot));
  for (int slot = 0; slot < kSlotCount; ++slot) {
    Status status = open_slot(slot, mode);
    if (!status || file_.is_open()) return status;
  }
  for (int slot = 0; slot < kSlotCount; ++slot) {
    if (is_regular_file(slot_path(slot))) {
      return io_error(path_, "is being written by other processes", EBUSY);
    }
  }
  return make_error(StatusCode::io,
                    "cannot be written: what has the names that its temporary file may have, " +
                        slot_path(0) + " to " + slot_path(kSlotCount - 1) +
                        ", is no file and cannot be replaced",
                    {path_});
}

/// Leaves file_ closed, without an error, where another process has this slot.
Status AtomicFile::open_slot(int slot, std::optional<unsigned> mode) {
  std::string path = slot_path(slot);
  FileDescriptor file(path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW,
                      mode ? kPrivateMode : kNewFileMode);
  if (!file.is_open()) {
    return errno == EEXIST ? ok_status() : io_error(path_, "cannot be written", errno);
  }
  // Between creation and lock another process may have taken the file for abandoned. Where the
  // file system knows no locks, nobody can.
  const bool is_locked = try_lock(file.number());
  if (!is_locked && errno == EWOULDBLOCK) return ok_status();
  if (!has_a_name(file.number())) return ok_status();
  temporary_path_ = std::move(path);
  if (mode && ::fchmod(file.number(), *mode & kModeBits) != 0) {
    return io_error(path_, "cannot be written", errno);
  }
  file_ = std::move(file);
  return ok_status();
}

Status AtomicFile::write(std::span<const std::uint8_t> bytes) {
  const WriteSignalGuard guard;
  if (write_all(file_.number(), bytes)) return ok_status();
  return io_error(path_, "cannot be written", errno);
}

Status AtomicFile::commit(Durability durability) {
  const bool is_synced = durability == Durability::synced;
  if (is_synced && ::fsync(file_.number()) != 0) {
    return io_error(path_, "cannot be written", errno);
  }
  if (::rename(temporary_path_.c_str(), path_.c_str()) != 0) {
    return io_error(path_, "cannot be written", errno);
  }
  temporary_path_.clear();
  if (!file_.close()) return io_error(path_, "cannot be written", errno);
  if (!is_synced) return ok_status();
  const FileDescriptor folder(folder_, O_RDONLY | O_DIRECTORY);
  // A folder that may be written but not read cannot be synced, nor can some file systems'.
  if (!folder.is_open() || ::fsync(folder.number()) == 0 || errno == EINVAL) return ok_status();
  return io_error(path_, "may not outlive a power failure", errno);
}

Status replace_file(const std::string& path, std::span<const std::uint8_t> bytes,
                    Durability durability) {
  AtomicFile file(path);
  Status status = file.open(std::nullopt);
  if (status) status = file.write(bytes);
  if (status) status = file.commit(durability);
  return status;
}

Result<std::optional<unsigned>> mode_of_replaced(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno == ENOENT) return std::optional<unsigned>();
    return io_error(path, "cannot be written", errno);
  }
  if (S_ISDIR(status.st_mode)) return io_error(path, "cannot be written", EISDIR);
  if (!S_ISREG(status.st_mode)) {
    return make_error(StatusCode::io, "cannot be written: is no regular file", {path});
  }
  // Renaming over a file asks nobody whether the file may be written: we do.
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
    return io_error(path, "cannot be written", errno);
  }
  return std::optional<unsigned>(status.st_mode);
}

Status sync_file_system(const std::string& folder) {
#ifdef __linux__
  const FileDescriptor any(folder, O_RDONLY | O_DIRECTORY);
  // A folder that may be written but not read cannot be synced.
  if (!any.is_open() || ::syncfs(any.number()) == 0) return ok_status();
  return io_error(folder, "cannot be written", errno);
#else
  static_cast<void>(folder);
  ::sync();
  return ok_status();
#endif
}

}  // namespace sfumato
