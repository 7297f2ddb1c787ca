#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "largest_layer.hpp"
#include "sfumato/solve/solution.hpp"

// The cost of a rough picture after two curves moved, compared with the exact one: CPU time in
// milliseconds of one thread, the minimum of some rounds. It also measures the begin of a drag of
// one curve and its first frame: after the rough picture, and after the exact one, which has
// reserved the data for the begin of drags.
//
//   build/bench/rough [--rounds N] FILE...
namespace sfumato {
namespace {

using bench::cpu_milliseconds;

/// The least time of each step.
struct Times {
  double rough = 1e9, rough_begin = 1e9, rough_frame = 1e9;
  double exact = 1e9, exact_begin = 1e9, exact_frame = 1e9;
  std::uint64_t rough_nodes = 0, exact_nodes = 0;
};

Curve moved(const Solution& solution, std::uint32_t layer, std::uint32_t curve, double by) {
  Curve result = solution.document().layers[layer].curves[curve];
  for (Vec2& p : result.control_points) p = p + Vec2{by, -0.5 * by};
  return result;
}

/// Takes the minimum of the former time and the time of a step.
template <class Step>
bool take_time(double& least, const Step& step) {
  const double start = cpu_milliseconds();
  const bool is_good = step().ok();
  least = std::min(least, cpu_milliseconds() - start);
  return is_good;
}

bool drag(Context& context, Solution& solution, std::uint32_t layer, std::uint32_t curve,
          double& begin, double& frame) {
  Curve to = moved(solution, layer, curve, 1);
  const auto drag_it = [&] { return solution.drag(context, {std::move(to)}); };
  return take_time(begin, [&] { return solution.begin_drag(context, layer, {curve}); }) &&
         take_time(frame, drag_it);
}

bool run_round(Context& context, Solution& solution, std::uint32_t layer, std::uint32_t count,
               double by, Times& times) {
  const std::uint32_t one = count / 3, other = 2 * count / 3;
  for (const std::uint32_t curve : {one, other}) {
    Curve to = moved(solution, layer, curve, by);
    if (!solution.apply(context, ReplaceCurve{layer, curve, std::move(to)}).ok()) return false;
  }
  DiffuseStats rough, exact;
  const bool is_good =
      take_time(times.rough, [&] { return solution.solve_roughly(context, {}, &rough); }) &&
      drag(context, solution, layer, one, times.rough_begin, times.rough_frame) &&
      take_time(times.exact, [&] { return solution.solve(context, {}, &exact); }) &&
      drag(context, solution, layer, one, times.exact_begin, times.exact_frame);
  times.rough_nodes = rough.nodes;
  times.exact_nodes = exact.nodes;
  return is_good;
}

bool measure(const std::string& path, int rounds) {
  Context context;
  std::optional<bench::LargestLayer> read = bench::read_largest_layer(context, path);
  if (!read || read->curve_count < 2) return false;
  Result<Solution> solution = Solution::create(context, std::move(read->document));
  if (!solution) return false;
  solution->expect_drags();
  if (!solution->solve(context, {}).ok()) return false;
  Times times;
  for (int round = 0; round < rounds; ++round) {
    const double by = round % 2 == 0 ? 3 : -3;
    if (!run_round(context, *solution, read->layer, read->curve_count, by, times)) return false;
  }
  std::printf(
      "%-14s rough %7.1f, %7llu nodes; begin %7.1f, frame %6.1f    exact %7.1f, %7llu nodes; begin "
      "%7.1f, frame %6.1f\n",
      read->name.c_str(), times.rough, static_cast<unsigned long long>(times.rough_nodes),
      times.rough_begin, times.rough_frame, times.exact,
      static_cast<unsigned long long>(times.exact_nodes), times.exact_begin, times.exact_frame);
  return true;
}

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  int rounds = 5;
  const auto read_rounds = [&](const char* value) { rounds = sfumato::bench::number_of(value, 1); };
  return sfumato::bench::measure_files(
      argc, argv, {{"--rounds", read_rounds}},
      [&](const std::string& path) { return sfumato::measure(path, rounds); },
      "cannot be measured");
}
