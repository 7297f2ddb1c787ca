#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// A layer through the frames of a film. Its mesh goes on from one frame to the next: only where
/// curves move is it another. So where nothing moves nothing flickers.
///
/// A frame is a copy of the meshes without the curves that ever moved, into which these are
/// inserted where they are now. It holds the bound on the error: nodes are gathered that see what
/// changed, the others keep the values of the frame before, and patches that miss are refined.
/// Triangles that were there before anything was inserted are refined for all frames from then on,
/// so that they do not come and go; until that has made them half as many again.
///
/// Memory stays charged to the Budget of the Context that begin() was given, which must outlive
/// this.
class LayerFilm {
 public:
  /// Solves the first frame. `sight` is that of the layer, and not empty.
  /// patches   out
  /// Errors    limit, cancelled
  static Result<LayerFilm> begin(Context& context, const Document& document, std::uint32_t layer,
                                 const LayerSight& sight, const DiffuseOptions& options,
                                 DiffuseStats* stats, PatchLayer& patches);

  LayerFilm(LayerFilm&&) noexcept;
  LayerFilm& operator=(LayerFilm&&) noexcept;
  ~LayerFilm();

  /// Whether the layer of a document may be a frame of this film: it has as many curves, half of
  /// which at least did not change, and is looked at in the same way.
  bool can_go_on(const Document& document, std::uint32_t layer, const LayerSight& sight) const;

  /// Solves the next frame, which can_go_on(); none where the curves cannot be changed on this
  /// mesh: they reach too far beyond what is shown, have other attributes, or lie on each other in
  /// another order. The film is to be begun anew then, and after an error.
  /// Errors: limit, cancelled.
  Result<std::optional<PatchLayer>> next(Context& context, const Document& document,
                                         std::uint32_t layer, DiffuseStats* stats);

 private:
  struct State;
  explicit LayerFilm(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato::solve
