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

/// Nodes of a frame keep the values that they had where the curve changes these for certain by no
/// more than this share of the range of code values, and where it was, by half of that. 0: all
/// nodes have their exact values, as colours have in other spaces, in which a small change may be
/// one of many code values.
inline constexpr double kMostMissed = 0.02;

/// How a frame is made.
struct FrameOptions {
  /// Until when nodes are gathered that may wait: those that the curve touches do not. The others
  /// keep the values that the last frame gave them, or that they have without the curve. It does
  /// not count where what is seen ends within the layer, nor where the curve crosses what is shown.
  FrameTime time{};
  bool wants_rows = false;        ///< LayerDrag::frame()
  DiffuseStats* stats = nullptr;  ///< unless null: added to, what was gathered
  std::optional<RoundWatch> watch{};
};

/// A curve of a layer that moves while all others stay: its layer solved without it, to which each
/// frame adds it at another place: in copies of the layer's tables, in which only what the curve
/// changes is made anew. A frame uses the copies of the one before, and first takes back what that
/// changed. It depends on the layer and on the curve, not on the frames before it.
///
/// Frames are for looking at while something moves. Their nodes have their exact values, but for
/// kMostMissed; the mesh is that of the layer as it was, no finer where the curve is
/// now than the angles ask; and the curve is drawn over all others.
///
/// Memory stays charged to the Budget of the Context that begin() was given, which must outlive
/// this. Frames may have a Context of their own, which then costs them anew copies each time.
class LayerDrag {
 public:
  /// Whether so much of the layer's mesh lies on the curve that a frame would take long, and that a
  /// drag is to begin with roughly() given options and nothing `refined`. Errors: cancelled. Cost:
  /// O(half-edges of the patch mesh).
  static Result<bool> is_costly(const Context& context, const RefinedLayer& refined,
                                std::uint32_t curve);

  /// Takes the curve off the layer. `sight` is that of the layer, and not empty.
  /// refined   what was kept of the layer as it is, solved for `sight` with `options`, in the
  ///           context's Budget, for any number of drags; or nothing: the layer is solved first,
  ///           on a mesh with room for a curve that is dragged beyond what is shown.
  /// Errors    limit, cancelled
  static Result<LayerDrag> begin(Context& context, const Document& document, std::uint32_t layer,
                                 std::uint32_t curve, const LayerSight& sight,
                                 const DiffuseOptions& options,
                                 std::optional<RefinedLayer>& refined,
                                 double most_missed = kMostMissed);

  LayerDrag(LayerDrag&&) noexcept;
  LayerDrag& operator=(LayerDrag&&) noexcept;
  ~LayerDrag();

  /// Whether its mesh has that room.
  bool has_room() const;

  /// Whether one with_room() would help where frame() says bad_input.
  bool needs_room(const Curve& curve) const;

  /// The same drag begun anew, with that room. Errors: limit, cancelled. Cost: that of the layer's
  /// solution.
  Result<LayerDrag> with_room(Context& context) const;

  /// The rows in which the patches of `refined` that begin() was given, as its layer was solved,
  /// are not those of the layer without the curve, like a frame's; none: any may be another. Moved
  /// out.
  std::optional<FrameRows> take_rows_of_solved();

  /// The layer's patches with the curve as it is now.
  /// options.wants_rows   the caller has the patches of an earlier frame, or those of
  ///                      take_rows_of_solved(): where the result is not whole these become the
  ///                      frame's by write(), before the next one
  /// Errors  bad_input (it reaches farther beyond what is shown than the layer's mesh has room, or
  ///         its sides ask for other fields than they did: solve the layer anew), limit, cancelled
  Result<FramePatches> frame(Context& context, const Curve& curve,
                             const FrameOptions& options = {});

  /// Gathers nodes that the last frame left, until options.time is over: those that it may change
  /// most come first. Errors as for frame(); where it fails, and where it is not can_go_on(), the
  /// frame is to be made anew.
  Result<FramePatches> go_on(Context& context, const FrameOptions& options);

  /// Gives the tables of patches room for the last frame, which can_go_on(). They stay as they are.
  /// Errors: limit (memory), cancelled.
  Status make_room(const Context& context, PatchLayer& layer) const;

  /// Makes patches the last frame, which can_go_on(). There is room in them.
  /// frame   what frame() or go_on() returned, not whole; its soft edges are moved out
  /// then    the rows of the patches as they are
  void write(FramePatches& frame, const FrameRows& then, PatchLayer& layer) const;

  /// Whether the tables of the last frame are there, and are of this Context's Budget.
  bool can_go_on(const Context& context) const;

  /// Gives up the tables that the last frame left for the next. Returns whether there were any.
  bool forget_frame();

 private:
  struct State;
  explicit LayerDrag(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato::solve
