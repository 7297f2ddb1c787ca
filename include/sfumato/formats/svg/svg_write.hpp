#pragma once

#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

/// A document as SVG with the namespace of docs/format.md, in one canonical form: what is read back
/// draws the same, and written again has the same bytes, but for layers that are never painted and
/// shaders that nothing uses: they are written, and left out by readers.
///
/// Exact: control points, offsets, radii, colours and transforms are the shortest decimals that
/// read back as the same number. A colour is #rrggbb where each channel is k / 255 to the bit, else
/// rgb(r% g% b%), where float(double(r) / 100) is the channel. An offset of arc length is p%, read
/// as double(p) / 100; the few doubles that are no such quotient become the nearest one.
///
/// A layer that is painted once stands in its place, others in <defs> with <use>. Ids are kept;
/// what is no XML name or not unique is changed. Textures are embedded as the PNG or JPEG file that
/// they came from, else as PNG. Radii that are 0 everywhere and local curves without a colour are
/// left out. Strokes and fills only show other programs where the curves are.
///
/// Errors  bad_input: the document is not valid, or a texture does not repeat; limit: memory, or
///         longer than can be read (limits::kInputBytes); cancelled.
/// Cost    O(size of the document).
Result<std::string> write_svg(Context& context, const Document& document);

}  // namespace sfumato
