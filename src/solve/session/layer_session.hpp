#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

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
/// keeps its value if the insertion of the curves certainly changes it by at most this error, or
/// the removal by at most half of it. Colours in other spaces than sRGB are always exact, because a
/// small change there may be many code values.
inline constexpr double kMostMissed = 0.02;

/// A layer to be solved, with the options that it is solved with.
struct LayerInput {
  Box artboard;  ///< of the document
  InterpolationSpace interpolation = InterpolationSpace::srgb;
  std::vector<Curve> curves;
  LayerSight sight;  ///< not empty
  DiffuseOptions options;
};

LayerInput input_of(const Document& document, std::uint32_t layer, const LayerSight& sight,
                    const DiffuseOptions& options);

/// How exact the frames of a session are.
struct FrameAccuracy {
  double most_missed = kMostMissed;  ///< as kMostMissed; 0: all nodes get exact values
  /// Refines the patches that the moving curves change until they hold the bound on the error, and
  /// accepts only curves that are drawn in the layer's order.
  bool holds_bound = false;
};

/// How a frame is made.
struct FramePolicy {
  /// The time after which nodes wait, except for nodes that the curves touch. Waiting nodes keep
  /// the values of the last frame, or the values without the curves. No node waits where the region
  /// that sees curves ends within the layer, or where a curve crosses the frame of the mesh.
  FrameTime time{};
  bool wants_rows = false;        ///< see LayerSession::frame()
  DiffuseStats* stats = nullptr;  ///< unless null, is added to: the work of the frame
  std::optional<RoundWatch> watch{};
};

/// A solved layer, some of whose curves move while all others stay. open() removes the moving
/// curves from the solved layer. Each frame copies the layer's tables, inserts the curves at their
/// new places, and computes only the parts that they change. A frame reuses the copies of the last
/// frame, after it has reverted the changes of that frame. A frame depends on the layer and the
/// curves, not on earlier frames.
///
/// Nodes have exact values, except for kMostMissed. The mesh is that of the solved layer; at the
/// curves' new places it is only as fine as the angles require, unless FrameAccuracy::holds_bound.
/// The moving curves are drawn over all others, in the layer's order among themselves.
///
/// Memory stays charged to the Budget of open()'s Context, which must outlive this. Frames may use
/// another Context, but each of them then makes its own copies.
class LayerSession {
 public:
  /// Returns whether so much of the layer's mesh lies on the curves that a frame would take long.
  /// If so, call open() with the options that roughly() returns and an empty `refined`. Errors:
  /// limit (memory), cancelled. Cost: O(half-edges of the patch mesh).
  static Result<bool> is_costly(const Context& context, const RefinedLayer& refined,
                                std::span<const std::uint32_t> moving);

  /// Solves a layer on a mesh with room for curves beyond the picture.
  /// refined   out: the tables for open(), if there is enough memory
  /// Errors    limit, cancelled
  static Result<PatchLayer> solve_with_room(Context& context, const LayerInput& input,
                                            DiffuseStats* stats,
                                            std::optional<RefinedLayer>& refined);

  /// Removes the moving curves from a layer.
  /// moving    indices of the curves, ascending, at least one
  /// refined   the kept tables of the solved layer, in the context's Budget; they serve any number
  ///           of sessions. Empty: the layer is solved first, with room beyond the picture
  /// Errors    limit, cancelled
  static Result<LayerSession> open(Context& context, LayerInput input,
                                   std::vector<std::uint32_t> moving,
                                   std::optional<RefinedLayer>& refined,
                                   const FrameAccuracy& accuracy = {});

  LayerSession(LayerSession&&) noexcept;
  LayerSession& operator=(LayerSession&&) noexcept;
  ~LayerSession();

  /// Returns the indices of the moving curves, ascending.
  const std::vector<std::uint32_t>& moving() const;

  /// Returns whether the mesh has room for curves beyond the picture.
  bool has_room() const;

  /// Returns whether with_room() would help after frame() has returned none.
  bool needs_room(std::span<const Curve> now) const;

  /// Opens the same session again, with room beyond the picture. Errors: limit, cancelled. Cost:
  /// that of solving the layer.
  Result<LayerSession> with_room(Context& context) const;

  /// Moves out the list of rows that differ between two versions of the layer: the solved patches
  /// of open()'s `refined`, and the patches without the moving curves. Empty: any row may differ.
  std::optional<FrameRows> take_rows_of_solved();

  /// Returns the layer's patches with the moving curves at their new places. Returns none if they
  /// lie beyond the room of the layer's mesh, or need other fields than before: solve the layer
  /// again.
  /// now                 the moving curves, in the order of moving()
  /// policy.wants_rows   the caller has the patches of an earlier frame, or the solved patches of
  ///                     take_rows_of_solved(). If the result is not whole, it must update them
  ///                     with write() before the next frame
  /// Errors  limit, cancelled
  Result<std::optional<FramePatches>> frame(Context& context, std::span<const Curve> now,
                                            const FramePolicy& policy = {});

  /// Gathers waiting nodes of the last frame until policy.time is over, first the nodes that the
  /// curves may change most. Precondition: can_go_on(); otherwise, and after an error, call
  /// frame(). Errors: as frame().
  Result<FramePatches> go_on(Context& context, const FramePolicy& policy);

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
  explicit LayerSession(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato::solve
