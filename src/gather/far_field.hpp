#pragma once

#include "gather/scene.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// Gives a scene its far field if its curves are many and thin, so that most of what a point sees
/// is far: Scene::far and Scene::far_mean. Errors: limit (memory), cancelled. Cost: O(triangles).
Status add_far_field(const Context& context, Scene& scene);

}  // namespace sfumato::gather
