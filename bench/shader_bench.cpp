#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "raster/shaders/image_shader.hpp"

// Image-domain shaders: rows of 256 pixels of a 512² image, one thread; the rate is per pixel.
namespace sfumato {
namespace {

using raster::ImageShader;

constexpr int kRow = 256;

Shader noise_texture() {
  Texture texture;
  texture.width = texture.height = 512;
  for (std::uint32_t i = 0; i < 4u * 512 * 512; ++i) {
    const std::uint32_t h = (i ^ (i >> 7)) * 0x7feb352dU;
    texture.rgba.push_back(i % 4 == 3 ? 255 : static_cast<std::uint8_t>(h >> 24));
  }
  return {"texture", texture};
}

Shader gradient(bool radial) {
  GradientFill fill;
  if (radial)
    fill.shape = RadialGradient{{256, 256}, {200, 220}, 200};
  else
    fill.shape = LinearGradient{{10, 0}, {500, 120}};
  fill.stops = {{0, {1, 0, 0}}, {0.3, {0, 1, 0}}, {1, {0, 0, 1}}};
  return {"gradient", fill};
}

void evaluate(benchmark::State& state, const Shader& document, double scale, SimdLevel simd) {
  Context context;
  context.simd = simd;
  if (context.simd > detected_simd_level()) {
    state.SkipWithError("this machine has no such instruction set");
    return;
  }
  const Result<ImageShader> shader =
      ImageShader::create(context, document, InterpolationSpace::srgb);
  if (!shader) {
    state.SkipWithError("the shader was refused");
    return;
  }
  const Affine map{scale, 0.05 * scale, -0.05 * scale, scale, 20, 30};
  std::vector<float> plane(4 * kRow);
  int y = 0;
  for (auto _ : state) {
    shader->evaluate(map, 0, y++ % 512, kRow, plane.data(), plane.data() + kRow,
                     plane.data() + 2 * kRow, plane.data() + 3 * kRow);
    benchmark::DoNotOptimize(plane.data());
  }
  state.counters["per_pixel"] = benchmark::Counter(
      kRow, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Arguments: hundredths of a texel to a pixel, SimdLevel.
void texture_row(benchmark::State& state) {
  evaluate(state, noise_texture(), static_cast<double>(state.range(0)) / 100,
           static_cast<SimdLevel>(state.range(1)));
}
BENCHMARK(texture_row)->ArgNames({"scale", "simd"})->ArgsProduct({{30, 150, 370, 2000}, {0, 1, 2}});

/// Argument: radial.
void gradient_row(benchmark::State& state) {
  evaluate(state, gradient(state.range(0) != 0), 1, detected_simd_level());
}
BENCHMARK(gradient_row)->ArgName("radial")->Arg(0)->Arg(1);

}  // namespace
}  // namespace sfumato

BENCHMARK_MAIN();
