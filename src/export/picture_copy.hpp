#pragma once

#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

/// Copies of parts of a picture, for a picture of these alone, allocated from `memory` piece by
/// piece.
namespace sfumato::outputs {

/// Appends a copy of a layer. Errors: limit (memory), cancelled.
Status copy_layer(const Context& context, const PatchLayer& layer, TableMemory& memory,
                  std::vector<PatchLayer>* to);

/// Appends copies of shaders; textures without their original files. Errors: limit (memory),
/// cancelled.
Status copy_shaders(const Context& context, std::span<const Shader> shaders, TableMemory& memory,
                    std::vector<Shader>* to);

}  // namespace sfumato::outputs
