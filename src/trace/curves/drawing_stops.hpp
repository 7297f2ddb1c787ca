#pragma once

#include <algorithm>

#include "base/poll.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::tracing {

/// Calls visit(curve) for all curves of all layers. Errors: cancelled.
template <class AnyDocument, class Visit>
Status for_each_curve(const Context& context, AnyDocument& drawing, Visit&& visit) {
  RarePoll<256> poll(context);
  for (auto& layer : drawing.layers) {
    for (auto& curve : layer.curves) {
      if (poll.cancelled()) return context.cancel_status();
      visit(curve);
    }
  }
  return ok_status();
}

/// Calls visit(list) for the colours of all sides that have any, in the order of columns that
/// curves::sample_stop_places() counts, layer by layer. Errors: cancelled.
template <class AnyDocument, class Visit>
Status for_each_color_list(const Context& context, AnyDocument& drawing, Visit&& visit) {
  return for_each_curve(context, drawing, [&](auto& curve) {
    for (auto* side : {&curve.left, &curve.right}) {
      if (side->color.kind == ShaderKind::curve_domain) visit(side->color.stops);
    }
  });
}

/// Returns the largest radius of blur on either side.
inline float largest_radius(const Curve& curve) {
  float largest = 0;
  for (const Side* side : {&curve.left, &curve.right}) {
    for (const Stop<float>& stop : side->blur_radius.stops) {
      largest = std::max(largest, stop.value);
    }
  }
  return largest;
}

}  // namespace sfumato::tracing
