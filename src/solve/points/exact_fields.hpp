#pragma once

#include <cstdint>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// Returns a layer as rays meet it; without fields where it has image-domain shaders.
///
/// sight    some part of the layer is seen
/// memory   charged with the layer
/// Errors   limit, cancelled
Result<ExactLayer> exact_layer(Context& context, const Document& document, std::uint32_t layer,
                               const LayerSight& sight, const DiffuseOptions& options,
                               TableMemory& memory);

/// Gives the layers of a picture of the document their exact fields, except layers that are not
/// seen, and layers with image-domain shaders. Errors: limit, cancelled.
Status add_exact_fields(Context& context, const Document& document, const DiffuseOptions& options,
                        Picture* picture);

}  // namespace sfumato::solve
