#include "base/native/file_stream.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/try.hpp"

namespace sfumato {
namespace {

constexpr unsigned kModeOfNewFiles = 0666;

}  // namespace

Status FileStream::open(const Context& context) {
  struct stat existing {};
  const bool exists = ::stat(path_.c_str(), &existing) == 0;
  is_regular_ = !exists || S_ISREG(existing.st_mode);
  file_.emplace(
      is_regular_ ? FileDescriptor(path_, O_WRONLY | O_CREAT | O_TRUNC | O_NOCTTY, kModeOfNewFiles)
                  : open_device(path_, S_ISFIFO(existing.st_mode), &context));
  if (file_->is_open()) return ok_status();
  const int error_number = errno;
  file_.reset();
  return io_error(path_, "cannot be written", error_number, &context);
}

Status FileStream::write(std::span<const std::uint8_t> bytes, const Context& context) {
  if (path_ != "-" && !file_) {
    SFUMATO_TRY(open(context));
  }
  const WriteSignalGuard guard;
  if (write_all(number(), bytes, &context)) {
    size_ += static_cast<std::int64_t>(bytes.size());
    return ok_status();
  }
  const int error_number = errno;
  // Where the part cannot be removed either, the error still reports the failed write.
  if (is_regular_) [[maybe_unused]]
    const int ignored = ::ftruncate(number(), size_);
  return io_error(path_ == "-" ? "standard output" : path_, "cannot be written", error_number,
                  &context);
}

Status FileStream::close() {
  if (!file_ || file_->close()) return ok_status();
  return io_error(path_, "cannot be written", errno);
}

}  // namespace sfumato
