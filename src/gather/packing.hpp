#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/locate.hpp"
#include "gather/scene.hpp"

namespace sfumato::gather {

/// Up to 16 points of a few neighbouring triangles.
struct Packet {
  std::uint32_t first_triangle = 0;  ///< in Packing::triangle
  std::uint8_t triangle_count = 0;
  std::uint8_t lane_count = 0;
};

/// All points of one gather call as packets. The content of a packet depends on the points alone.
struct Packing {
  std::vector<std::uint32_t> point;  ///< indices of the caller's points, by triangle
  std::vector<PacketTriangle> triangle;
  std::vector<Packet> packet;
  TableMemory memory{"packets of points"};
};

/// Fills packets triangle by triangle. A packet that is not full grows breadth-first over edges
/// that rays pass in both directions, to at most kPacketTriangles triangles. Errors: limit.
Result<Packing> pack(Context& context, const Scene& scene, const LocatedPoints& points);

}  // namespace sfumato::gather
