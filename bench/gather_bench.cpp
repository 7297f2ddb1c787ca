#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <utility>

#include "gather/exact.hpp"
#include "gather/gather.hpp"
#include "gather/rays.hpp"
#include "gather/scene/locate.hpp"
#include "gather/scene/packing.hpp"
#include "prepared.hpp"
#include "scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/document/build.hpp"

// Colours at the free nodes of the paper's mesh (no error-driven refinement), step by step. Times
// are for one thread, except in `gather_all`. docs/benchmarks.md reports time_per_point.
namespace sfumato {
namespace {

constexpr const char* kScenes[] = {"lady_bug.xml", "tomatos.xml", "dolphin.xml"};

using bench::prepare, bench::Prepared;

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

/// Returns curves of half a unit, anywhere on a square of 1024.
Document specks(int count) {
  std::mt19937 random(1);
  // uniform_real_distribution differs between standard libraries.
  const auto number = [&] { return static_cast<float>(random() >> 8) / (1 << 24); };
  const auto color = [&] { return Rgb{number(), number(), number()}; };
  Document document;
  document.artboard = {{0, 0}, {1024, 1024}};
  document.layers.resize(1);
  for (int i = 0; i < count; ++i) {
    const Vec2 a = 1024 * Vec2{number(), number()};
    const double angle = 2 * std::numbers::pi * number();
    Curve curve = polyline({a, a + 0.5 * Vec2{std::cos(angle), std::sin(angle)}});
    curve.left = colored({color()});
    curve.right = colored({color()});
    document.layers[0].curves.push_back(std::move(curve));
  }
  return document;
}

void count_points(benchmark::State& state, std::size_t count) {
  state.counters["points"] = static_cast<double>(count);
  state.counters["time_per_point"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

void create(benchmark::State& state) {
  const Prepared* p = prepared_scene(state);
  if (!p) return;
  Context context;
  for (auto _ : state) {
    benchmark::DoNotOptimize(gather::Gatherer::create(context, p->visibility, p->attributes).ok());
  }
}

void locate(benchmark::State& state) {
  const Prepared* p = prepared_scene(state);
  if (!p) return;
  Context context;
  const auto locator = gather::Locator::create(context, p->scene);
  for (auto _ : state) benchmark::DoNotOptimize(locator->locate(context, p->points).ok());
  count_points(state, p->points.size());
}

void pack(benchmark::State& state) {
  const Prepared* p = prepared_scene(state);
  if (!p) return;
  Context context;
  const auto locator = gather::Locator::create(context, p->scene);
  const auto located = locator->locate(context, p->points);
  std::size_t packets = 1;
  for (auto _ : state) packets = gather::pack(context, p->scene, *located)->packet.size();
  count_points(state, p->points.size());
  state.counters["lanes"] = static_cast<double>(p->points.size()) / static_cast<double>(packets);
}

void time_exact(benchmark::State& state, const Prepared* p, SimdLevel level) {
  Context context;
  context.simd = level;
  const auto locator = gather::Locator::create(context, p->scene);
  const auto located = locator->locate(context, p->points);
  const auto packing = gather::pack(context, p->scene, *located);
  std::vector<float> out(p->points.size() * 3);
  for (auto _ : state) {
    benchmark::DoNotOptimize(gather::gather_exact(context, p->scene, gather::FreeEnds(), p->points,
                                                  *located, *packing, {out, {}})
                                 .ok());
  }
  count_points(state, p->points.size());
}

/// range(1): the instruction set.
void exact(benchmark::State& state) {
  const Prepared* p = prepared_scene(state);
  if (!p) return;
  const auto level = static_cast<SimdLevel>(state.range(1));
  if (level > detected_simd_level()) return state.SkipWithError("not on this machine");
  time_exact(state, p, level);
}

/// range(0): the count. Distant windows are estimated.
void exact_among_specks(benchmark::State& state) {
  const std::unique_ptr<Prepared> p = prepare(specks(static_cast<int>(state.range(0))));
  if (!p) return state.SkipWithError("no mesh");
  time_exact(state, p.get(), detected_simd_level());
}

void rays_64(benchmark::State& state) {
  const Prepared* p = prepared_scene(state);
  if (!p) return;
  Context context;
  std::vector<float> out(p->points.size() * 3);
  const gather::GatherOptions options{.method = gather::Method::rays};
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        gather::gather_rays(context, p->scene, gather::FreeEnds(), p->points, options, out, {})
            .ok());
  }
  count_points(state, p->points.size());
}

/// Location, packing and the exact gather; range(1): threads.
void gather_all(benchmark::State& state) {
  const Prepared* p = prepared_scene(state);
  if (!p) return;
  ThreadPool pool(static_cast<int>(state.range(1)));
  Context context;
  context.executor = &pool;
  const auto gatherer = gather::Gatherer::create(context, p->visibility, p->attributes);
  std::vector<float> out(p->points.size() * 3);
  for (auto _ : state) {
    benchmark::DoNotOptimize(gatherer->gather(context, p->points, {}, out).ok());
  }
  count_points(state, p->points.size());
}

BENCHMARK(create)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(locate)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(pack)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(exact)->ArgsProduct({{0, 1, 2}, {0, 1, 2}})->Unit(benchmark::kMillisecond);
BENCHMARK(exact_among_specks)->Arg(1000)->Arg(3000)->Unit(benchmark::kMillisecond);
BENCHMARK(rays_64)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(gather_all)
    ->ArgsProduct({{0, 1, 2}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
