#include <utility>
#include <vector>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "capi/documents/document.hpp"
#include "capi/pictures/view.hpp"

namespace sfumato::capi {
namespace {

/// Copies the caller's points. Their number is checked before they are read; the document checks
/// their values.
Outcome read_points(const Context& context, const double* xy, std::size_t count,
                    std::vector<Vec2>& points) {
  if (!xy && count > 0) return bad_usage("NULL given; pass points");
  if (count > context.limits.control_points) {
    return limit_error(context.limits, &Limits::control_points, "control points");
  }
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) points.push_back({xy[2 * i], xy[2 * i + 1]});
  return {};
}

Outcome set_points(const Context& context, sfumato_document* handle, std::uint32_t layer,
                   std::uint32_t curve, const double* xy, std::size_t count) {
  const Curve* old = find_curve(handle, layer, curve);
  if (!old) return no_such_curve(handle, layer, curve);
  std::vector<Vec2> points;
  SFUMATO_TRY(read_points(context, xy, count, points));
  Curve moved = *old;
  moved.control_points = std::move(points);
  return change(context, *handle, ReplaceCurve{layer, curve, std::move(moved)});
}

Outcome set_weight(const Context& context, sfumato_document* handle, std::uint32_t layer,
                   std::uint32_t curve, double weight) {
  const Curve* old = find_curve(handle, layer, curve);
  if (!old) return no_such_curve(handle, layer, curve);
  Curve weighted = *old;
  weighted.weight = weight;
  return change(context, *handle, ReplaceCurve{layer, curve, std::move(weighted)});
}

Outcome insert(const Context& context, sfumato_document* handle, std::uint32_t layer,
               std::uint32_t at, const double* xy, std::size_t count) {
  SFUMATO_TRY(expect_layer(handle, layer));
  const std::size_t size = handle->document.layers[layer].curves.size();
  if (at == UINT32_MAX) at = static_cast<std::uint32_t>(size);
  if (at > size) return no_such_curve(handle, layer, at);
  Curve added;
  SFUMATO_TRY(read_points(context, xy, count, added.control_points));
  return change(context, *handle, InsertCurve{layer, at, std::move(added)});
}

}  // namespace
}  // namespace sfumato::capi

using sfumato::capi::Outcome;
using sfumato::capi::Workshop;

int32_t sfumato_curve_points(const sfumato_document* document, uint32_t layer, uint32_t curve,
                             sfumato_view* points) {
  if (points) *points = {};
  const sfumato::Curve* found = sfumato::capi::find_curve(document, layer, curve);
  if (!found || !points) return SFUMATO_BAD_USAGE;
  static_assert(sizeof(sfumato::Vec2) == 2 * sizeof(double));
  *points = sfumato::capi::view_of(found->control_points, 2, SFUMATO_F64, sizeof(double));
  return SFUMATO_OK;
}

int32_t sfumato_set_curve_points(sfumato_context* context, sfumato_document* document,
                                 uint32_t layer, uint32_t curve, const double* xy,
                                 size_t point_count) {
  return sfumato::capi::call(context, [&](Workshop& workshop) {
    return sfumato::capi::set_points(workshop.context, document, layer, curve, xy, point_count);
  });
}

double sfumato_curve_weight(const sfumato_document* document, uint32_t layer, uint32_t curve) {
  const sfumato::Curve* found = sfumato::capi::find_curve(document, layer, curve);
  return found ? found->weight : 0;
}

int32_t sfumato_set_curve_weight(sfumato_context* context, sfumato_document* document,
                                 uint32_t layer, uint32_t curve, double weight) {
  return sfumato::capi::call(context, [&](Workshop& workshop) {
    return sfumato::capi::set_weight(workshop.context, document, layer, curve, weight);
  });
}

int32_t sfumato_insert_curve(sfumato_context* context, sfumato_document* document, uint32_t layer,
                             uint32_t at, const double* xy, size_t point_count) {
  return sfumato::capi::call(context, [&](Workshop& workshop) {
    return sfumato::capi::insert(workshop.context, document, layer, at, xy, point_count);
  });
}

int32_t sfumato_remove_curve(sfumato_context* context, sfumato_document* document, uint32_t layer,
                             uint32_t curve) {
  return sfumato::capi::call(context, [&](Workshop& workshop) -> Outcome {
    if (!sfumato::capi::find_curve(document, layer, curve)) {
      return sfumato::capi::no_such_curve(document, layer, curve);
    }
    return sfumato::capi::change(workshop.context, *document, sfumato::RemoveCurve{layer, curve});
  });
}
