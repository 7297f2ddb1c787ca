#pragma once

#include <span>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// The gradient of several channels together (Di Zenzo 1986), from derivatives of Gaussians.
struct Gradient {
  Plane strength;  ///< √λ₁ of the structure tensor: the change per pixel across the edge
  Plane normal_x;  ///< unit vector across the edge, of either sign
  Plane normal_y;
};

/// sigma    standard deviation of the Gaussian, pixels, above 0
/// memory   of the planes of `out`, which are made if they have another size
/// Errors   limit (memory), cancelled
/// Cost     O(pixels · sigma); runs on the pool
Status find_gradient(Context& context, std::span<const Plane> channels, double sigma,
                     TableMemory& memory, Gradient& out);

/// A channel smoothed by a Gaussian. Errors and cost: as find_gradient().
Status smooth(Context& context, double sigma, TableMemory& memory, Plane& channel);

}  // namespace sfumato::tracing
