#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Checks that no file that a call writes is also read by it or written twice, under whatever name.
namespace sfumato::cli {

/// Identifies a file: the file itself, after all links are followed, or, if it does not exist yet,
/// its future folder and its name there.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::string name;  ///< empty: the file exists

  auto operator<=>(const FileIdentity&) const = default;
};

enum class FileUse : std::uint8_t { reads, writes };

/// Returns the identity of the file at a command's path; "-" is a standard stream. No value if it
/// is not a regular file (a pipe, /dev/null), because writing there replaces nothing.
std::optional<FileIdentity> file_identity(const std::string& path, FileUse use);

/// The files of a call by their identity, with their names in the call.
using FilesByIdentity = std::map<FileIdentity, std::string>;
FilesByIdentity written_files(const std::vector<std::string>& outputs);

/// A file that a call reads: "the drawing".
struct InputFile {
  std::string path;
  std::string what;
};

/// A file that a call writes: "the picture", made from "a.svg" or asked for by "--stats".
struct OutputFile {
  std::string path;
  std::string what;
  std::string source;
};

std::string in_quotes(const std::string& path);

/// Returns a message about a conflict between the files; empty if there is none.
std::string complaint_about(const std::vector<InputFile>& inputs,
                            const std::vector<OutputFile>& outputs);

}  // namespace sfumato::cli
