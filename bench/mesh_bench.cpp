/// The mesher's stages on the public scenes: 0.25 px chords at 1024 px, 22 degrees, 4 % area.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "sfumato/formats/orzan/orzan.hpp"
#include "support/places.hpp"

namespace {

using namespace sfumato;

struct Input {
  curves::FlatCurves flat;
  mesh::MeshOptions options;
};

std::optional<Input> load(const std::string& name) {
  std::ifstream stream(test::shared_path("scenes/") + name + ".xml", std::ios::binary);
  if (!stream) return std::nullopt;
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  Context context;
  Result<ReadDocument> read = read_orzan(context, bytes, name);
  if (!read) return std::nullopt;
  const Box artboard = read->document.artboard;
  const double unit = std::max(artboard.width(), artboard.height()) / 1024;
  curves::FlattenOptions flatten_options;
  flatten_options.tolerance = 0.25 * unit;
  Result<curves::FlatCurves> flat =
      curves::flatten(context, read->document.layers.at(0).curves, flatten_options);
  if (!flat) return std::nullopt;
  Input input{std::move(*flat), {}};
  input.options.frame = artboard;
  input.options.unit_size = unit;
  input.options.max_area = 0.04 * artboard.width() * artboard.height();
  return input;
}

/// Reports nanoseconds per triangle, for `count` triangles.
void report(benchmark::State& state, std::size_t count) {
  state.counters["triangles"] = static_cast<double>(count);
  state.counters["triangles/s"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

void build(benchmark::State& state, const std::string& name) {
  const std::optional<Input> input = load(name);
  if (!input) return state.SkipWithError("no public scene");
  Context context;
  std::size_t triangles = 0;
  for (auto _ : state) {
    Result<mesh::Mesher> mesher = mesh::Mesher::build(context, input->flat, input->options);
    triangles = mesher->visibility_mesh({})->triangle_count();
  }
  report(state, triangles);
}

void build_and_refine(benchmark::State& state, const std::string& name) {
  const std::optional<Input> input = load(name);
  if (!input) return state.SkipWithError("no public scene");
  Context context;
  std::optional<mesh::Mesher> last;
  for (auto _ : state) {
    Result<mesh::Mesher> mesher = mesh::Mesher::build(context, input->flat, input->options);
    if (!mesher->refine(context)) return state.SkipWithError("refine failed");
    last = std::move(*mesher);
  }
  report(state, last->patch_mesh({})->triangle_count());
}

void extract(benchmark::State& state, const std::string& name) {
  const std::optional<Input> input = load(name);
  if (!input) return state.SkipWithError("no public scene");
  Context context;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, input->flat, input->options);
  if (!mesher->refine(context)) return state.SkipWithError("refine failed");
  std::size_t triangles = 0;
  for (auto _ : state) triangles = mesher->patch_mesh({})->triangle_count();
  report(state, triangles);
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::string name : {"lady_bug", "dolphin", "tomatos", "roses_spirales", "drape"}) {
    benchmark::RegisterBenchmark(("build/" + name).c_str(),
                                 [name](benchmark::State& state) { build(state, name); });
    benchmark::RegisterBenchmark(
        ("build_and_refine/" + name).c_str(),
        [name](benchmark::State& state) { build_and_refine(state, name); });
    benchmark::RegisterBenchmark(("extract/" + name).c_str(),
                                 [name](benchmark::State& state) { extract(state, name); });
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
