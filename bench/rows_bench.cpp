#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "gather/gather.hpp"
#include "gather/rows/rows.hpp"
#include "mesh/mesher.hpp"
#include "scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"

// Rows of the gather at the pixels of a picture, and the gather itself at the same points.
// cpu_per_point sums all threads; time_per_point is wall clock.
namespace sfumato {
namespace {

constexpr const char* kScenes[] = {"lady_bug.xml", "tomatos.xml", "dolphin.xml"};

/// The approximate number of pixels; rows are for photos.
constexpr double kPixels = 300'000;

struct Prepared {
  Context context;  // charged with the other members
  TableMemory memory{"a benchmark"};
  mesh::TriangleMesh visibility;
  curves::SegmentAttributes colors, places;
  std::vector<Vec2> points;
  std::size_t segments = 0;
};

std::unique_ptr<Prepared> prepare(const Document& document) {
  auto prepared = std::make_unique<Prepared>();
  Context& context = prepared->context;
  const std::vector<Curve>& curves = document.layers[0].curves;
  const Box frame = document.artboard;
  const double side = std::max(frame.width(), frame.height());
  Result<curves::FlatCurves> flat =
      curves::flatten(context, curves, {.tolerance = side * 0.1 / 512});
  mesh::MeshOptions options;
  options.frame = frame;
  options.unit_size = side / 1024;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, options);
  if (!mesher) return nullptr;
  prepared->segments = flat->segment_count();
  prepared->visibility = *mesher->visibility_mesh({});
  TableMemory& memory = prepared->memory;
  prepared->colors =
      *curves::sample_colors(context, *flat, curves, InterpolationSpace::srgb, memory);
  prepared->places =
      *curves::sample_stop_places(context, *flat, curves, StopAttribute::color, memory);
  const double pixel = std::sqrt(frame.width() * frame.height() / kPixels);
  for (double y = 0.5 * pixel; y < frame.height(); y += pixel)
    for (double x = 0.5 * pixel; x < frame.width(); x += pixel)
      prepared->points.push_back(frame.min + Vec2{x, y});
  return prepared;
}

/// Returns the scene of range(0), prepared once; null: skipped.
const Prepared* prepared_scene(benchmark::State& state) {
  static std::map<std::string, std::unique_ptr<Prepared>> cache;
  const std::string name = kScenes[state.range(0)];
  state.SetLabel(name);
  auto& entry = cache[name];
  if (entry) return entry.get();
  const std::optional<Document> document = bench::scene(state, name);
  if (document) entry = prepare(*document);
  return entry.get();
}

void count_points(benchmark::State& state, const Prepared& p) {
  state.counters["segments"] = static_cast<double>(p.segments);
  state.counters["points"] = static_cast<double>(p.points.size());
  state.counters["time_per_point"] = benchmark::Counter(
      static_cast<double>(p.points.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// range(1): threads.
void rows(benchmark::State& state) {
  const Prepared* p = prepared_scene(state);
  if (!p) return;
  ThreadPool pool(static_cast<int>(state.range(1)));
  Context context;
  context.executor = &pool;
  std::size_t terms = 0;
  for (auto _ : state) {
    const Result<gather::Rows> rows =
        gather::gather_rows(context, p->visibility, p->places, p->points, {.negligible = 2e-4f});
    if (!rows) return state.SkipWithError("no rows");
    terms = rows->term.size();
  }
  count_points(state, *p);
  state.counters["terms_per_point"] =
      static_cast<double>(terms) / static_cast<double>(p->points.size());
}

/// The same points through the gather, which gives only colours.
void gather_all(benchmark::State& state) {
  const Prepared* p = prepared_scene(state);
  if (!p) return;
  ThreadPool pool(static_cast<int>(state.range(1)));
  Context context;
  context.executor = &pool;
  std::vector<float> out(p->points.size() * 3);
  for (auto _ : state) {
    const auto gatherer =
        gather::Gatherer::create(context, p->visibility, p->colors, gather::Ends::soft);
    benchmark::DoNotOptimize(gatherer->gather(context, p->points, {}, out).ok());
  }
  count_points(state, *p);
}

BENCHMARK(rows)
    ->ArgsProduct({{0, 1, 2}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(gather_all)
    ->ArgsProduct({{0, 1, 2}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
