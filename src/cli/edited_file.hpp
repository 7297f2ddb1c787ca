#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// A drawing that a page edits. What it holds has a number, which changes where another program
/// writes it: so nobody's work is replaced unseen.
class EditedFile {
 public:
  /// The context must outlive this; its limits say how long the file may be.
  EditedFile(const Context& context, std::string path);

  struct Content {
    std::string bytes;
    std::uint64_t version = 0;
  };

  /// Errors: io, limit, out_of_memory.
  Result<Content> read();

  /// Replaces the file in one step, if it still holds the version `expected`, or whatever it holds
  /// where that is empty. The new version; no value: it holds something else, or is gone.
  /// Errors: io, limit, out_of_memory.
  Result<std::optional<std::uint64_t>> save(std::optional<std::uint64_t> expected,
                                            std::span<const std::uint8_t> bytes);

  /// Its name without folders.
  std::string name() const;

 private:
  const Context& context_;
  std::string path_;
  std::string known_;  ///< what it held when somebody last looked
  std::uint64_t version_ = 0;
};

}  // namespace sfumato::cli
