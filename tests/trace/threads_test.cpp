// The same picture gives the same bytes for all thread counts and instruction sets.
#include <gtest/gtest.h>

#include <string>

#include "sfumato/base/native/thread_pool.hpp"
#include "support/flat_art.hpp"
#include "support/synthetic_photo.hpp"
#include "trace/tracing.hpp"

namespace sfumato {
namespace {

void expect_same_bytes(const Image& picture, const TraceOptions& options) {
  const std::string expected = test::svg_of(test::trace_of(picture, options));
  for (const int threads : {1, 2, 3, 8}) {
    ThreadPool pool(threads);
    for (const SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) continue;
      // Each level with one number of threads, and each number of threads with one level.
      if (threads != 1 && level != detected_simd_level()) continue;
      Context context{.executor = &pool};
      context.simd = level;
      const Result<Document> drawing = trace(context, picture, options);
      ASSERT_TRUE(drawing.ok()) << to_string(drawing.status());
      EXPECT_TRUE(test::svg_of(*drawing) == expected)
          << threads << " threads, level " << static_cast<int>(level);
      EXPECT_EQ(context.budget.used(), 0u);
    }
  }
}

TEST(TraceThreads, give_a_photo_the_same_bytes) {
  expect_same_bytes(test::synthetic_photo(120), {});
}

TEST(TraceThreads, give_a_transparent_picture_the_same_bytes) {
  Context context;
  const Result<Image> picture = test::flat_picture(context, "gear", false, 0.5);
  ASSERT_TRUE(picture.ok());
  expect_same_bytes(*picture, {.stops = TraceStops::few});
}

TEST(TraceThreads, give_another_choice_of_pixels_for_another_seed) {
  const Image photo = test::synthetic_photo(320);  // more pixels than are fitted between rounds
  const TraceOptions draft{.points = 200, .edges_only = true};
  TraceOptions other = draft;
  other.seed = 1;
  const std::string text = test::svg_of(test::trace_of(photo, draft));
  EXPECT_EQ(test::svg_of(test::trace_of(photo, draft)), text);
  EXPECT_NE(test::svg_of(test::trace_of(photo, other)), text);
}

}  // namespace
}  // namespace sfumato
