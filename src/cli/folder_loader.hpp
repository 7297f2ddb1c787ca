#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "formats/read_document.hpp"

namespace sfumato::cli {

/// Reads the files that a document names relative to its own folder, or by an absolute path. A file
/// is read only where it lies in the document's folder or in one that the user allows, or below
/// them, after all symbolic links were followed; and only if it is a regular file.
class FolderLoader final : public ResourceLoader {
 public:
  /// The path of the document; "-" is standard input: the current folder. `allowed_folders` exist.
  /// A file that is longer than the limits of `context` allow, or than its budget has room for, is
  /// an error. The context must outlive this.
  FolderLoader(const std::string& document, const std::vector<std::string>& allowed_folders,
               Context& context);

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override;

 private:
  Status check_place(const std::filesystem::path& file) const;

  Context& context_;
  std::filesystem::path folder_;                ///< of the document, as it was given
  std::vector<std::filesystem::path> granted_;  ///< without symbolic links; the document's first
};

}  // namespace sfumato::cli
