#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

// The cost of the artistic controls, as ratios to the plain picture in the same run: blur, opacity
// and textures on lady_bug, and a thousand instances of a small layer.
namespace sfumato {
namespace {

constexpr int kRuns = 11;

/// The gather on the paper's mesh; small blur radii make the mesh finer.
struct GatherCost {
  double seconds = 0;
  double nodes = 0;
};

GatherCost gather_cost(Context& context, const Document& document) {
  DiffuseOptions options;
  options.max_error = 0;
  DiffuseStats stats;
  const Result<Picture> picture = diffuse(context, document, options, &stats);
  return {picture ? stats.gather_seconds : -1, static_cast<double>(stats.nodes)};
}

double whole_seconds(Context& context, const Document& document) {
  RasterOptions raster{.width = 1024, .height = 1024};
  const Stopwatch watch;
  const Result<Picture> picture = diffuse(context, document, {});
  const Result<Image> image = rasterize(context, *picture, raster);
  return image ? watch.seconds() : -1;
}

void for_each_side(Document& document, const std::function<void(Side&, std::size_t)>& body) {
  std::size_t index = 0;
  for (Curve& curve : document.layers[0].curves) {
    for (Side* side : {&curve.left, &curve.right}) body(*side, index++);
  }
}

Document sharp(Document document) {
  for_each_side(document, [](Side& side, std::size_t) { side.blur_radius = {}; });
  return document;
}

Document blurred(Document document) {
  for_each_side(document, [](Side& side, std::size_t) {
    side.blur_radius = {StopSpace::parameter, {{0, 6.0f}}};
  });
  return document;
}

Curve ellipse(Vec2 center, Vec2 radius) {
  const double k = 0.5522847498307936;
  const auto at = [&](double x, double y) { return center + Vec2{radius.x * x, radius.y * y}; };
  Curve curve;
  curve.control_points = {at(1, 0),  at(1, k),  at(k, 1),   at(0, 1),   at(-k, 1),
                          at(-1, k), at(-1, 0), at(-1, -k), at(-k, -1), at(0, -1),
                          at(k, -1), at(1, -k), at(1, 0)};
  return curve;
}

SideShader<float> one_opacity(float opacity) {
  return {ShaderKind::curve_domain, {StopSpace::parameter, {{0, opacity}}}, 0};
}

SideShader<Rgb> one_color(Rgb color) {
  return {ShaderKind::curve_domain, {StopSpace::parameter, {{0, color}}}, 0};
}

Document with_opacity(Document document) {
  for_each_side(document, [](Side& side, std::size_t i) {
    side.opacity = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, i % 2 ? 1 : 0.5f}}}, 0};
  });
  return document;
}

/// Returns the document with a soft mask around the middle, independent of the colours.
Document with_mask(Document document) {
  Curve mask = ellipse({256, 256}, {220, 200});
  mask.left.opacity = one_opacity(0);
  mask.right.opacity = one_opacity(1);
  document.layers[0].curves.push_back(mask);
  return document;
}

Document with_textures(Document document, std::uint32_t count) {
  for (std::uint32_t s = 0; s < count; ++s) {
    Texture texture{64, 64, std::vector<std::uint8_t>(4 * 64 * 64), {}, true, {}, {}};
    for (std::size_t i = 0; i < texture.rgba.size(); ++i) {
      texture.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : (i * (s + 3)) % 256);
    }
    document.shaders.push_back({"texture", std::move(texture)});
  }
  for_each_side(document, [&](Side& side, std::size_t i) {
    if (side.color.kind != ShaderKind::curve_domain || i % 4 != 0) return;
    side.color = {ShaderKind::image_domain, {}, static_cast<std::uint32_t>(i / 4 % count)};
  });
  return document;
}

/// Returns `count` instances of a fish-like layer with a soft rim, on an artboard of 1024².
Document school(int count) {
  Document document;
  document.artboard = {{0, 0}, {1024, 1024}};
  document.background = Rgb{0.1f, 0.3f, 0.5f};
  Curve body = ellipse({40, 20}, {38, 17});
  body.left.opacity = one_opacity(0);
  body.right.opacity = one_opacity(1);
  body.left.blur_radius = body.right.blur_radius = {StopSpace::parameter, {{0, 2.0f}}};
  Curve back = ellipse({40, 24}, {30, 9});
  back.left.color = one_color({1, 0.7f, 0.1f});
  back.right.color = one_color({1, 0.95f, 0.7f});
  document.layers.push_back({"fish", {body, back}});
  for (int i = 0; i < count; ++i) {
    const double scale = 0.5 + 0.01 * (i % 50);
    const double x = 31.0 * (i * 7 % 32), y = 31.0 * (i * 13 % 31);
    document.stack.push_back(LayerInstance{0, {scale, 0.2 * scale, -0.2 * scale, scale, x, y}});
  }
  return document;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 10 ? "%.2f" : value < 100 ? "%.1f" : "%.0f", value);
  return text;
}

/// A drawing and its least times of all rounds.
struct Variant {
  const char* name;
  Document document;
  GatherCost gather = {1e9, 0};
  double whole_seconds = 1e9;
};

/// Measures all variants in turns, so that other programs disturb all of them alike.
void measure(Context& context, std::vector<Variant>& variants) {
  for (int i = 0; i < kRuns; ++i) {
    for (Variant& variant : variants) {
      const GatherCost gather = gather_cost(context, variant.document);
      variant.gather = {std::min(variant.gather.seconds, gather.seconds), gather.nodes};
      variant.whole_seconds =
          std::min(variant.whole_seconds, whole_seconds(context, variant.document));
    }
  }
}

void print_table(const std::vector<Variant>& variants) {
  std::printf(
      "| lady_bug | gather on the paper's mesh | ratio | nodes | ns a node "
      "| document to 1024² pixels, default options | ratio |\n|---|---|---|---|---|---|---|\n");
  const Variant& plain = variants.front();
  for (const Variant& v : variants) {
    std::printf("| %s | %s | %.2f | %.0f | %.0f | %s | %.2f |\n", v.name,
                number(1e3 * v.gather.seconds).c_str(), v.gather.seconds / plain.gather.seconds,
                v.gather.nodes, 1e9 * v.gather.seconds / v.gather.nodes,
                number(1e3 * v.whole_seconds).c_str(), v.whole_seconds / plain.whole_seconds);
  }
}

int run() {
  const std::optional<std::string> text = bench::scene_text("lady_bug.xml");
  if (!text) {
    std::fprintf(stderr, "features: no lady_bug.xml in ../shared/scenes\n");
    return bench::kSkipped;
  }
  ThreadPool pool(1);  // ratios of one thread are steadier
  Context context;
  context.executor = &pool;
  const Result<ReadDocument> read = read_orzan(context, *text, "lady_bug.xml");
  const Document plain = sharp(read->document);
  std::vector<Variant> variants = {{"plain", plain},
                                   {"its own blur", read->document},
                                   {"blur, 6 units on every side", blurred(plain)},
                                   {"opacity on every side", with_opacity(plain)},
                                   {"a mask of opacity", with_mask(plain)},
                                   {"8 textures", with_textures(plain, 8)}};
  std::vector<Variant> schools = {{"a fish", school(1)}, {"1,000 instances", school(1000)}};
  measure(context, variants);
  measure(context, schools);
  std::printf("Milliseconds; the best of %d runs in turns; one thread.\n\n", kRuns);
  print_table(variants);
  const double one = schools[0].whole_seconds;
  const double thousand = schools[1].whole_seconds;
  std::printf("\n1,000 instances of a fish take %.0f ms, %.0f times as long as one.\n",
              1e3 * thousand, thousand / one);
  return 0;
}

}  // namespace
}  // namespace sfumato

int main() {
  return sfumato::run();
}
