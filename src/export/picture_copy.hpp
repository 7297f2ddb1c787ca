#pragma once

#include <span>
#include <vector>

#include "base/charge.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

/// Copies of parts of a picture, for a picture of these alone: charged before they are made, and
/// made piece by piece.
namespace sfumato::outputs {

/// Appends a copy of a layer. Errors: limit (memory), cancelled.
Status copy_layer(Context& context, const PatchLayer& layer, ScopedCharge* charge,
                  std::vector<PatchLayer>* to);

/// Appends copies of shaders, textures without the files that they came from. Errors: limit
/// (memory), cancelled.
Status copy_shaders(Context& context, std::span<const Shader> shaders, ScopedCharge* charge,
                    std::vector<Shader>* to);

}  // namespace sfumato::outputs
