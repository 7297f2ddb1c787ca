#pragma once

#include <array>
#include <concepts>

#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// Barycentric coordinates of the ten nodes, in the order of PatchLayer: per node the weights of
/// corners 0, 1, 2.
inline constexpr std::array<std::array<double, 3>, kNodesPerTriangle> kNodeBarycentric{{
    {1, 0, 0},
    {0, 1, 0},
    {0, 0, 1},
    {2.0 / 3, 1.0 / 3, 0},
    {1.0 / 3, 2.0 / 3, 0},
    {0, 2.0 / 3, 1.0 / 3},
    {0, 1.0 / 3, 2.0 / 3},
    {1.0 / 3, 0, 2.0 / 3},
    {2.0 / 3, 0, 1.0 / 3},
    {1.0 / 3, 1.0 / 3, 1.0 / 3},
}};

/// The node at a triangle's centroid.
inline constexpr int kCenterNode = 9;

/// Returns the node on edge k, which runs from corner k to the next, that is nearer to corner k.
constexpr auto near_node(std::integral auto k) {
  return 3 + 2 * k;
}

/// Returns the other node on edge k.
constexpr auto far_node(std::integral auto k) {
  return 4 + 2 * k;
}

/// Returns the node a third of the way from corner i to corner j.
constexpr int edge_node(int i, int j) {
  return j == (i + 1) % 3 ? near_node(i) : far_node(j);
}

using PatchBasis = std::array<double, kNodesPerTriangle>;

namespace picture {

/// Returns eq. 18. Three other forms of this cubic exist where they are needed. Each rounds in its
/// own order, so that none follows from this one to the bit:
///
/// raster/kernels/patch_polynomial.hpp: monomials of differences to one node, so that a constant is
/// exact. Tests: RasterClosedForms.ten_nodes_reproduce_a_cubic_anywhere, and against this one
/// RasterReference.random_pictures_agree_at_any_scale.
///
/// export/facets/facet_patch.cpp: Bézier ordinates, for bounds and second derivatives. Test:
/// Facets.ordinates_and_basis_are_of_one_cubic.
///
/// web/viewer/shaders/patch.frag: in single precision on a graphics processor. Test:
/// GpuRender.patches_of_every_order_agree.
constexpr PatchBasis cubic_basis(double w, double u, double v) {
  return {0.5 * w * (3 * w - 1) * (3 * w - 2), 0.5 * u * (3 * u - 1) * (3 * u - 2),
          0.5 * v * (3 * v - 1) * (3 * v - 2), 4.5 * w * u * (3 * w - 1),
          4.5 * w * u * (3 * u - 1),           4.5 * u * v * (3 * u - 1),
          4.5 * u * v * (3 * v - 1),           4.5 * v * w * (3 * v - 1),
          4.5 * v * w * (3 * w - 1),           27 * w * u * v};
}

/// Returns eq. 17, with each edge centre from the cubic through the edge's four nodes: (−Zi + 9 Zij
/// + 9 Zji − Zj) / 16.
constexpr PatchBasis quadratic_basis(double w, double u, double v) {
  PatchBasis basis{w * (2 * w - 1), u * (2 * u - 1), v * (2 * v - 1), 0, 0, 0, 0, 0, 0, 0};
  const double edge[3] = {4 * w * u, 4 * u * v, 4 * v * w};
  for (int k = 0; k < 3; ++k) {
    basis[k] -= edge[k] / 16;
    basis[(k + 1) % 3] -= edge[k] / 16;
    basis[near_node(k)] += 9 * edge[k] / 16;
    basis[far_node(k)] += 9 * edge[k] / 16;
  }
  return basis;
}

}  // namespace picture

/// Returns the ten basis values at barycentric (w, u, v) of corners 0, 1, 2: eq. 18 (cubic), eq. 17
/// (quadratic, its edge centres taken from the cubic), or barycentric (linear). They sum to 1.
constexpr PatchBasis patch_basis(PatchOrder order, double w, double u, double v) {
  switch (order) {
    case PatchOrder::linear:
      return {w, u, v, 0, 0, 0, 0, 0, 0, 0};
    case PatchOrder::quadratic:
      return picture::quadratic_basis(w, u, v);
    case PatchOrder::cubic:
      break;
  }
  return picture::cubic_basis(w, u, v);
}

}  // namespace sfumato
