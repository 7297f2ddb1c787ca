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
/// What every reader of documents takes and gives.

namespace sfumato {

/// The format that a document was read from.
enum class DocumentFormat : std::uint8_t {
  svg,   ///< docs/format.md
  orzan  ///< docs/format-orzan.md
};

/// Where a curve stands in the text that it was read from.
struct CurveSource {
  /// Bytes before the `<` of the curve's element: a shape, also where a `use` copies it. 0: not
  /// known, as in text that is not UTF-8; no curve's element begins a document.
  std::size_t byte_offset = 0;
  /// Which of the element's subpaths it is, from 0. Those of no length count, movements after which
  /// nothing is drawn do not.
  std::uint32_t subpath = 0;
};

/// A document, and remarks on it by its reader.
struct ReadDocument {
  Document document;  ///< valid
  /// What the reader ignored or had to guess, each with its place: one warning of each kind, at
  /// most limits::kWarnings, then one that counts the rest.
  std::vector<Diagnostic> warnings;
  DocumentFormat format = DocumentFormat::svg;  ///< what the root element said
  /// Whether it is an SVG with nothing of Sfumato in it, which import_svg() can make curves of.
  bool is_foreign = false;
  /// Of each curve of each layer, as Document::layers has them. Empty for Orzan's XML and for a
  /// packed file.
  std::vector<std::vector<CurveSource>> curve_sources{};
};

/// Pixels of an image, borrowed: sRGB code values, not premultiplied.
struct ImagePixels {
  int width = 0;                         ///< pixels
  int height = 0;                        ///< pixels
  std::span<const std::uint8_t> rgba{};  ///< row by row, 4 × width × height
};

/// Brings the files that a document refers to: its textures. The library opens none by itself, so
/// that the caller decides which files a document may name.
class ResourceLoader {
 public:
  virtual ~ResourceLoader() = default;

  /// The content of the PNG or JPEG file that a document refers to. `href` is as in the document
  /// with percent signs decoded: a relative or absolute path, never a URI with a scheme. Guard
  /// against paths that lead elsewhere ("..", links). The implementation has to refuse files longer
  /// than Limits::image_file_bytes; nobody else does.
  ///
  /// Errors: any, usually bad_input, io or limit. The reader puts the place of the reference into
  /// the error.
  virtual Result<std::vector<std::uint8_t>> load(std::string_view href) const = 0;

  /// The pixels of an image whose file has these bytes, for callers that decode images themselves;
  /// they have to last until the document is read. Empty, as by default: the library decodes the
  /// file. It is asked for files from load() and for those in data: URIs.
  virtual std::optional<ImagePixels> decoded(std::span<const std::uint8_t> /*file*/) const {
    return std::nullopt;
  }
};

}  // namespace sfumato
