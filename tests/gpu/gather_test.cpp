#include "gather/gather.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "gather/scenes.hpp"
#include "gpu/gather_device.hpp"
#include "gpu/support.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/gpu/gather.hpp"
#include "support/twin_source.hpp"

// The exact gather by compute shaders: point_walk.glsl.
namespace sfumato::gpu {
namespace {

using gather::test::difference;
using gather::test::draw;
using gather::test::Drawing;
using gather::test::random_lines;
using gather::test::random_points;
using test::TwinSource;

/// Returns a device, or a reason to skip.
std::unique_ptr<GatherDevice> device_of(const WalkShape& shape = {},
                                        const GatherFaults& faults = {}) {
  Result<std::unique_ptr<GatherDevice>> device = GatherDevice::create(shape, faults);
  return device ? std::move(*device) : nullptr;
}

#define SFUMATO_NEEDS_COMPUTE()                                                    \
  if (const auto found = GatherDevice::create(); !found) {                         \
    ASSERT_EQ(found.status().code, StatusCode::unavailable);                       \
    GTEST_SKIP() << found.status().message << " (libgl1-mesa-dri is enough here)"; \
  }

std::vector<float> gathered(const Drawing& drawing, const std::vector<Vec2>& points,
                            PointSource* source) {
  ThreadPool pool(2);
  Context context;
  context.executor = &pool;
  context.point_source = source;
  std::vector<float> value = gather_at(context, drawing, points).value;
  EXPECT_EQ(context.budget.used(), 0u);
  return value;
}

Drawing blended(std::uint32_t seed, std::uint32_t shaders) {
  return draw(with_blends(random_lines(seed, 80, 0.1, 0.1), seed, 40, shaders));
}

TEST(GpuGather, has_the_bits_of_the_twin) {
  SFUMATO_NEEDS_COMPUTE();
  const Drawing drawings[] = {draw(random_lines(3, 200, 0.15, 0.1)), blended(5, 0), blended(6, 5)};
  for (const Drawing& drawing : drawings) {
    const std::vector<Vec2> points = random_points(drawing, 5, 3000, 0.05);
    TwinSource<16> twin16;
    TwinSource<8> twin8;
    EXPECT_EQ(gathered(drawing, points, device_of({.stack = 16}).get()),
              gathered(drawing, points, &twin16));
    EXPECT_EQ(gathered(drawing, points, device_of({.stack = 8, .local_size = 32}).get()),
              gathered(drawing, points, &twin8));
  }
}

TEST(GpuGather, is_near_the_packets) {
  SFUMATO_NEEDS_COMPUTE();
  const std::unique_ptr<GatherDevice> device = device_of();
  for (const Drawing& drawing : {draw(random_lines(8, 200, 0.15, 0.1)), blended(9, 5)}) {
    const std::vector<Vec2> points = random_points(drawing, 5, 2000, 0.5);
    const auto d =
        difference(gathered(drawing, points, device.get()), gathered(drawing, points, nullptr));
    EXPECT_LE(d.rms, 2e-3);
    EXPECT_LE(d.largest, 0.05);
  }
}

TEST(GpuGather, without_precise_it_is_right_too) {
  SFUMATO_NEEDS_COMPUTE();
  const std::unique_ptr<GatherDevice> device = device_of({.is_precise = false});
  const Drawing drawing = blended(11, 3);
  const std::vector<Vec2> points = random_points(drawing, 5, 2000, 0.5);
  TwinSource<16> twin;
  const auto d =
      difference(gathered(drawing, points, device.get()), gathered(drawing, points, &twin));
  EXPECT_LE(d.largest, 0.02);
}

TEST(GpuGather, specks_are_an_answer_in_short_batches) {
  SFUMATO_NEEDS_COMPUTE();
  const std::unique_ptr<GatherDevice> device = device_of();
  const Drawing drawing = draw(gather::test::specks(7, 300));
  const std::vector<Vec2> points = random_points(drawing, 5, 1500, 0.05);
  TwinSource<16> twin;
  EXPECT_EQ(gathered(drawing, points, device.get()), gathered(drawing, points, &twin));
}

/// Uses a device even for a few points.
class EvenOfFew : public PointSource {
 public:
  explicit EvenOfFew(PointSource& device) : device_(device) {}

  std::size_t least_points() const override { return 0; }
  Status sum(Context& context, const gather::Scene& scene, std::span<const gather::WalkPoint> point,
             std::span<float> sums) override {
    return device_.sum(context, scene, point, sums);
  }

 private:
  PointSource& device_;
};

// Mesa's llvmpipe ends loops after 65,535 rounds.
TEST(GpuGather, a_walk_that_the_driver_ends_is_left_to_the_packets) {
  SFUMATO_NEEDS_COMPUTE();
  const std::unique_ptr<GatherDevice> device = device_of({.stack = 1});
  EvenOfFew source(*device);
  const Drawing drawing = draw(gather::test::specks(7, 2000));
  const std::vector<Vec2> points = random_points(drawing, 5, 64, 0.05);
  TwinSource<1> twin;
  const auto d = difference(gathered(drawing, points, &source), gathered(drawing, points, &twin));
  EXPECT_GT(twin.most_steps(), 65'535);
  EXPECT_LE(d.largest, 0.5);
}

TEST(GpuGather, thousands_of_shaders_are_an_answer) {
  SFUMATO_NEEDS_COMPUTE();
  const std::unique_ptr<GatherDevice> device = device_of();
  const Drawing drawing = blended(8, 5000);
  const std::vector<Vec2> points = random_points(drawing, 5, 1100, 0.5);
  TwinSource<16> twin;
  EXPECT_EQ(gathered(drawing, points, device.get()), gathered(drawing, points, &twin));
}

TEST(GpuGather, threads_take_turns_and_scenes_do_not_mix) {
  SFUMATO_NEEDS_COMPUTE();
  const std::unique_ptr<GatherDevice> device = device_of();
  std::vector<std::thread> threads;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    threads.emplace_back([&, seed] {
      const Drawing drawing =
          seed % 2 ? blended(seed, seed) : draw(random_lines(seed, 60, 0.1, 0.1));
      const std::vector<Vec2> points = random_points(drawing, seed, 1100, 0.05);
      TwinSource<16> twin;
      EXPECT_EQ(gathered(drawing, points, device.get()), gathered(drawing, points, &twin)) << seed;
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(GpuGather, a_lost_device_leaves_all_to_the_packets) {
  SFUMATO_NEEDS_COMPUTE();
  const Drawing drawing = blended(13, 4);
  const std::vector<Vec2> points = random_points(drawing, 5, 1200, 0.5);
  const std::vector<float> packets = gathered(drawing, points, nullptr);
  const std::unique_ptr<GatherDevice> device = device_of({}, {.lost_after = 1});
  EXPECT_NE(gathered(drawing, points, device.get()), packets);
  EXPECT_EQ(gathered(drawing, points, device.get()), packets);
  EXPECT_TRUE(device->is_lost());
  EXPECT_EQ(device->least_points(), std::numeric_limits<std::size_t>::max());
  EXPECT_EQ(gathered(drawing, points, device.get()), packets);
}

/// In a separate process, before it has a device: checks the message if Mesa offers only OpenGL ES
/// 3.0. Other drivers ignore the variable.
[[noreturn]] void look_in_es_3_0() {
  setenv("MESA_GLES_VERSION_OVERRIDE", "3.0", 1);
  const auto device = GatherDevice::create();
  if (device.ok()) std::exit((*device)->name().find("llvmpipe") == std::string::npos ? 0 : 1);
  if (!Device::create().ok()) std::exit(0);  // there is no driver
  const std::string& message = device.status().message;
  const bool says_so = device.status().code == StatusCode::unavailable &&
                       message.find("no GPU can be used") == 0 &&
                       message.find("OpenGL ES 3.1") != std::string::npos;
  std::exit(says_so ? 0 : 2);
}

TEST(GpuGatherDeathTest, without_compute_shaders_it_is_unavailable) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(look_in_es_3_0(), testing::ExitedWithCode(0), "");
}

TEST(GpuGather, with_too_few_storage_blocks_it_is_unavailable) {
  SFUMATO_NEEDS_COMPUTE();
  for (int blocks : {0, kWalkBlocks - 1}) {
    const auto device = GatherDevice::create({}, {.limits = {.blocks = blocks}});
    ASSERT_FALSE(device.ok()) << blocks;
    EXPECT_EQ(device.status().code, StatusCode::unavailable);
    EXPECT_EQ(device.status().message.find("no GPU can be used"), 0u);
    EXPECT_NE(device.status().message.find("has too few storage blocks"), std::string::npos);
  }
  const Drawing drawing = blended(15, 4);
  const std::vector<Vec2> points = random_points(drawing, 5, 1200, 0.5);
  EXPECT_EQ(gathered(drawing, points, device_of({}, {.limits = {.blocks = kWalkBlocks}}).get()),
            gathered(drawing, points, device_of().get()));
}

TEST(GpuGather, what_no_storage_block_holds_is_left_to_the_packets) {
  SFUMATO_NEEDS_COMPUTE();
  const Drawing drawing = blended(16, 4);
  const std::vector<Vec2> points = random_points(drawing, 5, 1200, 0.5);
  const std::unique_ptr<GatherDevice> device = device_of({}, {.limits = {.block_bytes = 1000}});
  EXPECT_EQ(gathered(drawing, points, device.get()), gathered(drawing, points, nullptr));
  EXPECT_FALSE(device->is_lost());
}

/// Returns the status of gathering 1,200 points on a device.
Status status_of_gather(Context& context) {
  const std::unique_ptr<GatherDevice> device = device_of();
  const Drawing drawing = blended(14, 4);
  const std::vector<Vec2> points = random_points(drawing, 5, 1200, 0.5);
  Context roomy;
  const auto gatherer = gather::Gatherer::create(roomy, drawing.mesh, drawing.attributes);
  if (!gatherer) return gatherer.status();
  std::vector<float> out(points.size() * static_cast<std::size_t>(gatherer->channel_count()));
  context.point_source = device.get();
  return gatherer->gather(context, points, {}, out);
}

TEST(GpuGather, is_cancelled_between_batches) {
  SFUMATO_NEEDS_COMPUTE();
  Context context;
  context.cancel = true;
  EXPECT_EQ(status_of_gather(context).code, StatusCode::cancelled);
  context.cancel = false;
  EXPECT_TRUE(status_of_gather(context).ok());
}

TEST(GpuGather, is_charged_to_the_budget) {
  SFUMATO_NEEDS_COMPUTE();
  Context scarce{.budget = Budget(100'000)};
  EXPECT_EQ(status_of_gather(scarce).code, StatusCode::limit);
  EXPECT_EQ(scarce.budget.used(), 0u);
}

TEST(GpuGather, the_public_object_moves_and_ends) {
  SFUMATO_NEEDS_COMPUTE();
  Result<GpuGather> made = GpuGather::create();
  ASSERT_TRUE(made.ok());
  GpuGather first = std::move(*made);
  EXPECT_FALSE(first.device_name().empty());
  EXPECT_FALSE(first.is_lost());
  GpuGather second;
  EXPECT_EQ(second.source(), nullptr);
  EXPECT_EQ(second.device_name(), "");
  second = std::move(first);
  EXPECT_NE(second.source(), nullptr);
  EXPECT_EQ(first.source(), nullptr);
}

}  // namespace
}  // namespace sfumato::gpu
