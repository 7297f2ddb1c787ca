#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "base/pixel_rect.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "sfumato/trace/trace.hpp"

/// Structures that options set. An empty optional means that the option was not given.
namespace sfumato::options {

/// Holds bounds on the memory and time of work, and the limits on its input.
struct Resources {
  Limits limits{};
  std::size_t memory_bytes = limits::kMemoryBytes;
  std::optional<double> seconds{};  ///< none: no limit
};

/// Returns the deadline, counted from now.
std::optional<Deadline> deadline_of(const Resources& resources);

/// Holds the requested size: pixels, or pixels per user unit (not both).
struct SizeRequest {
  std::optional<int> width{};
  std::optional<int> height{};
  std::optional<double> scale{};
};

/// How colours are found: in closed form or by random rays on a mesh, or at every pixel without
/// one.
enum class Method : std::uint8_t { exact, rays, pixels };

/// The device that draws pixels or gathers colours.
enum class Device : std::uint8_t { cpu, gpu };

/// Holds how a picture is written. settle() fills in the values that are not given, except `dpi`,
/// whose default depends on the format.
struct OutputOptions {
  std::optional<int> quality{};  ///< of JPEG and lossy WebP
  bool lossless = false;
  // For outputs that can be enlarged:
  std::optional<double> detail{};  ///< the mesh is made for a picture this many times larger
  std::optional<double> dpi{};     ///< of parts stored as pixels
  std::optional<SvgMode> svg{};
  bool force = false;  ///< a vector SVG of any size
  PdfFlatten pdf_flatten = PdfFlatten::automatic;
  std::string title;
};

/// Holds everything about how a drawing is solved, drawn and written.
struct Settings {
  SizeRequest size;
  std::optional<PixelRect> window{};  ///< of the image that this size would be; none: all of it
  /// As requested, except pixels_per_unit, which follows from the size.
  DiffuseOptions diffuse;
  bool sets_max_error = false;  ///< max-error was given
  Method method = Method::exact;
  Device device = Device::cpu;
  Device gather = Device::cpu;
  /// As requested, except width, height, viewport and the alpha channel.
  RasterOptions raster;
  int depth = 8;                 ///< bits per channel
  std::optional<bool> dither{};  ///< settle() sets RasterOptions::dither from it
  bool no_background = false;    ///< ignore the drawing's own background too, always write alpha
  OutputOptions output;
  bool coherent = false;  ///< each drawing starts from the mesh of the drawing before
  int threads = 0;        ///< 0: all cores
};

/// Settings of a context that is made from options.
struct ContextSettings {
  std::optional<SimdLevel> simd{};  ///< none: the best that the machine has
};

/// Settings of a picture that the C interface keeps solved.
struct PictureSettings {
  std::optional<std::size_t> drag_triangles{};  ///< Solution::expect_drags(), if given
  bool pixel_grid = false;                      ///< DiffuseOptions::pixel_grid
};

/// Settings of a search for probable mistakes.
struct LintSettings {
  bool verbose = false;  ///< with notes
};

/// Settings for tracing a picture, or for fitting the colours of a drawing to it (the members that
/// ColorFit has).
struct TraceSettings {
  TraceOptions trace{};
  std::optional<double> detail{};     ///< 0 to 1, instead of TraceOptions::points
  bool keeps_colors = false;          ///< as ColorFit
  std::optional<std::string> only{};  ///< as parse_curves() reads it
};

/// Returns the number of control points for a detail from 0 to 1: 250 to 16,000.
int points_of_detail(double detail);

/// Returns the settings of a fit of colours, except `only`, whose memory the caller charges.
ColorFit color_fit_of(const TraceSettings& settings);

/// Settings of a document that is made from options.
struct DocumentSettings {
  std::optional<Box> artboard{};
  InterpolationSpace interpolation = InterpolationSpace::srgb;
  std::optional<Rgb> background{};
};

}  // namespace sfumato::options
