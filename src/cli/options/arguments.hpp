#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/commands/jobs.hpp"
#include "cli/files/paths.hpp"
#include "cli/messages.hpp"
#include "cli/resources.hpp"
#include "options/output_kind.hpp"
#include "options/settings.hpp"
#include "sfumato/trace/trace.hpp"

namespace sfumato::cli {

/// Arguments of every command that reads a document.
struct DocumentArguments {
  std::string input;
  std::vector<std::string> allowed_folders;  ///< textures may be in these existing folders too
  std::vector<std::string> outputs;  ///< files that the call writes; no texture may be one of them
  options::Resources resources = default_resources();
  bool quiet = false;
};

/// `input` is the input of the current job.
struct RenderArguments : DocumentArguments, JobArguments {
  OutputKind kind = OutputKind::png;
  options::Settings settings;
  /// Options that were given but do not apply to a solved picture: "--rays".
  std::vector<std::string> drawing_options;
};

/// `input` is the input of the current job.
struct SolveArguments : DocumentArguments, JobArguments {
  options::Settings settings;
};

/// `input`: a solved picture.
struct TilesArguments : DocumentArguments {
  TilesArguments() { resources.seconds.reset(); }  // no limit by default: gigapixels take long

  std::string output;
  std::string stats;              ///< where the JSON goes; empty: nowhere
  std::string extension = "png";  ///< of the tiles of a Deep Zoom pyramid
  bool is_tiff = false;           ///< one file with all tiles
  int tile_side = 256;            ///< pixels
  int overlap = 0;                ///< pixels
  Shard shard;
  options::Settings settings;
};

struct ConvertArguments : DocumentArguments {
  std::string output;
};

struct InfoArguments : DocumentArguments {
  bool json = false;
};

/// `input` is the current one.
struct LintArguments : DocumentArguments {
  std::vector<std::string> inputs;
  bool verbose = false;  ///< report notes too, which need no action
  bool strict = false;   ///< a hint is a failure
  bool json = false;
};

/// `input`: the SVG to make curves from; empty: the template is used.
struct InitArguments : DocumentArguments {
  std::string output;
  std::string template_name = "shape";
  bool force = false;  ///< an existing file is replaced
};

struct WatchArguments : DocumentArguments {
  int port = 0;                         ///< of 127.0.0.1; 0: any
  RenderArguments page;                 ///< the PNG for the page
  std::optional<RenderArguments> file;  ///< the file that is written too
};

/// `input`: the drawing, which is created if it does not exist.
struct EditArguments : DocumentArguments {
  int port = 0;  ///< of 127.0.0.1; 0: any
  bool opens_browser = true;
};

/// `input`: the drawing of --colors-only; empty: there is none.
struct TraceArguments : DocumentArguments, JobArguments {
  TraceOptions options;  ///< but the watch
  ColorFit fit;          ///< of --colors-only
  int threads = 0;       ///< 0: all cores
};

struct CompareArguments {
  std::string first;
  std::string second;
  std::string output;  ///< of the difference picture; empty: none
  double scale = 128;
  options::Resources resources = default_resources();
  bool json = false;
};

/// Holds the answer where no command runs: print `text` and return `exit_code`. The text goes to
/// standard output if exit_code is kDone, else to standard error.
struct NoCommand {
  std::string text;
  ExitCode exit_code = kBadUsage;
};

using Command = std::variant<NoCommand, RenderArguments, SolveArguments, TilesArguments,
                             InfoArguments, ConvertArguments, LintArguments, CompareArguments,
                             InitArguments, WatchArguments, EditArguments, TraceArguments>;

/// Reads the command line. Never prints, never exits.
Command parse_arguments(int argc, const char* const* argv);

}  // namespace sfumato::cli
