#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "document/document.hpp"

namespace sfumato {

enum class DocumentFormat : std::uint8_t { svg, orzan };

/// A document and what its reader had to overlook, each with its place.
struct ReadDocument {
  Document document;
  std::vector<Status>
      warnings;  ///< code bad_input; at most limits::kWarnings, then one that counts the rest
  DocumentFormat format = DocumentFormat::svg;
};

/// Brings the files that a document refers to: textures. The library opens none by itself.
class ResourceLoader {
 public:
  virtual ~ResourceLoader() = default;

  /// The bytes behind a reference as it is written in the document, percent signs decoded; never a
  /// data: URI. At most
  /// Limits::image_file_bytes. Errors: bad_input, limit; their place is ignored.
  virtual Result<std::vector<std::uint8_t>> load(std::string_view href) const = 0;
};

/// Reads a document of any format, by its root element: SVG (docs/format.md) or Orzan's XML
/// (docs/format-orzan.md); packed by gzip (.svgz) too. `file` names the input in messages.
/// `loader` may be null: then every file that the document refers to is an error.
/// Errors: bad_input, limit, cancelled, out_of_memory.
Result<ReadDocument> read_document(Context& context, std::string_view bytes,
                                   const std::string& file, const ResourceLoader* loader = nullptr);

}  // namespace sfumato
