#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/fields/frame_time.hpp"
#include "solve/layers/layer_solver.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// The largest error of a node that keeps its value, as a share of the range of code values. A node
/// keeps its value if the insertion of the curve certainly changes it by at most this error, or the
/// removal by at most half of it. 0: all nodes get exact values. Colours in other spaces than sRGB
/// are always exact, because a small change there may be many code values.
inline constexpr double kMostMissed = 0.02;

/// Options of a frame.
struct FrameOptions {
  /// The time after which nodes wait, except for nodes that the curve touches. Waiting nodes keep
  /// the values of the last frame, or the values without the curve. No node waits where the region
  /// that sees curves ends within the layer, or where the curve crosses the frame of the mesh.
  FrameTime time{};
  bool wants_rows = false;        ///< see LayerDrag::frame()
  DiffuseStats* stats = nullptr;  ///< unless null, is added to: the work of the frame
  std::optional<RoundWatch> watch{};
};

/// A curve of a layer that moves while all other curves stay. begin() solves the layer without the
/// curve. Each frame copies the layer's tables, inserts the curve at its new place, and computes
/// only the parts that the curve changes. A frame reuses the copies of the last frame, after it has
/// reverted the changes of that frame. A frame depends on the layer and the curve, not on
/// earlier frames.
///
/// Frames are previews. Their nodes have exact values, except for kMostMissed. The mesh is that of
/// the solved layer; at the curve's new place it is only as fine as the angles require. The curve
/// is drawn over all others.
///
/// Memory stays charged to the Budget of begin()'s Context, which must outlive this. Frames may use
/// another Context, but each of them then makes its own copies.
class LayerDrag {
 public:
  /// Returns whether so much of the layer's mesh lies on the curve that a frame would take long. If
  /// so, call begin() with the options that roughly() returns and an empty `refined`. Errors:
  /// cancelled. Cost: O(half-edges of the patch mesh).
  static Result<bool> is_costly(const Context& context, const RefinedLayer& refined,
                                std::uint32_t curve);

  /// Removes the curve from the layer. `sight` is the sight of the layer, and not empty.
  /// refined   the kept tables of the layer, solved for `sight` with `options` in the context's
  ///           Budget; they serve any number of drags. Empty: the layer is solved first, on a
  ///           mesh with room for a curve that is dragged beyond the picture
  /// Errors    limit, cancelled
  static Result<LayerDrag> begin(Context& context, const Document& document, std::uint32_t layer,
                                 std::uint32_t curve, const LayerSight& sight,
                                 const DiffuseOptions& options,
                                 std::optional<RefinedLayer>& refined,
                                 double most_missed = kMostMissed);

  LayerDrag(LayerDrag&&) noexcept;
  LayerDrag& operator=(LayerDrag&&) noexcept;
  ~LayerDrag();

  /// Returns whether the mesh has room for the curve beyond the picture.
  bool has_room() const;

  /// Returns whether with_room() would help after frame() has returned bad_input.
  bool needs_room(const Curve& curve) const;

  /// Begins the same drag again, with room beyond the picture. Errors: limit, cancelled. Cost: that
  /// of solving the layer.
  Result<LayerDrag> with_room(Context& context) const;

  /// Moves out the list of rows that differ between two versions of the layer: the solved patches
  /// of begin()'s `refined`, and the patches without the curve. Empty: any row may differ.
  std::optional<FrameRows> take_rows_of_solved();

  /// Returns the layer's patches with the curve at its new place.
  /// options.wants_rows   the caller has the patches of an earlier frame, or the solved patches of
  ///                      take_rows_of_solved(). If the result is not whole, it must update them
  ///                      with write() before the next frame
  /// Errors  bad_input (the curve lies beyond the room of the layer's mesh, or its sides need other
  ///         fields than before: solve the layer again), limit, cancelled
  Result<FramePatches> frame(Context& context, const Curve& curve,
                             const FrameOptions& options = {});

  /// Gathers waiting nodes of the last frame until options.time is over, first the nodes that the
  /// curve may change most. Precondition: can_go_on(); otherwise, and after an error, call frame().
  /// Errors: as frame().
  Result<FramePatches> go_on(Context& context, const FrameOptions& options);

  /// Reserves room for the last frame in the tables of patches, whose content stays. Precondition:
  /// can_go_on(). Errors: limit (memory), cancelled.
  Status make_room(const Context& context, PatchLayer& layer) const;

  /// Updates patches to the last frame. Preconditions: can_go_on(), and make_room() was called.
  /// frame   the result of frame() or go_on(), not whole; its soft edges are moved out
  /// then    the rows of the patches before this call
  void write(FramePatches& frame, const FrameRows& then, PatchLayer& layer) const;

  /// Returns whether the tables of the last frame are kept, in the Budget of this Context.
  bool can_go_on(const Context& context) const;

  /// Releases the tables that the last frame left for the next. Returns whether there were any.
  bool forget_frame();

 private:
  struct State;
  explicit LayerDrag(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato::solve
