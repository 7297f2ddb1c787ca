#pragma once

#include <optional>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::svg_import {

/// Moves the alphas of a paint into a separate paint, which returns them as opacities. If all
/// alphas are 1, returns no value and leaves the paint unchanged. Texels are allocated from
/// `memory`. Errors: limit (memory), cancelled.
Result<std::optional<Shader>> take_alphas(const Context& context, Shader& shader,
                                          TableMemory& memory);

}  // namespace sfumato::svg_import
