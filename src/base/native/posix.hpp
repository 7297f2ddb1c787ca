#pragma once

#include <signal.h>

#include <cstdint>
#include <span>
#include <string>

#include "sfumato/base/status.hpp"

namespace sfumato {

struct Context;

/// An open file descriptor, closed by its destructor. Movable.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  /// Does open(2), always close-on-exec and never on 0, 1 or 2, even where these are closed. Check
  /// `is_open`; if false, errno has the reason.
  FileDescriptor(const std::string& path, int flags, unsigned mode = 0);
  FileDescriptor(FileDescriptor&& other) noexcept : number_(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor();

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  int release();

  /// Does close(2), which reports errors of delayed writes. Returns false with the reason in errno.
  bool close();

 private:
  int number_ = -1;
};

/// Opens a file that is not regular for writing; waits until a FIFO has a reader. If the result is
/// not open, errno has the reason; ECANCELED: the context, if any, is cancelled.
FileDescriptor open_device(const std::string& path, bool is_fifo, const Context* context);

/// During its lifetime, writing to a closed pipe or past the process's file size limit is an error
/// of write(2), not a signal that kills the process. Its destructor restores the thread's signal
/// mask.
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

/// Waits until a descriptor can be read (POLLIN) or written (POLLOUT), and meanwhile polls
/// `context`, if any. Returns false with the reason in errno; ECANCELED: the context is cancelled.
bool wait_until_ready(int descriptor, short event, const Context* context = nullptr);

/// Waits for a short time before a retry. Returns false, with ECANCELED, if the context is
/// cancelled.
bool wait_a_moment(const Context* context);

/// Writes all bytes, continuing after short writes and interruptions. For files that are not
/// regular it waits like `wait_until_ready`. Returns false with the reason in errno.
bool write_all(int descriptor, std::span<const std::uint8_t> bytes,
               const Context* context = nullptr);

/// Makes an io error about `path`: "cannot be written: No space left on device". For ECANCELED from
/// the functions above: the status of `context`'s cancellation.
Status io_error(const std::string& path, const char* what, int error_number,
                const Context* context = nullptr);

}  // namespace sfumato
