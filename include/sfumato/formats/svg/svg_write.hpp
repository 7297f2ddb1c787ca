#pragma once

#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

/// Writes a document as SVG with the namespace of docs/format.md, in one canonical form. The result
/// reads back as a document that draws the same, and whose own SVG has the same bytes. The
/// exceptions are layers that are never painted and unused shaders: they are written, but readers
/// leave them out.
///
/// Control points, offsets, radii, colours and transforms are exact: the shortest decimals that
/// read back as the same number. A colour is `#rrggbb` where each channel is k / 255 to the bit,
/// otherwise `rgb(r% g% b%)`, where float(double(r) / 100) is the channel. An offset of arc length
/// is a percentage, read as double(p) / 100; the few doubles that are not such a quotient become
/// the nearest one.
///
/// A layer that is painted once stands in its place, others in `<defs>` with `<use>`. Ids are kept,
/// except that ids that are not XML names or not unique are changed. Textures are embedded as
/// Texture::file, or if that is empty as PNG. Radii that are 0 everywhere and local curves without
/// a colour are left out. Strokes and fills only let other programs show where the curves are.
///
/// Errors: bad_input (an invalid document), limit (memory, or a text longer than
/// Limits::input_bytes, which could not be read again), cancelled, out_of_memory.
/// Cost: O(size of the document).
Result<std::string> write_svg(Context& context, const Document& document);

}  // namespace sfumato
