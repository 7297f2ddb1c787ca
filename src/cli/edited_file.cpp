#include "cli/edited_file.hpp"

#include <filesystem>
#include <utility>

#include "base/utf8.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {

EditedFile::EditedFile(const Context& context, std::string path)
    : context_(context), path_(std::move(path)) {}

std::string EditedFile::name() const {
  return printable(std::filesystem::path(path_).filename().string());
}

Result<EditedFile::Content> EditedFile::read() {
  Result<std::string> bytes = read_file(path_, context_.limits.input_bytes);
  if (!bytes) return bytes.status();
  if (version_ == 0 || *bytes != known_) {
    known_ = *bytes;
    ++version_;
  }
  return Content{std::move(*bytes), version_};
}

Result<std::optional<std::uint64_t>> EditedFile::save(std::optional<std::uint64_t> expected,
                                                      std::span<const std::uint8_t> bytes) {
  if (expected) {
    const Result<Content> now = read();
    if (!now && now.status().code == StatusCode::out_of_memory) return now.status();
    // What cannot be read is not what the page has.
    if (!now || now->version != *expected) return std::optional<std::uint64_t>();
  }
  // An interrupt ends the command behind a save, never within.
  Status status = write_file(path_, bytes);
  if (!status) return status;
  known_.assign(bytes.begin(), bytes.end());
  return std::optional(++version_);
}

}  // namespace sfumato::cli
