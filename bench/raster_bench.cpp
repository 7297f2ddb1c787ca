#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "picture/patch.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/orzan/orzan.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/places.hpp"

// Picture → Image: on a synthetic picture as large as lady_bug's (about 10,000 triangles, and about
// 30,000 pixels of 1024² that curves cut), and on the public scenes if they are present.
namespace sfumato {
namespace {

constexpr int kCells = 71;
constexpr double kSide = 512;

double hash_unit(std::uint32_t i) {
  i = (i ^ (i >> 16)) * 0x7feb352dU;
  i = (i ^ (i >> 15)) * 0x846ca68bU;
  return (i ^ (i >> 16)) / 4294967296.0;
}

/// Returns the band around two points that holds p; borders of bands are the curves.
int region_of(Vec2 p) {
  const double a = length(p - Vec2{150, 170});
  const double b = length(p - Vec2{380, 330});
  return static_cast<int>(std::sqrt(a * b) / 32);
}

Rgb color_of(int region, Vec2 p) {
  const auto wave = [&](double kx, double ky) {
    return static_cast<float>(0.5 + 0.5 * std::sin(kx * p.x + ky * p.y + 2.3 * region));
  };
  return {wave(0.011, 0.002), wave(-0.007, 0.013), wave(0.005, -0.016)};
}

void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, PatchLayer* layer) {
  const std::uint32_t corner[3] = {a, b, c};
  Vec2 center;
  for (std::uint32_t v : corner) center = center + layer->vertex_position[v] / 3;
  for (int k = 0; k < 3; ++k) {
    layer->triangle_vertex.push_back(corner[k]);
    // The centre mirrored at the edge stands for the triangle across it.
    const Vec2 p = layer->vertex_position[corner[k]];
    const Vec2 q = layer->vertex_position[corner[(k + 1) % 3]];
    layer->edge_is_curve.push_back(region_of(center) != region_of(p + q - center));
  }
  for (const auto& weight : kNodeBarycentric) {
    Vec2 p;
    for (int k = 0; k < 3; ++k) p = p + layer->vertex_position[corner[k]] * weight[k];
    layer->color.triangle_node.push_back(
        static_cast<std::uint32_t>(layer->color.node_value.size() / 3));
    const Rgb color = color_of(region_of(center), p);
    for (float channel : {color.r, color.g, color.b}) layer->color.node_value.push_back(channel);
  }
}

Picture synthetic_picture() {
  PatchLayer layer;
  layer.frame = {{0, 0}, {kSide, kSide}};
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const std::uint32_t index = static_cast<std::uint32_t>(layer.vertex_position.size());
      const double dx = i % kCells ? 0.6 * (hash_unit(2 * index) - 0.5) : 0;
      const double dy = j % kCells ? 0.6 * (hash_unit(2 * index + 1) - 0.5) : 0;
      layer.vertex_position.push_back(Vec2{i + dx, j + dy} * (kSide / kCells));
    }
  }
  for (std::uint32_t j = 0; j < kCells; ++j) {
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t a = j * (kCells + 1) + i;
      const std::uint32_t d = a + kCells + 1;
      add_triangle(a, a + 1, d + 1, &layer);
      add_triangle(a, d + 1, d, &layer);
    }
  }
  Picture picture;
  picture.artboard = picture.viewport = layer.frame;
  picture.layers.push_back(std::move(layer));
  picture.stack.push_back(PatchInstance{});
  return picture;
}

/// Arguments: side of the image in pixels, threads, SimdLevel, antialias.
void rasterize_synthetic(benchmark::State& state) {
  const Picture picture = synthetic_picture();
  ThreadPool executor(static_cast<int>(state.range(1)));
  Context context;
  context.executor = &executor;
  context.simd = static_cast<SimdLevel>(state.range(2));
  if (context.simd > detected_simd_level()) {
    state.SkipWithError("this machine has no such instruction set");
    return;
  }
  RasterOptions options;
  options.width = options.height = static_cast<int>(state.range(0));
  options.antialias = state.range(3) != 0;
  for (auto _ : state) {
    const Result<Image> image = rasterize(context, picture, options);
    if (!image) state.SkipWithError("rasterize failed");
    benchmark::DoNotOptimize(image);
  }
  state.counters["triangles"] = picture.layers[0].triangle_count();
}

BENCHMARK(rasterize_synthetic)
    ->ArgNames({"side", "threads", "simd", "antialias"})
    ->Args({1024, 1, 0, 1})
    ->Args({1024, 1, 1, 1})
    ->Args({1024, 1, 2, 1})
    ->Args({1024, 1, 2, 0})
    ->Args({1024, 2, 2, 1})
    ->Args({128, 1, 2, 1})
    ->Args({4096, 2, 2, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// The same picture blended over a background. Arguments: BlendMode, InterpolationSpace (the node
/// values do not change, because their appearance does not matter).
void rasterize_blended(benchmark::State& state) {
  Picture picture = synthetic_picture();
  picture.interpolation = static_cast<InterpolationSpace>(state.range(1));
  PatchInstance& instance = std::get<PatchInstance>(picture.stack[0]);
  instance.opacity = 0.9f;
  instance.blend = static_cast<BlendMode>(state.range(0));
  Context context;
  RasterOptions options;
  options.width = options.height = 1024;
  for (auto _ : state) {
    const Result<Image> image = rasterize(context, picture, options);
    if (!image) state.SkipWithError("rasterize failed");
    benchmark::DoNotOptimize(image);
  }
}

BENCHMARK(rasterize_blended)
    ->ArgNames({"mode", "space"})
    ->Args({static_cast<int>(BlendMode::normal), static_cast<int>(InterpolationSpace::srgb)})
    ->Args({static_cast<int>(BlendMode::luminosity), static_cast<int>(InterpolationSpace::srgb)})
    ->Args({static_cast<int>(BlendMode::normal), static_cast<int>(InterpolationSpace::oklab)})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

constexpr int kSectors = 36;
constexpr int kRings = 7;

/// Returns a corner of a fish's mesh: rings around the middle, 80 × 36 units, narrowing to the
/// tail.
Vec2 fish_vertex(int ring, int sector) {
  const double angle = 2 * 3.14159265358979 * sector / kSectors;
  const double radius = static_cast<double>(ring) / kRings;
  const double narrow = 0.65 + 0.35 * std::cos(angle);
  return {40 * radius * std::cos(angle), 18 * radius * std::sin(angle) * narrow};
}

/// Returns 468 triangles, opaque in the middle and soft towards the rim; triangles outside are
/// dropped. Curves are the rim, the outline inside it and four stripes.
PatchLayer fish_layer() {
  PatchLayer layer;
  layer.opacity.channel_count = 1;
  const auto add = [&](const Vec2(&corner)[3], const bool(&is_curve)[3], int stripe) {
    for (int k = 0; k < 3; ++k) {
      layer.triangle_vertex.push_back(static_cast<std::uint32_t>(layer.vertex_position.size()));
      layer.vertex_position.push_back(corner[k]);
      layer.frame.extend(corner[k]);
      layer.edge_is_curve.push_back(is_curve[k]);
    }
    for (const auto& weight : kNodeBarycentric) {
      Vec2 p;
      for (int k = 0; k < 3; ++k) p = p + corner[k] * weight[k];
      const std::uint32_t node = static_cast<std::uint32_t>(layer.opacity.node_value.size());
      const Rgb color = color_of(stripe, 3 * p);
      layer.color.triangle_node.push_back(node);
      layer.opacity.triangle_node.push_back(node);
      for (float channel : {color.r, color.g, color.b}) layer.color.node_value.push_back(channel);
      const double outside = length_squared({p.x / 40, p.y / 18});
      layer.opacity.node_value.push_back(static_cast<float>(1 - outside * outside));
    }
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int sector = 0; sector < kSectors; ++sector) {
      const Vec2 a = fish_vertex(ring, sector), b = fish_vertex(ring + 1, sector);
      const Vec2 c = fish_vertex(ring + 1, sector + 1), d = fish_vertex(ring, sector + 1);
      const int stripe = sector * 4 / kSectors;
      const bool outer = ring + 1 == kRings || ring + 2 == kRings;
      const bool begins = sector % (kSectors / 4) == 0;
      add({a, b, c}, {begins, outer, false}, stripe);
      if (ring > 0) add({a, c, d}, {false, sector % 9 == 8, ring + 1 == kRings}, stripe);
    }
  }
  return layer;
}

/// Returns the school of the paper's Fig. 7: instances of one layer, rotated, scaled, half of them
/// mirrored.
Picture fish_picture(std::uint32_t fish_count) {
  Picture picture;
  picture.artboard = picture.viewport = {{0, 0}, {kSide, kSide}};
  picture.background = Rgb{0.1f, 0.3f, 0.5f};
  picture.layers.push_back(fish_layer());
  for (std::uint32_t i = 0; i < fish_count; ++i) {
    const double scale = 0.3 + 0.25 * hash_unit(5 * i);
    const double angle = 0.6 * (hash_unit(5 * i + 1) - 0.5);
    const double mirror = i % 2 ? -1 : 1;
    const double c = scale * std::cos(angle), s = scale * std::sin(angle);
    picture.stack.push_back(PatchInstance{
        0,
        {mirror * c, mirror * s, -s, c, kSide * hash_unit(5 * i + 2), kSide * hash_unit(5 * i + 3)},
        0.9f});
  }
  return picture;
}

/// Arguments: instances, side of the image in pixels, threads.
void rasterize_instances(benchmark::State& state) {
  const Picture picture = fish_picture(static_cast<std::uint32_t>(state.range(0)));
  ThreadPool executor(static_cast<int>(state.range(2)));
  Context context;
  context.executor = &executor;
  RasterOptions options;
  options.width = options.height = static_cast<int>(state.range(1));
  for (auto _ : state) {
    const Result<Image> image = rasterize(context, picture, options);
    if (!image) state.SkipWithError("rasterize failed");
    benchmark::DoNotOptimize(image);
  }
  state.counters["triangles"] = picture.layers[0].triangle_count();
}

BENCHMARK(rasterize_instances)
    ->ArgNames({"instances", "side", "threads"})
    ->Args({1000, 1024, 1})
    ->Args({1000, 1024, 2})
    ->Args({100, 1024, 2})
    ->Args({10000, 4096, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

constexpr const char* kScenes[] = {"lady_bug", "tomatos", "dolphin"};

/// Returns the picture with the paper's mesh density, without refinement.
Result<Picture> scene_picture(Context& context, const std::string& name) {
  const std::string path = test::shared_path("scenes/") + name + ".xml";
  std::ifstream file(path, std::ios::binary);
  const std::string xml((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const Result<ReadDocument> read = read_orzan(context, xml, path);
  if (!read) return read.status();
  DiffuseOptions options;
  options.max_error = 0;
  return diffuse(context, read->document, options);
}

/// Arguments: index into kScenes, width of the image in pixels, threads.
void rasterize_scene(benchmark::State& state) {
  ThreadPool executor(static_cast<int>(state.range(2)));
  Context context;
  context.executor = &executor;
  const std::string name = kScenes[state.range(0)];
  const Result<Picture> picture = scene_picture(context, name);
  if (!picture) {
    state.SkipWithError("the public scenes are not here");
    return;
  }
  RasterOptions options;
  options.width = static_cast<int>(state.range(1));
  options.height = static_cast<int>(
      std::lround(options.width * picture->viewport.height() / picture->viewport.width()));
  for (auto _ : state) {
    const Result<Image> image = rasterize(context, *picture, options);
    if (!image) state.SkipWithError("rasterize failed");
    benchmark::DoNotOptimize(image);
  }
  state.SetLabel(name);
  state.counters["triangles"] = picture->layers[0].triangle_count();
}

BENCHMARK(rasterize_scene)
    ->ArgNames({"scene", "width", "threads"})
    ->ArgsProduct({{0, 1, 2}, {1024}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
