#pragma once

#include "base/context.hpp"
#include "base/status.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "document/document.hpp"
#include "gather/gather.hpp"
#include "mesh/mesher.hpp"
#include "patches/diffuse.hpp"

namespace sfumato::patches {

/// What every way of evaluating a layer begins with: its curves flattened, meshed and made ready
/// for gathering.
struct LayerScene {
  curves::FlatCurves flat;
  curves::SegmentAttributes attributes;
  mesh::Mesher mesher;
  gather::Gatherer gatherer;
  Box frame;             ///< what the patch mesh covers, layer frame
  double smallest_edge;  ///< a triangle with no longer edge shows on no pixel, user units
};

/// `viewport`: the part of the layer frame that will be looked at. Adds to `stats` if not null.
Result<LayerScene> prepare_layer(Context& context, const Layer& layer, const Box& artboard,
                                 const Box& viewport, const DiffuseOptions& options,
                                 DiffuseStats* stats);

/// Checks lengths and counts of the options against what they mean.
Status validate(const DiffuseOptions& options);

}  // namespace sfumato::patches
