#include <benchmark/benchmark.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/picture/picture_file.hpp"
#include "sfumato/solve/diffuse.hpp"

// Pictures to bytes and back, with checks; `bytes` is the size of the file.
namespace sfumato {
namespace {

constexpr std::array<const char*, 3> kScenes{"lady_bug.xml", "dolphin.xml", "roses.xml"};

/// Returns the picture of a scene, solved once; null if the scene is missing.
const Picture* picture_of(benchmark::State& state) {
  static std::map<std::string, Picture> solved;
  const std::string name = kScenes[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(name);
  if (const auto known = solved.find(name); known != solved.end()) return &known->second;
  const auto document = bench::scene(state, name);
  if (!document) return nullptr;
  Context context;
  Result<Picture> picture = diffuse(context, *document, {});
  if (!picture) {
    state.SkipWithError("the scene was refused");
    return nullptr;
  }
  return &solved.emplace(name, std::move(*picture)).first->second;
}

void write(benchmark::State& state) {
  const Picture* const picture = picture_of(state);
  if (!picture) return;
  const Context context;
  for (auto _ : state) {
    auto bytes = write_picture(context, *picture);
    benchmark::DoNotOptimize(bytes);
    state.counters["bytes"] = static_cast<double>(bytes->size());
  }
}
BENCHMARK(write)->ArgName("scene")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

/// Arguments: scene, threads.
void read(benchmark::State& state) {
  const Picture* const picture = picture_of(state);
  if (!picture) return;
  ThreadPool executor(static_cast<int>(state.range(1)));
  const Context context{.executor = &executor};
  const auto bytes = write_picture(context, *picture);
  for (auto _ : state) {
    auto again = read_picture(context, *bytes);
    benchmark::DoNotOptimize(again);
  }
  state.counters["bytes"] = static_cast<double>(bytes->size());
}
BENCHMARK(read)
    ->ArgNames({"scene", "threads"})
    ->ArgsProduct({{0, 1, 2}, {1, 2}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
