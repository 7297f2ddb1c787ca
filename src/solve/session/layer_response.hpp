#pragma once

#include <optional>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/document/stop_place.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/layers/layer_solver.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// A solved layer, and how it answers to the value of a stop. Where that value, in the space of
/// Document::interpolation, grows by d, the node values of the attribute's field grow by d times
/// `factor`, and nothing else changes: colours blend linearly at nodes, blurred or not, and what
/// paints the sides bear and how opaque the layer is does not depend on them.
///
/// The layer has the values that the document says, on the triangles of its solution; it may have
/// more nodes at corners, where colours that were equal may come to differ, and triangles that are
/// invisible yet.
struct LayerResponse {
  PatchLayer layer;
  std::vector<float> factor;                      ///< per node of the attribute's field, 0 to 1
  TableMemory memory{"the response of a layer"};  ///< of `factor`
};

/// Finds that of a layer.
///
/// place    is there (curves::has_stop); its layer is the one
/// sight    that of the layer, not empty
/// refined  what was kept of the layer, solved for `sight` with `options`, in the context's Budget;
///          it is used and given back, also on failure. Nothing: the layer is solved first, exactly
///          also where the options ask for rays, and what is kept of it is put there
/// stats    unless null, is added to: what was gathered
/// Errors   limit, cancelled
/// Cost     that of meshing the layer, and a gather of the nodes that see the curve
Result<LayerResponse> respond(Context& context, const Document& document, const StopPlace& place,
                              const LayerSight& sight, const DiffuseOptions& options,
                              std::optional<RefinedLayer>& refined, DiffuseStats* stats = nullptr);

}  // namespace sfumato::solve
