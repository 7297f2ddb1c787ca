#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace sfumato::codecs {

/// The kind of a file by its first bytes.
enum class FileKind : std::uint8_t {
  png,
  jpeg,
  webp,
  gif,
  heif,
  tiff,
  bmp,
  pdf,
  gzip,
  zip,
  solved,
  xml,
  empty,
  unknown
};

/// Returns bytes as characters.
inline std::string_view text_view(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Returns the kind of the file that holds these bytes. Reads the first few only.
FileKind file_kind(std::string_view bytes);

/// Returns the kind for a message that says "is": "a GIF picture"; empty for an unknown kind.
std::string_view kind_text(FileKind kind);

}  // namespace sfumato::codecs
