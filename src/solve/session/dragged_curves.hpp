#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solve/layers/layer_solver.hpp"
#include "solve/session/layer_session.hpp"

namespace sfumato::solve {

/// Curves of a layer of a Solution that are being dragged.
struct DraggedCurves {
  std::uint32_t layer;
  std::vector<std::uint32_t> curves;     ///< ascending
  const Budget* budget;                  ///< the Budget that it is charged to
  std::optional<LayerSession> engine{};  ///< none where nothing shows the layer
  /// The same drag with room beyond the picture, begun when a curve first needs it. `engine`
  /// makes all other frames, so that a frame does not depend on earlier places of the curves.
  std::optional<LayerSession> roomy{};
  bool may_have_room = true;  ///< false once `roomy` lacked memory
  /// The engine that made the picture's layer, or began from it, and the rows of that layer. There
  /// are no rows if the layer comes from elsewhere.
  LayerSession* shown_by = nullptr;
  std::optional<FrameRows> shown{};
  std::size_t left = 0;  ///< nodes of the picture's layer that wait to be gathered

  /// Releases the tables of the engines' last frames. Returns whether there were any.
  bool forget_frames() {
    bool any = false;
    for (std::optional<LayerSession>* one : {&engine, &roomy})
      any |= *one && (*one)->forget_frame();
    return any;
  }

  /// Notes that the picture's layer no longer comes from an engine.
  void forget_shown() {
    shown.reset();
    left = 0;
  }
};

}  // namespace sfumato::solve
