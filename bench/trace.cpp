// Traces pictures and reports the quality, as Markdown:
//
//   trace [--points N,N...] [--threads N] [--smooth PX] [--stops few|normal|many]
//         [--blur fitted|estimated|sharp] [--out FOLDER] [photos|drawings|flat|FILE]...
//
// Without a picture: all three groups. PSNR and SSIM compare the picture with the drawing, rendered
// with 16 bits at the picture's size; a transparent picture is compared on white and on black, and
// the worse value counts. "predicted" is the trace's own estimate after its last round. For
// drawings: the visible share of the length of their curves, the share of it that the trace finds
// within two pixels, and the share of the trace that lies on it. Seconds of wall clock and of CPU,
// and the peak memory of the process, cover only trace(). --out stores the drawings as
// FOLDER-NAME-POINTS.svg and .png.

#include "sfumato/trace/trace.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/stopwatch.hpp"
#include "largest_layer.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "support/draw.hpp"
#include "support/found_curves.hpp"
#include "support/picture_quality.hpp"
#include "trace_pictures.hpp"

namespace sfumato {
namespace {

struct Arguments {
  std::vector<int> points{0};
  int threads = 0;
  std::string out;
  TraceOptions options;
  std::vector<std::string> files;
};

/// Measures the peak memory of this process in MB since the last reset(). 0 if the system does not
/// report it.
struct PeakMemory {
  static void reset() { std::ofstream("/proc/self/clear_refs") << "5"; }
  static double megabytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("VmHWM:")) return std::atof(line.c_str() + 6) / 1000;
    }
    return 0;
  }
};

struct Counts {
  std::size_t curves = 0;
  std::size_t points = 0;
  std::size_t stops = 0;
};

Counts counts_of(const Document& document) {
  Counts counts;
  for (const Layer& layer : document.layers) {
    counts.curves += layer.curves.size();
    for (const Curve& curve : layer.curves) {
      counts.points += curve.control_points.size();
      counts.stops += curve.left.color.stops.stops.size() + curve.right.color.stops.stops.size();
    }
  }
  return counts;
}

/// The similarity of a drawing and a picture.
struct Likeness {
  double psnr_db = 0;
  std::optional<double> ssim;
};

Likeness likeness_of(const Image& drawn, const Image& picture) {
  std::optional<Likeness> worst;
  std::vector<Rgb> backgrounds{{1, 1, 1}};
  if (channel_count(picture.format) == 4) backgrounds.push_back({0, 0, 0});
  for (const Rgb& background : backgrounds) {
    const test::Planes a = test::planes_of(drawn, background);
    const test::Planes b = test::planes_of(picture, background);
    const Likeness likeness{test::psnr_db(a, b), test::ssim(a, b)};
    if (!worst || likeness.psnr_db < worst->psnr_db) worst = likeness;
  }
  return *worst;
}

Status keep(Context& context, const std::string& stem, const std::string& svg, const Image& drawn) {
  const std::span text(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size());
  if (Status status = write_file(stem + ".svg", text); !status) return status;
  const Result<std::vector<std::uint8_t>> png = encode_png(context, drawn);
  return png ? write_file(stem + ".png", *png) : png.status();
}

void print_head() {
  std::printf(
      "| picture | points | dB | SSIM | predicted dB | curves | points | stops | bytes | "
      "s | CPU s | MB | median length, px | curves with 9/10 | visible | found | true |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_truth(const bench::TracePicture& picture, const Document& drawing) {
  if (!picture.truth) {
    std::printf(" | | |\n");
    return;
  }
  const test::FoundCurves found =
      test::find_curves(*picture.truth, drawing, test::planes_of(picture.image));
  std::printf(" %.0f%% | %.1f%% | %.1f%% |\n", 100 * found.visible_share, 100 * found.found_share,
              100 * found.true_share);
}

Status measure(Context& context, const bench::TracePicture& picture, int points,
               const Arguments& arguments) {
  TraceOptions options = arguments.options;
  options.points = points;
  TraceStats stats;
  PeakMemory::reset();
  const Stopwatch watch;
  const double cpu = bench::cpu_milliseconds();
  const Result<Document> drawing = trace(context, picture.image, options, &stats);
  const double seconds = watch.seconds(), cpu_seconds = (bench::cpu_milliseconds() - cpu) / 1000;
  const double megabytes = PeakMemory::megabytes();
  if (!drawing) return drawing.status();

  const bool has_alpha = channel_count(picture.image.format) == 4;
  const Result<Image> drawn =
      test::draw(context, *drawing, picture.image.width, picture.image.height,
                 has_alpha ? PixelFormat::rgba16 : PixelFormat::rgb16);
  if (!drawn) return drawn.status();
  const Result<std::string> svg = write_svg(context, *drawing);
  if (!svg) return svg.status();
  const Likeness likeness = likeness_of(*drawn, picture.image);
  const Counts counts = counts_of(*drawing);
  std::printf(
      "| %s | %d | %.2f | %.3f | %.2f | %zu | %zu | %zu | %zu | %.2f | %.2f | %.0f | %.0f | %zu |",
      picture.name.c_str(), points, likeness.psnr_db, likeness.ssim.value_or(0),
      stats.rounds.empty() ? 0 : stats.rounds.back().psnr_db, counts.curves, counts.points,
      counts.stops, svg->size(), seconds, cpu_seconds, megabytes, stats.median_length_px,
      stats.curves_of_nine_tenths);
  print_truth(picture, *drawing);
  std::fflush(stdout);
  if (arguments.out.empty()) return ok_status();
  std::string file = picture.name + '-' + std::to_string(points);
  std::ranges::replace(file, '/', '-');
  return keep(context, arguments.out + '/' + file, *svg, *drawn);
}

bool take_number_list(const std::string& text, std::vector<int>& numbers) {
  numbers.clear();
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const int number = std::atoi(text.substr(at, end - at).c_str());
    if (number <= 0) return false;
    numbers.push_back(number);
    at = end + 1;
  }
  return true;
}

template <class Value>
bool take_name(const std::string& name, const std::map<std::string, Value>& values, Value& value) {
  const auto found = values.find(name);
  if (found == values.end()) return false;
  value = found->second;
  return true;
}

bool take_option(const std::string& name, const std::string& value, Arguments& arguments) {
  TraceOptions& options = arguments.options;
  if (name == "--points") return take_number_list(value, arguments.points);
  if (name == "--stops") {
    return take_name<TraceStops>(
        value,
        {{"few", TraceStops::few}, {"normal", TraceStops::normal}, {"many", TraceStops::many}},
        options.stops);
  }
  if (name == "--blur") {
    return take_name<TraceBlur>(value,
                                {{"fitted", TraceBlur::fitted},
                                 {"estimated", TraceBlur::estimated},
                                 {"sharp", TraceBlur::sharp}},
                                options.blur);
  }
  if (name == "--threads") {
    arguments.threads = std::atoi(value.c_str());
  } else if (name == "--smooth") {
    options.smooth_px = std::atof(value.c_str());
  } else if (name == "--out") {
    arguments.out = value;
  } else {
    return false;
  }
  return true;
}

std::optional<Arguments> arguments_of(int argc, char** argv) {
  Arguments arguments;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (!argument.starts_with("--")) {
      names.push_back(argument);
    } else if (i + 1 == argc || !take_option(argument, argv[++i], arguments)) {
      std::fprintf(stderr, "trace: %s is not understood; bench/trace.cpp says what is\n",
                   argument.c_str());
      return std::nullopt;
    }
  }
  if (names.empty()) names = {"photos", "drawings", "flat"};
  for (const std::string& name : names) {
    std::vector<std::string> group = bench::trace_group(name);
    if (group.empty() && name.find('.') != std::string::npos) group = {name};
    arguments.files.insert(arguments.files.end(), group.begin(), group.end());
  }
  return arguments;
}

bool measure_file(Context& context, const std::string& path, const Arguments& arguments) {
  const Result<bench::TracePicture> picture = bench::read_trace_picture(context, path);
  Status status = picture.status();
  for (const int points : arguments.points) {
    if (status) status = measure(context, *picture, points, arguments);
  }
  if (!status) std::fprintf(stderr, "trace: %s: %s\n", path.c_str(), to_string(status).c_str());
  return status.ok();
}

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  const std::optional<sfumato::Arguments> arguments = sfumato::arguments_of(argc, argv);
  if (!arguments) return 2;
  sfumato::ThreadPool pool(arguments->threads);
  sfumato::Context context;
  context.executor = &pool;
  sfumato::print_head();
  bool is_good = true;
  for (const std::string& path : arguments->files) {
    is_good = sfumato::measure_file(context, path, *arguments) && is_good;
  }
  return is_good ? 0 : 1;
}
