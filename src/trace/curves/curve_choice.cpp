#include "trace/curves/curve_choice.hpp"

#include <string>

#include "base/poll.hpp"

namespace sfumato::tracing {

Status check_curves(const Context& context, const Document& drawing,
                    std::span<const CurveOfLayer> curves) {
  RarePoll<4096> poll(context);
  for (const auto& [layer, curve] : curves) {
    if (poll.cancelled()) return context.cancel_status();
    if (layer < drawing.layers.size() && curve < drawing.layers[layer].curves.size()) continue;
    return make_error(StatusCode::bad_input, "there is no curve " + std::to_string(curve) +
                                                 " in layer " + std::to_string(layer) +
                                                 " to be fitted");
  }
  return context.check();
}

}  // namespace sfumato::tracing
