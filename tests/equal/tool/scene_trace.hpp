#pragma once

#include "equal/tool/scene.hpp"
#include "equal/tool/trace.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::test {

/// Works on a scene like diffuse() and rasterize(), and keeps the result of each step: the
/// document; then, for each layer, its flattened curves, visibility mesh, the mesh, node positions
/// and node values of every round, and patches; then the image of growing parts of the stack, the
/// whole image, and its PNG. Returns the errors of diffuse() and rasterize().
Result<Trace> trace_scene(Context& context, const Scene& scene);

}  // namespace sfumato::test
