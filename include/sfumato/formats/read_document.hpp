#pragma once

#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato {

/// Reads a document of either format, SVG (docs/format.md) or Orzan's XML (docs/format-orzan.md),
/// which its root element tells apart; it may be packed by gzip (.svgz).
///
/// - `bytes`: the whole file
/// - `file`: names the input in messages; nothing of that name is opened
/// - `loader`: brings the textures that are files of their own. Null: each of these is an error,
///   while data: URIs are read
///
/// The result is valid: validate() has accepted it. An ordinary SVG without anything of Sfumato
/// gives an empty document with ReadDocument::is_foreign set.
///
/// Errors: bad_input, limit, cancelled, out_of_memory, and those of the loader.
/// Cost: O(n log n) in the bytes of the text after gzip is unpacked, with elements that `use` reads
/// again; O(texels) for the textures. In the calling thread.
Result<ReadDocument> read_document(Context& context, std::string_view bytes,
                                   const std::string& file, const ResourceLoader* loader = nullptr);

}  // namespace sfumato
