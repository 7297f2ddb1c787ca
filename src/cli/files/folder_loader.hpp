#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/files/file_uses.hpp"
#include "cli/options/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato::cli {

/// Returns the folder to which names in a document are relative: the document's own folder, or the
/// current folder for standard input.
std::filesystem::path folder_of(const std::string& document);

/// Reads the files that a document names, relative to its own folder or by an absolute path. After
/// all symbolic links are followed, a file is read only if it is a regular file in or below the
/// document's folder or a folder that the user allows.
class FolderLoader final : public ResourceLoader {
 public:
  /// Makes a loader for the document of the arguments; standard input uses the current folder. A
  /// file is an error if it is longer than the limits of `context` allow, if the budget has no room
  /// for it, or if the call writes it. Arguments and context must outlive this object.
  FolderLoader(const DocumentArguments& arguments, Context& context);

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override;

 private:
  Status check_place(const std::filesystem::path& file) const;
  Status check_use(const std::string& path) const;

  const DocumentArguments& arguments_;
  Context& context_;
  /// The files that the call writes, as they exist when the first file is requested.
  mutable std::optional<FilesByIdentity> outputs_;
  std::filesystem::path folder_;                ///< of the document, as it was given
  std::vector<std::filesystem::path> granted_;  ///< without symbolic links; the document's first
};

}  // namespace sfumato::cli
