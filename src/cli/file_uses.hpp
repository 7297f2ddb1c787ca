#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// No file that a call writes may be one that it reads, or another that it writes, however they are
/// named.
namespace sfumato::cli {

/// What tells a file from every other: the file itself, behind all links, or, where there is none
/// yet, the folder that will hold it and its name there.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::string name;  ///< empty: the file exists

  auto operator<=>(const FileIdentity&) const = default;
};

enum class FileUse : std::uint8_t { reads, writes };

/// Of a path as the command takes it: "-" is a standard stream. Nothing for what is no regular file
/// (a pipe, /dev/null): writing there replaces nothing.
std::optional<FileIdentity> file_identity(const std::string& path, FileUse use);

/// The files of a call by what they are; with how the call names them.
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

/// What is wrong with them together; empty: nothing.
std::string complaint_about(const std::vector<InputFile>& inputs,
                            const std::vector<OutputFile>& outputs);

}  // namespace sfumato::cli
