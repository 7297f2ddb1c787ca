#include "solve/layers/layer_runs.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "base/parallel.hpp"
#include "base/try.hpp"
#include "solve/layers/kept_layers.hpp"
#include "solve/layers/rough.hpp"

namespace sfumato::solve {
namespace {

/// With more threads than this, the others help with the loops of each layer. Every layer at work
/// takes memory. A thread that waits for its helpers and solves another layer meanwhile also takes
/// stack.
constexpr std::size_t kLayersAtOnce = 8;

void add(const DiffuseStats& part, DiffuseStats& sum) {
  sum.curves += part.curves;
  sum.segments += part.segments;
  sum.triangles += part.triangles;
  sum.vertices += part.vertices;
  sum.nodes += part.nodes;
  sum.geometry_seconds += part.geometry_seconds;
  sum.triangulation_seconds += part.triangulation_seconds;
  sum.gather_seconds += part.gather_seconds;
}

}  // namespace

void SharedProgress::add(double done) {
  done_.fetch_add(done);
  if (!progress_ || is_telling_.test_and_set()) return;
  progress_->report("gather", std::min(1.0, done_.load() / total_));
  is_telling_.clear();
}

LayerRuns::LayerRuns(Context& context, const Document& document, std::span<const LayerTask> tasks,
                     const DiffuseOptions& options, std::optional<std::size_t> most_kept)
    : context_(context),
      document_(document),
      tasks_(tasks),
      options_(options),
      most_kept_(most_kept),
      progress_(context.progress, total_work()),
      first_failed_(task_count()) {}

/// Estimates the work of a layer.
double LayerRuns::work_of(std::uint32_t index) const {
  return static_cast<double>(document_.layers[tasks_[index].layer].curves.size());
}

double LayerRuns::total_work() const {
  double sum = 0;
  for (std::uint32_t i = 0; i < task_count(); ++i) sum += work_of(i);
  return std::max(sum, 1.0);
}

Status LayerRuns::run() {
  Status status = make_tables();
  if (status && context_.thread_count() > 1) status = run_side_by_side();
  if (status && first_failed_ < task_count()) status = run_one_by_one();
  give_up_beyond();
  return status;
}

Status LayerRuns::make_tables() {
  SFUMATO_TRY(memory_.reserve(context_, runs_, task_count()));
  SFUMATO_TRY(memory_.resize(context_, order_, task_count()));
  for (std::uint32_t i = 0; i < task_count(); ++i) runs_.emplace_back();
  std::iota(order_.begin(), order_.end(), 0u);
  std::ranges::sort(order_, [&](std::uint32_t a, std::uint32_t b) {
    return work_of(a) != work_of(b) ? work_of(a) > work_of(b) : a < b;
  });
  if (context_.thread_count() == 1) first_failed_ = 0;
  return ok_status();
}

Status LayerRuns::run_side_by_side() {
  const auto threads = static_cast<std::size_t>(context_.thread_count());
  const bool takes_turns = threads > kLayersAtOnce && order_.size() > kLayersAtOnce;
  const std::size_t tasks = takes_turns ? kLayersAtOnce : order_.size();
  std::atomic<std::size_t> next{0};
  Status status = parallel_for(context_, tasks, 1, [&](std::size_t, std::size_t) {
    do {
      const std::size_t i = next++;
      if (i >= order_.size()) return;
      run_beside(order_[i]);
    } while (takes_turns);
  });
  if (!status || first_failed_ == task_count()) return status;
  const Run& failed = runs_[first_failed_];
  return may_succeed_by_itself(failed) ? ok_status() : failed.status;
}

/// Returns whether a layer may succeed alone. One that had all memory to itself is not prepared
/// with less of it the next time.
bool LayerRuns::may_succeed_by_itself(const Run& failed) const {
  return is_lack_of_memory(failed.status) && (failed.is_prepared || task_count() > 1);
}

/// Layers after one that failed are skipped: run() ends with the first that failed.
void LayerRuns::run_beside(std::uint32_t index) {
  if (index > first_failed_) return;
  Status& status = runs_[index].status;
  status = no_throw([&] { return solve(index, true); });
  std::uint32_t first = first_failed_;
  while (!status && index < first && !first_failed_.compare_exchange_weak(first, index)) continue;
}

Status LayerRuns::run_one_by_one() {
  for (std::uint32_t i = first_failed_; i < task_count(); ++i)
    runs_[i] = Run{{}, {}, {}, {}, runs_[i].told, false, false};
  for (std::uint32_t i = first_failed_; i < task_count(); ++i) {
    SFUMATO_TRY(solve(i, false));
    give_up_beyond();
  }
  return ok_status();
}

Status LayerRuns::solve(std::uint32_t index, bool side_by_side) {
  Run& run = runs_[index];
  const auto tell = [&](double fraction) {
    if (fraction <= run.told) return;
    progress_.add(work_of(index) * (fraction - std::exchange(run.told, fraction)));
  };
  SFUMATO_TRY_ASSIGN(run.layer, solve_layer(index, run.stats, {side_by_side, tell}));
  tell(1);
  Status status = run.charge.add(context_, bytes_of(run.layer), "patches");
  run.is_finished = status.ok();
  return status;
}

Result<PatchLayer> LayerRuns::solve_layer(std::uint32_t index, DiffuseStats& stats, SolveWay way) {
  const auto& [layer, sight, last_drag] = tasks_[index];
  if (sight.viewport.empty() || document_.layers[layer].curves.empty()) return PatchLayer{};
  if (!is_for_pixel_grid(options_)) return solve_layer_by(options_, index, stats, way);
  DiffuseStats tried;
  bool has_border = false;
  Result<PatchLayer> solved = solve_layer_by(options_, index, tried, way, &has_border);
  if (!has_border) {
    add(tried, stats);
    return solved;
  }
  *solved = {};
  // The border of the region that sees a curve continues chords over long distances: fine chords
  // keep it in its place.
  DiffuseOptions fine = options_;
  fine.pixel_grid = false;
  return solve_layer_by(fine, index, stats, way);
}

Result<PatchLayer> LayerRuns::solve_layer_by(const DiffuseOptions& options, std::uint32_t index,
                                             DiffuseStats& stats, SolveWay way, bool* has_border) {
  const auto& [layer, sight, last_drag] = tasks_[index];
  const LayerUse use = options.exact_pixels ? LayerUse::points
                       : most_kept_         ? LayerUse::drags
                                            : LayerUse::patches;
  SFUMATO_TRY_ASSIGN(auto&& prepared, prepare_layer(context_, document_, layer, sight, options,
                                                    &stats, use, way.side_by_side));
  runs_[index].is_prepared = true;
  const bool is_exact = prepared.is_exact;
  LayerSolver solver(context_, std::move(prepared), options, &stats, {}, way);
  if (is_exact) return solver.take_exact();
  Result<PatchLayer> solved = solver.solve(most_kept_ ? &runs_[index].refined : nullptr);
  if (has_border) *has_border = solved.ok() && solver.has_border();
  return solved;
}

/// Gives up kept layers beyond the limit, while no layer is being solved.
void LayerRuns::give_up_beyond() {
  if (!most_kept_) return;
  std::vector<KeptLayer> kept;
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    if (run.refined) kept.push_back({i, tasks_[i].last_drag, run.layer.triangle_count()});
  }
  for (const std::uint32_t i : layers_beyond(std::move(kept), *most_kept_))
    runs_[i].refined.reset();
}

void LayerRuns::add_to(DiffuseStats& stats) const {
  for (const Run& run : runs_) add(run.stats, stats);
}

std::vector<PatchLayer> LayerRuns::take() {
  std::vector<PatchLayer> layers;
  layers.reserve(runs_.size());
  for (Run& run : runs_) layers.push_back(std::move(run.layer));
  return layers;
}

std::optional<PatchLayer> LayerRuns::take_finished(std::uint32_t task) {
  if (task >= runs_.size() || !std::exchange(runs_[task].is_finished, false)) return std::nullopt;
  runs_[task].charge = {};
  return std::move(runs_[task].layer);
}

std::optional<RefinedLayer> LayerRuns::take_refined(std::uint32_t task) {
  return task < runs_.size() ? std::exchange(runs_[task].refined, std::nullopt) : std::nullopt;
}

}  // namespace sfumato::solve
