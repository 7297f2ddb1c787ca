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

/// A solved layer, and its response to the value of a stop. When that value, in the space of
/// Document::interpolation, grows by d, the node values of the attribute's field grow by d times
/// `factor`. Nothing else changes: values blend linearly at nodes, blurred or not, and the weights
/// of paints and the other attribute do not depend on them.
///
/// The layer has the values of the document, on the triangles of its solution. It may have more
/// nodes at corners, where equal colours may later differ, and triangles that are still invisible.
struct LayerResponse {
  PatchLayer layer;
  std::vector<float> factor;                      ///< per node of the attribute's field, 0 to 1
  TableMemory memory{"the response of a layer"};  ///< of `factor`
};

/// Computes the response of a layer.
///
/// place    an existing stop (curves::has_stop) of the layer
/// sight    of the layer, not empty
/// refined  the kept tables of the layer, solved for `sight` with `options`, in the context's
///          Budget; they stay valid, also after an error. Empty: the layer is solved
///          first, exactly even if the options ask for rays, and its tables are put here
/// stats    unless null, is added to: the work of this call
/// Errors   limit, cancelled
/// Cost     that of meshing the layer, and a gather of the nodes that see the curve
Result<LayerResponse> respond(Context& context, const Document& document, const StopPlace& place,
                              const LayerSight& sight, const DiffuseOptions& options,
                              std::optional<RefinedLayer>& refined, DiffuseStats* stats = nullptr);

}  // namespace sfumato::solve
