#pragma once

#include <cstdint>
#include <span>

#include "gather/ends/free_ends.hpp"
#include "gather/gather.hpp"
#include "gather/scene/scene.hpp"

namespace sfumato::gather {

/// Does the paper's Monte Carlo gather: for every point `rays_per_node` jittered rays, one in each
/// equal share of the circle, through a regular grid; Z = Σ w z / Σ w with w = k r⁻² at the first
/// hit. Random numbers are a hash of (seed, point, ray). Errors: limit, cancelled.
Status gather_rays(Context& context, const Scene& scene, const FreeEnds& ends,
                   const PointList& points, const GatherOptions& options, std::span<float> out,
                   std::span<std::uint8_t> hit);

}  // namespace sfumato::gather
