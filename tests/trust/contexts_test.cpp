// Contexts that work at the same time do not affect each other. The test also runs under
// ThreadSanitizer (scripts/sanitize).
#include <gtest/gtest.h>

#include <barrier>
#include <string>
#include <thread>
#include <vector>

#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/random_document.hpp"

namespace sfumato::test {
namespace {

constexpr int kRounds = 3;

/// Returns the outputs of a document, one after another; an error's message if one is refused.
std::string outputs_of(Executor* executor, const std::string& text) {
  Context context{.executor = executor};
  const auto read = read_document(context, text, "a.svg");
  if (!read) return to_string(read.status());
  const auto hints = lint(context, read->document);
  const auto picture = diffuse(context, read->document, {});
  if (!hints || !picture) return to_string(picture.status());
  const auto image = rasterize(context, *picture, {.width = 96, .height = 96});
  if (!image) return to_string(image.status());
  std::string all = std::to_string(hints->size());
  for (const auto& file : {encode_png(context, *image), encode_jpeg(context, *image, 80),
                           encode_webp(context, *image, {})}) {
    if (!file) return to_string(file.status());
    all.append(file->begin(), file->end());
  }
  EXPECT_EQ(context.budget.used(), 0u);
  return all;
}

/// Two documents as SVG, and the outputs of each one alone.
class Contexts : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::uint64_t seed : {3, 8}) {
      Context context;
      const auto text = write_svg(context, random_document(seed));
      ASSERT_TRUE(text.ok()) << to_string(text.status());
      texts_.push_back(*text);
      expected_.push_back(outputs_of(nullptr, *text));
      ASSERT_GT(expected_.back().size(), 1000u) << expected_.back();
    }
    ASSERT_NE(expected_[0], expected_[1]);
  }

  /// Expects the same bytes for each document on its own thread and executor, at the same time.
  void expect_the_same_bytes(const std::vector<Executor*>& executors) {
    std::barrier start(static_cast<std::ptrdiff_t>(executors.size()));
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < executors.size(); ++i) {
      threads.emplace_back([&, i] {
        start.arrive_and_wait();
        for (int round = 0; round < kRounds; ++round) {
          EXPECT_TRUE(outputs_of(executors[i], texts_[i % 2]) == expected_[i % 2]) << i;
        }
      });
    }
  }

  std::vector<std::string> texts_;
  std::vector<std::string> expected_;
};

TEST_F(Contexts, with_an_executor_each_give_their_own_bytes) {
  ThreadPool first(2), second(2);
  expect_the_same_bytes({&first, &second});
}

TEST_F(Contexts, that_share_an_executor_give_their_own_bytes) {
  ThreadPool shared(3);
  expect_the_same_bytes({&shared, &shared});
}

TEST_F(Contexts, without_executors_give_their_own_bytes) {
  expect_the_same_bytes({nullptr, nullptr, nullptr});
}

}  // namespace
}  // namespace sfumato::test
