#include <benchmark/benchmark.h>

#include <memory>
#include <optional>
#include <string>

#include "scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/gpu/render.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

// Picture → Image of a public scene at 1024² on the CPU and by OpenGL, with the name of the device.
// Mesa's llvmpipe is software on the same CPU. Each run makes a new context with its programs.
namespace sfumato {
namespace {

constexpr int kSide = 1024;

using Draw = Result<Image> (*)(Context&, const Picture&, const RasterOptions&);

void draw_lady_bug(benchmark::State& state, Draw draw) {
  const std::optional<Document> document = bench::scene(state, "lady_bug.xml");
  if (!document) return;
  ThreadPool executor;
  Context context;
  context.executor = &executor;
  DiffuseOptions diffusion;
  diffusion.pixels_per_unit = kSide / document->artboard.width();
  const Result<Picture> picture = diffuse(context, *document, diffusion);
  if (!picture) return state.SkipWithError(picture.status().message.c_str());
  RasterOptions options;
  options.width = options.height = kSide;
  for (auto _ : state) {
    const Result<Image> image = draw(context, *picture, options);
    if (!image) return state.SkipWithError(image.status().message.c_str());
    benchmark::DoNotOptimize(image->bytes.data());
  }
}

void lady_bug_by_cpu(benchmark::State& state) {
  draw_lady_bug(state, rasterize);
}
BENCHMARK(lady_bug_by_cpu)->Unit(benchmark::kMillisecond)->UseRealTime();

void lady_bug_by_opengl(benchmark::State& state) {
  const Result<std::string> name = gpu_name();
  if (!name) return state.SkipWithError(name.status().message.c_str());
  state.SetLabel(*name);
  draw_lady_bug(state, render_on_gpu);
}
BENCHMARK(lady_bug_by_opengl)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
