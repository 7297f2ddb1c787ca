#include "gather/scene/packing.hpp"

#include <algorithm>
#include <numeric>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::gather {
namespace {

/// The points of one triangle in Packing::point: those from `next` up to `end` are not packed yet.
struct Run {
  std::uint32_t triangle, next, end;

  bool empty() const { return next == end; }
};

/// One group: the runs of all triangles of the scene, by counting.
class RunsOfScene {
 public:
  Status sort(const Context& context, const std::vector<std::uint32_t>& triangle,
              std::size_t triangle_count, std::span<std::uint32_t> point) {
    RarePoll<65536> poll(context);
    SFUMATO_TRY(memory_.resize(context, runs_, triangle_count));
    for (std::uint32_t t : triangle) {
      if (poll.cancelled()) return context.cancel_status();
      ++runs_[t].end;
    }
    std::uint32_t begin = 0;
    for (std::uint32_t t = 0; t < triangle_count; ++t) {
      const std::uint32_t count = runs_[t].end;
      runs_[t] = {t, begin, begin};
      begin += count;
    }
    for (std::size_t i = 0; i < triangle.size(); ++i) {
      if (poll.cancelled()) return context.cancel_status();
      point[runs_[triangle[i]].end++] = static_cast<std::uint32_t>(i);
    }
    return ok_status();
  }

  std::span<Run> all() { return runs_; }
  Run* find(std::uint32_t triangle) { return &runs_[triangle]; }

 private:
  std::vector<Run> runs_;
  TableMemory memory_{"packets of points"};
};

/// One of many small groups: the runs of its own triangles, by sorting.
class RunsOfGroup {
 public:
  /// Sorts the points [begin, end).
  void sort(const std::vector<std::uint32_t>& triangle, std::uint32_t begin, std::uint32_t end,
            std::span<std::uint32_t> point) {
    const auto group = point.subspan(begin, end - begin);
    std::iota(group.begin(), group.end(), begin);
    std::ranges::sort(group, [&](std::uint32_t a, std::uint32_t b) {
      return triangle[a] != triangle[b] ? triangle[a] < triangle[b] : a < b;
    });
    runs_.clear();
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t t = triangle[point[i]];
      if (runs_.empty() || runs_.back().triangle != t) runs_.push_back({t, i, i});
      runs_.back().end = i + 1;
    }
  }

  std::span<Run> all() { return runs_; }
  Run* find(std::uint32_t triangle) {
    const auto found = std::ranges::lower_bound(runs_, triangle, {}, &Run::triangle);
    return found != runs_.end() && found->triangle == triangle ? &*found : nullptr;
  }

 private:
  std::vector<Run> runs_;
};

/// Packs the points of a group.
template <class Runs>
class Packer {
 public:
  Packer(Context& context, const Scene& scene, Packing& packing)
      : context_(context), poll_(context), scene_(scene), packing_(packing) {}

  Status pack(Runs& runs) {
    for (Run& run : runs.all()) {
      if (poll_.cancelled()) return context_.cancel_status();
      while (!run.empty()) {
        SFUMATO_TRY(packing_.memory.make_room(context_, packing_.triangle, kPacketTriangles));
        SFUMATO_TRY(packing_.memory.make_room(context_, packing_.packet));
        pack_from(run, runs);
      }
    }
    return ok_status();
  }

 private:
  /// Moves points of a triangle into the packet, as many as there is room for.
  void take(Run& run, int parent, int parent_edge, int own_edge) {
    const std::uint32_t room = kPacketLanes - packet_.lane_count;
    const std::uint32_t count = std::min(room, run.end - run.next);
    const auto lane_end = static_cast<std::uint8_t>(packet_.lane_count + count);
    packing_.triangle.push_back(
        {run.triangle, run.next, packet_.lane_count, lane_end, static_cast<std::uint8_t>(parent),
         static_cast<std::uint8_t>(parent_edge), static_cast<std::uint8_t>(own_edge)});
    run.next += count;
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

  void pack_from(Run& run, Runs& runs) {
    packet_ = {static_cast<std::uint32_t>(packing_.triangle.size()), 0, 0};
    take(run, 0, 0, 0);
    for (int i = 0; i < packet_.triangle_count && !full(); ++i) grow_from(i, runs);
    packing_.packet.push_back(packet_);
  }

  void grow_from(int member, Runs& runs) {
    const std::size_t index = packet_.first_triangle + static_cast<std::size_t>(member);
    const SceneTriangle& triangle = scene_.triangle[packing_.triangle[index].triangle];
    for (int k = 0; k < 3 && !full(); ++k) {
      if (triangle.edge[k] < 0) continue;
      const auto twin = static_cast<std::uint32_t>(triangle.twin[k]);
      const std::uint32_t neighbour = twin / 3;
      if (scene_.triangle[neighbour].edge[twin % 3] < 0) continue;
      Run* const run = runs.find(neighbour);
      if (!run || run->empty() || in_packet(neighbour)) continue;
      take(*run, member, k, static_cast<int>(twin % 3));
    }
  }

  Context& context_;
  RarePoll<8192> poll_;
  const Scene& scene_;
  Packing& packing_;
  Packet packet_;
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

Result<Packing> pack(Context& context, const Scene& scene, const LocatedPoints& points,
                     std::span<const std::uint32_t> group_end) {
  Packing packing;
  SFUMATO_TRY(packing.memory.resize(context, packing.point, points.triangle.size()));
  if (group_end.empty()) {
    RunsOfScene runs;
    SFUMATO_TRY(runs.sort(context, points.triangle, scene.triangle.size(), packing.point));
    SFUMATO_TRY(Packer<RunsOfScene>(context, scene, packing).pack(runs));
    return packing;
  }
  RunsOfGroup runs;
  Packer<RunsOfGroup> packer(context, scene, packing);
  std::uint32_t begin = 0;
  for (const std::uint32_t end : group_end) {
    runs.sort(points.triangle, begin, end, packing.point);
    SFUMATO_TRY(packer.pack(runs));
    begin = end;
  }
  return packing;
}

}  // namespace sfumato::gather
