#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/picture/picture.hpp"
#include "solve/fields/nodes.hpp"

namespace sfumato::solve {

/// Points at which patches are compared with the exact gather: three inside each triangle, and the
/// centre of each edge, once for both its triangles. Edges on curves have none, since the patch is
/// exact there.
struct ProbeSet {
  std::vector<Vec2> position;            ///< layer frame
  std::vector<std::uint32_t> half_edge;  ///< inside triangle h / 3; see `place`
  std::vector<std::uint8_t> place;       ///< 0 to 2: inside, near that corner; kEdgePlace
  TableMemory memory{"probes of patches"};
};
inline constexpr std::uint8_t kEdgePlace = 3;  ///< the centre of the edge

/// Some of a triangle's probes. Bit k: the one near corner k; bit kEdgePlace: the probes of its
/// edges.
using ProbeChoice = std::uint8_t;
inline constexpr ProbeChoice kInnerProbes = 0b0111;
inline constexpr ProbeChoice kAllProbes = 0b1111;

/// Places probes of some triangles, ascending, with the choice for each. Errors: limit (memory),
/// cancelled.
Result<ProbeSet> place_probes(const Context& context, const mesh::TriangleMesh& mesh,
                              const NodeLayout& layout, std::span<const std::uint32_t> triangles,
                              std::span<const ProbeChoice> choice);

/// Factors of the prediction of a patch's error.
struct MissFactors {
  /// Measured on four drawings: the error of 99% of patches is less than three times the difference
  /// between the cubic and the quadratic through the same nodes, at the inner probes.
  float per_cubic_part = 5;
  /// A blur's profile has a break at its radius R: a patch 1.44 R deep has nodes that fit a
  /// quadratic, and is off by up to a 24th of their range between them.
  float per_range = 1.0f / 24;
};

/// Factors for a picture for a pixel grid. One in 300 patches with a prediction below the limit
/// misses. They save a third of lady_bug's probes. The share of smooth pixels with an error above
/// one code value grows by 0.003% of the pixels.
inline constexpr MissFactors kGridMissFactors{1.8f, 0.015f};

/// Predicts from its nodes alone an upper bound of the error of triangle t's cubic patch at its
/// probes; with the default factors it holds for 99% of patches. Writes layout.channel_count
/// floats. Returns the probes where it is likely to be largest: one, or the inner ones where
/// nothing distinguishes them.
ProbeChoice foretell_miss(const NodeLayout& layout, std::uint32_t t, const MissFactors& factors,
                          float* miss);

/// Computes the patch's value at probe i, layout.channel_count floats.
void patch_value_at_probe(const ProbeSet& probes, std::size_t i, const NodeLayout& layout,
                          PatchOrder order, float* value);

}  // namespace sfumato::solve
