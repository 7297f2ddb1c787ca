#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "raster/layers/local_stroke.hpp"

// A local curve → pixels: scribbles of several lengths and radii over 1024², one thread.
namespace sfumato {
namespace {

using raster::StrokePainter;

constexpr int kSide = 1024;

double hash_unit(std::uint32_t i) {
  i = (i ^ (i >> 16)) * 0x7feb352dU;
  i = (i ^ (i >> 15)) * 0x846ca68bU;
  return (i ^ (i >> 16)) / 4294967296.0;
}

/// Returns a random walk of `pieces` cubics of about 5 units each that stays inside the image.
LocalCurve scribble(int pieces, float radius, bool two_sided) {
  LocalCurve curve;
  Vec2 p{kSide / 2, kSide / 2};
  double angle = 0, bend = 0;
  curve.control_points.push_back(p);
  for (int i = 0; i < 3 * pieces; ++i) {
    bend = 0.9 * bend + 0.2 * (hash_unit(static_cast<std::uint32_t>(i)) - 0.5);
    angle += bend;
    const Vec2 next = p + Vec2{std::cos(angle), std::sin(angle)} * 1.7;
    const bool inside = next.x > 8 && next.x < kSide - 8 && next.y > 8 && next.y < kSide - 8;
    if (inside) p = next;
    if (!inside) angle += 2.5;
    curve.control_points.push_back(p);
  }
  curve.left_color.stops = {{0, {1, 0, 0}}, {static_cast<double>(pieces), {0, 0, 1}}};
  if (two_sided) curve.right_color.stops = {{0, {0, 1, 0}}};
  curve.influence_radius.stops = {{0, radius}};
  return curve;
}

/// Arguments: pieces of the curve, influence radius in pixels, both sides coloured, SimdLevel.
void paint_scribble(benchmark::State& state) {
  Context context;
  context.simd = static_cast<SimdLevel>(state.range(3));
  if (context.simd > detected_simd_level()) {
    state.SkipWithError("this machine has no such instruction set");
    return;
  }
  const LocalStroke stroke{scribble(static_cast<int>(state.range(0)),
                                    static_cast<float>(state.range(1)), state.range(2) != 0),
                           {}};
  std::vector<float> plane[4];
  for (auto& values : plane) values.assign(std::size_t{kSide} * kSide, 0);
  for (auto _ : state) {
    for (auto& values : plane) std::fill(values.begin(), values.end(), 0.0f);
    const Result<StrokePainter> painter =
        StrokePainter::create(context, stroke, {}, InterpolationSpace::srgb);
    if (!painter) {
      state.SkipWithError("the stroke was refused");
      return;
    }
    const Status status = painter->paint(context, 0, 0, kSide, kSide, plane[0].data(),
                                         plane[1].data(), plane[2].data(), plane[3].data(), kSide);
    if (!status) return state.SkipWithError("cancelled");
    benchmark::DoNotOptimize(plane[3].data());
  }
  double covered = 0;
  for (float alpha : plane[3]) covered += alpha > 0;
  state.counters["covered"] = covered;
  state.counters["per_pixel"] = benchmark::Counter(
      covered, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(paint_scribble)
    ->ArgNames({"pieces", "radius", "two_sided", "simd"})
    ->Args({100, 4, 0, 2})
    ->Args({1000, 4, 0, 2})
    ->Args({10000, 4, 0, 2})
    ->Args({10000, 4, 0, 1})
    ->Args({10000, 4, 0, 0})
    ->Args({10000, 4, 1, 2})
    ->Args({10000, 1, 0, 2})
    ->Args({1000, 20, 0, 2})
    ->Args({1000, 20, 1, 2})
    ->Args({100, 200, 0, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
