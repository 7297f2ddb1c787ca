#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/stopwatch.hpp"
#include "scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

// lady_bug in each format: bytes, bytes after gzip (formats that are compressed already hardly
// change), triangles, and the time from the picture to the bytes.
namespace sfumato {
namespace {

constexpr int kRuns = 5;

using Bytes = std::vector<std::uint8_t>;
struct Format {
  const char* name;
  Result<Bytes> (*make)(Context&, const Picture&, ExportNotes*);
};

Result<Bytes> png(Context& context, const Picture& picture, ExportNotes*) {
  const Result<Image> image = rasterize(context, picture, {.width = 1024, .height = 1024});
  if (!image) return image.status();
  return encode_png(context, *image);
}

/// Writes HTML as the command does, with pixels until the first frame.
Result<Bytes> html(Context& context, const Picture& picture, ExportNotes* notes) {
  const Result<Image> image = rasterize(context, picture, {.width = 512, .height = 512});
  if (!image) return image.status();
  Result<Bytes> fallback = encode_jpeg(context, *image, 80);
  if (!fallback) return fallback.status();
  HtmlOptions options;
  options.fallback = std::move(*fallback);
  options.fallback_type = "image/jpeg";
  return export_html(context, picture, options, notes);
}

Result<Bytes> pdf(Context& context, const Picture& picture, ExportNotes* notes) {
  return export_pdf(context, picture, {}, notes);
}

Result<Bytes> eps(Context& context, const Picture& picture, ExportNotes* notes) {
  return export_eps(context, picture, {}, notes);
}

Result<Bytes> svg_of_pixels(Context& context, const Picture& picture, ExportNotes* notes) {
  return export_svg(context, picture, {.mode = SvgMode::image}, notes);
}

Result<Bytes> svg_of_triangles(Context& context, const Picture& picture, ExportNotes* notes) {
  return export_svg(context, picture, {.mode = SvgMode::vector}, notes);
}

Result<Bytes> glb(Context& context, const Picture& picture, ExportNotes* notes) {
  return export_glb(context, picture, {}, notes);
}

constexpr Format kFormats[] = {{"PNG, 1024²", png},
                               {"HTML viewer", html},
                               {"PDF", pdf},
                               {"EPS", eps},
                               {"SVG of pixels, 192 dpi", svg_of_pixels},
                               {"SVG of triangles", svg_of_triangles},
                               {"GLB", glb}};

std::size_t packed_bytes(const Bytes& bytes) {
  uLongf size = compressBound(bytes.size());
  Bytes packed(size);
  compress2(packed.data(), &size, bytes.data(), bytes.size(), 9);
  return size;
}

void print(Context& context, const Picture& picture, const Format& format) {
  std::vector<double> seconds;
  Bytes bytes;
  ExportNotes notes;
  for (int i = 0; i < kRuns; ++i) {
    notes = {};
    const Stopwatch watch;
    Result<Bytes> made = format.make(context, picture, &notes);
    seconds.push_back(watch.seconds());
    if (!made) {
      std::printf("| %s | %s | | | |\n", format.name, made.status().message.c_str());
      return;
    }
    bytes = std::move(*made);
  }
  const double best = *std::min_element(seconds.begin(), seconds.end());
  const std::string triangles =
      notes.triangle_count > 0 ? std::to_string(notes.triangle_count) : std::string();
  std::printf("| %s | %.0f | %.0f | %s | %.0f |\n", format.name, 1e-3 * bytes.size(),
              1e-3 * packed_bytes(bytes), triangles.c_str(), 1e3 * best);
}

int run() {
  const std::optional<std::string> text = bench::scene_text("lady_bug.xml");
  if (!text) {
    std::fprintf(stderr, "outputs: no lady_bug.xml in ../shared/scenes\n");
    return bench::kSkipped;
  }
  ThreadPool pool(2);
  Context context;
  context.executor = &pool;
  const Result<ReadDocument> read = read_orzan(context, *text, "lady_bug.xml");
  const Result<Picture> picture = diffuse(context, read->document, {});
  std::printf("lady_bug at default options, %u patches; the best of %d runs; two threads.\n\n",
              picture->layers[0].triangle_count(), kRuns);
  std::printf("| lady_bug as | kB | kB after gzip | triangles | ms |\n|---|---|---|---|---|\n");
  for (const Format& format : kFormats) print(context, *picture, format);
  return 0;
}

}  // namespace
}  // namespace sfumato

int main() {
  return sfumato::run();
}
