// The library on threads of 256 KiB: the calling thread and the threads of the pool.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <pthread.h>

#include <functional>
#include <string>

#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/random_document.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::test {
namespace {

constexpr std::size_t kStackBytes = std::size_t{256} << 10;

void* call(void* body) {
  (*static_cast<std::function<void()>*>(body))();
  return nullptr;
}

/// Runs body on a thread with a small stack.
void run_on_small_stack(std::function<void()> body) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, kStackBytes), 0);
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, call, &body), 0);
  pthread_attr_destroy(&attributes);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
}

void draw(Executor* executor, std::uint64_t seed) {
  Context context{.executor = executor};
  const auto text = write_svg(context, random_document(seed));
  ASSERT_TRUE(text.ok()) << to_string(text.status());
  const auto read = read_document(context, *text, "a.svg");
  ASSERT_TRUE(read.ok()) << to_string(read.status());
  const auto picture = diffuse(context, read->document, {});
  ASSERT_TRUE(picture.ok()) << to_string(picture.status());
  const auto image = rasterize(context, *picture, {.width = 200, .height = 200});
  ASSERT_TRUE(image.ok()) << to_string(image.status());
  EXPECT_TRUE(encode_png(context, *image).ok());
  EXPECT_TRUE(export_pdf(context, *picture, {}).ok());
}

TEST(SmallStack, of_the_calling_thread_is_enough) {
  if (SFUMATO_HAS_SANITIZER) GTEST_SKIP() << "sanitizers make frames larger";
  for (const std::uint64_t seed : {1, 2, 3, 4}) run_on_small_stack([=] { draw(nullptr, seed); });
}

TEST(SmallStack, of_the_pools_threads_is_enough) {
  if (SFUMATO_HAS_SANITIZER) GTEST_SKIP() << "sanitizers make frames larger";
  // Must come before the process's first pool; ctest runs each test in a separate process.
  const tbb::global_control small(tbb::global_control::thread_stack_size, kStackBytes);
  ThreadPool executor(4);
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    run_on_small_stack([&] { draw(&executor, seed); });
  }
}

}  // namespace
}  // namespace sfumato::test
