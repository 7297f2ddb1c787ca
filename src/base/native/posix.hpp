#pragma once

#include <signal.h>

#include <cstdint>
#include <span>
#include <string>

#include "sfumato/base/status.hpp"

namespace sfumato {

struct Context;

/// An open file descriptor that closes itself. Movable.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  /// open(2), always close-on-exec and never on 0, 1 or 2, even where these are closed. Check
  /// `is_open`; errno says why not.
  FileDescriptor(const std::string& path, int flags, unsigned mode = 0);
  FileDescriptor(FileDescriptor&& other) noexcept : number_(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor();

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  int release();

  /// close(2), whose errors are those of late writes. False: errno says why.
  bool close();

 private:
  int number_ = -1;
};

/// While it lives, writing to a closed pipe or past the process's file size limit is an error of
/// write(2) and no signal that kills. The thread's signal mask is as before at the end.
class WriteSignalGuard {
 public:
  WriteSignalGuard();
  ~WriteSignalGuard();
  WriteSignalGuard(const WriteSignalGuard&) = delete;
  WriteSignalGuard& operator=(const WriteSignalGuard&) = delete;

 private:
  sigset_t guarded_;
  sigset_t previous_mask_;
};

/// Waits until a descriptor can be read (POLLIN) or written (POLLOUT), and looks at `context`, if
/// any, all the while. False: errno says why; ECANCELED: the context says to stop.
bool wait_until_ready(int descriptor, short event, const Context* context = nullptr);

/// Waits a moment before something is tried again. False, with ECANCELED: the context says to stop.
bool wait_a_moment(const Context* context);

/// Writes all bytes, over short writes and interruptions. What is no regular file is waited for as
/// `wait_until_ready` does. False: errno says why.
bool write_all(int descriptor, std::span<const std::uint8_t> bytes,
               const Context* context = nullptr);

/// An io error about `path`: "cannot be written: No space left on device". ECANCELED of the
/// functions above: why `context` says to stop.
Status io_error(const std::string& path, const char* what, int error_number,
                const Context* context = nullptr);

}  // namespace sfumato
