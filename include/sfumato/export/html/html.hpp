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

/// Options of export_html().
struct HtmlOptions {
  std::string title = "Sfumato";  ///< of the page, UTF-8
  /// Shown where no layer covers; default: Picture::background, or white.
  std::optional<Rgb> background{};
  /// An image file of the picture, shown until the first frame is drawn and where there is no WebGL
  /// 2. Empty: a message is shown instead.
  std::vector<std::uint8_t> fallback{};
  std::string fallback_type = "image/png";  ///< media type of `fallback`: "image/" and a name
};

/// Exports a picture as one HTML file that shows it in a browser, without other files, server or
/// network. The file holds the patches, which a viewer draws by WebGL 2, so that the picture can be
/// enlarged without end (docs/viewer.md). Use export_sfv() to show a picture on a page of your own.
/// `notes`, unless null, receives the number of triangles.
///
/// Errors: bad_input (an invalid picture or background, a fallback type that is not an image type),
/// limit (Limits::viewer_triangles, Limits::viewer_stroke_segments, memory), cancelled,
/// out_of_memory.
/// Cost: about 2 µs and 12 bytes of the file a triangle, and 90 kB for the viewer.
Result<std::vector<std::uint8_t>> export_html(Context& context, const Picture& picture,
                                              const HtmlOptions& options,
                                              ExportNotes* notes = nullptr);

/// Options of export_sfv().
struct SfvOptions {
  /// Shown where no layer covers; default: Picture::background, or white.
  std::optional<Rgb> background{};
};

/// Exports the picture data of such a page as a separate file: the viewer's payload
/// (docs/viewer.md) in zlib's format, which `<sfumato-picture src>` shows without solving
/// (docs/npm.md). `notes`, unless null, receives the number of triangles.
///
/// Errors and cost: as export_html(), without the viewer's 90 kB.
Result<std::vector<std::uint8_t>> export_sfv(Context& context, const Picture& picture,
                                             const SfvOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
