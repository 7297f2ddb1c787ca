#include "base/native/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "base/try.hpp"

namespace sfumato {
namespace {

/// The number of processes that may write one name at the same time.
constexpr int kSlotCount = 8;
constexpr std::size_t kNameBytes = 255 - 32;
constexpr unsigned kNewFileMode = 0666;
constexpr unsigned kPrivateMode = 0600;
constexpr unsigned kModeBits = 07777;

/// Locks a file. A writer holds this lock from the file's creation until its final name.
bool try_lock(int descriptor) {
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

bool has_a_name(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

/// Returns whether the path still names the open file.
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
  // Since this process opened the file, its writer may have renamed it, and another may have begun.
  // Under the lock no other process moves it.
  if (file.is_open() && try_lock(file.number()) && is_at(file.number(), path)) {
    ::unlink(path.c_str());
  }
}

/// Does rename(2) without replacing a file. False: errno has the reason.
bool rename_if_free(const std::string& from, const std::string& to) {
#ifdef RENAME_NOREPLACE
  return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0;
#else
  static_cast<void>(from), static_cast<void>(to);
  errno = ENOTSUP;
  return false;
#endif
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
                        ", is not a regular file and cannot be replaced",
                    {path_});
}

/// Opens a slot. Leaves file_ closed, without an error, where another process has this slot.
Status AtomicFile::open_slot(int slot, std::optional<unsigned> mode) {
  std::string path = slot_path(slot);
  FileDescriptor file(path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW,
                      mode ? kPrivateMode : kNewFileMode);
  if (!file.is_open()) {
    return errno == EEXIST ? ok_status() : io_error(path_, "cannot be written", errno);
  }
  // Between creation and lock another process may have taken the file for abandoned. Without locks
  // in the file system no process can.
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
  return finish(durability);
}

Result<bool> AtomicFile::commit_new() {
  if (::fsync(file_.number()) != 0) return io_error(path_, "cannot be written", errno);
  if (::link(temporary_path_.c_str(), path_.c_str()) != 0) {
    if (errno == EEXIST) return false;
    // Some file systems have no hard links.
    if (!rename_if_free(temporary_path_, path_)) {
      if (errno == EEXIST) return false;
      return io_error(path_, "cannot be written", errno);
    }
  } else {
    ::unlink(temporary_path_.c_str());
  }
  temporary_path_.clear();
  SFUMATO_TRY(finish(Durability::synced));
  return true;
}

/// Closes the file under its final name, and syncs its folder.
Status AtomicFile::finish(Durability durability) {
  if (!file_.close()) return io_error(path_, "cannot be written", errno);
  if (durability != Durability::synced) return ok_status();
  const FileDescriptor folder(folder_, O_RDONLY | O_DIRECTORY);
  // A folder with permission to write but not to read cannot be synced; some file systems cannot
  // sync folders at all.
  if (!folder.is_open() || ::fsync(folder.number()) == 0 || errno == EINVAL) return ok_status();
  return io_error(path_, "may not outlive a power failure", errno);
}

Result<bool> create_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  AtomicFile file(path);
  SFUMATO_TRY(file.open(std::nullopt));
  SFUMATO_TRY(file.write(bytes));
  return file.commit_new();
}

Status replace_file(const std::string& path, std::span<const std::uint8_t> bytes,
                    Durability durability) {
  AtomicFile file(path);
  SFUMATO_TRY(file.open(std::nullopt));
  SFUMATO_TRY(file.write(bytes));
  return file.commit(durability);
}

Result<std::optional<unsigned>> mode_of_replaced(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno == ENOENT) return std::optional<unsigned>();
    return io_error(path, "cannot be written", errno);
  }
  if (S_ISDIR(status.st_mode)) return io_error(path, "cannot be written", EISDIR);
  if (!S_ISREG(status.st_mode)) {
    return make_error(StatusCode::io, "cannot be written: it is not a regular file", {path});
  }
  // Renaming over a file does not check whether the file is writable, so this does.
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
    return io_error(path, "cannot be written", errno);
  }
  return std::optional<unsigned>(status.st_mode);
}

Status sync_file_system(const std::string& folder) {
#ifdef __linux__
  const FileDescriptor any(folder, O_RDONLY | O_DIRECTORY);
  // A folder with permission to write but not to read cannot be synced.
  if (!any.is_open() || ::syncfs(any.number()) == 0) return ok_status();
  return io_error(folder, "cannot be written", errno);
#else
  static_cast<void>(folder);
  ::sync();
  return ok_status();
#endif
}

}  // namespace sfumato
