#include "gather/scene/packing.hpp"

#include <algorithm>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::gather {
namespace {

class Packer {
 public:
  Packer(Context& context, const Scene& scene, const LocatedPoints& points, Packing& packing)
      : context_(context), poll_(context), scene_(scene), points_(points), packing_(packing) {}

  Status pack() {
    SFUMATO_TRY(sort_by_triangle(points_.triangle));
    for (std::uint32_t t = 0; t < scene_.triangle.size(); ++t) {
      if (poll_.cancelled()) return context_.cancel_status();
      while (next_[t] < end_of(t)) {
        SFUMATO_TRY(packing_.memory.make_room(context_, packing_.triangle, kPacketTriangles));
        SFUMATO_TRY(packing_.memory.make_room(context_, packing_.packet));
        pack_from(t);
      }
    }
    return ok_status();
  }

 private:
  Status sort_by_triangle(const std::vector<std::uint32_t>& triangle) {
    RarePoll<65536> poll(context_);
    SFUMATO_TRY(memory_.resize(context_, begin_, scene_.triangle.size() + 1));
    SFUMATO_TRY(memory_.resize(context_, next_, scene_.triangle.size()));
    SFUMATO_TRY(packing_.memory.resize(context_, packing_.point, triangle.size()));
    for (std::uint32_t t : triangle) {
      if (poll.cancelled()) return context_.cancel_status();
      ++begin_[t + 1];
    }
    for (std::size_t t = 1; t < begin_.size(); ++t) begin_[t] += begin_[t - 1];
    next_.assign(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < triangle.size(); ++i) {
      if (poll.cancelled()) return context_.cancel_status();
      packing_.point[next_[triangle[i]]++] = static_cast<std::uint32_t>(i);
    }
    next_.assign(begin_.begin(), begin_.end() - 1);
    return ok_status();
  }

  std::uint32_t end_of(std::uint32_t t) const { return begin_[t + 1]; }

  /// Moves points of triangle t into the packet, as many as there is room for.
  void take(std::uint32_t t, int parent, int parent_edge, int own_edge) {
    const std::uint32_t room = kPacketLanes - packet_.lane_count;
    const std::uint32_t count = std::min(room, end_of(t) - next_[t]);
    const auto lane_end = static_cast<std::uint8_t>(packet_.lane_count + count);
    packing_.triangle.push_back(
        {t, next_[t], packet_.lane_count, lane_end, static_cast<std::uint8_t>(parent),
         static_cast<std::uint8_t>(parent_edge), static_cast<std::uint8_t>(own_edge)});
    next_[t] += count;
    packet_.lane_count = lane_end;
    ++packet_.triangle_count;
  }

  bool full() const {
    return packet_.lane_count == kPacketLanes || packet_.triangle_count == kPacketTriangles;
  }

  bool in_packet(std::uint32_t t) const {
    const auto first = packing_.triangle.begin() + packet_.first_triangle;
    return std::any_of(first, packing_.triangle.end(),
                       [t](const PacketTriangle& other) { return other.triangle == t; });
  }

  void pack_from(std::uint32_t t) {
    packet_ = {static_cast<std::uint32_t>(packing_.triangle.size()), 0, 0};
    take(t, 0, 0, 0);
    for (int i = 0; i < packet_.triangle_count && !full(); ++i) grow_from(i);
    packing_.packet.push_back(packet_);
  }

  void grow_from(int member) {
    const std::size_t index = packet_.first_triangle + static_cast<std::size_t>(member);
    const SceneTriangle& triangle = scene_.triangle[packing_.triangle[index].triangle];
    for (int k = 0; k < 3 && !full(); ++k) {
      if (triangle.edge[k] < 0) continue;
      const auto twin = static_cast<std::uint32_t>(triangle.twin[k]);
      const std::uint32_t neighbour = twin / 3;
      if (scene_.triangle[neighbour].edge[twin % 3] < 0) continue;
      if (next_[neighbour] == end_of(neighbour) || in_packet(neighbour)) continue;
      take(neighbour, member, k, static_cast<int>(twin % 3));
    }
  }

  Context& context_;
  RarePoll<8192> poll_;
  const Scene& scene_;
  const LocatedPoints& points_;
  Packing& packing_;
  Packet packet_;
  std::vector<std::uint32_t> begin_;  ///< first sorted point of each triangle
  std::vector<std::uint32_t> next_;   ///< first that is not packed yet
  TableMemory memory_{"packets of points"};
};

}  // namespace

PacketInput packet_input(const Packing& packing, const Packet& packet,
                         const LocatedPoints& points) {
  PacketInput input;
  input.triangle = packing.triangle.data() + packet.first_triangle;
  input.triangle_count = packet.triangle_count;
  int lane = 0;
  for_each_point(packing, packet, [&](int used_lane, std::uint32_t point) {
    input.x[used_lane] = points.x[point];
    input.y[used_lane] = points.y[point];
    lane = used_lane;
  });
  for (int i = lane + 1; i < kPacketLanes; ++i) {
    input.x[i] = input.x[lane];
    input.y[i] = input.y[lane];
  }
  return input;
}

Result<Packing> pack(Context& context, const Scene& scene, const LocatedPoints& points) {
  Packing packing;
  SFUMATO_TRY(Packer(context, scene, points, packing).pack());
  return packing;
}

}  // namespace sfumato::gather
