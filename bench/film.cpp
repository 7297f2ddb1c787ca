#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "largest_layer.hpp"
#include "sfumato/solve/solution.hpp"

// The cost of the frames of a film, compared with solving each frame alone: CPU time in
// milliseconds of one thread, and the triangles of the last frame.
//
//   build/bench/film [--curves N] [--frames N] FILE...
//
// N curves of the layer with the most curves move by up to seven user units.
namespace sfumato {
namespace {

using bench::cpu_milliseconds;

struct Options {
  std::uint32_t curves = 1;
  int frames = 24;
};

/// Moves curves that are evenly distributed in the layer.
void move_curves(const Layer& first, std::uint32_t curves, int frame, Layer& layer) {
  const auto count = static_cast<std::uint32_t>(first.curves.size());
  for (std::uint32_t i = 0; i < curves; ++i) {
    const std::uint32_t curve = (2 * i + 1) * count / (2 * curves);
    layer.curves[curve] = first.curves[curve];
    for (Vec2& p : layer.curves[curve].control_points)
      p = p + Vec2{1.0 + frame % 6, 2.0 - frame % 7};
  }
}

bool measure(const std::string& path, const Options& asked) {
  Context context;
  std::optional<bench::LargestLayer> read = bench::read_largest_layer(context, path);
  if (!read) return false;
  Document document = std::move(read->document);
  const std::uint32_t curves = std::min(asked.curves, read->curve_count);
  const Layer first = document.layers[read->layer];
  Result<Solution> film = Solution::create(context, document);
  if (!film || !film->solve_next(context, {})) return false;
  double alone = 0, next = 0, second = 0;
  std::uint32_t triangles = 0, triangles_alone = 0;
  FrameLayers layers;
  for (int i = 0; i < asked.frames; ++i) {
    move_curves(first, curves, i, document.layers[read->layer]);
    double start = cpu_milliseconds();
    const Result<Picture> picture = diffuse(context, document, {});
    if (!picture) return false;
    alone += cpu_milliseconds() - start;
    if (!film->apply(context, ReplaceDocument{document})) return false;
    start = cpu_milliseconds();
    if (!film->solve_next(context, {}, &layers)) return false;
    (i == 0 ? second : next) += cpu_milliseconds() - start;
    triangles = film->picture().layers[read->layer].triangle_count();
    triangles_alone = picture->layers[read->layer].triangle_count();
  }
  alone /= asked.frames;
  next /= asked.frames - 1;
  std::printf(
      "%-24s alone %7.1f  second frame %7.1f  later %7.1f  ratio %.2f  begun %zu  triangles %u, "
      "alone %u  memory %.0f MB\n",
      read->name.c_str(), alone, second, next, next / alone, layers.begun, triangles,
      triangles_alone, static_cast<double>(context.budget.used()) * 1e-6);
  return true;
}

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  sfumato::Options options;
  const auto read_curves = [&](const char* value) {
    options.curves = static_cast<std::uint32_t>(sfumato::bench::number_of(value, 1));
  };
  const auto read_frames = [&](const char* value) {
    options.frames = sfumato::bench::number_of(value, 2);
  };
  return sfumato::bench::measure_files(
      argc, argv, {{"--curves", read_curves}, {"--frames", read_frames}},
      [&](const std::string& path) { return sfumato::measure(path, options); }, "cannot be solved");
}
