#include "gather/exact.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "gather/gather.hpp"
#include "gather/kernels/kernel_entry.hpp"
#include "gather/packet_stack.hpp"
#include "gather/rows/weight_class.hpp"

namespace sfumato::gather {
namespace {

constexpr std::size_t kPacketsPerTask = 4;

/// A packet may walk through every triangle of the mesh, in some 30 ns each: this many between two
/// polls of the cancel flag.
constexpr std::size_t kTrianglesPerPoll = 500'000;

/// One shader's weights of a packet, on a register's boundary.
struct alignas(64) SharesOfPacket {
  float lane[kPacketLanes];
};

class ExactGather {
 public:
  ExactGather(Context& context, const Scene& scene, const FreeEnds& ends, const PointList& points,
              const LocatedPoints& located, const Packing& packing, const GatherOutput& output)
      : context_(context),
        kernel_(packet_kernel(context.simd)),
        scene_(view_of(scene, ends)),
        base_channels_(scene.base_channels),
        channel_count_(static_cast<std::size_t>(scene.channel_count())),
        points_(points),
        located_(located),
        packing_(packing),
        packets_per_poll_(std::clamp<std::size_t>(kTrianglesPerPoll / (scene.triangle.size() + 1),
                                                  1, kPacketsPerTask)),
        output_(output) {}

  Status run() {
    return try_parallel_for(context_, packing_.packet.size(), kPacketsPerTask,
                            [&](std::size_t begin, std::size_t end) { return task(begin, end); });
  }

 private:
  Status task(std::size_t begin, std::size_t end) {
    PacketInput input[kPacketsPerTask];
    PacketResult result[kPacketsPerTask];
    const auto shader_count = static_cast<std::size_t>(scene_.shader_count);
    std::vector<SharesOfPacket> shares(kPacketsPerTask * shader_count);
    for (std::size_t i = begin; i < end; ++i) {
      input[i - begin] = packet_input(packing_, packing_.packet[i], located_);
      result[i - begin].shader_share =
          shares.empty() ? nullptr : shares[(i - begin) * shader_count].lane;
    }
    GrowingStack stack(context_);
    for (std::size_t i = begin; i < end; i += packets_per_poll_) {
      if (context_.cancelled()) return context_.cancel_status();
      const std::size_t count = std::min(packets_per_poll_, end - i);
      SFUMATO_TRY(
          walk({input + (i - begin), result + (i - begin), static_cast<int>(count)}, stack));
    }
    for (std::size_t i = begin; i < end; ++i) store(packing_.packet[i], result[i - begin]);
    return ok_status();
  }

  Status walk(const PacketBatch& batch, GrowingStack& stack) {
    while (!kernel_(scene_, batch, stack.view())) {
      SFUMATO_TRY(stack.grow());
    }
    return ok_status();
  }

  void store(const Packet& packet, const PacketResult& result) {
    for_each_point(packing_, packet, [&](int lane, std::uint32_t point) {
      const std::size_t slot = points_.slot(point);
      float* out = output_.out.data() + slot * channel_count_;
      for (int c = 0; c < base_channels_; ++c) *out++ = result.value[c][lane];
      for (int s = 0; s < scene_.shader_count; ++s) {
        *out++ = result.shader_share[s * kPacketLanes + lane];
      }
      if (output_.hit.empty()) return;
      const float weight = result.weight[lane];
      output_.hit[slot] = output_.weighs ? weight_class(weight) : weight > 0;
    });
  }

  static SceneView view_of(const Scene& scene, const FreeEnds& ends) {
    SceneView view = scene.view();
    view.ends = ends.view();
    return view;
  }

  Context& context_;
  PacketKernel* kernel_;
  SceneView scene_;
  int base_channels_;
  std::size_t channel_count_;
  const PointList& points_;
  const LocatedPoints& located_;
  const Packing& packing_;
  std::size_t packets_per_poll_;
  GatherOutput output_;
};

}  // namespace

Status gather_exact(Context& context, const Scene& scene, const FreeEnds& ends,
                    const PointList& points, const LocatedPoints& located, const Packing& packing,
                    const GatherOutput& output) {
  return ExactGather(context, scene, ends, points, located, packing, output).run();
}

}  // namespace sfumato::gather
