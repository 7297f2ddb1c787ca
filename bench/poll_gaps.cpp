#include <dlfcn.h>
#include <execinfo.h>

#include <cstdio>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "codecs/image_file.hpp"
#include "limits/large_inputs.hpp"
#include "scenes.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/import/import_svg.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "support/poll_recorder.hpp"

// How long work runs without a poll of the cancel flag: the longest gap of each stage, in CPU time
// of the only working thread, over the public scenes and over inputs near the limits.
//
//   build/bench/poll_gaps [--where] [WORD...]      only cases whose name has one of the words
//
// --where prints the functions on the stack at the end of each gap longer than 20 ms.
namespace sfumato {
namespace {

using test::PollRecorder;

constexpr double kToldSeconds = 0.02;
constexpr int kFramesTold = 9;

bool tells_where = false;
std::vector<std::string> words;

bool is_wanted(const std::string& name) {
  if (words.empty()) return true;
  for (const std::string& word : words) {
    if (name.find(word) != std::string::npos) return true;
  }
  return false;
}

void tell_stack(double seconds) {
  if (!tells_where || seconds < kToldSeconds) return;
  void* frames[32];
  const int count = backtrace(frames, 32);
  std::printf("  %.0f ms at", 1e3 * seconds);
  for (int i = 3; i < count && i < 3 + kFramesTold; ++i) {
    Dl_info info{};
    dladdr(frames[i], &info);
    const auto offset = reinterpret_cast<char*>(frames[i]) - static_cast<char*>(info.dli_fbase);
    std::printf(" %lx", static_cast<unsigned long>(offset));
  }
  std::printf("\n");
}

/// Runs one stage, prints its line, and returns its result.
template <class Work>
auto measured(const std::string& name, Context& context, Work work) {
  PollRecorder recorder;
  recorder.on_longest = tell_stack;
  context.poll_watch = &recorder;
  recorder.start();
  const double begin = test::thread_seconds();
  auto result = work(context);
  recorder.stop();
  const double seconds = test::thread_seconds() - begin;
  context.poll_watch = nullptr;
  const std::string note = result.ok() ? std::string() : result.status().message;
  std::printf("| %s | %.1f | %.2f | %llu | %s |\n", name.c_str(), 1e3 * recorder.longest_seconds(),
              seconds, static_cast<unsigned long long>(recorder.polls()), note.c_str());
  std::fflush(stdout);
  return result;
}

template <class Work>
void measure(const std::string& name, Context& context, Work work) {
  static_cast<void>(measured(name, context, work));
}

Context roomy() {
  return Context{.budget = Budget(std::size_t{12} << 30)};
}

/// Measures every exporter on a picture.
void measure_exports(const std::string& name, const Picture& picture) {
  Context context = roomy();
  measure(name + ", PDF", context, [&](Context& c) { return export_pdf(c, picture, {}); });
  measure(name + ", EPS", context, [&](Context& c) { return export_eps(c, picture, {}); });
  measure(name + ", GLB", context, [&](Context& c) { return export_glb(c, picture, {}); });
  measure(name + ", HTML", context, [&](Context& c) { return export_html(c, picture, {}); });
  measure(name + ", SVG", context, [&](Context& c) {
    return export_svg(c, picture, {.mode = SvgMode::vector, .force = true});
  });
}

void measure_encoders(const std::string& name, const Image& image) {
  Context context = roomy();
  measure(name + ", PNG", context, [&](Context& c) { return encode_png(c, image); });
  measure(name + ", JPEG", context, [&](Context& c) { return encode_jpeg(c, image, 90); });
  measure(name + ", WebP", context, [&](Context& c) { return encode_webp(c, image, {}); });
  measure(name + ", lossless WebP", context,
          [&](Context& c) { return encode_webp(c, image, {.lossless = true}); });
}

std::optional<Picture> measure_diffuse(const std::string& name, const Document& document,
                                       const DiffuseOptions& options = {}) {
  Context context = roomy();
  Result<Picture> picture = measured(name + ", diffuse", context,
                                     [&](Context& c) { return diffuse(c, document, options); });
  if (!picture) return std::nullopt;
  return std::move(*picture);
}

void measure_raster(const std::string& name, const Picture& picture, int width, int height) {
  Context context = roomy();
  const Result<Image> image = measured(name + ", raster", context, [&](Context& c) {
    return rasterize(c, picture, {.width = width, .height = height});
  });
  if (image) measure_encoders(name, *image);
}

std::optional<Document> measure_read(const std::string& name, const std::string& text) {
  Context context = roomy();
  Result<ReadDocument> read =
      measured(name + ", read", context, [&](Context& c) { return read_document(c, text, name); });
  if (!read) return std::nullopt;
  return std::move(read->document);
}

void public_scene(const std::string& name) {
  const std::optional<std::string> text = bench::scene_text(name + ".xml");
  if (!text) return;
  const std::optional<Document> document = measure_read(name, *text);
  if (!document) return;
  Context context = roomy();
  measure(name + ", lint", context, [&](Context& c) { return lint(c, *document); });
  measure(name + ", convert", context, [&](Context& c) { return write_svg(c, *document); });
  DiffuseOptions options;
  options.pixels_per_unit = 8;
  const std::optional<Picture> picture = measure_diffuse(name, *document, options);
  if (!picture) return;
  measure_raster(name, *picture, 1024, 1024);
  measure_exports(name, *picture);
  measure(name + ", pixels", context, [&](Context& c) {
    return render_pixels(c, *document, {}, {.width = 256, .height = 256});
  });
}

void many_stops() {
  const Document document = test::curve_of_many_stops(limits::kStopsPerList);
  Context context{.budget = Budget(std::size_t{12} << 30), .deadline = Deadline::in(40)};
  measure("10,000 stops, diffuse", context, [&](Context& c) { return diffuse(c, document, {}); });
  context.deadline = Deadline::in(20);
  measure("10,000 stops, pixels", context,
          [&](Context& c) { return render_pixels(c, document, {}, {.width = 64, .height = 64}); });
  context.deadline = Deadline::in(20);
  measure("10,000 stops, lint", context, [&](Context& c) { return lint(c, document); });
}

void many_curves() {
  measure_read("200,000 curves of SVG", test::many_curves_svg(limits::kCurves));
  measure_read("200,000 curves of Orzan", test::many_curves_orzan(100'000));
  const Document document = test::many_curves(limits::kCurves);
  Context context = roomy();
  measure("200,000 curves, convert", context, [&](Context& c) { return write_svg(c, document); });
  measure("200,000 curves, lint", context, [&](Context& c) { return lint(c, document); });
  const std::optional<Picture> picture = measure_diffuse("200,000 curves", document);
  if (picture) measure_raster("200,000 curves", *picture, 4096, 4096);
  if (picture) measure_exports("200,000 curves", *picture);
}

void long_path() {
  measure_read("path of 1.3 M pieces", test::long_path_svg(1'300'000));
}

void refinement() {
  const std::optional<std::string> text = bench::scene_text("lady_bug.xml");
  if (!text) return;
  const std::optional<Document> document = measure_read("lady_bug", *text);
  DiffuseOptions options;
  options.max_area_fraction = 4e-7;
  options.max_error = 0;
  const std::optional<Picture> picture =
      measure_diffuse("millions of triangles", *document, options);
  if (!picture) return;
  std::printf("%u triangles\n", picture->layers[0].triangle_count());
  measure_raster("millions of triangles", *picture, 2048, 2048);
  measure_exports("millions of triangles", *picture);
}

void exports() {
  const std::optional<Picture> picture =
      measure_diffuse("1000 curves", test::many_curves(1000), {.max_error = 0});
  if (picture) measure_exports("1000 curves", *picture);
}

void wide_images() {
  const Document document = test::many_curves(100);
  const std::optional<Picture> picture = measure_diffuse("100 curves", document);
  if (picture) measure_raster("16,384 x 4096", *picture, 16'384, 4096);
  measure_encoders("16,383 x 2000 of noise", test::noise_image(16'383, 2000));
  Context context = roomy();
  measure("16,384 x 64, pixels", context, [&](Context& c) {
    return render_pixels(c, document, {}, {.width = 16'384, .height = 64});
  });
}

void webp() {
  for (const PixelFormat format : {PixelFormat::rgb8, PixelFormat::rgba8}) {
    const std::string channels = format == PixelFormat::rgb8 ? "" : " with alpha";
    Context context = roomy();
    const Image noise = test::noise_image(2048, 2048, format);
    measure("noise of 2048²" + channels + ", WebP", context,
            [&](Context& c) { return encode_webp(c, noise, {}); });
    const std::optional<Picture> picture = measure_diffuse("20 curves", test::many_curves(20));
    if (!picture) continue;
    const Result<Image> image =
        rasterize(context, *picture, {.width = 4096, .height = 4096, .format = format});
    if (image) measure_encoders("20 curves on 4096²" + channels, *image);
  }
}

void strokes() {
  const Document document = test::many_strokes(20'000, 40);
  const std::optional<Picture> picture = measure_diffuse("20,000 local curves", document);
  if (picture) measure_raster("20,000 local curves", *picture, 1024, 1024);
  const Document wide = test::many_strokes(200, 3000);
  const std::optional<Picture> far = measure_diffuse("wide local curves", wide);
  if (far) measure_raster("wide local curves", *far, 1024, 1024);
}

/// Measures drawings of 10,000 shapes: apart, on one ground, and each over others.
void imports() {
  for (const test::ShapePlaces places :
       {test::ShapePlaces::apart, test::ShapePlaces::on_ground, test::ShapePlaces::overlapping}) {
    const std::string text = test::many_shapes_svg(10'000, places);
    Context context = roomy();
    context.limits.layers = 20'000;
    measure("10,000 shapes " + std::string(test::name_of(places)) + ", import", context,
            [&](Context& c) { return import_svg(c, text, "shapes.svg"); });
  }
}

void textures() {
  const Image image = test::noise_image(8000, 8000);
  Context context = roomy();
  const auto png = encode_png(context, image);
  if (png)
    measure("PNG of 8000 x 8000", context,
            [&](Context& c) { return codecs::decode_image(c, *png); });
  const auto jpeg = encode_jpeg(context, image, 90);
  if (jpeg) {
    measure("JPEG of 8000 x 8000", context,
            [&](Context& c) { return codecs::decode_image(c, *jpeg); });
  }
  const Document document = test::textured_curve(8000);
  const std::optional<Picture> picture = measure_diffuse("texture of 8000 x 8000", document);
  if (picture) measure_raster("texture of 8000 x 8000", *picture, 512, 512);
  if (picture) measure_exports("texture of 8000 x 8000", *picture);
  measure("texture of 8000 x 8000, convert", context,
          [&](Context& c) { return write_svg(c, document); });
}

struct Case {
  const char* name;
  void (*run)();
};

constexpr Case kCases[] = {{"stops", many_stops}, {"curves", many_curves},
                           {"path", long_path},   {"refinement", refinement},
                           {"exports", exports},  {"wide", wide_images},
                           {"strokes", strokes},  {"textures", textures},
                           {"webp", webp},        {"imports", imports}};

constexpr const char* kScenes[] = {"lady_bug", "dolphin", "tomatos", "glass_droplet_blur"};

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  using namespace sfumato;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--where") == 0) {
      tells_where = true;
    } else {
      words.emplace_back(argv[i]);
    }
  }
  std::printf(
      "| work on one thread | longest gap, ms of CPU | CPU s | polls | |\n|---|---|---|---|---|\n");
  for (const char* scene : kScenes) {
    if (is_wanted(scene)) public_scene(scene);
  }
  for (const Case& one : kCases) {
    if (is_wanted(one.name)) one.run();
  }
}
