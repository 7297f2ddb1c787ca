#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "base/vec2.hpp"
#include "curves/attributes.hpp"
#include "gather/scene_layout.hpp"
#include "mesh/triangle_mesh.hpp"

namespace sfumato::gather {

/// What a ray meets at a constrained edge, seen from one side. Where several pieces lie on the edge
/// it is the curve that was drawn last, of those whose facing side is not open; where that curve
/// lies along itself, the passage that reached farthest to this side before the weld, the first of
/// equals.
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

/// The visibility mesh in the layout of the gather: single-precision coordinates relative to
/// `origin`. Half-edges whose facing side is open are walked through. Triangles stand in an order
/// of their own, neighbours near each other in memory too: a walk is bound by its loads.
struct Scene {
  Vec2 origin;                          ///< layer frame
  std::vector<EdgeBeyond> edge_beyond;  ///< of half-edges that rays walk through
  std::vector<StopEdge> stop;
  std::vector<SceneTriangle> triangle;
  ScopedCharge charge;

  SceneView view() const;
};

/// Errors: limit.
Result<Scene> build_scene(Context& context, const mesh::TriangleMesh& mesh,
                          const curves::SegmentAttributes& attributes);

}  // namespace sfumato::gather
