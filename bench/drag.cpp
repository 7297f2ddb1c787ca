#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "largest_layer.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/session/layer_session.hpp"

// The cost of the begin of a drag, of its first frame and of later frames, while a curve moves,
// compared with solving its layer: CPU time in milliseconds of one thread. It also prints the
// memory, in MB, that a solution reserves for drags.
//
//   build/bench/drag [--curves N] [--together N] [--max-error E] [--missed SHARE] [--seconds S]
//   FILE...
//
// SHARE is FrameAccuracy::most_missed. S is the time of a frame (FramePolicy::time), after which
// `left` nodes wait. N curves of the layer with the most curves are dragged by up to seven user
// units: one after another, or so many together.
namespace sfumato {
namespace {

constexpr int kFrames = 30;  // after the first frame

struct Options {
  std::uint32_t curves = 12;
  std::uint32_t together = 1;
  double max_error = 1;
  double most_missed = solve::kMostMissed;
  double seconds = std::numeric_limits<double>::infinity();
};

using bench::cpu_milliseconds;

struct Times {
  double begin = 0;
  double first = 0;
  double frame = 0;
  double gathered = 0;
  double left = 0;
  int frames = 0;
};

/// A solved layer.
struct Solved {
  solve::LayerSight sight;
  std::optional<solve::RefinedLayer> refined;
  PatchLayer patches;
};

bool solve_layer(Context& context, const Document& document, std::uint32_t layer,
                 const DiffuseOptions& options, Solved& solved) {
  solved.sight = solve::sight_of_layer(document, layer, document.artboard);
  Result<solve::PreparedLayer> prepared = solve::prepare_layer(
      context, document, layer, solved.sight, options, nullptr, solve::LayerUse::drags);
  if (!prepared) return false;
  Result<PatchLayer> patches =
      solve::LayerSolver(context, std::move(*prepared), options, nullptr).solve(&solved.refined);
  if (patches) solved.patches = std::move(*patches);
  return patches.ok();
}

bool drag_some(Context& context, const Document& document, std::uint32_t layer,
               const std::vector<std::uint32_t>& curves, const DiffuseOptions& options,
               const Options& asked, Solved& solved, Times& times) {
  const double start = cpu_milliseconds();
  Result<solve::LayerSession> drag =
      solve::LayerSession::open(context, solve::input_of(document, layer, solved.sight, options),
                                curves, solved.refined, {.most_missed = asked.most_missed});
  if (!drag) return false;
  times.begin += cpu_milliseconds() - start;
  PatchLayer shown = solved.patches;                                   // then the last frame
  std::optional<solve::FrameRows> rows = drag->take_rows_of_solved();  // of it
  for (int i = 0; i <= kFrames; ++i) {
    std::vector<Curve> moved;
    for (const std::uint32_t curve : curves) {
      moved.push_back(document.layers[layer].curves[curve]);
      for (Vec2& p : moved.back().control_points) p = p + Vec2{1.0 + i % 6, 2.0 - i % 7};
    }
    DiffuseStats stats;
    const double frame_start = cpu_milliseconds();
    const solve::FramePolicy how{solve::FrameTime(asked.seconds), rows.has_value(), &stats};
    Result<std::optional<solve::FramePatches>> made = drag->frame(context, moved, how);
    if (!made || !*made) return false;
    solve::FramePatches* const frame = &**made;
    if (frame->is_whole) {
      shown = std::move(frame->layer);
    } else {
      if (!drag->make_room(context, shown)) return false;
      drag->write(*frame, *rows, shown);
    }
    rows = std::move(frame->rows);
    (i == 0 ? times.first : times.frame) += cpu_milliseconds() - frame_start;
    if (i == 0) continue;
    times.gathered += static_cast<double>(stats.nodes);
    times.left += static_cast<double>(frame->left);
    ++times.frames;
  }
  return true;
}

bool measure(const std::string& path, const Options& asked) {
  Context context;
  const std::optional<bench::LargestLayer> read = bench::read_largest_layer(context, path);
  if (!read) return false;
  const auto [layer, count] = std::pair(read->layer, read->curve_count);
  const Document& document = read->document;
  DiffuseOptions options;
  options.max_error = asked.max_error;
  Solved solved;
  const std::uint64_t used = context.budget.used();
  const double start = cpu_milliseconds();
  if (!solve_layer(context, document, layer, options, solved)) return false;
  const double solve = cpu_milliseconds() - start;
  const double kept = static_cast<double>(context.budget.used() - used) * 1e-6;
  Times times;
  const std::uint32_t curves = std::min(asked.curves, count);
  for (std::uint32_t i = 0; i < curves; ++i) {
    std::vector<std::uint32_t> together;
    const std::uint32_t first = i * count / curves;
    for (std::uint32_t k = 0; k < std::min(asked.together, count - first); ++k)
      together.push_back(first + k);
    if (!drag_some(context, document, layer, together, options, asked, solved, times)) return false;
  }
  std::printf(
      "%-24s solve %7.1f  kept %6.1f  begin %7.1f  first frame %6.2f  later %6.2f, nodes %6.0f, "
      "left %6.0f\n",
      read->name.c_str(), solve, kept, times.begin / curves, times.first / curves,
      times.frame / times.frames, times.gathered / times.frames, times.left / times.frames);
  return true;
}

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  using sfumato::bench::number_of;
  sfumato::Options options;
  const auto count = [](std::uint32_t& to) {
    return [&to](const char* value) { to = static_cast<std::uint32_t>(number_of(value, 1)); };
  };
  const auto real = [](double& to) { return [&to](const char* value) { to = std::atof(value); }; };
  return sfumato::bench::measure_files(
      argc, argv,
      {{"--curves", count(options.curves)},
       {"--together", count(options.together)},
       {"--missed", real(options.most_missed)},
       {"--seconds", real(options.seconds)},
       {"--max-error", real(options.max_error)}},
      [&](const std::string& path) { return sfumato::measure(path, options); },
      "cannot be dragged");
}
