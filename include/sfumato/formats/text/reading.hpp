#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

/// What every reader of documents takes and gives.
namespace sfumato {

enum class DocumentFormat : std::uint8_t { svg, orzan };

/// A document and what its reader had to overlook, each with its place.
struct ReadDocument {
  Document document;
  /// At most limits::kWarnings, then one that counts the rest.
  std::vector<Diagnostic> warnings;
  DocumentFormat format = DocumentFormat::svg;
  bool is_foreign =
      false;  ///< an SVG with nothing of Sfumato in it: import_svg() makes curves of it
};

/// Brings the files that a document refers to: textures. The library opens none by itself.
class ResourceLoader {
 public:
  virtual ~ResourceLoader() = default;

  /// The bytes behind a reference as it is written in the document, percent signs decoded; never a
  /// data: URI. At most Limits::image_file_bytes. Errors: bad_input, limit; their place is ignored.
  virtual Result<std::vector<std::uint8_t>> load(std::string_view href) const = 0;
};

}  // namespace sfumato
