#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "base/try.hpp"
#include "sfumato/solve/solution.hpp"
#include "solve/layers/layer_runs.hpp"
#include "solve/session/color_drag.hpp"
#include "solve/session/dragged_curves.hpp"
#include "solve/session/film_layer.hpp"

namespace sfumato {

/// The state of a Solution. solution.cpp solves layers, solution_drag.cpp drags curves and changes
/// colours, and solution_film.cpp makes frames of films.
struct Solution::State {
  /// The kind of solution to compute for layers that are not solved.
  enum class SolveGoal : std::uint8_t { exact, rough, next };

  using Drag = solve::DraggedCurves;

  static constexpr std::string_view kPurpose = "the solution of a document";
  static constexpr std::size_t kAllTriangles = std::numeric_limits<std::size_t>::max();

  /// The state of a layer of the document.
  struct LayerState {
    solve::LayerSight sight{};                     ///< the sight that its patches were solved for
    std::optional<std::uint32_t> in_picture{};     ///< the picture's layer with the patches
    std::optional<PatchLayer> fresh{};             ///< the patches, if no picture has them yet
    std::optional<solve::RefinedLayer> refined{};  ///< tables for drags, if memory allows
    /// Whether the patches show the present curves, but are not the ones that diffuse() makes.
    bool is_rough = false;

    bool is_solved() const { return in_picture || fresh; }
    bool is_exact() const { return is_solved() && !is_rough; }
  };

  /// Returns the state of a layer whose patches in the picture come from a frame.
  static LayerState shown_roughly(solve::LayerSight sight, std::uint32_t layer) {
    return {std::move(sight), layer, std::nullopt, std::nullopt, true};
  }

  State(Context& context, Document d)
      : document(std::move(d)),
        document_bytes(bytes_of(document)),
        layers(document.layers.size()),
        last_drag(document.layers.size()),
        budget(&context.budget),
        held(context.budget) {}

  /// Charges the document. Call first.
  Status start(const Context& context) { return hold(context, document); }
  Result<Change> apply(Context& context, Change change);
  Status solve(Context& context, const DiffuseOptions& wanted, SolveGoal goal, DiffuseStats* stats);
  /// counts   in, out: is added to
  Status solve_next(Context& context, const DiffuseOptions& wanted, FrameLayers& counts,
                    DiffuseStats* stats);
  Status check_is_editable() const;
  Status begin_drag(Context& context, std::uint32_t layer, std::vector<std::uint32_t> curves);
  Status drag_to(Context& context, std::vector<Curve> curves, const solve::FrameTime& time,
                 DiffuseStats* stats);
  Status drag_more(Context& context, const solve::FrameTime& time, DiffuseStats* stats);
  Status begin_color(Context& context, const StopPlace& place);
  Status color_to(Context& context, const StopValue& value);
  Result<ExactLayer> exact_layer(Context& context, std::uint32_t layer) const;
  void end_drag() {
    drag.reset();
    coloring.reset();
  }

  Document document;
  std::size_t document_bytes;  ///< bytes_of(document)
  Picture picture;
  PictureDelta delta;
  std::optional<Drag> drag;  ///< at most one of this and `coloring` exists
  std::optional<solve::ColorDrag> coloring;
  /// solve() keeps the tables that drags start from, for layers of at most this many triangles in
  /// all; none: it keeps no tables.
  std::optional<std::size_t> most_kept{};

 private:
  /// Releases, at the end of its scope, charges for memory that is not held, as after a step that
  /// failed.
  class SpareRelease {
   public:
    explicit SpareRelease(State& state) : state_(state) {}
    ~SpareRelease() { state_.release_spare(); }
    SpareRelease(const SpareRelease&) = delete;
    SpareRelease& operator=(const SpareRelease&) = delete;

   private:
    State& state_;
  };

  Result<Box> prepare(Context& context, const DiffuseOptions& wanted, SolveGoal goal);
  Status show_solved(Context& context, const Box& viewport, Status solved);
  void follow(const Change& inverse, std::vector<LayerState> next);
  void carry_over(const Document& old, std::vector<LayerState> next);
  std::optional<std::size_t> find_same(const Document& old, std::size_t index) const;
  void forget(const DiffuseOptions& wanted);
  const PatchLayer& patches_of(const LayerState& layer) const;
  bool drop_refined();
  template <class Work>
  Status run_with_all_memory(const Work& work, bool keeps = false);
  Status solve_layers(Context& context, const Box& viewport, SolveGoal goal, DiffuseStats* stats,
                      bool keeps);
  Status solve_films(Context& context, const Box& viewport, DiffuseStats* stats,
                     FrameLayers& counts);
  Status solve_film(Context& context, const solve::LayerTask& task, DiffuseStats* stats,
                    FrameLayers& counts);
  Result<PatchLayer> solve_frame(Context& context, const solve::LayerTask& task,
                                 DiffuseStats* stats, FrameLayers& counts);
  Status refine(Context& context, std::uint32_t layer);
  std::uint64_t drag_of(std::uint32_t layer) const;
  void note_drag(std::uint32_t layer);
  void give_up_beyond();
  DiffuseOptions options_of(const LayerState& layer) const;
  Status begin_engine(Context& context, Drag& begun);
  Status begin_roomy(Context& context);
  std::vector<Curve> dragged_curves() const;
  Status replace_dragged(const Context& context, std::vector<Curve>& curves);
  void restore_dragged(std::vector<Curve>& curves, std::size_t count);
  Result<std::optional<solve::FramePatches>> make_frame(Context& context,
                                                        const solve::FramePolicy& how,
                                                        solve::LayerSession*& maker);
  bool wants_rows(const solve::LayerSession* maker) const;
  Status make_room(Context& context, const solve::LayerSession& maker);
  Status show_frame(Context& context, solve::LayerSession* maker, solve::FramePatches frame,
                    const solve::FramePolicy& how);
  Result<std::vector<solve::LayerTask>> tasks(const Context& context, const Box& viewport,
                                              SolveGoal goal) const;
  Status keep(const Context& context, std::span<solve::LayerTask> tasks, SolveGoal goal,
              solve::LayerRuns& runs);
  Status assemble(Context& context, const Box& viewport);
  PictureDelta delta_with_news() const;
  Status make_room(const Context& context, const InsertCurve& insert);
  Status show(Context& context, const solve::FramePolicy& how);
  Status show_more(Context& context, const solve::FramePolicy& how);
  std::size_t bytes() const;
  void count_bytes(const Change& inverse);

  /// Charges an object that the state is about to hold.
  template <class Thing>
  Status hold(const Context& context, const Thing& thing) {
    return hold_more(context, thing, 0);
  }

  /// Charges an object, except for `known` bytes, which are charged already.
  template <class Thing>
  Status hold_more(const Context& context, const Thing& thing, std::size_t known) {
    const std::size_t before = std::min(bytes_of(thing), known);
    SFUMATO_TRY(run_with_all_memory(
        [&](bool) { return held.add(context, bytes_of(thing) - before, kPurpose); }));
    charged += bytes_of(thing) - before;
    return ok_status();
  }

  void release_spare() {
    const std::size_t spare = charged - std::min(charged, bytes());
    held.release(spare);
    charged -= spare;
  }

  std::vector<LayerState> layers;
  std::vector<std::optional<solve::FilmLayer>> films;  ///< per layer, or empty
  std::vector<std::uint64_t> last_drag;                ///< per layer: KeptLayer::last_drag
  std::uint64_t drag_count = 0;
  std::optional<DiffuseOptions> options;  ///< the options that the layers were solved with
  bool frame_changed = true;              ///< since the picture was made
  const Budget* budget;                   ///< of `held`, and of tables kept for drags
  ScopedCharge held;
  std::size_t charged = 0;

  friend class Solution;
};

/// Calls work(keeps). If it lacks memory, releases the tables kept for drags and films, and calls
/// work(false).
template <class Work>
Status Solution::State::run_with_all_memory(const Work& work, bool keeps) {
  Status status = no_throw([&] { return work(keeps); });
  if (!is_lack_of_memory(status) || !(drop_refined() || keeps)) return status;
  return no_throw([&] { return work(false); });
}

}  // namespace sfumato
