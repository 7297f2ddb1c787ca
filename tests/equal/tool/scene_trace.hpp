#pragma once

#include "equal/tool/scene.hpp"
#include "equal/tool/trace.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::test {

/// Works on a scene as diffuse() and rasterize() do and keeps what each step gave: the document,
/// then for each layer its flattened curves, visibility mesh, the mesh, node positions and node
/// values of every round, and patches; then the image of ever more of the stack, whole, and as PNG.
/// Errors: those of diffuse() and rasterize().
Result<Trace> trace_scene(Context& context, const Scene& scene);

}  // namespace sfumato::test
