#include "cli/servers/edited_file.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "base/text/utf8.hpp"
#include "base/try.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {

EditedFile::EditedFile(const Context& context, std::string path)
    : context_(context), path_(std::move(path)) {}

std::string EditedFile::name() const {
  return printable(std::filesystem::path(path_).filename().string());
}

Result<EditedFile::Content> EditedFile::read() {
  // Reading a pipe would wait for its writer and block the page.
  std::error_code error;
  if (!std::filesystem::is_regular_file(path_, error)) {
    return make_error(StatusCode::io, "is no longer a file", {path_});
  }
  SFUMATO_TRY_ASSIGN(auto&& bytes, read_file(path_, context_.limits.input_bytes));
  if (version_ == 0 || bytes != known_) {
    known_ = bytes;
    ++version_;
  }
  return Content{std::move(bytes), version_};
}

Result<std::optional<std::uint64_t>> EditedFile::save(std::optional<std::uint64_t> expected,
                                                      std::span<const std::uint8_t> bytes) {
  if (expected) {
    const Result<Content> now = read();
    if (!now && now.status().code == StatusCode::out_of_memory) return now.status();
    // A file that cannot be read differs from the page's version.
    if (!now || now->version != *expected) return std::optional<std::uint64_t>();
  }
  // An interrupt ends the command after a save, never during one.
  SFUMATO_TRY(write_file(path_, bytes));
  known_.assign(bytes.begin(), bytes.end());
  return std::optional(++version_);
}

}  // namespace sfumato::cli
