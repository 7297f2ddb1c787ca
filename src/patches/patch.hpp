#pragma once

#include <array>

#include "patches/picture.hpp"

namespace sfumato {

inline constexpr int kNodesPerTriangle = 10;

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

/// The ten basis values at barycentric (w, u, v) of corners 0, 1, 2: eq. 18 (cubic), eq. 17
/// (quadratic, its edge centres taken from the cubic), or barycentric (linear). They sum to 1.
std::array<double, kNodesPerTriangle> patch_basis(PatchOrder order, double w, double u, double v);

}  // namespace sfumato
