#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "base/vec2.hpp"
#include "curves/attributes.hpp"
#include "mesh/triangle_mesh.hpp"

namespace sfumato::gather {

/// What a ray meets at a constrained edge, seen from one side: the resolved owner of the facing
/// side (the last drawn piece whose facing side is not open).
struct Facing {
  ShaderKind kind = ShaderKind::open;
  std::uint32_t shader = 0;
  Rgb from;  ///< colour at the start of the *half-edge* (its origin)
  Rgb to;    ///< colour at its target
  float weight = 1;
};

/// The owner of the side of half-edge h on which h's own triangle lies. Precondition: h is
/// constrained.
Facing facing_color(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                    std::uint32_t half_edge);

/// The visibility mesh in the layout of the exact gather: single-precision coordinates relative to
/// `origin`, one record per free half-edge (apex and the codes of the two edges beyond) and one
/// per half-edge that stops rays. Half-edges whose facing side is open are walked through.
struct Scene;

}  // namespace sfumato::gather
