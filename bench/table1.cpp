// Prints the paper's Table 1 beside our figures, as Markdown:
//
//   table1 [--runs N] [--threads N] [FOLDER OF SCENES]
//
// Times are medians of N runs (default 11) after one uncounted run, in milliseconds of wall clock,
// with the best run in parentheses; ratios are of medians. Default: all threads. The mesh is the
// paper's (no error-driven refinement), except in the last two rows. The paper's machine had a
// GTX 780. Exit 77 if a scene is missing (bench/regions.txt).

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <sfumato/sfumato.hpp>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "support/places.hpp"

namespace sfumato {
namespace {

constexpr int kImagePixels = 1024;
constexpr int kSkipped = 77;  // the exit code where a scene is missing

struct PaperColumn {
  const char* name;
  const char* curves;
  const char* triangles;
  const char* vertices;
  const char* nodes;
  const char* geometry;
  const char* triangulation;
  const char* color;
  const char* rays_to_picture;
};

struct Scene {
  const char* file;
  PaperColumn paper;
};

constexpr Scene kScenes[] = {
    {"lady_bug", {"LADYBUG", "72", "9k", "5k", "37k", "18", "7", "49", "16"}},
    {"tomatos", {"TOMATOES", "395", "10k", "5k", "38k", "19", "5", "53", "16"}},
    {"dolphin", {"FISH", "1859", "53k", "27k", "113k", "61", "16", "277", "16"}},
};

/// Milliseconds of wall clock. On a busy machine `best` is more reliable.
struct Time {
  double median = 0;
  double best = 0;
};

/// One scene with one number of threads.
struct Measured {
  int threads = 0;
  DiffuseStats sizes;
  Time geometry;
  Time triangulation;
  Time gather_exact;
  Time gather_rays;
  Time raster;
  Time pixels_exact;
  DiffuseStats default_sizes;
  Time default_total;
};

[[noreturn]] void fail(const Status& status) {
  std::fprintf(stderr, "table1: %s\n", to_string(status).c_str());
  std::exit(status.code == StatusCode::io ? 1 : 4);
}

template <class T>
T value_or_fail(Result<T> result) {
  if (!result) fail(result.status());
  return std::move(*result);
}

Time summary(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const std::size_t middle = seconds.size() / 2;
  const double median =
      seconds.size() % 2 ? seconds[middle] : (seconds[middle - 1] + seconds[middle]) / 2;
  return {1000 * median, 1000 * seconds.front()};
}

/// Returns summaries of the columns that `run` returns in seconds, after one uncounted run.
std::vector<Time> times_of(int run_count, const std::function<std::vector<double>()>& run) {
  std::vector<std::vector<double>> columns(run().size());
  for (int i = 0; i < run_count; ++i) {
    const std::vector<double> row = run();
    for (std::size_t c = 0; c < row.size(); ++c) columns[c].push_back(row[c]);
  }
  std::vector<Time> result;
  for (const auto& column : columns) result.push_back(summary(column));
  return result;
}

/// Returns the pixel centres of an image over the artboard, in tiles of 4×4, so that neighbours in
/// the list are neighbours in the plane.
std::vector<Vec2> pixel_centres(const Box& artboard) {
  std::vector<Vec2> points;
  for (int tile_y = 0; tile_y < kImagePixels; tile_y += 4) {
    for (int tile_x = 0; tile_x < kImagePixels; tile_x += 4) {
      for (int i = 0; i < 16; ++i) {
        const double x = (tile_x + i % 4 + 0.5) / kImagePixels;
        const double y = (tile_y + i / 4 + 0.5) / kImagePixels;
        points.push_back(
            {artboard.min.x + x * artboard.width(), artboard.min.y + y * artboard.height()});
      }
    }
  }
  return points;
}

/// Returns options without blur, because the paper's mesh ignores blur radii; bench/features
/// measures them.
DiffuseOptions sharp_options() {
  DiffuseOptions options;
  options.ignore_blur = true;
  options.ends = gather::Ends::paper;
  return options;
}

void measure_paper_mesh(Context& context, const Document& document, int runs, Measured& out) {
  DiffuseOptions options = sharp_options();
  options.max_error = 0;
  const auto times = times_of(runs, [&] {
    value_or_fail(diffuse(context, document, options, &(out.sizes = {})));
    const DiffuseStats& s = out.sizes;
    return std::vector{s.geometry_seconds, s.triangulation_seconds, s.gather_seconds};
  });
  out.geometry = times[0];
  out.triangulation = times[1];
  out.gather_exact = times[2];

  options.gather.method = gather::Method::rays;
  out.gather_rays = times_of(runs, [&] {
    DiffuseStats stats;
    value_or_fail(diffuse(context, document, options, &stats));
    return std::vector{stats.gather_seconds};
  })[0];
}

void measure_raster(Context& context, const Document& document, int runs, Measured& out) {
  DiffuseOptions options = sharp_options();
  options.max_error = 0;
  const Picture picture = value_or_fail(diffuse(context, document, options));
  RasterOptions raster_options;
  raster_options.width = kImagePixels;
  raster_options.height = kImagePixels;
  out.raster = times_of(runs, [&] {
    const Stopwatch watch;
    value_or_fail(rasterize(context, picture, raster_options));
    return std::vector{watch.seconds()};
  })[0];
}

void measure_pixels(Context& context, const Document& document, int runs, Measured& out) {
  const auto evaluator = value_or_fail(PointEvaluator::create(context, document, sharp_options()));
  const std::vector<Vec2> points = pixel_centres(document.artboard);
  std::vector<float> rgb(3 * points.size());
  std::vector<std::uint8_t> hit(points.size());
  out.pixels_exact = times_of(runs, [&] {
    const Stopwatch watch;
    const Status status = evaluator.evaluate(context, 0, points, rgb, hit);
    if (!status) fail(status);
    return std::vector{watch.seconds()};
  })[0];
}

void measure_default(Context& context, const Document& document, int runs, Measured& out) {
  out.default_total = times_of(runs, [&] {
    const Stopwatch watch;
    value_or_fail(diffuse(context, document, sharp_options(), &(out.default_sizes = {})));
    return std::vector{watch.seconds()};
  })[0];
}

Measured measure(const Document& document, int threads, int runs) {
  ThreadPool pool(threads);
  Context context;
  context.executor = &pool;
  Measured out;
  out.threads = context.thread_count();
  measure_paper_mesh(context, document, runs, out);
  measure_raster(context, document, runs, out);
  measure_pixels(context, document, runs, out);
  measure_default(context, document, runs, out);
  return out;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 10 ? "%.2f" : value < 100 ? "%.1f" : "%.0f", value);
  return text;
}

std::string text_of(const Time& time) {
  return number(time.median) + " (" + number(time.best) + ")";
}

std::string ratio(double value, double unit) {
  return number(value / unit);
}

/// A scene with its figures: two columns of the table.
struct Column {
  const Scene* scene;
  Measured measured;
};

void print_row(const char* name, const std::vector<Column>& columns,
               const char* PaperColumn::*paper,
               const std::function<std::string(const Measured&)>& text) {
  std::printf("| %s |", name);
  for (const Column& column : columns) {
    const char* theirs = paper ? column.scene->paper.*paper : "";
    std::printf(" %s | %s |", theirs, text(column.measured).c_str());
  }
  std::printf("\n");
}

void print_head(const std::vector<Column>& columns) {
  std::printf("| |");
  for (const Column& column : columns) {
    std::printf(" paper: %s | %s |", column.scene->paper.name, column.scene->file);
  }
  std::printf("\n|---|");
  for (std::size_t i = 0; i < columns.size(); ++i) std::printf("---|---|");
  std::printf("\n");
}

void print_sizes(const std::vector<Column>& columns) {
  const auto row = [&](const char* name, const char* PaperColumn::*paper, auto size) {
    print_row(name, columns, paper,
              [size](const Measured& m) { return std::to_string(m.sizes.*size); });
  };
  row("curves", &PaperColumn::curves, &DiffuseStats::curves);
  row("triangles", &PaperColumn::triangles, &DiffuseStats::triangles);
  row("vertices", &PaperColumn::vertices, &DiffuseStats::vertices);
  row("nodes", &PaperColumn::nodes, &DiffuseStats::nodes);
}

/// Returns the cost of 64 rays at every pixel, from the cost of a node, in units of the picture's.
std::string rays_to_picture(const Measured& m) {
  const double pixels = double{kImagePixels} * kImagePixels;
  const double rays = m.gather_rays.median / static_cast<double>(m.sizes.nodes) * pixels;
  return ratio(
      rays, m.geometry.median + m.triangulation.median + m.gather_exact.median + m.raster.median);
}

void print_times(const std::vector<Column>& columns) {
  const auto row = [&](const char* name, const char* PaperColumn::*paper, Time Measured::*time) {
    print_row(name, columns, paper, [time](const Measured& m) { return text_of(m.*time); });
  };
  row("geometry", &PaperColumn::geometry, &Measured::geometry);
  row("triangulation: both meshes, layout of the nodes", &PaperColumn::triangulation,
      &Measured::triangulation);
  row("colour: exact gather", nullptr, &Measured::gather_exact);
  row("colour: 64 rays a node", &PaperColumn::color, &Measured::gather_rays);
  row("raster at 1024²", nullptr, &Measured::raster);
  row("exact gather at every pixel of 1024²", nullptr, &Measured::pixels_exact);
  print_row("exact : rays : every pixel", columns, nullptr, [](const Measured& m) {
    return "1 : " + ratio(m.gather_rays.median, m.gather_exact.median) + " : " +
           ratio(m.pixels_exact.median, m.gather_exact.median);
  });
  print_row("exact gather, ns a node", columns, nullptr, [](const Measured& m) {
    return number(1e6 * m.gather_exact.median / static_cast<double>(m.sizes.nodes));
  });
  print_row("64 rays at every pixel : whole picture", columns, &PaperColumn::rays_to_picture,
            rays_to_picture);
  row("with refinement (the default): whole diffuse()", nullptr, &Measured::default_total);
  print_row("with refinement: nodes", columns, nullptr,
            [](const Measured& m) { return std::to_string(m.default_sizes.nodes); });
}

const char* simd_name(SimdLevel level) {
  switch (level) {
    case SimdLevel::avx512:
      return "AVX-512";
    case SimdLevel::avx2:
      return "AVX2";
    default:
      return "128-bit SIMD";
  }
}

Document document_of(const std::string& folder, const Scene& scene) {
  const std::string path = folder + "/" + scene.file + ".xml";
  auto xml = read_file(path, limits::kInputBytes);
  if (!xml) {
    std::fprintf(stderr,
                 "table1: no %s. The scenes are Orzan et al.'s research data and not part of this "
                 "project: give the folder that holds them as an argument.\n",
                 path.c_str());
    std::exit(kSkipped);
  }
  Context context;
  return value_or_fail(read_orzan(context, *xml, path)).document;
}

int run(const std::string& folder, int threads, int runs) {
  std::vector<Column> columns;
  for (const Scene& scene : kScenes) {
    columns.push_back({&scene, measure(document_of(folder, scene), threads, runs)});
  }
  const int used = columns.front().measured.threads;
  std::printf("Milliseconds; medians of %d runs, and the best in parentheses; %d thread%s; %s.\n\n",
              runs, used, used == 1 ? "" : "s", simd_name(detected_simd_level()));
  print_head(columns);
  print_sizes(columns);
  print_times(columns);
  return 0;
}

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  std::string folder = sfumato::test::shared_path("scenes");
  int runs = 11;
  int threads = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--runs" && i + 1 < argc) {
      runs = std::max(1, std::atoi(argv[++i]));
    } else if (word == "--threads" && i + 1 < argc) {
      threads = std::max(0, std::atoi(argv[++i]));
    } else {
      folder = word;
    }
  }
  return sfumato::run(folder, threads, runs);
}
