#include "gather/from_source.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "gather/rows/weight_class.hpp"

namespace sfumato::gather {
namespace {

/// The memory for sums of the points of one request to a source; a single point may need more.
constexpr std::size_t kSumBytes = std::size_t{16} << 20;

constexpr std::size_t kSumsPerTask = 4096;

class SourceGather {
 public:
  SourceGather(Context& context, PointSource& source, const Scene& scene, const FreeEnds& ends,
               const PointList& points, const LocatedPoints& located, const Packing& packing,
               const GatherOutput& output)
      : context_(context),
        source_(source),
        scene_(scene),
        ends_(ends),
        points_(points),
        located_(located),
        packing_(packing),
        output_(output),
        channels_(static_cast<std::size_t>(scene.channel_count())),
        stride_(sums_of_point(scene)) {}

  Status run() {
    const std::size_t count = packing_.point.size();
    if (count == 0) return context_.check();
    const std::size_t most =
        std::clamp<std::size_t>(kSumBytes / (stride_ * sizeof(float)), 1, count);
    Status status = memory_.resize(context_, walk_, most);
    if (status) status = memory_.resize(context_, sums_, most * stride_);
    if (status) status = memory_.resize(context_, is_done_, located_.x.size());
    for (std::size_t begin = 0; status && begin < count; begin += most)
      status = gather(std::span(packing_.point).subspan(begin, std::min(most, count - begin)));
    if (status || status.code == StatusCode::unavailable) return gather_rest();
    return status;
  }

 private:
  Status gather(std::span<const std::uint32_t> point) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      walk_[i] = {located_.x[point[i]], located_.y[point[i]],
                  static_cast<std::int32_t>(located_.triangle[point[i]])};
    }
    const std::span<float> sums = std::span(sums_).first(point.size() * stride_);
    SFUMATO_TRY(source_.sum(context_, scene_, std::span(walk_).first(point.size()), sums));
    return parallel_for(context_, point.size(), kSumsPerTask,
                        [&](std::size_t begin, std::size_t end) {
                          for (std::size_t i = begin; i < end; ++i)
                            store(walk_[i], point[i], sums.data() + i * stride_);
                        });
  }

  /// Stores Z / W of eq. 6 with the terms of free ends.
  void store(const WalkPoint& at, std::uint32_t point, const float* sums) {
    if (!(sums[0] >= 0)) return;
    is_done_[point] = 1;
    const std::size_t slot = points_.slot(point);
    const std::span<float> out = output_.out.subspan(slot * channels_, channels_);
    const auto base = static_cast<std::size_t>(scene_.base_channels);
    const auto mean = [&](float sum) { return sums[0] > 0 ? sum / sums[0] : 0.0f; };
    for (std::size_t c = 0; c < base; ++c) out[c] = mean(sums[1 + c]);
    for (std::size_t c = base; c < channels_; ++c)
      out[c] = mean(sums[1 + kValueChannels + (c - base)]);
    const float weight = ends_.add({at.x, at.y}, sums[0], out);
    if (output_.hit.empty()) return;
    output_.hit[slot] = output_.weighs ? weight_class(weight) : weight > 0;
  }

  /// Gathers the packets with points that are not done.
  Status gather_rest() {
    Packing rest;
    for (const Packet& packet : packing_.packet) {
      bool is_done = true;
      for_each_point(packing_, packet, [&](int, std::uint32_t p) { is_done &= is_done_[p] != 0; });
      if (is_done) continue;
      SFUMATO_TRY(rest.memory.push_back(context_, rest.packet, packet));
    }
    if (rest.packet.empty()) return context_.check();
    SFUMATO_TRY(rest.memory.resize(context_, rest.point, packing_.point.size()));
    SFUMATO_TRY(rest.memory.resize(context_, rest.triangle, packing_.triangle.size()));
    std::ranges::copy(packing_.point, rest.point.begin());
    std::ranges::copy(packing_.triangle, rest.triangle.begin());
    return gather_exact(context_, scene_, ends_, points_, located_, rest, output_);
  }

  Context& context_;
  PointSource& source_;
  const Scene& scene_;
  const FreeEnds& ends_;
  const PointList& points_;
  const LocatedPoints& located_;
  const Packing& packing_;
  GatherOutput output_;
  std::size_t channels_;
  std::size_t stride_;
  std::vector<WalkPoint> walk_;
  std::vector<float> sums_;
  std::vector<std::uint8_t> is_done_;  ///< per point
  TableMemory memory_{"points of a GPU's gather"};
};

}  // namespace

Status gather_from(Context& context, PointSource& source, const Scene& scene, const FreeEnds& ends,
                   const PointList& points, const LocatedPoints& located, const Packing& packing,
                   const GatherOutput& output) {
  return SourceGather(context, source, scene, ends, points, located, packing, output).run();
}

}  // namespace sfumato::gather
