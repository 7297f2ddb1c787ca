#include "cli/files/paths.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/text/ascii.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPackedExtension = "svgz";

/// Returns the extension without its dot; empty if there is none.
std::string extension_of(const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  return extension.empty() ? extension : extension.substr(1);
}

/// Returns "a file name that ends in .svg, or -".
std::string expected_name(const OutputNames& names) {
  std::string text = "a file name that ends in ";
  const char* before = "";
  for (const std::string_view extension : extensions_of(names)) {
    text.append(std::exchange(before, ", ")).append(".").append(extension);
  }
  return names.takes_dash ? text + ", or -" : text;
}

Status cannot_write(const std::string& path, const std::string& why) {
  return make_error(StatusCode::io, "cannot be written: " + why, {path});
}

/// Returns the names of a folder's files, sorted; none if they are too many to look at.
std::vector<std::string> file_names(const fs::path& folder) {
  constexpr std::size_t kMostNames = 10'000;
  std::vector<std::string> names;
  std::error_code error, ignored;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (names.size() == kMostNames) return {};
    if (entry->is_regular_file(ignored)) names.push_back(entry->path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

/// Returns "; did you mean pictures/icon.svg?" for a file that does not exist beside one whose name
/// is similar, or differs in its extension alone; else nothing.
std::string hint_at_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(path, ignored))) return {};
  const fs::path folder = path.parent_path();
  const std::vector<std::string> names = file_names(folder.empty() ? "." : folder);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::string_view meant = text::nearest(path.filename().string(), candidates);
  const auto same = std::ranges::find_if(
      candidates, [&](const fs::path& name) { return name.stem() == path.stem(); });
  if (meant.empty() && same != candidates.end()) meant = *same;
  return meant.empty() ? std::string() : "; did you mean " + (folder / meant).string() + "?";
}

}  // namespace

std::vector<std::string_view> extensions_of(const OutputNames& names) {
  if (names.is_solved) return {kSolvedExtension};
  std::vector<std::string_view> extensions;
  for (const options::KnownOutput& known : options::known_outputs()) {
    if (!names.only || known.kind == *names.only) extensions.push_back(known.extension);
  }
  if (names.takes_packed) extensions.push_back(kPackedExtension);
  if (names.takes_frames) {
    for (const options::KnownOutput& known : options::known_frames())
      extensions.push_back(known.extension);
  }
  return extensions;
}

std::optional<OutputKind> output_kind(const std::string& path) {
  return kind_of_format(extension_of(path));
}

std::optional<OutputKind> kind_of_format(const std::string& extension) {
  const std::optional<OutputKind> kind = options::kind_of_extension(extension);
  return kind ? kind : options::frame_of_extension(extension);
}

bool is_packed_name(const std::string& path) {
  return ascii_lower(extension_of(path)) == kPackedExtension;
}

std::string complaint_about_output(const std::string& name, const OutputNames& names) {
  if (name == "-" && names.takes_dash) return {};
  if (names.takes_packed && is_packed_name(name)) return {};
  const bool has_solved_name = ascii_lower(extension_of(name)) == kSolvedExtension;
  if (names.is_solved && has_solved_name) return {};
  const std::optional<OutputKind> kind = output_kind(name);
  const bool is_allowed = kind && (!options::is_frame(*kind) || names.takes_frames);
  if (!names.is_solved && is_allowed && (!names.only || kind == names.only)) return {};
  const std::string_view meant =
      text::nearest(ascii_lower(extension_of(name)), extensions_of(names));
  std::string text = "cannot tell the format of \"" + name + "\"; use " + expected_name(names);
  if (!names.only && has_solved_name) return text + "; `sfumato solve` writes solved pictures";
  if (!meant.empty()) {
    text += "; did you mean " + fs::path(name).replace_extension(meant).string() + "?";
  }
  return text;
}

Status check_output(const std::string& path) {
  if (path == "-") return ok_status();
  std::error_code ignored;
  const fs::file_status target = fs::status(path, ignored);
  if (fs::is_directory(target)) return cannot_write(path, "this is a folder; add a file name");
  if (fs::exists(target) && !fs::is_regular_file(target)) return ok_status();
  if (fs::exists(target) && access(path.c_str(), W_OK) != 0) {
    return cannot_write(path, std::strerror(errno));
  }
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  const fs::file_status folder_status = fs::status(folder, ignored);
  if (!fs::exists(folder_status)) {
    return cannot_write(path, "the folder " + folder.string() + " does not exist; create it first");
  }
  if (!fs::is_directory(folder_status)) {
    return cannot_write(path, folder.string() + " is not a folder");
  }
  if (fs::is_symlink(fs::symlink_status(path, ignored))) return ok_status();
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return cannot_write(path, "the folder " + folder.string() + ": " + std::strerror(errno) +
                                  "; choose a folder that you may write to");
  }
  return ok_status();
}

Result<std::string> read_input(const Context& context, const std::string& path,
                               std::size_t max_bytes) {
  Result<std::string> bytes = read_file(path, max_bytes, &context);
  if (bytes || bytes.status().code != StatusCode::io) return bytes;
  Status status = bytes.status();
  status.code = StatusCode::bad_input;
  if (path != "-") status.message += hint_at_file(path);
  return status;
}

std::string display_name(const std::string& path) {
  return path == "-" ? "<stdin>" : path;
}

Status naming(const std::string& input, Status status) {
  if (!status && status.where.file.empty()) status.where.file = display_name(input);
  return status;
}

}  // namespace sfumato::cli
