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

/// A layer through the frames of a film. Its mesh continues from one frame to the next, and changes
/// only where curves move. Therefore nothing flickers where nothing moves.
///
/// A frame copies the still meshes, which lack the curves that ever moved, and inserts these curves
/// at their new places. It holds the bound on the error: the nodes that see a change are gathered,
/// the others keep their values, and patches that miss are refined. If such a patch is a triangle
/// of the still mesh, the still mesh is refined there for all later frames, so that triangles do
/// not come and go. Once these refinements have enlarged it by half, they are reverted.
///
/// Memory stays charged to the Budget of begin()'s Context, which must outlive this.
class LayerFilm {
 public:
  /// Solves the first frame. `sight` is the sight of the layer, and not empty.
  /// patches   out: the first frame
  /// Errors    limit, cancelled
  static Result<LayerFilm> begin(Context& context, const Document& document, std::uint32_t layer,
                                 const LayerSight& sight, const DiffuseOptions& options,
                                 DiffuseStats* stats, PatchLayer& patches);

  LayerFilm(LayerFilm&&) noexcept;
  LayerFilm& operator=(LayerFilm&&) noexcept;
  ~LayerFilm();

  /// Returns whether the layer of a document may be the next frame of this film: it has as many
  /// curves, at least half of them unchanged, and its sight, artboard and interpolation are the
  /// same.
  bool can_go_on(const Document& document, std::uint32_t layer, const LayerSight& sight) const;

  /// Solves the next frame. Returns none if this mesh cannot take the curves: they reach too far
  /// beyond the picture, need other fields, or lie on each other in another order. Begin a new film
  /// then, and after an error. Precondition: can_go_on(). Errors: limit, cancelled.
  Result<std::optional<PatchLayer>> next(Context& context, const Document& document,
                                         std::uint32_t layer, DiffuseStats* stats);

 private:
  struct State;
  explicit LayerFilm(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato::solve
