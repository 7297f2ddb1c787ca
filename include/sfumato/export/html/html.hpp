#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sfumato/base/color.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

struct HtmlOptions {
  std::string title = "Sfumato";  ///< UTF-8
  /// Behind what no layer covers; default the picture's own, else white.
  std::optional<Rgb> background{};
  /// The picture as pixels, shown until the first frame is drawn and where there is no WebGL 2;
  /// empty: words alone.
  std::vector<std::uint8_t> fallback{};
  std::string fallback_type = "image/png";  ///< media type of `fallback`
};

/// One file that shows the picture in a browser: no other file, server or network is needed. The
/// patches themselves are in it, so that it is sharp at every zoom (docs/viewer.md).
///
/// Errors: bad_input (a picture whose tables do not fit, a fallback type that is none), limit
/// (kViewerTriangles, kViewerStrokeSegments, memory), cancelled.
/// Cost: about 2 µs and 12 bytes of the file a triangle, and 90 kB for the viewer.
Result<std::vector<std::uint8_t>> export_html(Context& context, const Picture& picture,
                                              const HtmlOptions& options,
                                              ExportNotes* notes = nullptr);

}  // namespace sfumato
