#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

/// @file
/// The inputs and outputs that all readers of documents share.

namespace sfumato {

/// The format that a document was read from.
enum class DocumentFormat : std::uint8_t {
  svg,   ///< docs/format.md
  orzan  ///< docs/format-orzan.md
};

/// The place of a curve in the text that it was read from.
struct CurveSource {
  /// Bytes before the `<` of the curve's element: a shape, also where a `use` copies it. 0:
  /// unknown, as in text that is not UTF-8; no curve's element begins a document.
  std::size_t byte_offset = 0;
  /// The number of the element's subpath, from 0. Subpaths of length 0 count; movements that draw
  /// nothing do not.
  std::uint32_t subpath = 0;
};

/// A document, and remarks on it by its reader.
struct ReadDocument {
  Document document;  ///< valid
  /// Content that the reader ignored or had to guess, each with its place: one warning of each
  /// kind, at most limits::kWarnings, then one that counts the rest.
  std::vector<Diagnostic> warnings;
  DocumentFormat format = DocumentFormat::svg;  ///< from the root element
  /// Whether it is an SVG without Sfumato content. Use import_svg() to make curves from it.
  bool is_foreign = false;
  /// The places of the curves of each layer, in the order of Document::layers. Empty for Orzan's
  /// XML and for a packed file.
  std::vector<std::vector<CurveSource>> curve_sources{};
};

/// Pixels of an image, borrowed: sRGB code values, not premultiplied.
struct ImagePixels {
  int width = 0;                         ///< pixels
  int height = 0;                        ///< pixels
  std::span<const std::uint8_t> rgba{};  ///< row by row, 4 × width × height
};

/// Loads the files that a document refers to: its textures. The library opens no files on its own,
/// so that the caller decides which files a document may name.
class ResourceLoader {
 public:
  virtual ~ResourceLoader() = default;

  /// Returns the content of the PNG or JPEG file that a document refers to. `href` is as in the
  /// document with percent signs decoded: a relative or absolute path, never a URI with a scheme.
  /// Guard against paths that lead elsewhere ("..", links). The implementation must refuse files
  /// longer than Limits::image_file_bytes; the library does not.
  ///
  /// Errors: any, usually bad_input, io or limit. The reader puts the place of the reference into
  /// the error.
  virtual Result<std::vector<std::uint8_t>> load(std::string_view href) const = 0;

  /// Returns the pixels of an image whose file has these bytes. Override it to decode images
  /// yourself; the pixels must last until the document is read. Empty, which is the default: the
  /// library decodes the file. The reader calls it for files from load() and from data: URIs.
  virtual std::optional<ImagePixels> decoded(std::span<const std::uint8_t> /*file*/) const {
    return std::nullopt;
  }
};

}  // namespace sfumato
