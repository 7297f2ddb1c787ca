#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "largest_layer.hpp"
#include "sfumato/solve/solution.hpp"

// The cost of preparing a stop for colour changes, and of a frame after a change, compared with
// solving the document: CPU time in milliseconds of one thread.
//
//   build/bench/color [--curves N] [--max-error E] FILE...
//
// Five colours are given, one after another, to the first left stop of N curves of the layer with
// the most curves.
namespace sfumato {
namespace {

constexpr int kFrames = 5;

struct Options {
  std::uint32_t curves = 12;
  double max_error = 1;
};

using bench::cpu_milliseconds;

struct Times {
  double begin = 0;
  double first = 0;  ///< the first frame, which makes tables
  double frame = 0;  ///< the other frames
  double nodes = 0;
  int stops = 0;
};

bool color_one(Context& context, Solution& solution, const StopPlace& place, Times& times) {
  const Curve before = solution.document().layers[place.layer].curves[place.curve];
  const double start = cpu_milliseconds();
  if (!solution.begin_color(context, place)) return false;
  times.begin += cpu_milliseconds() - start;
  times.nodes += static_cast<double>(solution.color_response().size());
  for (int i = 0; i <= kFrames; ++i) {
    const double frame_start = cpu_milliseconds();
    if (!solution.color(context, Rgb{0.2f * static_cast<float>(i), 0.5f, 0.25f})) return false;
    (i == 0 ? times.first : times.frame) += cpu_milliseconds() - frame_start;
  }
  ++times.stops;
  return solution.apply(context, ReplaceCurve{place.layer, place.curve, before}).ok();
}

bool measure(const std::string& path, const Options& asked) {
  Context context;
  std::optional<bench::LargestLayer> read = bench::read_largest_layer(context, path);
  if (!read) return false;
  const auto [layer, count] = std::pair(read->layer, read->curve_count);
  Result<Solution> solution = Solution::create(context, std::move(read->document));
  if (!solution) return false;
  DiffuseOptions options;
  options.max_error = asked.max_error;
  solution->expect_drags();
  const double start = cpu_milliseconds();
  if (!solution->solve(context, options)) return false;
  const double solve = cpu_milliseconds() - start;
  Times times;
  const std::uint32_t curves = std::min(asked.curves, count);
  for (std::uint32_t i = 0; i < curves; ++i) {
    const StopPlace place{layer, i * count / curves, CurveSide::left, StopAttribute::color, 0};
    const Curve& curve = solution->document().layers[layer].curves[place.curve];
    if (curve.left.color.kind != ShaderKind::curve_domain) continue;
    if (!color_one(context, *solution, place, times) || !solution->solve(context, options))
      return false;
  }
  if (times.stops == 0) return false;
  std::printf("%-24s solve %7.1f  begin %7.1f  first frame %6.2f  frame %6.2f  nodes %7.0f\n",
              read->name.c_str(), solve, times.begin / times.stops, times.first / times.stops,
              times.frame / (kFrames * times.stops), times.nodes / times.stops);
  return true;
}

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  sfumato::Options options;
  const auto read_curves = [&](const char* value) {
    options.curves = static_cast<std::uint32_t>(sfumato::bench::number_of(value, 1));
  };
  const auto read_error = [&](const char* value) { options.max_error = std::atof(value); };
  return sfumato::bench::measure_files(
      argc, argv, {{"--curves", read_curves}, {"--max-error", read_error}},
      [&](const std::string& path) { return sfumato::measure(path, options); },
      "has no colours to change");
}
