#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "solve/layers/layer_solver.hpp"
#include "solve/session/layer_drag.hpp"

namespace sfumato::solve {

/// A curve that is being dragged, of a Solution.
struct DraggedCurve {
  std::uint32_t layer;
  std::uint32_t curve;
  const Budget* budget;               ///< that it is charged to
  std::optional<LayerDrag> engine{};  ///< none where nothing shows the layer
  /// Its other self for where the curve is beyond the picture, once it was there. So a frame does
  /// not depend on where the curve was before.
  std::optional<LayerDrag> roomy{};
  bool may_have_room = true;  ///< until that lacks memory
  /// Of the picture's layer, while a frame made it or the drag began from it: which engine did, and
  /// its rows.
  LayerDrag* shown_by = nullptr;
  std::optional<FrameRows> shown{};
  std::size_t left = 0;  ///< nodes of the picture's layer that may be gathered yet

  /// Gives up the tables of the engines' last frames. Returns whether there were any.
  bool forget_frames() {
    bool any = false;
    for (std::optional<LayerDrag>* one : {&engine, &roomy}) any |= *one && (*one)->forget_frame();
    return any;
  }

  /// The picture's layer comes from elsewhere now.
  void forget_shown() {
    shown.reset();
    left = 0;
  }
};

}  // namespace sfumato::solve
