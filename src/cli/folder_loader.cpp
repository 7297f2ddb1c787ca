#include "cli/folder_loader.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/limits.hpp"
#include "base/native/file.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

}  // namespace

FolderLoader::FolderLoader(const std::string& document)
    : folder_(document == "-" ? std::string() : fs::path(document).parent_path().string()) {}

Result<std::vector<std::uint8_t>> FolderLoader::load(std::string_view href) const {
  if (href.find('\0') != std::string_view::npos) return bad("is no file name");
  const fs::path name(href);
  if (name.is_absolute()) {
    return bad("is an absolute path; expected one relative to the document's folder");
  }
  const fs::path path = fs::path(folder_) / name;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return bad("there is no such file in the folder " + (folder_.empty() ? "." : folder_));
  }
  if (!fs::is_regular_file(status)) return bad("is not a file");
  Result<std::string> bytes = read_file(path.string(), limits::kImageFileBytes);
  if (!bytes) {
    const Status& failed = bytes.status();
    const bool is_io = failed.code == StatusCode::io;
    return make_error(is_io ? StatusCode::bad_input : failed.code, failed.message);
  }
  return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
}

}  // namespace sfumato::cli
