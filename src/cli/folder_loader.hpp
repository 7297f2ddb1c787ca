#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/file_uses.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato::cli {

/// The folder that the names in a document go by: its own, of standard input the current one.
std::filesystem::path folder_of(const std::string& document);

/// Reads the files that a document names relative to its own folder, or by an absolute path. A file
/// is read only where it lies in the document's folder or in one that the user allows, or below
/// them, after all symbolic links were followed; and only if it is a regular file.
class FolderLoader final : public ResourceLoader {
 public:
  /// Of the document that the arguments name; of standard input: the current folder. A file is an
  /// error that is longer than the limits of `context` allow, or than its budget has room for, and
  /// one that the call writes. Arguments and context must outlive this.
  FolderLoader(const DocumentArguments& arguments, Context& context);

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override;

 private:
  Status check_place(const std::filesystem::path& file) const;
  Status check_use(const std::string& path) const;

  const DocumentArguments& arguments_;
  Context& context_;
  /// That the call writes, as they are when the first file is asked for.
  mutable std::optional<FilesByIdentity> outputs_;
  std::filesystem::path folder_;                ///< of the document, as it was given
  std::vector<std::filesystem::path> granted_;  ///< without symbolic links; the document's first
};

}  // namespace sfumato::cli
