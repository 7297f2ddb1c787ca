#pragma once

#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato {

/// Reads a document of either format, SVG (docs/format.md) or Orzan's XML (docs/format-orzan.md),
/// distinguished by the root element; it may be packed by gzip (.svgz).
///
/// - `bytes`: the whole file
/// - `file`: names the input in messages; no file of that name is opened
/// - `loader`: loads the textures that are separate files. Null: each of these is an error, while
///   data: URIs are read
///
/// The result is valid: validate() has accepted it. An ordinary SVG without Sfumato content gives
/// an empty document with ReadDocument::is_foreign set.
///
/// Errors: bad_input, limit, cancelled, out_of_memory, and the errors of the loader.
/// Cost: O(n log n) in the bytes of the text after gzip is unpacked, with elements that `use` reads
/// again; O(texels) for the textures. In the calling thread.
Result<ReadDocument> read_document(Context& context, std::string_view bytes,
                                   const std::string& file, const ResourceLoader* loader = nullptr);

}  // namespace sfumato
