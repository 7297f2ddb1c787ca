#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/messages.hpp"
#include "cli/output_size.hpp"
#include "cli/paths.hpp"
#include "cli/render_jobs.hpp"
#include "cli/resources.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::cli {

/// What every command is told that reads a document.
struct DocumentArguments {
  std::string input;
  std::vector<std::string> allowed_folders;  ///< textures may come from there too; they exist
  std::vector<std::string> outputs;          ///< that the call writes: no texture may be one
  Resources resources;
  bool quiet = false;
};

/// How a picture is written.
struct OutputOptions {
  OutputKind kind = OutputKind::png;
  int quality = 90;  ///< of JPEG and lossy WebP
  bool lossless = false;
  // Of outputs that can be enlarged:
  double detail = 2;            ///< the mesh is made for a picture this many times larger
  std::optional<double> dpi{};  ///< of what stands as pixels; none: as the format has it
  SvgMode svg = SvgMode::image;
  bool force = false;  ///< a vector SVG of any size
  PdfFlatten pdf_flatten = PdfFlatten::automatic;
  std::string title;  ///< empty: the name of the drawing
};

/// `input` is of the job at hand.
struct RenderArguments : DocumentArguments {
  std::vector<RenderJob> jobs;
  bool many = false;  ///< --out-dir was given
  std::string output_folder;
  OutputOptions output;
  SizeRequest size;
  bool per_pixel = false;  ///< --method pixels
  bool on_gpu = false;     ///< --device gpu
  /// As asked for, but for pixels_per_unit, which comes from the size.
  DiffuseOptions diffuse;
  /// As asked for, but for width, height, viewport and the alpha channel.
  RasterOptions raster;
  bool no_background = false;  ///< --background none: not even the drawing's own, always alpha
  int threads = 0;             ///< 0: all cores
  std::string stats;           ///< where the JSON goes; empty: nowhere
};

struct ConvertArguments : DocumentArguments {
  std::string output;
};

struct InfoArguments : DocumentArguments {
  bool json = false;
};

/// `input` is the one at hand.
struct LintArguments : DocumentArguments {
  std::vector<std::string> inputs;
  bool verbose = false;  ///< with notes, which ask for nothing
  bool strict = false;   ///< a hint is a failure
  bool json = false;
};

/// `input`: what curves are made of; empty: the template.
struct InitArguments : DocumentArguments {
  std::string output;
  std::string template_name = "shape";
  bool force = false;  ///< an existing file is replaced
};

struct WatchArguments : DocumentArguments {
  int port = 0;                         ///< of 127.0.0.1; 0: any
  RenderArguments page;                 ///< as PNG, for the page
  std::optional<RenderArguments> file;  ///< what is written besides
};

struct CompareArguments {
  std::string first;
  std::string second;
  std::string output;  ///< of the difference picture; empty: none
  double scale = 128;
  Resources resources;
  bool json = false;
};

/// No command was given, or none is to be run: print `text` and return `exit_code`. The text
/// belongs to standard output exactly where exit_code is kDone.
struct NoCommand {
  std::string text;
  ExitCode exit_code = kBadUsage;
};

using Command = std::variant<NoCommand, RenderArguments, InfoArguments, ConvertArguments,
                             LintArguments, CompareArguments, InitArguments, WatchArguments>;

/// Reads the command line. Never prints, never exits.
Command parse_arguments(int argc, const char* const* argv);

}  // namespace sfumato::cli
