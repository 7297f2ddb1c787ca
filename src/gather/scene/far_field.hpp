#pragma once

#include "gather/scene/scene.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// Gives a scene its far field, Scene::far and Scene::far_mean, if its curves are many and thin:
/// most of the curves that a point sees are then far. Errors: limit (memory), cancelled. Cost:
/// O(triangles).
Status add_far_field(const Context& context, Scene& scene);

}  // namespace sfumato::gather
