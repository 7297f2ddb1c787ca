#include "sfumato/solve/solution.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "curves/response.hpp"
#include "solve/color_drag.hpp"
#include "solve/dragged_curve.hpp"
#include "solve/layer_rows.hpp"
#include "solve/layer_runs.hpp"

namespace sfumato {
namespace {

using solve::LayerSight;
using solve::LayerTask;
using Drag = solve::DraggedCurve;

constexpr std::string_view kPurpose = "the solution of a document";

/// What is known of one of the document's layers.
struct LayerState {
  LayerSight sight{};                            ///< that its patches were solved for
  std::optional<std::uint32_t> in_picture{};     ///< the picture's layer that has them
  std::optional<PatchLayer> fresh{};             ///< or they, where no picture has them yet
  std::optional<solve::RefinedLayer> refined{};  ///< for drags, if memory allows

  bool is_solved() const { return in_picture || fresh; }
};

/// The layer that a change to a curve touches; none of other changes.
std::optional<std::uint32_t> layer_of(const Change& change) {
  if (const auto* replace = std::get_if<ReplaceCurve>(&change)) return replace->layer;
  if (const auto* insert = std::get_if<InsertCurve>(&change)) return insert->layer;
  if (const auto* remove = std::get_if<RemoveCurve>(&change)) return remove->layer;
  return {};
}

}  // namespace

struct Solution::State {
  State(Context& context, Document d)
      : document(std::move(d)),
        document_bytes(bytes_of(document)),
        layers(document.layers.size()),
        budget(&context.budget),
        held(context.budget) {}

  /// Comes first: charges the document.
  Status start(const Context& context) { return hold(context, document); }
  Result<Change> apply(Context& context, Change change);
  Status solve(Context& context, const DiffuseOptions& wanted, DiffuseStats* stats);
  Status begin_drag(Context& context, std::uint32_t layer, std::uint32_t curve);
  Status drag_to(Context& context, Curve curve, DiffuseStats* stats);
  Status begin_color(Context& context, const StopPlace& place);
  Status color_to(Context& context, const StopValue& value);
  void end_drag() {
    drag.reset();
    coloring.reset();
  }

  Document document;
  std::size_t document_bytes;  ///< bytes_of(document)
  Picture picture;
  PictureDelta delta;
  std::optional<Drag> drag;  ///< there is at most one of this and `coloring`
  std::optional<solve::ColorDrag> coloring;
  bool expects_drags = false;  ///< solve() keeps what they begin from

 private:
  /// At the end of its scope no more is charged than is held. While it lives, what was charged for
  /// something that then failed may still be.
  class SpareRelease {
   public:
    explicit SpareRelease(State& state) : state_(state) {}
    ~SpareRelease() { state_.release_spare(); }
    SpareRelease(const SpareRelease&) = delete;
    SpareRelease& operator=(const SpareRelease&) = delete;

   private:
    State& state_;
  };

  void follow(const Change& inverse, std::vector<LayerState> next);
  void carry_over(const Document& old, std::vector<LayerState> next);
  std::optional<std::size_t> find_same(const Document& old, std::size_t index) const;
  void forget(const DiffuseOptions& wanted);
  bool drop_refined();
  template <class Work>
  Status run_with_all_memory(const Work& work, bool keeps = false);
  Status solve_layers(Context& context, const Box& viewport, DiffuseStats* stats, bool keeps);
  Status begin_engine(Context& context, Drag& begun);
  Status begin_roomy(Context& context);
  Status make_frame(Context& context, const Curve& curve, DiffuseStats* stats,
                    solve::FramePatches& patches, const solve::LayerDrag*& maker);
  Status show_frame(const Context& context, const solve::LayerDrag* maker,
                    solve::FramePatches frame);
  Result<std::vector<LayerTask>> tasks(const Context& context, const Box& viewport) const;
  Status keep(const Context& context, std::span<LayerTask> tasks, solve::LayerRuns& runs);
  Status assemble(Context& context, const Box& viewport);
  PictureDelta delta_with_news() const;
  Status make_room(const Context& context, const InsertCurve& insert);
  Status show(Context& context, Curve curve, DiffuseStats* stats);
  std::size_t bytes() const;
  void count_bytes(const Change& inverse);

  /// Charges what is about to be held.
  template <class Thing>
  Status hold(const Context& context, const Thing& thing) {
    return hold_more(context, thing, 0);
  }

  /// The same where `known` bytes of it are charged already.
  template <class Thing>
  Status hold_more(const Context& context, const Thing& thing, std::size_t known) {
    const std::size_t before = std::min(bytes_of(thing), known);
    Status status = run_with_all_memory(
        [&](bool) { return held.add(context, bytes_of(thing) - before, kPurpose); });
    if (status) charged += bytes_of(thing) - before;
    return status;
  }

  void release_spare() {
    const std::size_t spare = charged - std::min(charged, bytes());
    held.release(spare);
    charged -= spare;
  }

  std::vector<LayerState> layers;
  std::optional<DiffuseOptions> options;  ///< that the layers were solved with
  bool frame_changed = true;              ///< since the picture was made
  const Budget* budget;                   ///< of `held`, and of what is kept for drags
  ScopedCharge held;
  std::size_t charged = 0;

  friend class Solution;
};

std::size_t Solution::State::bytes() const {
  std::size_t bytes = document_bytes + bytes_of(picture);
  for (const LayerState& layer : layers) bytes += layer.fresh ? bytes_of(*layer.fresh) : 0;
  for (const LayerRows& rows : delta.rows) bytes += bytes_of(rows);
  if (drag) bytes += bytes_of(drag->spare.layer);
  return bytes;
}

/// After a change with this inverse.
void Solution::State::count_bytes(const Change& inverse) {
  if (const auto* replaced = std::get_if<ReplaceCurve>(&inverse)) {
    document_bytes += bytes_of(document.layers[replaced->layer].curves[replaced->curve]);
    document_bytes -= bytes_of(replaced->value);
  } else {
    document_bytes = bytes_of(document);
  }
}

/// Whatever may fail comes before the state of the layers follows.
Result<Change> Solution::State::apply(Context& context, Change change) {
  const SpareRelease release(*this);
  if (Status status = hold(context, change); !status) return status;
  if (const auto* insert = std::get_if<InsertCurve>(&change)) {
    if (Status status = make_room(context, *insert); !status) return status;
  }
  std::vector<LayerState> next;
  if (const auto* whole = std::get_if<ReplaceDocument>(&change)) {
    next.resize(whole->value.layers.size());
  }
  Result<Change> inverse = apply_change(context, document, std::move(change));
  if (inverse) count_bytes(*inverse);
  if (inverse) follow(*inverse, std::move(next));
  return inverse;
}

/// For a curve that is inserted, if the layer is there: the list of curves does not grow
/// afterwards.
Status Solution::State::make_room(const Context& context, const InsertCurve& insert) {
  if (insert.layer >= document.layers.size()) return ok_status();
  std::vector<Curve>& curves = document.layers[insert.layer].curves;
  if (curves.size() < curves.capacity()) return ok_status();
  std::vector<Curve> larger;
  larger.reserve(std::max<std::size_t>(4, 2 * curves.size()));
  Status status = run_with_all_memory(
      [&](bool) { return held.add(context, capacity_bytes(larger), kPurpose); });
  if (!status) return status;
  charged += capacity_bytes(larger);
  std::ranges::move(curves, std::back_inserter(larger));
  curves = std::move(larger);
  document_bytes = bytes_of(document);
  return status;
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

/// Layers whose curves are the same in the new document stay solved.
void Solution::State::carry_over(const Document& old, std::vector<LayerState> next) {
  frame_changed = true;
  const bool is_alike =
      old.interpolation == document.interpolation && old.artboard == document.artboard;
  for (std::size_t i = 0; is_alike && i < next.size(); ++i) {
    if (const auto same = find_same(old, i)) next[i] = std::exchange(layers[*same], {});
  }
  layers = std::move(next);
}

/// Among the layers that are solved: at the same place from the front, from the back, or with the
/// same id.
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

Result<std::vector<LayerTask>> Solution::State::tasks(const Context& context,
                                                      const Box& viewport) const {
  Result<std::vector<LayerSight>> sights = solve::sights_of_layers(context, document, viewport);
  if (!sights) return sights.status();
  std::vector<LayerTask> tasks;
  for (std::uint32_t i = 0; i < layers.size(); ++i) {
    LayerSight& sight = (*sights)[i];
    if (layers[i].is_solved() && layers[i].sight == sight) continue;
    tasks.push_back({i, std::move(sight)});
  }
  return tasks;
}

Status Solution::State::solve(Context& context, const DiffuseOptions& wanted, DiffuseStats* stats) {
  const SpareRelease release(*this);
  coloring.reset();
  if (Status status = solve::validate(wanted); !status) return status;
  if (Status status = validate(context, document); !status) return status;
  if (!options || !(*options == wanted)) {
    drag.reset();
    forget(wanted);
  }
  const Box viewport = wanted.viewport.value_or(document.artboard);
  const auto run = [&](bool keeps) { return solve_layers(context, viewport, stats, keeps); };
  Status status = run_with_all_memory(run, expects_drags && &context.budget == budget);
  const bool is_shown = std::ranges::all_of(
      layers, [](const LayerState& layer) { return layer.in_picture.has_value(); });
  if (!status || (is_shown && !frame_changed)) return status;
  return run_with_all_memory([&](bool) { return assemble(context, viewport); });
}

/// Those that are not solved, and keeps what was finished; with `keeps` also what drags begin from.
Status Solution::State::solve_layers(Context& context, const Box& viewport, DiffuseStats* stats,
                                     bool keeps) {
  Result<std::vector<LayerTask>> to_solve = tasks(context, viewport);
  if (!to_solve || to_solve->empty()) return to_solve.status();
  for (const LayerTask& task : *to_solve) layers[task.layer].refined.reset();
  solve::LayerRuns runs(context, document, *to_solve, *options, keeps);
  Status status = runs.run();
  if (stats) runs.add_to(*stats);
  Status kept = keep(context, *to_solve, runs);
  return status ? kept : status;
}

/// What is kept for drags, or for their next frames. Returns whether there was any.
bool Solution::State::drop_refined() {
  bool any = false;
  for (auto Drag::*engine : {&Drag::engine, &Drag::roomy})
    if (drag && (*drag).*engine) any |= ((*drag).*engine)->forget_frame();
  for (LayerState& layer : layers) {
    any |= layer.refined.has_value();
    layer.refined.reset();
  }
  return any;
}

/// work(keeps), and once more without what is kept for drags if it lacks memory.
template <class Work>
Status Solution::State::run_with_all_memory(const Work& work, bool keeps) {
  Status status = no_throw([&] { return work(keeps); });
  if (!is_lack_of_memory(status) || !(drop_refined() || keeps)) return status;
  return no_throw([&] { return work(false); });
}

/// Nothing that was solved with other options counts.
void Solution::State::forget(const DiffuseOptions& wanted) {
  for (LayerState& layer : layers) layer = {};
  frame_changed = true;
  options = wanted;
  release_spare();
}

/// What was finished, although other layers may have failed.
Status Solution::State::keep(const Context& context, std::span<LayerTask> tasks,
                             solve::LayerRuns& runs) {
  for (std::uint32_t i = 0; i < tasks.size(); ++i) {
    std::optional<PatchLayer> layer = runs.take_finished(i);
    if (!layer) continue;
    if (Status status = hold(context, *layer); !status) return status;
    layers[tasks[i].layer] = {std::move(tasks[i].sight), std::nullopt, std::move(layer),
                              runs.take_refined(i)};
  }
  return ok_status();
}

/// The delta as it will be once the picture has the layers that are fresh.
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

/// All that may fail comes first: the last picture stays whole until the next one is.
Status Solution::State::assemble(Context& context, const Box& viewport) {
  std::optional<Picture> frame;
  if (frame_changed) {
    Result<Picture> made = picture_frame(context, document, viewport);
    if (!made) return made.status();
    if (Status status = hold(context, *made); !status) return status;
    frame.emplace(std::move(*made));
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

Status Solution::State::begin_drag(Context& context, std::uint32_t layer, std::uint32_t curve) {
  end_drag();
  expects_drags = true;
  if (layer >= layers.size() || curve >= document.layers[layer].curves.size()) {
    return make_error(StatusCode::bad_input, "there is no such curve to drag");
  }
  LayerState& state = layers[layer];
  if (!options || !state.in_picture || frame_changed) {
    return make_error(StatusCode::bad_input, "the document is to be solved before a drag");
  }
  Drag begun{layer, curve, &context.budget};
  if (!state.sight.views.empty()) {
    Status status = run_with_all_memory([&](bool) { return begin_engine(context, begun); });
    if (!status) return status;
  }
  drag.emplace(std::move(begun));
  return ok_status();
}

Status Solution::State::begin_engine(Context& context, Drag& begun) {
  LayerState& layer = layers[begun.layer];
  std::optional<solve::RefinedLayer> none;
  const bool is_at_home = &context.budget == budget;
  Result<solve::LayerDrag> engine =
      solve::LayerDrag::begin(context, document, begun.layer, begun.curve, layer.sight, *options,
                              is_at_home ? layer.refined : none);
  if (engine) begun.engine.emplace(std::move(*engine));
  return engine.status();
}

/// What fails leaves the curve and its layer as they were.
Status Solution::State::drag_to(Context& context, Curve curve, DiffuseStats* stats) {
  if (!drag) return make_error(StatusCode::bad_input, "no curve is dragged");
  const SpareRelease release(*this);
  if (Status status = hold(context, curve); !status) return status;
  const ReplaceCurve change{drag->layer, drag->curve, curve};
  Result<Change> inverse = apply_change(context, document, change);
  if (!inverse) return inverse.status();
  count_bytes(*inverse);
  LayerState& layer = layers[drag->layer];
  layer.refined.reset();
  LayerState before = std::exchange(layer, {});
  if (!drag->engine) return ok_status();
  Status status = no_throw([&] { return show(context, std::move(curve), stats); });
  if (status) return status;
  layer = std::move(before);
  std::swap(document.layers[drag->layer].curves[drag->curve],
            std::get<ReplaceCurve>(*inverse).value);
  count_bytes(*inverse);
  return status;
}

/// maker   out: the engine that made it
Status Solution::State::make_frame(Context& context, const Curve& curve, DiffuseStats* stats,
                                   solve::FramePatches& patches, const solve::LayerDrag*& maker) {
  const auto draw = [&](solve::LayerDrag& engine) {
    maker = &engine;
    return run_with_all_memory([&](bool) {
      solve::FramePatches spare;
      if (drag->spare_by == &engine) spare = std::exchange(drag->spare, {});
      Result<solve::FramePatches> frame =
          engine.frame(context, curve, std::move(spare), {.stats = stats});
      if (frame) patches = std::move(*frame);
      return frame.status();
    });
  };
  Status status = draw(*drag->engine);
  if (status.code != StatusCode::bad_input || !drag->engine->needs_room(curve)) return status;
  if (Status begun = begin_roomy(context); !begun) return begun;
  return drag->roomy ? draw(*drag->roomy) : status;
}

/// For a drag beyond the picture, if that is charged to the same Budget and memory is not lacking.
Status Solution::State::begin_roomy(Context& context) {
  if (drag->roomy || !drag->may_have_room || &context.budget != drag->budget) return ok_status();
  Status status = run_with_all_memory([&](bool) {
    Result<solve::LayerDrag> roomy = drag->engine->with_room(context);
    if (roomy) drag->roomy.emplace(std::move(*roomy));
    return roomy.status();
  });
  drag->may_have_room = !is_lack_of_memory(status);
  return drag->may_have_room ? status : ok_status();
}

/// The picture with the curve that is dragged, which the document has already.
Status Solution::State::show(Context& context, Curve curve, DiffuseStats* stats) {
  const std::size_t spare_bytes = bytes_of(drag->spare.layer);
  solve::FramePatches frame;
  const solve::LayerDrag* maker = nullptr;
  Status status = make_frame(context, curve, stats, frame, maker);
  if (status.code == StatusCode::bad_input) return solve(context, *options, stats);
  if (status) status = hold_more(context, frame.layer, spare_bytes);
  return status ? show_frame(context, maker, std::move(frame)) : status;
}

/// All that may fail comes first.
Status Solution::State::show_frame(const Context& context, const solve::LayerDrag* maker,
                                   solve::FramePatches frame) {
  std::optional<LayerRows> news;
  if (drag->shown && frame.rows && drag->shown_by == maker) {
    // In the news, and twice while the delta takes these up.
    for (int copies = 0; copies < 3; ++copies) {
      Status status = hold(context, *drag->shown);
      if (status) status = hold(context, *frame.rows);
      if (!status) return status;
    }
    news = solve::rows_between(drag->layer, *drag->shown, *frame.rows);
  }
  delta.layers.reserve(delta.layers.size() + 1);
  delta.rows.reserve(delta.rows.size() + 1);
  solve::note_new(drag->layer, std::move(news), delta);
  std::swap(picture.layers[drag->layer], frame.layer);
  drag->spare = {};
  if (drag->shown) drag->spare = {std::move(frame.layer), std::move(drag->shown)};
  drag->spare_by = drag->shown_by;
  drag->shown = std::move(frame.rows);
  drag->shown_by = maker;
  return ok_status();
}

Status Solution::State::begin_color(Context& context, const StopPlace& place) {
  end_drag();
  expects_drags = true;
  if (place.layer >= layers.size() ||
      !curves::has_stop(document.layers[place.layer].curves, place)) {
    return make_error(StatusCode::bad_input, "there is no such stop to be changed");
  }
  LayerState& layer = layers[place.layer];
  if (!options || !layer.is_solved() || frame_changed) {
    return make_error(StatusCode::bad_input,
                      "the document is to be solved before a colour changes");
  }
  const bool is_at_home = &context.budget == budget;
  return run_with_all_memory([&](bool) {
    std::optional<solve::RefinedLayer> none;
    Result<solve::ColorDrag> begun = solve::ColorDrag::begin(
        context, document, place, layer.sight, *options, is_at_home ? layer.refined : none);
    if (begun) coloring.emplace(std::move(*begun));
    return begun.status();
  });
}

/// The first frame brings a layer with tables of its own: that of the solution counts on for as
/// long as the document is the one that was solved.
Status Solution::State::color_to(Context& context, const StopValue& value) {
  if (!coloring) return make_error(StatusCode::bad_input, "no stop is prepared to be changed");
  const SpareRelease release(*this);
  Status status = coloring->prepare(context, value);
  if (status && coloring->new_layer()) status = hold(context, *coloring->new_layer());
  if (!status) return status;
  delta.layers.reserve(delta.layers.size() + 1);
  const StopPlace& place = coloring->place();
  LayerState& layer = layers[place.layer];
  Curve& curve = document.layers[place.layer].curves[place.curve];
  const bool keeps = coloring->keeps(curve);
  std::optional<PatchLayer> solved = coloring->show(curve, picture.layers[place.layer]);
  if (!keeps) {
    layer = {};
  } else if (layer.in_picture && solved) {
    layer.fresh = std::move(solved);
    layer.in_picture.reset();
  }
  solve::note_new(place.layer, {}, delta);
  return status;
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
    if (Status status = validate(context, document); !status) return status;
    auto state = std::make_unique<State>(context, std::move(document));
    if (Status status = state->start(context); !status) return status;
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
  return public_verb(context, [&] { return state_->solve(context, options, stats); });
}

void Solution::expect_drags() {
  state_->expects_drags = true;
}

Status Solution::begin_drag(Context& context, std::uint32_t layer, std::uint32_t curve) {
  return public_verb(context, [&] { return state_->begin_drag(context, layer, curve); });
}

Status Solution::drag(Context& context, Curve curve, DiffuseStats* stats) {
  return public_verb(context, [&] { return state_->drag_to(context, std::move(curve), stats); });
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

PictureDelta Solution::take_delta() {
  return std::exchange(state_->delta, {});
}

}  // namespace sfumato
