#include <algorithm>
#include <span>
#include <utility>

#include "base/try.hpp"
#include "capi/documents/document.hpp"
#include "capi/documents/stop_change.hpp"
#include "capi/pictures/picture.hpp"

namespace sfumato::capi {
namespace {

/// The largest share of a layer's control points that several dragged curves may have. With more, a
/// rough picture of the layer takes less time than a frame.
constexpr double kMostDragged = 1.0 / 16;

/// Prepares the curves for a drag. Errors: bad_input if their layer must be solved first.
Status expect_drag(sfumato_context& context, const LayerCurves& curves, sfumato_picture& handle) {
  if (handle.dragged == curves) return ok_status();
  handle.solution->end_drag();
  handle.dragged.reset();
  handle.colored.reset();
  handle.has_moved = false;
  handle.drag_workshop = context.workshop;
  SFUMATO_TRY(handle.solution->begin_drag(context.workshop->context, curves.layer, curves.curves));
  handle.dragged = curves;
  return ok_status();
}

/// Returns whether the drag that runs includes the changed curves.
bool is_dragged(const LayerCurves& changed, const sfumato_picture& handle) {
  return handle.has_moved && handle.dragged->layer == changed.layer &&
         std::ranges::includes(handle.dragged->curves, changed.curves);
}

/// Notes that the picture shows the document, after a change of these curves.
/// is_same   the solution has the same curves as `document`, to the last bit
void note_shown(const sfumato_document& document, const LayerCurves& changed, bool is_same,
                sfumato_picture& handle) {
  const auto& [layer, curves] = changed;
  for (const std::uint32_t curve : curves) {
    const std::uint64_t number = document.revisions.curves[layer][curve];
    handle.shown.curves[layer][curve] = number;
    handle.applied.curves[layer][curve] = is_same ? number : 0;
  }
}

/// Shows the curves at their new places in the picture.
Status drag(sfumato_context& context, const LayerCurves& moved, const sfumato_document& document,
            double seconds, sfumato_picture& handle) {
  SFUMATO_TRY(expect_drag(context, moved, handle));
  std::vector<ChangedRows> changed(handle.changed.size());
  std::vector<Curve> curves;
  for (const std::uint32_t curve : moved.curves)
    curves.push_back(document.document.layers[moved.layer].curves[curve]);
  DiffuseStats stats;
  SFUMATO_TRY(handle.solution->drag(context.workshop->context, std::move(curves), &stats, seconds));
  handle.has_moved = true;
  handle.count(stats);
  note_changes(handle.picture(), handle.solution->take_delta(), changed);
  handle.changed = std::move(changed);
  note_shown(document, moved, true, handle);
  return ok_status();
}

/// Prepares the stop for other values. Errors: bad_input if its layer must be solved first.
Status take_stop(sfumato_context& context, const StopPlace& place, sfumato_picture& handle) {
  if (handle.colored == place) return ok_status();
  handle.solution->end_drag();
  handle.dragged.reset();
  handle.colored.reset();
  handle.drag_workshop = context.workshop;
  return handle.solution->begin_color(context.workshop->context, place);
}

/// Notes the whole layer as changed if its tables are new, otherwise only its values.
void note_stop(const StopPlace& place, bool is_first, sfumato_picture& handle,
               std::vector<ChangedRows>& changed) {
  note_changes(handle.picture(), handle.solution->take_delta(), changed);
  const auto values =
      place.attribute == StopAttribute::color ? SFUMATO_COLOR_VALUES : SFUMATO_OPACITY_VALUES;
  for (std::uint32_t table = 0; !is_first && table < changed[place.layer].size(); ++table) {
    if (table != values) changed[place.layer][table] = {};
  }
}

/// Sets the value of a stop. The first call puts new tables of the layer into the picture.
Status set_stop(sfumato_context& context, const StopChange& change, sfumato_picture& handle) {
  const bool is_first = handle.colored != change.place;
  std::vector<ChangedRows> changed(handle.changed.size());
  SFUMATO_TRY(take_stop(context, change.place, handle));
  SFUMATO_TRY(handle.solution->color(context.workshop->context, change.value));
  note_stop(change.place, is_first, handle, changed);
  handle.changed = std::move(changed);
  handle.count({});
  handle.colored = change.place;
  return ok_status();
}

/// Returns the change of a stop, if it is the only difference of these curves from the picture's.
std::optional<StopChange> only_stop_change(const LayerCurves& changed,
                                           const sfumato_document& document,
                                           const sfumato_picture& handle) {
  if (changed.curves.size() != 1) return std::nullopt;
  const Document& shown = handle.solution->document();
  const StopPlace at{changed.layer, changed.curves[0]};
  return find_stop_change(shown.layers[at.layer].curves[at.curve],
                          document.document.layers[at.layer].curves[at.curve], at,
                          shown.interpolation);
}

/// Shows the new value of a stop in the picture.
Status recolor(sfumato_context& context, const StopChange& change, const LayerCurves& changed,
               const sfumato_document& document, sfumato_picture& handle) {
  SFUMATO_TRY(set_stop(context, change, handle));
  const auto curve_of = [&](const Document& of) -> const Curve& {
    return of.layers[change.place.layer].curves[change.place.curve];
  };
  // All stops of a side may differ by rounding.
  const bool is_same = curve_of(handle.solution->document()) == curve_of(document.document);
  note_shown(document, changed, is_same, handle);
  return ok_status();
}

/// Converts a place in the terms of the C API; none if the side or the attribute is unknown.
std::optional<StopPlace> place_of(std::uint32_t layer, std::uint32_t curve, std::uint32_t side,
                                  std::uint32_t attribute, std::uint32_t index) {
  if (side > SFUMATO_RIGHT || attribute > SFUMATO_OPACITY) return std::nullopt;
  StopPlace place{layer, curve, side == SFUMATO_LEFT ? CurveSide::left : CurveSide::right,
                  attribute == SFUMATO_COLOR ? StopAttribute::color : StopAttribute::opacity,
                  index};
  if (index == UINT32_MAX) place.index.reset();
  return place;
}

/// Returns the value of a stop, or of the first one of a list; none if there is no such stop.
std::optional<StopValue> value_of(const Document& document, const StopPlace& place) {
  if (place.layer >= document.layers.size()) return std::nullopt;
  const std::vector<Curve>& curves = document.layers[place.layer].curves;
  if (place.curve >= curves.size()) return std::nullopt;
  const Side& side =
      place.side == CurveSide::left ? curves[place.curve].left : curves[place.curve].right;
  const auto value = [&](const auto& stops) -> std::optional<StopValue> {
    const std::size_t index = place.index.value_or(0);
    return index < stops.size() ? std::optional<StopValue>(stops[index].value) : std::nullopt;
  };
  return place.attribute == StopAttribute::color ? value(side.color.stops.stops)
                                                 : value(side.opacity.stops.stops);
}

/// Gives a view of the response to a stop. Sets the stop to its present value, which puts the new
/// tables of its layer into the picture.
Outcome respond(sfumato_context& context, sfumato_picture* handle,
                const std::optional<StopPlace>& place, sfumato_view& view) {
  if (!handle) return bad_usage("NULL given; pass a picture");
  if (!handle->solution) return no_solution();
  if (!place) return bad_usage("an unknown side, or an attribute without a response");
  const std::optional<StopValue> value = value_of(handle->solution->document(), *place);
  if (!value) return bad_usage("there is no such stop");
  if (handle->colored == place) {
    for (ChangedRows& rows : handle->changed) rows = {};
  } else if (Status status = set_stop(context, {*place, *value}, *handle); !status) {
    return status;
  }
  const std::span<const float> response = handle->solution->color_response();
  view = {response.data(), response.size(), sizeof(float), 1, SFUMATO_F32};
  return {};
}

}  // namespace

bool may_be_dragged(const LayerCurves& changed, const Document& document) {
  if (changed.curves.size() == 1) return true;
  const std::vector<Curve>& curves = document.layers[changed.layer].curves;
  std::size_t all = 0, dragged = 0;
  for (const Curve& curve : curves) all += curve.control_points.size();
  for (const std::uint32_t curve : changed.curves) dragged += curves[curve].control_points.size();
  return static_cast<double>(dragged) <= kMostDragged * static_cast<double>(all);
}

Status show_changes(sfumato_context& context, const LayerCurves& changed,
                    const sfumato_document& document, double seconds, sfumato_picture& handle) {
  if (is_dragged(changed, handle)) {
    const LayerCurves dragged = *handle.dragged;
    return drag(context, dragged, document, seconds, handle);
  }
  if (const auto change = only_stop_change(changed, document, handle)) {
    return recolor(context, *change, changed, document, handle);
  }
  return drag(context, changed, document, seconds, handle);
}

Status show_more(sfumato_context& context, double seconds, sfumato_picture& handle) {
  std::vector<ChangedRows> changed(handle.changed.size());
  DiffuseStats stats;
  SFUMATO_TRY(handle.solution->drag_more(context.workshop->context, &stats, seconds));
  handle.count(stats);
  note_changes(handle.picture(), handle.solution->take_delta(), changed);
  handle.changed = std::move(changed);
  return ok_status();
}

}  // namespace sfumato::capi

int32_t sfumato_expect_drag(sfumato_context* context, sfumato_picture* picture, uint32_t layer,
                            const uint32_t* curves, size_t curve_count) {
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop&) -> sfumato::capi::Outcome {
    if (!picture) return sfumato::capi::bad_usage("NULL given; pass a picture");
    if (!curves && curve_count > 0) return sfumato::capi::bad_usage("NULL given; pass curves");
    if (!picture->solution) return sfumato::capi::no_solution();
    std::vector<std::uint32_t> list(curves, curves + curve_count);
    std::ranges::sort(list);
    return sfumato::capi::expect_drag(*context, {layer, std::move(list)}, *picture);
  });
}

int32_t sfumato_stop_response(sfumato_context* context, sfumato_picture* picture, uint32_t layer,
                              uint32_t curve, uint32_t side, uint32_t attribute, uint32_t index,
                              sfumato_view* response) {
  if (response) *response = {};
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop&) -> sfumato::capi::Outcome {
    if (!response) return sfumato::capi::bad_usage("NULL given; pass room for a view");
    return sfumato::capi::respond(*context, picture,
                                  sfumato::capi::place_of(layer, curve, side, attribute, index),
                                  *response);
  });
}
