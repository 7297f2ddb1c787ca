#include <benchmark/benchmark.h>

#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/fields/nodes.hpp"

// The stages without a benchmark of their own, and the whole path from a document to a PNG.
namespace sfumato {
namespace {

constexpr const char* kScenes[] = {"lady_bug.xml", "tomatos.xml", "dolphin.xml"};

void read_document(benchmark::State& state) {
  const std::string name = kScenes[state.range(0)];
  const std::optional<std::string> text = bench::scene_text(name);
  if (!text) return state.SkipWithError("the public scenes are not at hand");
  Context context;
  for (auto _ : state) benchmark::DoNotOptimize(read_orzan(context, *text, name).ok());
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text->size()));
}

void flatten_and_sample(benchmark::State& state) {
  const std::optional<Document> document = bench::scene(state, kScenes[state.range(0)]);
  if (!document) return;
  Context context;
  const std::vector<Curve>& curves = document->layers[0].curves;
  std::size_t segments = 0;
  for (auto _ : state) {
    Result<curves::FlatCurves> flat = curves::flatten(context, curves, {});
    TableMemory memory("a benchmark");
    benchmark::DoNotOptimize(
        curves::sample_colors(context, *flat, curves, InterpolationSpace::srgb, memory));
    segments = flat->segment_count();
  }
  state.counters["segments"] = static_cast<double>(segments);
}

void lay_out_nodes(benchmark::State& state) {
  const std::optional<Document> document = bench::scene(state, kScenes[state.range(0)]);
  if (!document) return;
  Context context;
  Result<curves::FlatCurves> flat = curves::flatten(context, document->layers[0].curves, {});
  TableMemory memory("a benchmark");
  const auto sampled = curves::sample_colors(context, *flat, document->layers[0].curves,
                                             InterpolationSpace::srgb, memory);
  const curves::SegmentAttributes& attributes = *sampled;
  mesh::MeshOptions options;
  options.frame = document->artboard;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, options);
  if (!mesher || !mesher->refine(context)) return state.SkipWithError("no mesh");
  const mesh::TriangleMesh mesh = *mesher->patch_mesh({});
  for (auto _ : state) {
    const Result<solve::Seams> seams = solve::Seams::create(context, mesh, attributes);
    TableMemory layout_memory("a benchmark");
    benchmark::DoNotOptimize(
        solve::lay_out_nodes(context, mesh, attributes, *seams, layout_memory));
  }
  state.counters["triangles"] = mesh.triangle_count();
}

/// Document → PNG in memory with the default options; range(1): threads.
void whole(benchmark::State& state) {
  const std::optional<Document> document = bench::scene(state, kScenes[state.range(0)]);
  if (!document) return;
  ThreadPool pool(static_cast<int>(state.range(1)));
  Context context;
  context.executor = &pool;
  RasterOptions raster;
  raster.width = static_cast<int>(document->artboard.width());
  raster.height = static_cast<int>(document->artboard.height());
  for (auto _ : state) {
    const Result<Picture> picture = diffuse(context, *document, {});
    const Result<Image> image = rasterize(context, *picture, raster);
    benchmark::DoNotOptimize(encode_png(context, *image).ok());
  }
}

BENCHMARK(read_document)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(flatten_and_sample)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(lay_out_nodes)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(whole)->ArgsProduct({{0, 1, 2}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
