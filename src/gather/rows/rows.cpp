#include "gather/rows/rows.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <optional>
#include <utility>

#include "base/limit_error.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "gather/kernels/row_kernel_entry.hpp"
#include "gather/packet_stack.hpp"
#include "gather/point_terms.hpp"
#include "gather/rows/row_sources.hpp"
#include "gather/scene/locate.hpp"
#include "gather/scene/packing.hpp"
#include "gather/scene/scene.hpp"

namespace sfumato::gather {
namespace {

/// Points are packed and gathered in waves of this size, so that few terms wait for sorting.
constexpr std::size_t kPointsPerWave = 16384;
constexpr std::size_t kRowPacketsPerTask = 16;
/// The number of points whose terms are sorted at a time.
constexpr std::size_t kPointsPerCopy = 512;

/// The terms of the points of one packet after another. Errors: limit (memory), cancelled; terms
/// found after an error are dropped.
class PacketTerms {
 public:
  PacketTerms(const Context& context, const Scene& scene, const RowSources& sources,
              float negligible)
      : context_(context),
        poll_(context),
        scene_(scene),
        sources_(sources),
        negligible_(negligible),
        lane_(kPacketLanes, PointTerms(sources)) {}

  /// points   in double precision, one for each lane
  void begin(const std::array<Vec2, kPacketLanes>& points) {
    for (std::size_t i = 0; i < kPacketLanes; ++i) lane_[i].begin(points[i]);
  }

  PointTerms& lane(int i) { return lane_[static_cast<std::size_t>(i)]; }

  /// Returns the taker. Call it after begin() and before lane().
  RowTaker taker() {
    const auto take = [](void* self, const RowView* view, int count) {
      static_cast<PacketTerms*>(self)->take({view, static_cast<std::size_t>(count)});
    };
    return {this, take, negligible_};
  }

  const Status& status() const { return status_; }

 private:
  void take(std::span<const RowView> views) {
    if (status_ && poll_.cancelled()) status_ = context_.cancel_status();
    if (!status_) return;
    for (const RowView& view : views) add(view);
    status_ = memory_.settle(context_, capacity_bytes(), known_bytes_);
  }

  std::size_t capacity_bytes() const {
    std::size_t bytes = 0;
    for (const PointTerms& terms : lane_) bytes += terms.capacity_bytes();
    return bytes;
  }

  void add(const RowView& view) {
    const double k = scene_.hit_edge[view.hit].weight;
    const RowSource& source = sources_.source[view.hit];
    const bool varies = source.blur_from != source.blur_to && source.back.has_value;
    for (std::uint32_t lanes = view.lanes; lanes != 0; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      const double weight = k * view.weight[i];
      const PartMoment part{weight, 0.5 * (weight + k * view.lean[i])};
      PointTerms& terms = lane(view.first_lane + i);
      if (varies) {
        terms.add_varied(view.hit, k, view.from[i], view.to[i], part);
      } else {
        terms.add(view.hit, part);
      }
    }
  }

  const Context& context_;
  RarePoll<64> poll_;
  const Scene& scene_;
  const RowSources& sources_;
  float negligible_;
  std::vector<PointTerms> lane_;
  std::size_t known_bytes_ = 0;
  Status status_;
  TableMemory memory_{"rows of the gather"};
};

class RowGather {
 public:
  RowGather(Context& context, const mesh::TriangleMesh& mesh, std::span<const Vec2> points,
            const RowOptions& options)
      : context_(context),
        kernel_(row_kernel(context.simd)),
        mesh_(mesh),
        points_(points),
        options_(options) {}

  Result<Rows> run(const curves::SegmentAttributes& places) {
    SFUMATO_TRY(prepare(places));
    for (std::size_t i = 0; i < points_.size(); i += kPointsPerWave)
      SFUMATO_TRY(add_wave(points_.subspan(i, std::min(kPointsPerWave, points_.size() - i))));
    rows_.source = std::move(sources_.source);
    sources_.memory.free(sources_.edge);
    rows_.memory.take(std::move(sources_.memory));
    return std::move(rows_);
  }

 private:
  /// The results of a task.
  struct Found {
    std::vector<RowTerm> term;
    std::size_t known_bytes = 0;
    TableMemory memory{"rows of the gather"};
  };
  /// The place of the terms of a point among the results.
  struct Place {
    std::uint32_t task = 0, begin = 0, end = 0;
  };
  /// Points that are gathered together.
  struct Wave {
    std::span<const Vec2> points;
    const LocatedPoints& located;
    const Packing& packing;
  };

  Status prepare(const curves::SegmentAttributes& places) {
    SFUMATO_TRY_ASSIGN(scene_, build_scene(context_, mesh_, places));
    view_ = scene_.view();
    SFUMATO_TRY_ASSIGN(sources_,
                       find_row_sources(context_, mesh_, places, scene_, options_.values));
    if (!scene_.triangle.empty()) {
      SFUMATO_TRY_ASSIGN(auto&& locator, Locator::create(context_, scene_));
      locator_.emplace(std::move(locator));
    }
    SFUMATO_TRY(rows_.memory.reserve(context_, rows_.begin, points_.size() + 1));
    rows_.begin.push_back(0);
    return ok_status();
  }

  Status add_wave(std::span<const Vec2> points) {
    if (!locator_) {
      rows_.begin.resize(rows_.begin.size() + points.size(), 0);
      return context_.check();
    }
    SFUMATO_TRY_ASSIGN(const LocatedPoints& located, locator_->locate(context_, points));
    SFUMATO_TRY_ASSIGN(const Packing& packing, pack(context_, scene_, located));
    const Wave wave{points, located, packing};
    const std::size_t packets = packing.packet.size();
    const std::size_t tasks = (packets + kRowPacketsPerTask - 1) / kRowPacketsPerTask;
    if (found_.size() < tasks) found_.resize(tasks);
    SFUMATO_TRY(memory_.resize(context_, place_, points.size()));
    Status status = try_parallel_for(
        context_, packets, kRowPacketsPerTask, [&](std::size_t begin, std::size_t end) {
          return gather(wave, begin, end, static_cast<std::uint32_t>(begin / kRowPacketsPerTask));
        });
    return status ? append(points.size()) : status;
  }

  /// Does one task: packets [begin, end).
  Status gather(const Wave& wave, std::size_t begin, std::size_t end, std::uint32_t task) {
    GrowingStack stack(context_);
    PacketTerms terms(context_, scene_, sources_, options_.negligible);
    Found& found = found_[task];
    found.term.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const Packet& packet = wave.packing.packet[i];
      Status status = walk(wave, packet, stack, terms);
      for_each_point(wave.packing, packet, [&](int lane, std::uint32_t point) {
        if (status) status = store(wave, point, terms.lane(lane), found);
        if (status) place_[point].task = task;
      });
      if (!status) return status;
    }
    return ok_status();
  }

  Status walk(const Wave& wave, const Packet& packet, GrowingStack& stack,
              PacketTerms& terms) const {
    std::array<Vec2, kPacketLanes> points{};
    for_each_point(wave.packing, packet, [&](int lane, std::uint32_t point) {
      points[static_cast<std::size_t>(lane)] = wave.points[point];
    });
    const PacketInput input = packet_input(wave.packing, packet, wave.located);
    for (;;) {
      terms.begin(points);
      if (kernel_(view_, input, terms.taker(), stack.view())) return terms.status();
      SFUMATO_TRY(stack.grow());
    }
  }

  Status store(const Wave& wave, std::uint32_t point, PointTerms& terms, Found& found) {
    if (context_.cancelled()) return context_.cancel_status();
    place_[point].begin = static_cast<std::uint32_t>(found.term.size());
    if (is_inside(wave, point)) {
      terms.add_ends();
      terms.store(options_.negligible, found.term);
    }
    place_[point].end = static_cast<std::uint32_t>(found.term.size());
    return found.memory.settle(context_, capacity_bytes(found.term), found.known_bytes);
  }

  /// Returns whether a point is inside. A point outside has a triangle at the hull, which is
  /// convex.
  bool is_inside(const Wave& wave, std::uint32_t point) const {
    const std::uint32_t t = wave.located.triangle[point];
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (scene_.triangle[t].twin[k] >= 0) continue;
      const std::uint32_t h = 3 * scene_.source[t] + k;
      const Vec2 a = mesh_.vertex_position[mesh_.origin(h)];
      if (cross(mesh_.vertex_position[mesh_.target(h)] - a, wave.points[point] - a) < 0)
        return false;
    }
    return true;
  }

  /// Appends the terms of the next points, in their order.
  Status append(std::size_t points) {
    const std::size_t first = rows_.begin.size() - 1;
    std::size_t count = rows_.term.size();
    for (const Place& place : place_) {
      count += place.end - place.begin;
      rows_.begin.push_back(static_cast<std::uint32_t>(count));
    }
    if (count > std::numeric_limits<std::uint32_t>::max()) {
      return make_limit_error("memory", "rows have too many terms: 4 billion are the most");
    }
    SFUMATO_TRY(make_room(count, first + points));
    rows_.term.resize(count);
    return parallel_for(context_, points, kPointsPerCopy, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Place& place = place_[i];
        const RowTerm* const from = found_[place.task].term.data();
        std::copy(from + place.begin, from + place.end, rows_.term.data() + rows_.begin[first + i]);
      }
    });
  }

  /// Makes room for these terms of these points, and for the remaining points if these have as many
  /// each: a table that grows is twice in memory.
  Status make_room(std::size_t count, std::size_t points) {
    if (count <= rows_.term.capacity()) return ok_status();
    const double expected = 1.05 * static_cast<double>(count) *
                            (static_cast<double>(points_.size()) / static_cast<double>(points));
    if (rows_.memory.reserve(context_, rows_.term, static_cast<std::size_t>(expected)))
      return ok_status();
    return rows_.memory.reserve(context_, rows_.term, count);
  }

  Context& context_;
  RowKernel* kernel_;
  const mesh::TriangleMesh& mesh_;
  std::span<const Vec2> points_;
  RowOptions options_;
  Scene scene_;
  SceneView view_{};
  RowSources sources_;
  std::optional<Locator> locator_;  ///< empty where the mesh has no triangle
  std::vector<Found> found_;        ///< per task of a wave
  std::vector<Place> place_;        ///< per point of a wave
  Rows rows_;
  TableMemory memory_{"rows of the gather"};
};

}  // namespace

Result<Rows> gather_rows(Context& context, const mesh::TriangleMesh& mesh,
                         const curves::SegmentAttributes& places, std::span<const Vec2> points,
                         const RowOptions& options) {
  if (points.size() > context.limits.nodes) {
    return limit_error(context.limits, &Limits::nodes, "points to gather at");
  }
  return RowGather(context, mesh, points, options).run(places);
}

}  // namespace sfumato::gather
