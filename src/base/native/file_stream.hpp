#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/native/posix.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// A file that is written part by part, in place. "-" is standard output. The first part creates
/// the file, or empties the existing one.
class FileStream {
 public:
  explicit FileStream(std::string path) : path_(std::move(path)) {}

  /// Appends a part. A regular file contains the whole part afterwards, or none of it. Where
  /// writing has to wait, it waits until `context` is cancelled. Errors: io, as
  /// Context::cancel_status().
  Status write(std::span<const std::uint8_t> bytes, const Context& context);

  /// Closes the file, and reports errors of earlier writes. Errors: io.
  Status close();

 private:
  Status open(const Context& context);
  int number() const { return path_ == "-" ? kStandardOutput : file_->number(); }

  static constexpr int kStandardOutput = 1;

  std::string path_;
  std::optional<FileDescriptor> file_{};  ///< once it is open, unless it is standard output
  bool is_regular_ = false;
  std::int64_t size_ = 0;  ///< for a regular file
};

}  // namespace sfumato
