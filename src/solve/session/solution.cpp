#include "sfumato/solve/solution.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "solve/layers/kept_layers.hpp"
#include "solve/layers/layer_rows.hpp"
#include "solve/layers/rough.hpp"
#include "solve/points/exact_fields.hpp"
#include "solve/session/solution_state.hpp"

namespace sfumato {
namespace {

using solve::LayerSight;
using solve::LayerTask;

/// Returns the layer whose curve a change edits; none for other changes.
std::optional<std::uint32_t> layer_of(const Change& change) {
  if (const auto* replace = std::get_if<ReplaceCurve>(&change)) return replace->layer;
  if (const auto* insert = std::get_if<InsertCurve>(&change)) return insert->layer;
  if (const auto* remove = std::get_if<RemoveCurve>(&change)) return remove->layer;
  return {};
}

/// Checks the time for a frame; none: no limit.
Status check_seconds(std::optional<double> seconds) {
  if (!seconds || *seconds >= 0) return ok_status();
  return make_error(StatusCode::bad_input, "the time for a frame must be at least 0 seconds");
}

}  // namespace

std::size_t Solution::State::bytes() const {
  std::size_t bytes = document_bytes + bytes_of(picture);
  for (const LayerState& layer : layers) bytes += layer.fresh ? bytes_of(*layer.fresh) : 0;
  for (const LayerRows& rows : delta.rows) bytes += bytes_of(rows);
  return bytes;
}

/// Updates document_bytes after a change with this inverse.
void Solution::State::count_bytes(const Change& inverse) {
  if (const auto* replaced = std::get_if<ReplaceCurve>(&inverse)) {
    document_bytes += bytes_of(document.layers[replaced->layer].curves[replaced->curve]);
    document_bytes -= bytes_of(replaced->value);
  } else {
    document_bytes = bytes_of(document);
  }
}

/// Applies a change. All steps that may fail precede the update of the layers' states.
Result<Change> Solution::State::apply(Context& context, Change change) {
  const SpareRelease release(*this);
  SFUMATO_TRY(hold(context, change));
  if (const auto* insert = std::get_if<InsertCurve>(&change)) {
    SFUMATO_TRY(make_room(context, *insert));
  }
  std::vector<LayerState> next;
  if (const auto* whole = std::get_if<ReplaceDocument>(&change)) {
    next.resize(whole->value.layers.size());
    last_drag.reserve(next.size());
  }
  Result<Change> inverse = apply_change(context, document, std::move(change));
  if (inverse) count_bytes(*inverse);
  if (inverse) follow(*inverse, std::move(next));
  return inverse;
}

/// Reserves room in the list of curves for a curve to be inserted, if the layer exists.
Status Solution::State::make_room(const Context& context, const InsertCurve& insert) {
  if (insert.layer >= document.layers.size()) return ok_status();
  std::vector<Curve>& curves = document.layers[insert.layer].curves;
  if (curves.size() < curves.capacity()) return ok_status();
  std::vector<Curve> larger;
  larger.reserve(std::max<std::size_t>(4, 2 * curves.size()));
  SFUMATO_TRY(run_with_all_memory(
      [&](bool) { return held.add(context, capacity_bytes(larger), kPurpose); }));
  charged += capacity_bytes(larger);
  std::ranges::move(curves, std::back_inserter(larger));
  curves = std::move(larger);
  document_bytes = bytes_of(document);
  return ok_status();
}

void Solution::State::follow(const Change& inverse, std::vector<LayerState> next) {
  if (const auto* whole = std::get_if<ReplaceDocument>(&inverse)) {
    carry_over(whole->value, std::move(next));
  } else if (const std::optional<std::uint32_t> layer = layer_of(inverse)) {
    layers[*layer] = {};
  } else {
    frame_changed = true;
  }
}

/// Updates the layers after a new document. Layers with the same curves stay solved.
void Solution::State::carry_over(const Document& old, std::vector<LayerState> next) {
  frame_changed = true;
  const bool is_alike =
      old.interpolation == document.interpolation && old.artboard == document.artboard;
  for (std::size_t i = 0; is_alike && i < next.size(); ++i) {
    if (const auto same = find_same(old, i)) next[i] = std::exchange(layers[*same], {});
  }
  if (next.size() != layers.size()) films.clear();
  layers = std::move(next);
  // By index: if layers were added or removed, tables of other layers may be kept until the next
  // drag.
  last_drag.resize(layers.size());
}

/// Returns a solved layer of the old document with the same curves: at the same index from the
/// front or from the back, or with the same id.
std::optional<std::size_t> Solution::State::find_same(const Document& old,
                                                      std::size_t index) const {
  const Layer& layer = document.layers[index];
  const auto is_same = [&](std::size_t i) {
    return i < old.layers.size() && layers[i].is_solved() && old.layers[i].curves == layer.curves;
  };
  const std::size_t from_back = index + old.layers.size() - document.layers.size();
  if (is_same(index)) return index;
  if (is_same(from_back)) return from_back;
  const auto named = std::ranges::find(old.layers, layer.id, &Layer::id);
  const auto i = static_cast<std::size_t>(named - old.layers.begin());
  return is_same(i) ? std::optional(i) : std::nullopt;
}

Result<std::vector<LayerTask>> Solution::State::tasks(const Context& context, const Box& viewport,
                                                      SolveGoal goal) const {
  SFUMATO_TRY_ASSIGN(auto&& sights, solve::sights_of_layers(context, document, viewport));
  std::vector<LayerTask> tasks;
  for (std::uint32_t i = 0; i < layers.size(); ++i) {
    LayerSight& sight = sights[i];
    const bool is_done = goal == SolveGoal::exact ? layers[i].is_exact() : layers[i].is_solved();
    if (is_done && layers[i].sight == sight) continue;
    tasks.push_back({i, std::move(sight), drag_of(i)});
  }
  return tasks;
}

/// Checks the options and the document, and forgets what other options made. Returns the viewport.
Result<Box> Solution::State::prepare(Context& context, const DiffuseOptions& wanted,
                                     SolveGoal goal) {
  coloring.reset();
  if (wanted.pixel_grid && goal != SolveGoal::exact) {
    return make_error(StatusCode::bad_input,
                      "pixel_grid works with neither films nor rough pictures; solve without "
                      "pixel_grid");
  }
  SFUMATO_TRY(solve::validate(wanted));
  SFUMATO_TRY(validate(context, document));
  if (!options || !(*options == wanted)) {
    drag.reset();
    forget(wanted);
  }
  return wanted.viewport.value_or(document.artboard);
}

/// Puts the solved layers into the picture, unless `solved` is an error or the picture has them.
Status Solution::State::show_solved(Context& context, const Box& viewport, Status solved) {
  const bool is_shown = std::ranges::all_of(
      layers, [](const LayerState& layer) { return layer.in_picture.has_value(); });
  if (!solved || (is_shown && !frame_changed)) return solved;
  return run_with_all_memory([&](bool) { return assemble(context, viewport); });
}

Status Solution::State::solve(Context& context, const DiffuseOptions& wanted, SolveGoal goal,
                              DiffuseStats* stats) {
  const SpareRelease release(*this);
  SFUMATO_TRY_ASSIGN(const Box viewport, prepare(context, wanted, goal));
  const auto run = [&](bool keeps) { return solve_layers(context, viewport, goal, stats, keeps); };
  const bool keeps =
      goal == SolveGoal::exact && !wanted.pixel_grid && most_kept && &context.budget == budget;
  return show_solved(context, viewport, run_with_all_memory(run, keeps));
}

/// Solves the layers that are not solved, and keeps the finished ones. With `keeps`, also keeps the
/// tables that drags start from.
Status Solution::State::solve_layers(Context& context, const Box& viewport, SolveGoal goal,
                                     DiffuseStats* stats, bool keeps) {
  Result<std::vector<LayerTask>> to_solve = tasks(context, viewport, goal);
  if (!to_solve || to_solve->empty()) return to_solve.status();
  for (const LayerTask& task : *to_solve) layers[task.layer].refined.reset();
  const DiffuseOptions how = goal == SolveGoal::rough ? solve::roughly(*options) : *options;
  solve::LayerRuns runs(context, document, *to_solve, how, keeps ? most_kept : std::nullopt);
  Status status = runs.run();
  if (stats) runs.add_to(*stats);
  Status kept = keep(context, *to_solve, goal, runs);
  give_up_beyond();
  return status ? kept : status;
}

/// Returns the patches of a solved layer.
const PatchLayer& Solution::State::patches_of(const LayerState& layer) const {
  return layer.fresh ? *layer.fresh : picture.layers[*layer.in_picture];
}

/// Solves an exact layer of the picture again, for the tables that drags start from.
Status Solution::State::refine(Context& context, std::uint32_t layer) {
  const solve::LayerTask task{layer, layers[layer].sight, last_drag[layer]};
  const auto run = [&](bool keeps) {
    if (!keeps) return ok_status();
    solve::LayerRuns runs(context, document, {&task, 1}, *options, most_kept);
    SFUMATO_TRY(runs.run());
    layers[layer].refined = runs.take_refined(0);
    return ok_status();
  };
  Status status = run_with_all_memory(run, true);
  give_up_beyond();
  return status;
}

/// Returns the number of the layer's last drag. A single layer counts as dragged.
std::uint64_t Solution::State::drag_of(std::uint32_t layer) const {
  const std::uint64_t least = layers.size() == 1 ? 1 : 0;
  return std::max(last_drag[layer], least);
}

void Solution::State::note_drag(std::uint32_t layer) {
  if (!most_kept) most_kept = kAllTriangles;
  last_drag[layer] = ++drag_count;
}

/// Releases the tables kept for drags, of the layers beyond `most_kept`.
void Solution::State::give_up_beyond() {
  std::vector<solve::KeptLayer> kept;
  for (std::uint32_t i = 0; i < layers.size(); ++i) {
    const LayerState& layer = layers[i];
    if (!layer.refined) continue;
    kept.push_back({i, drag_of(i), patches_of(layer).triangle_count()});
  }
  const std::size_t most = most_kept.value_or(kAllTriangles);
  for (const std::uint32_t i : solve::layers_beyond(std::move(kept), most))
    layers[i].refined.reset();
}

/// Releases the tables kept for drags or next frames. Returns whether there were any.
bool Solution::State::drop_refined() {
  bool any = drag && drag->forget_frames();
  for (std::optional<solve::FilmLayer>& film : films) {
    any |= film.has_value();
    film.reset();
  }
  for (LayerState& layer : layers) {
    any |= layer.refined.has_value();
    layer.refined.reset();
  }
  return any;
}

/// Forgets the layers that were solved with other options.
void Solution::State::forget(const DiffuseOptions& wanted) {
  for (LayerState& layer : layers) layer = {};
  films.clear();
  frame_changed = true;
  options = wanted;
  release_spare();
}

/// Keeps the finished layers, although others may have failed.
Status Solution::State::keep(const Context& context, std::span<LayerTask> tasks, SolveGoal goal,
                             solve::LayerRuns& runs) {
  for (std::uint32_t i = 0; i < tasks.size(); ++i) {
    std::optional<PatchLayer> layer = runs.take_finished(i);
    if (!layer) continue;
    SFUMATO_TRY(hold(context, *layer));
    layers[tasks[i].layer] = {std::move(tasks[i].sight), std::nullopt, std::move(layer),
                              runs.take_refined(i), goal == SolveGoal::rough};
  }
  return ok_status();
}

/// Returns the delta for a picture with the fresh layers.
PictureDelta Solution::State::delta_with_news() const {
  PictureDelta result{delta.frame || frame_changed, {}, delta.rows};
  std::erase_if(result.rows, [&](const LayerRows& rows) {
    return rows.layer >= layers.size() || layers[rows.layer].in_picture != rows.layer;
  });
  auto known = delta.layers.begin();
  for (std::uint32_t i = 0; i < layers.size(); ++i) {
    const bool is_known = known != delta.layers.end() && *known == i;
    if (is_known) ++known;
    if (is_known || layers[i].in_picture != i) result.layers.push_back(i);
  }
  return result;
}

/// Puts the layers into the picture. All steps that may fail come first, so that the last picture
/// stays complete.
Status Solution::State::assemble(Context& context, const Box& viewport) {
  std::optional<Picture> frame;
  if (frame_changed) {
    SFUMATO_TRY_ASSIGN(auto&& made, picture_frame(context, document, viewport));
    made.for_pixel_grid = solve::is_for_pixel_grid(*options);
    SFUMATO_TRY(hold(context, made));
    frame.emplace(std::move(made));
  }
  std::vector<PatchLayer> patches(layers.size());
  PictureDelta news = delta_with_news();
  if (drag && layers[drag->layer].fresh) drag->forget_shown();
  for (std::uint32_t i = 0; i < layers.size(); ++i) {
    LayerState& layer = layers[i];
    patches[i] = std::move(layer.fresh ? *layer.fresh : picture.layers[*layer.in_picture]);
    layer.fresh.reset();
    layer.in_picture = i;
  }
  if (frame) picture = std::move(*frame);
  picture.layers = std::move(patches);
  delta = std::move(news);
  frame_changed = false;
  return ok_status();
}

Result<ExactLayer> Solution::State::exact_layer(Context& context, std::uint32_t layer) const {
  if (layer >= layers.size() || !layers[layer].is_solved())
    return make_error(StatusCode::bad_input, "there is no such layer that is solved");
  if (patches_of(layers[layer]).triangle_count() == 0) return ExactLayer{};
  TableMemory memory("exact fields");
  return solve::exact_layer(context, document, layer, layers[layer].sight, *options, memory);
}

Solution& Solution::operator=(Solution&& other) noexcept {
  std::swap(state_, other.state_);
  return *this;
}

Solution::~Solution() {
  delete state_;
}

Result<Solution> Solution::create(Context& context, Document document) {
  return public_verb(context, [&]() -> Result<Solution> {
    SFUMATO_TRY(validate(context, document));
    auto state = std::make_unique<State>(context, std::move(document));
    SFUMATO_TRY(state->start(context));
    return Solution(state.release());
  });
}

const Document& Solution::document() const {
  return state_->document;
}

Result<Change> Solution::apply(Context& context, Change change) {
  return public_verb(context, [&] {
    Result<Change> inverse = state_->apply(context, std::move(change));
    if (inverse) state_->end_drag();
    return inverse;
  });
}

Status Solution::solve(Context& context, const DiffuseOptions& options, DiffuseStats* stats) {
  return public_verb(
      context, [&] { return state_->solve(context, options, State::SolveGoal::exact, stats); });
}

Status Solution::solve_roughly(Context& context, const DiffuseOptions& options,
                               DiffuseStats* stats) {
  return public_verb(
      context, [&] { return state_->solve(context, options, State::SolveGoal::rough, stats); });
}

Status Solution::solve_next(Context& context, const DiffuseOptions& options, FrameLayers* layers,
                            DiffuseStats* stats) {
  return public_verb(context, [&] {
    FrameLayers uncounted;
    return state_->solve_next(context, options, layers ? *layers : uncounted, stats);
  });
}

void Solution::expect_drags(std::size_t most_triangles) {
  state_->most_kept = most_triangles;
}

Status Solution::begin_drag(Context& context, std::uint32_t layer,
                            std::vector<std::uint32_t> curves) {
  return public_verb(context,
                     [&] { return state_->begin_drag(context, layer, std::move(curves)); });
}

Status Solution::drag(Context& context, std::vector<Curve> curves, DiffuseStats* stats,
                      std::optional<double> seconds) {
  const solve::FrameTime time(seconds);
  return public_verb(context, [&] {
    Status status = check_seconds(seconds);
    return status ? state_->drag_to(context, std::move(curves), time, stats) : status;
  });
}

Status Solution::drag_more(Context& context, DiffuseStats* stats, std::optional<double> seconds) {
  const solve::FrameTime time(seconds);
  return public_verb(context, [&] {
    Status status = check_seconds(seconds);
    return status ? state_->drag_more(context, time, stats) : status;
  });
}

std::size_t Solution::waiting_nodes() const {
  return state_->drag ? state_->drag->left : 0;
}

Status Solution::begin_color(Context& context, const StopPlace& place) {
  return public_verb(context, [&] { return state_->begin_color(context, place); });
}

Status Solution::color(Context& context, const StopValue& value) {
  return public_verb(context, [&] { return state_->color_to(context, value); });
}

std::span<const float> Solution::color_response() const {
  return state_->coloring ? state_->coloring->factor() : std::span<const float>();
}

void Solution::end_drag() {
  state_->end_drag();
}

const Picture& Solution::picture() const {
  return state_->picture;
}

Result<ExactLayer> Solution::exact_layer(Context& context, std::uint32_t layer) const {
  return public_verb(context, [&] { return state_->exact_layer(context, layer); });
}

PictureDelta Solution::take_delta() {
  return std::exchange(state_->delta, {});
}

}  // namespace sfumato
