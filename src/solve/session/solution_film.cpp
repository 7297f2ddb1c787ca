#include <utility>

#include "base/try.hpp"
#include "solve/session/solution_state.hpp"

/// The part of Solution that makes frames of films.
namespace sfumato {

/// Makes the next frame of a visible layer: continues its film, or begins a new one.
Result<PatchLayer> Solution::State::solve_frame(Context& context, const solve::LayerTask& task,
                                                DiffuseStats* stats, FrameLayers& counts) {
  // Lack of memory releases the films in `films`; this film must stay during the frame.
  std::optional<solve::FilmLayer> film = std::exchange(films[task.layer], std::nullopt);
  if (film && film->can_go_on(document, task.layer, task.sight)) {
    SFUMATO_TRY_ASSIGN(auto&& next, film->next(context, document, task.layer, stats));
    if (next) {
      ++counts.continued;
      films[task.layer] = std::move(film);
      return std::move(*next);
    }
  }
  film.reset();
  PatchLayer patches;
  SFUMATO_TRY_ASSIGN(auto&& begun, solve::FilmLayer::begin(context, document, task.layer,
                                                           task.sight, *options, stats, patches));
  ++counts.begun;
  films[task.layer].emplace(std::move(begun));
  return patches;
}

Status Solution::State::solve_film(Context& context, const solve::LayerTask& task,
                                   DiffuseStats* stats, FrameLayers& counts) {
  LayerState& layer = layers[task.layer];
  layer.refined.reset();
  PatchLayer patches;
  if (!task.sight.viewport.empty() && !document.layers[task.layer].curves.empty()) {
    SFUMATO_TRY_ASSIGN(patches, solve_frame(context, task, stats, counts));
  }
  SFUMATO_TRY(hold(context, patches));
  layer = {task.sight, std::nullopt, std::move(patches), std::nullopt, true};
  return ok_status();
}

/// Makes the next frame of all layers. Solves them as solve() does if films lack memory, or if this
/// Context has another Budget.
Status Solution::State::solve_films(Context& context, const Box& viewport, DiffuseStats* stats,
                                    FrameLayers& counts) {
  SFUMATO_TRY_ASSIGN(auto&& to_solve, tasks(context, viewport, SolveGoal::next));
  const FrameLayers before = counts;
  counts.kept += layers.size() - to_solve.size();
  Status status = no_throw([&] {
    films.resize(layers.size());
    for (const solve::LayerTask& task : to_solve) {
      if (&context.budget != budget) break;
      SFUMATO_TRY(solve_film(context, task, stats, counts));
    }
    return ok_status();
  });
  if (status && &context.budget == budget) return status;
  if (!status && !is_lack_of_memory(status)) return status;
  films.clear();
  counts = before;
  counts.kept += layers.size() - to_solve.size();
  counts.begun += to_solve.size();
  return run_with_all_memory(
      [&](bool) { return solve_layers(context, viewport, SolveGoal::next, stats, false); });
}

Status Solution::State::solve_next(Context& context, const DiffuseOptions& wanted,
                                   FrameLayers& counts, DiffuseStats* stats) {
  const SpareRelease release(*this);
  SFUMATO_TRY_ASSIGN(const Box viewport, prepare(context, wanted, SolveGoal::next));
  return show_solved(context, viewport, solve_films(context, viewport, stats, counts));
}

}  // namespace sfumato
