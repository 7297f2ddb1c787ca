#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/native/posix.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// A file that is written part by part, in place. "-" is standard output. The first part makes the
/// file, or empties the one that is there.
class FileStream {
 public:
  explicit FileStream(std::string path) : path_(std::move(path)) {}

  /// Appends a part. A regular file has it whole, or ends before it. Where writing has to wait, it
  /// waits until `context` says to stop. Errors: io, those of Context::cancel_status.
  Status write(std::span<const std::uint8_t> bytes, const Context& context);

  /// Reports what writes have left to be found. Errors: io.
  Status close();

 private:
  Status open(const Context& context);
  int number() const { return path_ == "-" ? kStandardOutput : file_->number(); }

  static constexpr int kStandardOutput = 1;

  std::string path_;
  std::optional<FileDescriptor> file_{};  ///< once it is open, unless it is standard output
  bool is_regular_ = false;
  std::int64_t size_ = 0;  ///< of a regular file
};

}  // namespace sfumato
