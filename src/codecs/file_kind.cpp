#include "codecs/file_kind.hpp"

#include <algorithm>
#include <iterator>

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

/// In the order of FileKind.
constexpr std::string_view kTexts[] = {"a PNG picture",          "a JPEG picture",
                                       "a WebP picture",         "a GIF picture",
                                       "a HEIC or AVIF picture", "a TIFF or raw file",
                                       "a BMP picture",          "a PDF",
                                       "a file packed by gzip",  "a ZIP archive",
                                       "a solved picture",       "a drawing or other XML",
                                       "an empty file",          {}};
static_assert(std::size(kTexts) == static_cast<std::size_t>(FileKind::unknown) + 1);

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
  return kTexts[static_cast<std::size_t>(kind)];
}

}  // namespace sfumato::codecs
