#include "cli/files/folder_loader.hpp"

#include <algorithm>
#include <system_error>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

/// Returns whether the file lies in the folder or below it. Both paths have no symbolic links and
/// no "..".
bool is_below(const fs::path& file, const fs::path& folder) {
  const auto [in_folder, in_file] =
      std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return in_folder == folder.end() && in_file != file.end();
}

}  // namespace

fs::path folder_of(const std::string& document) {
  const fs::path folder = document == "-" ? fs::path() : fs::path(document).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

FolderLoader::FolderLoader(const DocumentArguments& arguments, Context& context)
    : arguments_(arguments), context_(context), folder_(folder_of(arguments.input)) {
  std::error_code error;
  const fs::path own = fs::canonical(folder_, error);
  if (!error) granted_.push_back(own);
  for (const std::string& folder : arguments.allowed_folders) {
    const fs::path allowed = fs::canonical(folder, error);
    if (!error) granted_.push_back(allowed);
  }
}

Status FolderLoader::check_place(const fs::path& file) const {
  const auto holds = [&file](const fs::path& folder) { return is_below(file, folder); };
  if (std::ranges::any_of(granted_, holds)) return ok_status();
  std::string folders;
  for (const fs::path& folder : granted_) {
    folders += (folders.empty() ? "" : " and ") + folder.string();
  }
  return bad("leads to " + file.string() + ", outside of " + folders +
             "; move the file there, or allow its folder with --allow-files DIR");
}

Status FolderLoader::check_use(const std::string& path) const {
  if (!outputs_) outputs_ = written_files(arguments_.outputs);
  const auto identity = file_identity(path, FileUse::reads);
  const auto output = identity ? outputs_->find(*identity) : outputs_->end();
  if (output == outputs_->end()) return ok_status();
  return bad("the output " + in_quotes(output->second) + " would replace this file");
}

Result<std::vector<std::uint8_t>> FolderLoader::load(std::string_view href) const {
  if (href.find('\0') != std::string_view::npos) return bad("is not a file name");
  std::error_code error;
  // Reads the checked path without links, not the path that the document names.
  const fs::path path = fs::weakly_canonical(folder_ / fs::path(href), error);
  if (error) return bad("cannot be read: " + error.message());
  SFUMATO_TRY(check_place(path));
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return bad("there is no such file in " + path.parent_path().string());
  if (!fs::is_regular_file(status)) return bad("is not a file");
  SFUMATO_TRY(check_use(path.string()));
  // The caller charges the bytes.
  const std::size_t most = context_.limits.image_file_bytes, room = context_.budget.room();
  Result<std::vector<std::uint8_t>> bytes =
      read_bytes(path.string(), std::min(most, room), &context_);
  if (bytes) return bytes;
  const Status& failed = bytes.status();
  if (failed.code == StatusCode::limit) {
    if (room < most) return context_.budget.charge(room + 1, "a texture file");
    return limit_error(context_.limits, &Limits::image_file_bytes, "bytes in the file");
  }
  const bool is_io = failed.code == StatusCode::io;
  return make_error(is_io ? StatusCode::bad_input : failed.code, failed.message);
}

}  // namespace sfumato::cli
