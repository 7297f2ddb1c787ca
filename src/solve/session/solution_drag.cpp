#include <algorithm>
#include <utility>

#include "base/try.hpp"
#include "curves/response.hpp"
#include "solve/layers/layer_rows.hpp"
#include "solve/layers/rough.hpp"
#include "solve/session/solution_state.hpp"

/// The part of Solution that drags curves and changes colours.
namespace sfumato {
namespace {

Status no_curve() {
  return make_error(StatusCode::bad_input, "no curve is dragged");
}

}  // namespace

/// Checks that the picture is not for a pixel grid: such a picture keeps no tables for drags.
Status Solution::State::check_is_editable() const {
  if (!options->pixel_grid) return ok_status();
  return make_error(StatusCode::bad_input,
                    "a picture for a pixel grid cannot be dragged; solve without pixel_grid");
}

Status Solution::State::begin_drag(Context& context, std::uint32_t layer,
                                   std::vector<std::uint32_t> curves) {
  end_drag();
  std::ranges::sort(curves);
  const bool are_known = layer < layers.size() && !curves.empty() &&
                         curves.back() < document.layers[layer].curves.size() &&
                         std::ranges::adjacent_find(curves) == curves.end();
  if (!are_known) return make_error(StatusCode::bad_input, "there are no such curves to drag");
  LayerState& state = layers[layer];
  if (!options || !state.in_picture || frame_changed) {
    return make_error(StatusCode::bad_input, "the document is to be solved before a drag");
  }
  SFUMATO_TRY(check_is_editable());
  note_drag(layer);
  Drag begun{layer, std::move(curves), &context.budget};
  if (!state.sight.views.empty()) {
    SFUMATO_TRY(run_with_all_memory([&](bool) { return begin_engine(context, begun); }));
  }
  drag.emplace(std::move(begun));
  if (drag->engine) drag->shown = drag->engine->take_rows_of_solved();
  if (drag->engine) drag->shown_by = &*drag->engine;
  return ok_status();
}

Status Solution::State::begin_engine(Context& context, Drag& begun) {
  LayerState& layer = layers[begun.layer];
  std::optional<solve::RefinedLayer> none;
  const bool is_at_home = &context.budget == budget;
  if (is_at_home && !layer.refined && layer.is_exact()) {
    SFUMATO_TRY(refine(context, begun.layer));
  }
  const bool is_known = is_at_home && layer.refined;
  bool is_costly = false;
  if (is_known) {
    SFUMATO_TRY_ASSIGN(is_costly,
                       solve::LayerSession::is_costly(context, *layer.refined, begun.curves));
  }
  SFUMATO_TRY_ASSIGN(auto&& engine,
                     solve::LayerSession::open(
                         context,
                         solve::input_of(document, begun.layer, layer.sight,
                                         is_costly ? solve::roughly(*options) : options_of(layer)),
                         begun.curves, is_known && !is_costly ? layer.refined : none));
  begun.engine.emplace(std::move(engine));
  return ok_status();
}

/// Returns the options with which the layer was solved.
DiffuseOptions Solution::State::options_of(const LayerState& layer) const {
  return layer.is_rough ? solve::roughly(*options) : *options;
}

/// Returns the dragged curves as they are now.
std::vector<Curve> Solution::State::dragged_curves() const {
  std::vector<Curve> curves;
  curves.reserve(drag->curves.size());
  for (const std::uint32_t curve : drag->curves)
    curves.push_back(document.layers[drag->layer].curves[curve]);
  return curves;
}

/// Replaces the dragged curves, and makes a frame. Errors leave the curves and their layer
/// unchanged.
Status Solution::State::drag_to(Context& context, std::vector<Curve> curves,
                                const solve::FrameTime& time, DiffuseStats* stats) {
  if (!drag) return no_curve();
  if (curves.size() != drag->curves.size()) {
    return make_error(StatusCode::bad_input, "pass as many curves as are dragged");
  }
  const SpareRelease release(*this);
  for (const Curve& curve : curves) SFUMATO_TRY(hold(context, curve));
  SFUMATO_TRY(replace_dragged(context, curves));
  LayerState& layer = layers[drag->layer];
  layer.refined.reset();
  LayerState before = std::exchange(layer, {});
  Status status;
  if (drag->engine) {
    status = no_throw([&] { return show(context, {.time = time, .stats = stats}); });
  }
  if (status) {
    if (!layer.is_solved()) layer = shown_roughly(std::move(before.sight), drag->layer);
    return status;
  }
  drag->forget_frames();  // one of them may have the new curves
  layer = std::move(before);
  restore_dragged(curves, curves.size());
  return status;
}

/// Exchanges the dragged curves with these. Errors: as apply_change(); they leave the document
/// unchanged.
Status Solution::State::replace_dragged(const Context& context, std::vector<Curve>& curves) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    Result<Change> inverse = apply_change(
        context, document, ReplaceCurve{drag->layer, drag->curves[i], std::move(curves[i])});
    if (!inverse) {
      restore_dragged(curves, i);
      return inverse.status();
    }
    count_bytes(*inverse);
    curves[i] = std::move(std::get<ReplaceCurve>(*inverse).value);
  }
  return ok_status();
}

/// Puts the first `count` curves back that replace_dragged() took out.
void Solution::State::restore_dragged(std::vector<Curve>& curves, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    Curve& curve = document.layers[drag->layer].curves[drag->curves[i]];
    document_bytes += bytes_of(curves[i]) - bytes_of(curve);
    std::swap(curve, curves[i]);
  }
}

/// Gathers nodes that the last frame left.
Status Solution::State::drag_more(Context& context, const solve::FrameTime& time,
                                  DiffuseStats* stats) {
  if (!drag) return no_curve();
  if (drag->left == 0) return ok_status();
  const SpareRelease release(*this);
  return no_throw([&] { return show_more(context, {.time = time, .stats = stats}); });
}

/// Continues the last frame. Makes it again if its tables were released.
Status Solution::State::show_more(Context& context, const solve::FramePolicy& how) {
  solve::LayerSession* const maker = drag->shown_by;
  if (!maker->can_go_on(context)) return show(context, how);
  solve::FramePolicy more = how;
  more.wants_rows = wants_rows(maker);
  Result<solve::FramePatches> frame = maker->go_on(context, more);
  if (!frame && is_lack_of_memory(frame.status())) return show(context, how);
  return frame ? show_frame(context, maker, std::move(*frame), how) : frame.status();
}

/// Returns whether the picture's layer can be updated to an engine's next frame row by row.
bool Solution::State::wants_rows(const solve::LayerSession* maker) const {
  return drag->shown && drag->shown_by == maker;
}

/// Makes a frame of the dragged curves. Returns none if no engine can take them.
/// maker   out: the engine that made the frame
Result<std::optional<solve::FramePatches>> Solution::State::make_frame(
    Context& context, const solve::FramePolicy& how, solve::LayerSession*& maker) {
  const std::vector<Curve> curves = dragged_curves();
  std::optional<solve::FramePatches> patches;
  const auto draw = [&](solve::LayerSession& engine) {
    maker = &engine;
    solve::FramePolicy one = how;
    one.wants_rows = wants_rows(&engine);
    return run_with_all_memory([&](bool) {
      SFUMATO_TRY_ASSIGN(patches, engine.frame(context, curves, one));
      return ok_status();
    });
  };
  SFUMATO_TRY(draw(*drag->engine));
  if (patches || !drag->engine->needs_room(curves)) return patches;
  SFUMATO_TRY(begin_roomy(context));
  if (drag->roomy) SFUMATO_TRY(draw(*drag->roomy));
  return patches;
}

/// Begins the engine with room beyond the picture, if this Context has the drag's Budget and memory
/// suffices.
Status Solution::State::begin_roomy(Context& context) {
  if (drag->roomy || !drag->may_have_room || &context.budget != drag->budget) return ok_status();
  Status status = run_with_all_memory([&](bool) {
    Result<solve::LayerSession> roomy = drag->engine->with_room(context);
    if (roomy) drag->roomy.emplace(std::move(*roomy));
    return roomy.status();
  });
  drag->may_have_room = !is_lack_of_memory(status);
  return drag->may_have_room ? status : ok_status();
}

/// Shows the dragged curves in the picture. The document already has them.
Status Solution::State::show(Context& context, const solve::FramePolicy& how) {
  solve::LayerSession* maker = nullptr;
  SFUMATO_TRY_ASSIGN(auto&& frame, make_frame(context, how, maker));
  if (!frame) return solve(context, *options, SolveGoal::rough, how.stats);
  return show_frame(context, maker, std::move(*frame), how);
}

/// Reserves room in the picture's layer for the last frame of `maker`, unless that was released.
Status Solution::State::make_room(Context& context, const solve::LayerSession& maker) {
  PatchLayer& layer = picture.layers[drag->layer];
  const std::size_t known = bytes_of(layer);
  Status status = run_with_all_memory([&](bool) {
    return maker.can_go_on(context) ? maker.make_room(context, layer) : ok_status();
  });
  return status ? hold_more(context, layer, known) : status;
}

/// Puts a frame into the picture. All steps that may fail come first. Makes the frame again if its
/// tables were released meanwhile.
Status Solution::State::show_frame(Context& context, solve::LayerSession* maker,
                                   solve::FramePatches frame, const solve::FramePolicy& how) {
  SFUMATO_TRY(hold(context, frame.layer));
  if (!frame.is_whole) SFUMATO_TRY(make_room(context, *maker));
  std::optional<LayerRows> news;
  if (drag->shown && frame.rows && drag->shown_by == maker) {
    // One copy is for `news`, and two for the delta while it is updated.
    for (int copies = 0; copies < 3; ++copies) {
      SFUMATO_TRY(hold(context, *drag->shown));
      SFUMATO_TRY(hold(context, *frame.rows));
    }
    news = solve::rows_between(drag->layer, *drag->shown, *frame.rows);
  }
  delta.layers.reserve(delta.layers.size() + 1);
  delta.rows.reserve(delta.rows.size() + 1);
  if (!frame.is_whole && !maker->can_go_on(context)) {
    drag->forget_shown();
    return show(context, how);
  }
  solve::note_new(drag->layer, std::move(news), delta);
  if (frame.is_whole) {
    picture.layers[drag->layer] = std::move(frame.layer);
  } else {
    maker->write(frame, *drag->shown, picture.layers[drag->layer]);
  }
  drag->left = frame.left;
  drag->shown = std::move(frame.rows);
  drag->shown_by = maker;
  return ok_status();
}

Status Solution::State::begin_color(Context& context, const StopPlace& place) {
  end_drag();
  if (place.layer >= layers.size() ||
      !curves::has_stop(document.layers[place.layer].curves, place)) {
    return make_error(StatusCode::bad_input, "there is no such stop to be changed");
  }
  LayerState& layer = layers[place.layer];
  if (!options || !layer.is_solved() || frame_changed) {
    return make_error(StatusCode::bad_input,
                      "the document is to be solved before a colour changes");
  }
  SFUMATO_TRY(check_is_editable());
  note_drag(place.layer);
  const bool is_at_home = &context.budget == budget;
  return run_with_all_memory([&](bool) {
    std::optional<solve::RefinedLayer> none;
    Result<solve::ColorDrag> begun =
        solve::ColorDrag::begin(context, document, place, layer.sight, options_of(layer),
                                is_at_home ? layer.refined : none);
    if (begun) coloring.emplace(std::move(*begun));
    return begun.status();
  });
}

/// Sets the value of the prepared stop. The first frame puts a layer with its own tables into the
/// picture. The solved layer stays valid while the curve is unchanged.
Status Solution::State::color_to(Context& context, const StopValue& value) {
  if (!coloring) return make_error(StatusCode::bad_input, "no stop is prepared to be changed");
  const SpareRelease release(*this);
  SFUMATO_TRY(coloring->prepare(context, value));
  if (coloring->new_layer()) SFUMATO_TRY(hold(context, *coloring->new_layer()));
  delta.layers.reserve(delta.layers.size() + 1);
  const StopPlace& place = coloring->place();
  LayerState& layer = layers[place.layer];
  Curve& curve = document.layers[place.layer].curves[place.curve];
  const bool keeps = coloring->keeps(curve);
  std::optional<PatchLayer> solved = coloring->show(curve, picture.layers[place.layer]);
  if (!keeps) {
    layer = shown_roughly(std::move(layer.sight), place.layer);
  } else if (layer.in_picture && solved) {
    layer.fresh = std::move(solved);
    layer.in_picture.reset();
  }
  solve::note_new(place.layer, {}, delta);
  return ok_status();
}

}  // namespace sfumato
