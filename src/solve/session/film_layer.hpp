#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/charge.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/session/layer_session.hpp"

namespace sfumato::solve {

/// A layer through the frames of a film. The first frame is solved. Later ones are the frames of a
/// LayerSession whose moving curves are all curves that ever moved, and which holds the bound on
/// the error. Nodes and triangles that see no moving curve are therefore the same in all frames,
/// and nothing flickers there.
///
/// Memory stays charged to the Budget of begin()'s Context, which must outlive this.
class FilmLayer {
 public:
  /// Solves the first frame. `sight` is the sight of the layer, and not empty.
  /// patches   out: the first frame
  /// Errors    limit, cancelled
  static Result<FilmLayer> begin(Context& context, const Document& document, std::uint32_t layer,
                                 const LayerSight& sight, const DiffuseOptions& options,
                                 DiffuseStats* stats, PatchLayer& patches);

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
  explicit FilmLayer(LayerInput first) : first_(std::move(first)), last_(first_.curves) {}

  std::vector<std::uint32_t> moving(const std::vector<Curve>& now) const;

  LayerInput first_;                     ///< the layer in the first frame
  std::vector<Curve> last_;              ///< its curves in the last frame
  std::optional<RefinedLayer> refined_;  ///< the first frame, if there is enough memory
  std::optional<LayerSession> session_;
  ScopedCharge charge_;  ///< of the curves
};

}  // namespace sfumato::solve
