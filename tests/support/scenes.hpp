#pragma once

#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "sfumato/formats/orzan/orzan.hpp"
#include "support/places.hpp"

namespace sfumato::test {

/// Returns the bytes of a file, or nothing if it cannot be read.
inline std::optional<std::string> file_bytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// Returns the bytes of one of the public scenes ("lady_bug.xml"), or nothing if they are missing.
inline std::optional<std::string> shared_scene_bytes(const std::string& name) {
  return file_bytes(shared_path("scenes/") + name);
}

/// Returns a public scene, or nothing if it is missing. A test then calls GTEST_SKIP() << "no
/// public scene " << name.
inline std::optional<Document> shared_scene(const std::string& name) {
  const std::optional<std::string> bytes = shared_scene_bytes(name);
  if (!bytes) return std::nullopt;
  Context context;
  Result<ReadDocument> read = read_orzan(context, *bytes, name);
  if (!read) return std::nullopt;
  return std::move(read->document);
}

}  // namespace sfumato::test
