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

/// What options set. Empty optionals were not given.
namespace sfumato::options {

/// Bounds on the memory and time of work, and the limits on its input.
struct Resources {
  Limits limits{};
  std::size_t memory_bytes = limits::kMemoryBytes;
  std::optional<double> seconds{};  ///< none: no limit
};

/// The deadline, counted from now.
std::optional<Deadline> deadline_of(const Resources& resources);

/// The size that the user requested: pixels, or pixels per user unit (not both).
struct SizeRequest {
  std::optional<int> width{};
  std::optional<int> height{};
  std::optional<double> scale{};
};

/// How colours are found: in closed form or by random rays on a mesh, or at every pixel without
/// one.
enum class Method : std::uint8_t { exact, rays, pixels };

/// What draws pixels, or gathers.
enum class Device : std::uint8_t { cpu, gpu };

/// How a picture is written. settle() gives those a value that are not given, but for `dpi`, whose
/// default is the format's.
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

/// Everything that says how a drawing is solved, drawn and written.
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
  std::optional<bool> dither{};  ///< settle() decides for RasterOptions::dither
  bool no_background = false;    ///< not even the drawing's own, always alpha
  OutputOptions output;
  bool coherent = false;  ///< each of many drawings goes on with the mesh of the one before
  int threads = 0;        ///< 0: all cores
};

/// Of a context that is made from options.
struct ContextSettings {
  std::optional<SimdLevel> simd{};  ///< none: the best that the machine has
};

/// Of a picture that the C interface keeps solved.
struct PictureSettings {
  std::optional<std::size_t> drag_triangles{};  ///< Solution::expect_drags(), if given
};

/// Of a look for probable mistakes.
struct LintSettings {
  bool verbose = false;  ///< with notes
};

/// Of a trace of a picture; of colours from one, what ColorFit has.
struct TraceSettings {
  TraceOptions trace{};
  std::optional<double> detail{};     ///< 0 to 1, in the place of TraceOptions::points
  bool keeps_colors = false;          ///< as ColorFit
  std::optional<std::string> only{};  ///< as parse_curves() reads it
};

/// The control points that a detail from 0 to 1 stands for: 250 to 16,000.
int points_of_detail(double detail);

/// What the settings say of colours, but `only`, whose memory is the caller's affair.
ColorFit color_fit_of(const TraceSettings& settings);

/// Of a document that is made from options.
struct DocumentSettings {
  std::optional<Box> artboard{};
  InterpolationSpace interpolation = InterpolationSpace::srgb;
  std::optional<Rgb> background{};
};

}  // namespace sfumato::options
