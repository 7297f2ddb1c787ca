#pragma once

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// Colour and opacity of a layer as one field of four channels, alpha last: 1 where the layer has
/// no opacity. Weights of shaders are left out. Two patches share a node where they share it in
/// both fields. Its tables are of `memory`. Errors: limit (memory), cancelled.
Result<PatchField> joined_field(Context& context, const PatchField& color,
                                const PatchField& opacity, TableMemory& memory);

}  // namespace sfumato::outputs
