#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// The edges with curves at a vertex of a mesh.
struct Meeting {
  std::uint32_t edges = 0;
  std::uint32_t half_edge = 0;  ///< one of them, out of the vertex
};

/// Finds one for each vertex. Errors: limit (memory), cancelled.
Status find_meetings(const Context& context, const mesh::TriangleMesh& mesh, TableMemory& memory,
                     std::vector<Meeting>& meetings);

/// Curves that leave a vertex on four edges, in their order around it. Where several lie on an edge
/// the one that was drawn last counts.
struct Cross {
  struct Strand {
    std::uint32_t half_edge = 0;  ///< out of the vertex
    std::uint32_t curve = 0;
  };
  std::array<Strand, 4> strand;

  /// Returns whether one curve passes through another.
  bool is_of_two_curves() const {
    return strand[0].curve == strand[2].curve && strand[1].curve == strand[3].curve &&
           strand[0].curve != strand[1].curve;
  }
  bool is_of_one_curve() const {
    for (const Strand& other : strand) {
      if (other.curve != strand[0].curve) return false;
    }
    return true;
  }
};

/// Returns the last drawn curve on a half-edge. Precondition: it has curves.
std::uint32_t curve_on(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                       std::uint32_t half_edge);

/// Returns the cross; nullopt: there are not four edges with curves, or the vertex lies on the
/// mesh's border.
std::optional<Cross> cross_at(const mesh::TriangleMesh& mesh,
                              const curves::SegmentAttributes& attributes, const Meeting& meeting);

/// Returns whether colours differ by more in a channel, as sRGB code values.
bool differ(const curves::SegmentAttributes& attributes, const curves::FieldValue& a,
            const curves::FieldValue& b, float by);

/// Returns whether in one of the four corners two colours face each other that differ by more.
bool clashes(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
             const Cross& cross, float by);

}  // namespace sfumato::gather
