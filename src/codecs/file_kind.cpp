#include "codecs/file_kind.hpp"

#include <algorithm>

namespace sfumato::codecs {
namespace {

/// A signature: bytes at the beginning, and more bytes at a given place.
struct Signature {
  FileKind kind;
  std::string_view begin;
  std::size_t at = 0;
  std::string_view bytes{};
};

constexpr Signature kSignatures[] = {
    {FileKind::png, "\x89PNG\r\n\x1a\n"},
    {FileKind::jpeg, "\xff\xd8\xff"},
    {FileKind::webp, "RIFF", 8, "WEBP"},
    {FileKind::gif, "GIF8"},
    {FileKind::heif, {"\0", 1}, 4, "ftyp"},
    {FileKind::tiff, {"II*\0", 4}},
    {FileKind::tiff, {"MM\0*", 4}},
    {FileKind::bmp, "BM"},
    {FileKind::pdf, "%PDF-"},
    {FileKind::gzip, "\x1f\x8b"},
    {FileKind::zip, "PK\x03\x04"},
    {FileKind::solved, "SFPICT\x1a"},
};

/// Returns whether the first non-blank character begins an element, in any of XML's encodings.
bool begins_as_xml(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  const std::size_t first = bytes.find_first_not_of(std::string_view(" \t\r\n\0", 5));
  return first != std::string_view::npos && bytes[first] == '<';
}

}  // namespace

FileKind file_kind(std::string_view bytes) {
  if (bytes.empty()) return FileKind::empty;
  for (const Signature& known : kSignatures) {
    if (bytes.starts_with(known.begin) &&
        bytes.substr(std::min(known.at, bytes.size())).starts_with(known.bytes)) {
      return known.kind;
    }
  }
  return begins_as_xml(bytes.substr(0, 256)) ? FileKind::xml : FileKind::unknown;
}

std::string_view kind_text(FileKind kind) {
  switch (kind) {
    case FileKind::png:
      return "a PNG picture";
    case FileKind::jpeg:
      return "a JPEG picture";
    case FileKind::webp:
      return "a WebP picture";
    case FileKind::gif:
      return "a GIF picture";
    case FileKind::heif:
      return "a HEIC or AVIF picture";
    case FileKind::tiff:
      return "a TIFF or raw file";
    case FileKind::bmp:
      return "a BMP picture";
    case FileKind::pdf:
      return "a PDF";
    case FileKind::gzip:
      return "a file packed by gzip";
    case FileKind::zip:
      return "a ZIP archive";
    case FileKind::solved:
      return "a solved picture";
    case FileKind::xml:
      return "a drawing or other XML";
    case FileKind::empty:
      return "an empty file";
    case FileKind::unknown:
      return {};
  }
  return {};
}

}  // namespace sfumato::codecs
