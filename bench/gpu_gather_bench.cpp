#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "gather/exact.hpp"
#include "gpu/walker.hpp"
#include "scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "support/twin_source.hpp"
#include "walk_points.hpp"

// The exact gather by compute shaders (point_walk.glsl), compared with the CPU's packets: nodes of
// the paper's mesh, pixels of an image 1024 wide, and of one 3840 wide. The label is the device; a
// software driver gets only a sample of the points. `bits` counts the points that differ from the
// C++ twin, and `most` is the largest difference in code values.
namespace sfumato {
namespace {

constexpr const char* kScenes[] = {"lady_bug.xml", "tomatos.xml", "dolphin.xml"};
constexpr int kWidths[] = {0, 1024, 3840};  // 0: the nodes
constexpr std::size_t kSample = 20'000;
constexpr std::size_t kCompared = 20'000;

struct Points {
  std::unique_ptr<bench::Prepared> drawing;
  Box artboard;
  std::map<int, std::vector<gather::WalkPoint>> at{};  ///< by width
};

/// Returns null to skip.
Points* points_of(benchmark::State& state, int scene, int width) {
  static std::map<int, Points> cache;
  Points& points = cache[scene];
  if (!points.drawing) {
    const std::optional<Document> document = bench::scene(state, kScenes[scene]);
    if (!document) return nullptr;
    points.artboard = document->artboard;
    points.drawing = bench::prepare(*document);
  }
  std::vector<gather::WalkPoint>& at = points.at[width];
  if (at.empty()) {
    at = width == 0 ? bench::node_points(*points.drawing)
                    : bench::pixel_points(*points.drawing, points.artboard, width);
  }
  return &points;
}

bool is_software(const std::string& device) {
  return device.find("llvmpipe") != std::string::npos ||
         device.find("SwiftShader") != std::string::npos;
}

void count_points(benchmark::State& state, std::size_t count) {
  state.counters["points"] = static_cast<double>(count);
  state.counters["time_per_point"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

std::string label(int scene, int width, const std::string& by) {
  const std::string what = width == 0 ? "nodes" : std::to_string(width) + " pixels wide";
  return std::string(kScenes[scene]) + ", " + what + ", " + by;
}

template <int kStack>
void compare_with_twin(benchmark::State& state, const gather::Scene& scene,
                       std::span<const gather::WalkPoint> points, std::span<const float> sums) {
  const std::size_t stride = gather::sums_of_point(scene);
  test::TwinSource<kStack> twin;
  Context context;
  std::vector<float> expected(points.size() * stride);
  if (!twin.sum(context, scene, points, expected)) return;
  int bits = 0;
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float* const a = &sums[i * stride];
    const float* const b = &expected[i * stride];
    bits += !std::equal(a, a + stride, b);
    for (std::size_t c = 1; b[0] > 0 && c < stride; ++c)
      most = std::max(most, 255 * std::fabs(double{a[c]} / a[0] - double{b[c]} / b[0]));
  }
  state.counters["bits"] = bits;
  state.counters["most"] = most;
}

void compare(benchmark::State& state, int stack, const gather::Scene& scene,
             std::span<const gather::WalkPoint> points, std::span<const float> sums) {
  points = points.first(std::min(points.size(), kCompared));
  if (stack == 4) compare_with_twin<4>(state, scene, points, sums);
  if (stack == 8) compare_with_twin<8>(state, scene, points, sums);
  if (stack == 16) compare_with_twin<16>(state, scene, points, sums);
}

/// Scene, width, stack, local size.
void by_device(benchmark::State& state) {
  const auto argument = [&](std::size_t i) { return static_cast<int>(state.range(i)); };
  const int scene = argument(0), width = argument(1);
  Points* const found = points_of(state, scene, kWidths[width]);
  if (!found) return;
  const Result<std::unique_ptr<gpu::Walker>> walker =
      gpu::Walker::create({.stack = argument(2), .local_size = argument(3)});
  if (!walker) return state.SkipWithError(walker.status().message.c_str());
  state.SetLabel(label(scene, kWidths[width], (*walker)->device_name()));
  const std::vector<gather::WalkPoint>& all = found->at[kWidths[width]];
  const std::vector<gather::WalkPoint> points =
      is_software((*walker)->device_name()) ? bench::sample_of(all, kSample) : all;
  gather::Scene& tables = found->drawing->scene;
  tables.identity = std::make_shared<const char>();
  Context context;
  std::vector<float> sums(points.size() * gather::sums_of_point(tables));
  // The first call compiles, uploads, and finds out how many points fit into a batch.
  for (int i = 0; i < 2; ++i)
    if (!(*walker)->sum(context, tables, points, sums)) return state.SkipWithError("no answer");
  for (auto _ : state) benchmark::DoNotOptimize((*walker)->sum(context, tables, points, sums).ok());
  count_points(state, points.size());
  compare(state, argument(2), tables, points, sums);
}

/// Scene, width, threads.
void by_packets(benchmark::State& state) {
  const int scene = static_cast<int>(state.range(0));
  const int width = kWidths[state.range(1)];
  Points* const found = points_of(state, scene, width);
  if (!found) return;
  ThreadPool pool(static_cast<int>(state.range(2)));
  Context context;
  context.executor = &pool;
  state.SetLabel(label(scene, width, std::to_string(pool.thread_count()) + " threads"));
  const gather::Scene& tables = found->drawing->scene;
  gather::LocatedPoints located;
  const std::vector<gather::WalkPoint>& all = found->at[width];
  std::vector<Vec2> at;
  for (const gather::WalkPoint& point : all) {
    at.push_back(tables.origin + Vec2{point.x, point.y});
    located.x.push_back(point.x), located.y.push_back(point.y);
    located.triangle.push_back(static_cast<std::uint32_t>(point.triangle));
  }
  const Result<gather::Packing> packing = gather::pack(context, tables, located);
  std::vector<float> out(all.size() * static_cast<std::size_t>(tables.channel_count()));
  const gather::FreeEnds no_ends;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        gather::gather_exact(context, tables, no_ends, at, located, *packing, {out, {}, false})
            .ok());
  }
  count_points(state, all.size());
}

/// Creates a context, and reads the limits of its device.
void create_context(benchmark::State& state) {
  for (auto _ : state) {
    const auto walker = gpu::Walker::create({});
    if (!walker) return state.SkipWithError(walker.status().message.c_str());
  }
}
BENCHMARK(create_context)->Unit(benchmark::kMillisecond)->UseRealTime();

void with_device(benchmark::State& state, void (*body)(benchmark::State&, const gpu::Device&)) {
  const auto device = gpu::Device::create(gpu::DeviceUse::compute);
  if (!device) return state.SkipWithError(device.status().message.c_str());
  state.SetLabel((*device)->name());
  body(state, **device);
}

void compile(benchmark::State& state) {
  with_device(state, [](benchmark::State& s, const gpu::Device& device) {
    for (auto _ : s) benchmark::DoNotOptimize(gpu::walk_program(device, {}, s.range(0) != 0).ok());
  });
}
BENCHMARK(compile)->ArgName("blends")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void upload(benchmark::State& state) {
  Points* const found = points_of(state, static_cast<int>(state.range(0)), 0);
  if (!found) return;
  with_device(state, [](benchmark::State& s, const gpu::Device&) {
    const gather::Scene& scene = points_of(s, static_cast<int>(s.range(0)), 0)->drawing->scene;
    for (auto _ : s) {
      const gpu::WalkTables tables(scene);
      glFinish();
    }
    s.SetBytesProcessed(s.iterations() *
                        static_cast<std::int64_t>(gpu::WalkTables::bytes_of(scene)));
  });
}
BENCHMARK(upload)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();

void shapes(benchmark::internal::Benchmark* b) {
  for (int scene = 0; scene < 3; ++scene)
    for (int width = 0; width < 3; ++width) b->Args({scene, width, 16, 64});
  for (const int stack : {4, 8}) b->Args({0, 1, stack, 64});
  for (const int local : {32, 128}) b->Args({0, 1, 16, local});
  b->ArgNames({"scene", "width", "stack", "local"});
}
BENCHMARK(by_device)->Apply(shapes)->Unit(benchmark::kMillisecond)->UseRealTime();

void threads(benchmark::internal::Benchmark* b) {
  for (int scene = 0; scene < 3; ++scene)
    for (int width = 0; width < 3; ++width)
      for (const int count : {1, 0}) b->Args({scene, width, count});
  b->ArgNames({"scene", "width", "threads"});
}
BENCHMARK(by_packets)->Apply(threads)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
