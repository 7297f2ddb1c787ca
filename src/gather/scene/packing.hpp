#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/scene/locate.hpp"
#include "gather/scene/scene.hpp"

namespace sfumato::gather {

/// Up to 16 points of a few neighbouring triangles.
struct Packet {
  std::uint32_t first_triangle = 0;  ///< in Packing::triangle
  std::uint8_t triangle_count = 0;
  std::uint8_t lane_count = 0;
};

/// All points of one gather call as packets. The content of a packet depends only on the points of
/// its group.
struct Packing {
  std::vector<std::uint32_t> point;  ///< indices of the caller's points, by group and triangle
  std::vector<PacketTriangle> triangle;
  std::vector<Packet> packet;
  TableMemory memory{"packets of points"};
};

/// Calls body(lane, index of the point) for the used lanes of a packet.
template <class Body>
void for_each_point(const Packing& packing, const Packet& packet, Body body) {
  for (int i = 0; i < packet.triangle_count; ++i) {
    const PacketTriangle& t = packing.triangle[packet.first_triangle + static_cast<std::size_t>(i)];
    for (int lane = t.lane_begin; lane < t.lane_end; ++lane) {
      body(lane, packing.point[t.first_point + static_cast<std::uint32_t>(lane - t.lane_begin)]);
    }
  }
}

/// Returns a packet in the layout of the kernels, valid while `packing` lives.
PacketInput packet_input(const Packing& packing, const Packet& packet, const LocatedPoints& points);

/// Fills packets triangle by triangle. A packet that is not full grows breadth-first over edges
/// that rays pass in both directions, to at most kPacketTriangles triangles. A packet has points of
/// one group: PointList::group_end(). Errors: limit, cancelled.
Result<Packing> pack(Context& context, const Scene& scene, const LocatedPoints& points,
                     std::span<const std::uint32_t> group_end = {});

}  // namespace sfumato::gather
