#include "cli/files/file_uses.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

std::optional<FileIdentity> regular_file(const struct stat& facts) {
  if (!S_ISREG(facts.st_mode)) return std::nullopt;
  return FileIdentity{facts.st_dev, facts.st_ino, {}};
}

std::optional<FileIdentity> standard_stream(int descriptor) {
  struct stat facts {};
  if (::fstat(descriptor, &facts) != 0) return std::nullopt;
  return regular_file(facts);
}

/// Returns the identity of a file that does not exist yet: the nearest folder that exists, and the
/// path from there.
std::optional<FileIdentity> future_file(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(without_links(path), error), error);
  if (error) return std::nullopt;
  fs::path name = whole.filename();
  for (fs::path folder = whole.parent_path();; folder = folder.parent_path()) {
    struct stat facts {};
    if (::stat(folder.c_str(), &facts) == 0) {
      return FileIdentity{facts.st_dev, facts.st_ino, name.string()};
    }
    if (folder == folder.parent_path()) return std::nullopt;
    name = folder.filename() / name;
  }
}

}  // namespace

std::optional<FileIdentity> file_identity(const std::string& path, FileUse use) {
  if (path.empty()) return std::nullopt;
  if (path == "-") return standard_stream(use == FileUse::reads ? STDIN_FILENO : STDOUT_FILENO);
  struct stat facts {};
  return ::stat(path.c_str(), &facts) == 0 ? regular_file(facts) : future_file(path);
}

FilesByIdentity written_files(const std::vector<std::string>& outputs) {
  FilesByIdentity files;
  for (const std::string& output : outputs) {
    if (auto identity = file_identity(output, FileUse::writes)) {
      files.emplace(std::move(*identity), output);
    }
  }
  return files;
}

std::string in_quotes(const std::string& path) {
  return '"' + path + '"';
}

std::string complaint_about(const std::vector<InputFile>& inputs,
                            const std::vector<OutputFile>& outputs) {
  std::map<FileIdentity, const InputFile*> input_at;
  for (const InputFile& input : inputs) {
    if (auto identity = file_identity(input.path, FileUse::reads)) {
      input_at.emplace(std::move(*identity), &input);
    }
  }
  std::map<FileIdentity, const OutputFile*> output_at;
  for (const OutputFile& output : outputs) {
    const auto identity = file_identity(output.path, FileUse::writes);
    if (!identity) continue;
    const auto input = input_at.find(*identity);
    if (input != input_at.end()) {
      return output.what + " would replace " + input->second->what + ' ' +
             in_quotes(input->second->path) + "; choose another name";
    }
    const auto [other, is_new] = output_at.emplace(*identity, &output);
    if (is_new) continue;
    return other->second->source + " and " + output.source + " would both become " +
           in_quotes(output.path) + "; choose other names";
  }
  return {};
}

}  // namespace sfumato::cli
