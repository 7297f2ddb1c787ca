#include "gpu/device.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "gpu/table.hpp"
#include "raster/pictures.hpp"
#include "support.hpp"

namespace sfumato::gpu {
namespace {

const Box kSmallBox{{0, 0}, {16, 16}};

Picture red_picture() {
  return test::make_picture(test::flat_layer(kSmallBox, {1, 0, 0}));
}

TEST(GpuDevice, has_a_name) {
  SFUMATO_NEEDS_GPU();
  const Result<std::string> name = gpu_name();
  ASSERT_TRUE(name.ok());
  EXPECT_FALSE(name->empty());
}

TEST(GpuDevice, of_two_the_older_is_current_again_when_the_other_is_gone) {
  SFUMATO_NEEDS_GPU();
  const auto older = Device::create();
  ASSERT_TRUE(older.ok());
  const GlObject texture = make_texture();
  {
    const auto younger = Device::create();
    ASSERT_TRUE(younger.ok());
  }
  EXPECT_NE(glGetString(GL_RENDERER), nullptr);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(GpuDevice, renders_twice_and_in_two_threads_alike) {
  SFUMATO_NEEDS_GPU();
  const Picture picture = red_picture();
  const RasterOptions options = test::image_size(16, 16, PixelFormat::rgb8);
  const Image first = test::on_gpu(picture, options);
  EXPECT_EQ(test::on_gpu(picture, options).bytes, first.bytes);
  std::vector<Image> images(2);
  std::vector<std::thread> threads;
  for (Image& image : images) threads.emplace_back([&] { image = test::on_gpu(picture, options); });
  for (std::thread& thread : threads) thread.join();
  for (const Image& image : images) EXPECT_EQ(image.bytes, first.bytes);
}

TEST(GpuDevice, a_table_larger_than_its_textures_is_a_limit) {
  SFUMATO_NEEDS_GPU();
  const auto device = Device::create();
  Context context;
  const std::size_t most = kTableWidth * static_cast<std::size_t>((*device)->largest_side());
  const Result<Table> table = Table::create(context, **device, kFlagTable, most + 1, "a layer");
  ASSERT_FALSE(table.ok());
  EXPECT_EQ(table.status().code, StatusCode::limit);
  EXPECT_NE(table.status().message.find("a layer"), std::string::npos);
}

TEST(GpuDevice, memory_is_charged_and_given_back) {
  SFUMATO_NEEDS_GPU();
  const RasterOptions options = test::image_size(16, 16, PixelFormat::rgb8);
  std::size_t budget = 100;
  for (bool is_enough = false; !is_enough; budget *= 2) {
    ASSERT_LT(budget, std::size_t{1} << 30);
    Context context{.budget = Budget(budget)};
    const Result<Image> image = render_on_gpu(context, red_picture(), options);
    is_enough = image.ok();
    EXPECT_EQ(image.status().code, is_enough ? StatusCode::ok : StatusCode::limit);
    EXPECT_EQ(context.budget.used(), 0u);
  }
  EXPECT_GT(budget, 100'000u);
}

TEST(GpuDevice, a_cancelled_rendering_says_so) {
  SFUMATO_NEEDS_GPU();
  Context context;
  context.cancel = true;
  const Result<Image> image =
      render_on_gpu(context, red_picture(), test::image_size(16, 16, PixelFormat::rgb8));
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.status().code, StatusCode::cancelled);
}

TEST(GpuDevice, bad_sizes_and_pictures_are_refused_before_anything_is_done) {
  Context context;
  const Result<Image> none = render_on_gpu(context, red_picture(), test::image_size(0, 4));
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.status().code, StatusCode::bad_input);
  Picture broken = red_picture();
  broken.layers[0].triangle_vertex[0] = 1000;
  const Result<Image> image = render_on_gpu(context, broken, test::image_size(4, 4));
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.status().code, StatusCode::bad_input);
}

/// In a separate process: exits according to whether there is a GPU when EGL finds no driver.
[[noreturn]] void look_without_drivers() {
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);
  const auto device = Device::create();
  const bool says_so = !device.ok() && device.status().code == StatusCode::unavailable &&
                       device.status().message.find("no GPU can be used") == 0;
  std::exit(says_so ? 0 : 1);
}

TEST(GpuDeviceDeathTest, without_a_driver_it_is_unavailable) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(look_without_drivers(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace sfumato::gpu
