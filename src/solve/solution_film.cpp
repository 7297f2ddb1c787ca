#include <utility>

#include "solve/solution_state.hpp"

/// Solution while it makes the frames of a film.
namespace sfumato {

/// Of a layer that is seen: by its film, or by a new one.
Result<PatchLayer> Solution::State::solve_frame(Context& context, const solve::LayerTask& task,
                                                DiffuseStats* stats, FrameLayers& counts) {
  // What takes part in this frame is not among what lack of memory drops.
  std::optional<solve::LayerFilm> film = std::exchange(films[task.layer], std::nullopt);
  if (film && film->can_go_on(document, task.layer, task.sight)) {
    Result<std::optional<PatchLayer>> next = film->next(context, document, task.layer, stats);
    if (!next) return next.status();
    if (*next) {
      ++counts.continued;
      films[task.layer] = std::move(film);
      return std::move(**next);
    }
  }
  film.reset();
  PatchLayer patches;
  Result<solve::LayerFilm> begun =
      solve::LayerFilm::begin(context, document, task.layer, task.sight, *options, stats, patches);
  if (!begun) return begun.status();
  ++counts.begun;
  films[task.layer].emplace(std::move(*begun));
  return patches;
}

Status Solution::State::solve_film(Context& context, const solve::LayerTask& task,
                                   DiffuseStats* stats, FrameLayers& counts) {
  LayerState& layer = layers[task.layer];
  layer.refined.reset();
  PatchLayer patches;
  if (!task.sight.viewport.empty() && !document.layers[task.layer].curves.empty()) {
    Result<PatchLayer> frame = solve_frame(context, task, stats, counts);
    if (!frame) return frame.status();
    patches = std::move(*frame);
  }
  if (Status status = hold(context, patches); !status) return status;
  layer = {task.sight, std::nullopt, std::move(patches), std::nullopt, true};
  return ok_status();
}

/// Layers for whose films there is no memory are solved as by solve().
Status Solution::State::solve_films(Context& context, const Box& viewport, DiffuseStats* stats,
                                    FrameLayers& counts) {
  Result<std::vector<solve::LayerTask>> to_solve = tasks(context, viewport, SolveGoal::next);
  if (!to_solve) return to_solve.status();
  const FrameLayers before = counts;
  counts.kept += layers.size() - to_solve->size();
  Status status = no_throw([&] {
    films.resize(layers.size());
    for (const solve::LayerTask& task : *to_solve) {
      if (&context.budget != budget) break;
      if (Status one = solve_film(context, task, stats, counts); !one) return one;
    }
    return ok_status();
  });
  if (status && &context.budget == budget) return status;
  if (!status && !is_lack_of_memory(status)) return status;
  films.clear();
  counts = before;
  counts.kept += layers.size() - to_solve->size();
  counts.begun += to_solve->size();
  return run_with_all_memory(
      [&](bool) { return solve_layers(context, viewport, SolveGoal::next, stats, false); });
}

}  // namespace sfumato
