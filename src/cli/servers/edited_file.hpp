#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// Holds a drawing that a page edits. The contents have a version number, which changes when
/// another program writes the file, so that no one's work is overwritten unnoticed.
class EditedFile {
 public:
  /// The context must outlive this object; its limits bound the length of the file.
  EditedFile(const Context& context, std::string path);

  struct Content {
    std::string bytes;
    std::uint64_t version = 0;
  };

  /// Errors: io, limit, out_of_memory.
  Result<Content> read();

  /// Replaces the file in one step if it still holds the version `expected`; if `expected` is
  /// empty, replaces it in any case. Returns the new version, or no value if the file holds
  /// something else or is gone. Errors: io, limit, out_of_memory.
  Result<std::optional<std::uint64_t>> save(std::optional<std::uint64_t> expected,
                                            std::span<const std::uint8_t> bytes);

  /// Returns whether save() may accept the expected version, without a look at the file.
  bool may_save(std::optional<std::uint64_t> expected) const {
    return !expected || (*expected == version_ && version_ != 0);
  }

  /// Returns the name without folders.
  std::string name() const;

 private:
  const Context& context_;
  std::string path_;
  std::string known_;  ///< contents when the file was last read
  std::uint64_t version_ = 0;
};

}  // namespace sfumato::cli
