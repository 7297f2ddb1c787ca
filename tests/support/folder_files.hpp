#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sfumato/base/native/file.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato::test {

/// Loads the files that one of our own documents refers to, beside it or in subfolders. Not for
/// untrusted files.
class FolderFiles : public ResourceLoader {
 public:
  explicit FolderFiles(std::string folder) : folder_(std::move(folder)) {}

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override {
    const auto bytes = read_file(folder_ + '/' + std::string(href), limits::kImageFileBytes);
    if (!bytes) return bytes.status();
    return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
  }

 private:
  std::string folder_;
};

}  // namespace sfumato::test
