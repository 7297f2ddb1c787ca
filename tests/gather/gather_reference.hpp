#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "curves/attributes.hpp"
#include "gather/ends/free_ends.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// W, Σ w z of curve-domain sides and W_s of eq. 4–11 before the division.
struct ReferenceSums {
  double weight = 0;
  std::array<double, 3> color{};
  std::vector<double> shader_weight;  ///< W_s of each image-domain shader

  /// Returns Σ w z / W; 0 where nothing is hit.
  std::array<double, 3> value() const;
  /// Returns W_s / W; 0 where nothing is hit.
  std::vector<double> shares() const;
};

/// Gathers slowly and readably: one point, double precision, directly on the mesh. Every fast path
/// is compared with it. Precondition: p lies in triangle `triangle`, not on a vertex.
///
/// ends   their terms are added.
///
/// Cost: O(triangles that the windows cross + ends).
ReferenceSums gather_reference(const mesh::TriangleMesh& mesh,
                               const curves::SegmentAttributes& attributes, Vec2 p,
                               std::uint32_t triangle, std::span<const FreeEnd> ends = {});

/// Returns a triangle that contains p (its edges included), or mesh::kNone. Cost: O(triangles).
std::int32_t find_triangle(const mesh::TriangleMesh& mesh, Vec2 p);

}  // namespace sfumato::gather
