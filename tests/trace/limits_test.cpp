// A trace that is cancelled or runs out of memory ends cleanly.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "support/cancel_at.hpp"
#include "support/flat_art.hpp"
#include "support/poll_gap.hpp"
#include "support/synthetic_photo.hpp"
#include "trace/curves/candidates.hpp"
#include "trace/curves/snap.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/planes_of.hpp"
#include "trace/tracing.hpp"

namespace sfumato {
namespace {

/// Records the places in the code that poll the flag, and their polls.
class PollPlaces : public PollWatch {
 public:
  bool wants_every_turn() const override { return true; }
  void polled() override {
    std::uint64_t& polls = places_[__builtin_return_address(0)];
    ++polls_;
    if (std::has_single_bit(++polls) && std::countr_zero(polls) % 4 == 0) chosen_.insert(polls_);
  }

  /// Returns, for each place, the first poll, the 16th, the 256th and so on, and some evenly spread
  /// ones.
  std::set<std::uint64_t> chosen() const {
    std::set<std::uint64_t> polls = chosen_;
    constexpr std::uint64_t kSpread = 20;
    for (std::uint64_t i = 1; i <= kSpread; ++i) polls.insert(1 + (polls_ - 1) * i / kSpread);
    return polls;
  }

 private:
  std::map<const void*, std::uint64_t> places_;
  std::set<std::uint64_t> chosen_;
  std::uint64_t polls_ = 0;
};

TEST(TraceLimits, each_poll_can_cancel) {
  Context plain;
  const Result<Image> picture = test::flat_picture(plain, "gear", false, 0.15);
  ASSERT_TRUE(picture.ok());
  Context context;
  PollPlaces places;
  context.poll_watch = &places;
  ASSERT_TRUE(trace(context, *picture, {.points = 100}).ok());
  const std::set<std::uint64_t> chosen = places.chosen();
  EXPECT_GT(chosen.size(), 20u);
  for (const std::uint64_t poll : chosen) {
    Context cancelled;
    CancelFlag& flag = cancelled.cancel;
    test::CancelAt watch(poll, flag);
    cancelled.poll_watch = &watch;
    EXPECT_EQ(trace(cancelled, *picture, {.points = 100}).status().code, StatusCode::cancelled)
        << "poll " << poll;
    EXPECT_EQ(cancelled.budget.used(), 0u) << "poll " << poll;
  }
}

TEST(TraceLimits, it_looks_at_the_flag_often) {
  const Image photo = test::synthetic_photo(640);
  test::expect_short_gaps("trace", [&photo] {
    Context context;
    test::PollRecorder recorder;
    context.poll_watch = &recorder;
    recorder.start();
    EXPECT_TRUE(trace(context, photo, {.points = 500}).ok());
    recorder.stop();
    return recorder.longest_seconds();
  });
}

/// Returns a gray picture of value(x, y).
template <class Value>
Image gray(int side, const Value& value) {
  Image image{side, side, PixelFormat::rgb8, {}};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(value(x, y)));
    }
  }
  return image;
}

/// Returns a picture with the largest possible number of chains and curves.
Image noise(int side) {
  std::uint32_t state = 1;
  return gray(side, [&state](int, int) {
    state = state * 1'664'525 + 1'013'904'223;
    return state >> 24;
  });
}
Image checkers(int side) {
  return gray(side, [](int x, int y) { return (x / 4 + y / 4) % 2 == 0 ? 255 : 0; });
}

/// Returns CPU seconds from the flag, which is set at a poll, to the return, which frees all
/// memory.
double seconds_to_end(const Image& picture, const TraceOptions& options, std::uint64_t poll) {
  Context context;
  test::PollRecorder recorder;
  recorder.cancel = &context.cancel;
  recorder.cancel_at = poll;
  context.poll_watch = &recorder;
  recorder.start();
  EXPECT_EQ(trace(context, picture, options).status().code, StatusCode::cancelled) << poll;
  return test::thread_seconds() - recorder.cancelled_at();
}

TEST(TraceLimits, it_ends_soon_once_it_is_cancelled_and_all_is_freed) {
  const Image picture = noise(250);
  const TraceOptions draft{.edges_only = true};
  test::PollRecorder all;
  Context context;
  context.poll_watch = &all;
  ASSERT_TRUE(trace(context, picture, draft).ok());
  constexpr std::uint64_t kTries = 6;
  for (std::uint64_t i = 1; i < kTries; ++i) {
    test::expect_short_gaps(
        "trace of noise", [&] { return seconds_to_end(picture, draft, all.polls() * i / kTries); });
  }
}

TEST(TraceLimits, little_memory_is_a_limit_or_enough) {
  for (const Image& picture : {test::synthetic_photo(160), noise(48), checkers(48)}) {
    bool was_refused = false, was_enough = false;
    for (std::size_t mebibytes = 1; mebibytes <= 256; mebibytes *= 2) {
      Context context{.budget = Budget(mebibytes << 20)};
      const StatusCode code = trace(context, picture).status().code;
      EXPECT_TRUE(code == StatusCode::ok || code == StatusCode::limit) << mebibytes;
      EXPECT_FALSE(was_enough && code != StatusCode::ok) << mebibytes;
      (code == StatusCode::ok ? was_enough : was_refused) = true;
      EXPECT_EQ(context.budget.used(), 0u) << mebibytes;
    }
    EXPECT_TRUE(was_refused);
    EXPECT_TRUE(was_enough);
  }
}

/// Expects that the candidates for curves of a gray picture are all charged.
void expect_candidates_are_charged(const Image& image) {
  const auto plane = test::plane_of(image.width, image.height, [&image](Vec2 p) {
    const auto at =
        static_cast<std::size_t>(p.y) * image.row_bytes() + 3 * static_cast<std::size_t>(p.x);
    return image.bytes[at] / 255.0;
  });
  const std::vector<tracing::TracedCurve> none;
  const auto find = [&](Context& context, TableMemory& memory) {
    return tracing::find_candidates(context, std::span(&plane, 1), {}, 1.2, none, memory);
  };
  std::size_t bytes = 0;
  {
    Context context;
    TableMemory memory("curves");
    const auto candidates = find(context, memory);
    ASSERT_TRUE(candidates.ok());
    bytes = tracing::bytes_of(*candidates);
    EXPECT_GT(candidates->size(), 50u);
    EXPECT_GE(context.budget.used(), bytes);
  }
  bool was_enough = false;
  for (std::size_t most = bytes / 4; most < 64 * bytes; most += most / 4) {
    Context context{.budget = Budget(most)};
    const StatusCode code = [&] {
      TableMemory memory("curves");
      return find(context, memory).status().code;
    }();
    EXPECT_TRUE(code == StatusCode::ok || (code == StatusCode::limit && !was_enough)) << most;
    EXPECT_EQ(context.budget.used(), 0u) << most;
    was_enough = was_enough || code == StatusCode::ok;
  }
  EXPECT_TRUE(was_enough);
}

TEST(TraceLimits, candidates_are_charged_however_many_there_are) {
  expect_candidates_are_charged(noise(128));
  expect_candidates_are_charged(checkers(128));
}

TEST(TraceLimits, what_is_kept_of_each_pixel_is_charged) {
  Context small{.budget = Budget(100000)};
  std::vector<tracing::TracedCurve> curves{tracing::frame_of(400, 300)};
  EXPECT_EQ(tracing::snap_to_curves(small, 400, 300, {0.1f}, curves).code, StatusCode::limit);
  TableMemory memory("curves");
  EXPECT_EQ(
      tracing::choose_curves(small, curves, 400, 300, {100, 10}, curves, memory).status().code,
      StatusCode::limit);
  EXPECT_EQ(small.budget.used(), 0u);
}

TEST(TraceLimits, equations_are_charged_as_they_are_made) {
  // The matrix alone has 800,000 bytes; for a moment its rows exist twice.
  Context small{.budget = Budget(1200000)};
  const auto fill = [](std::size_t, tracing::RowSummer& sum) {
    for (std::uint32_t column = 0; column < 100; ++column) sum.add(column, 1);
  };
  EXPECT_EQ(tracing::build_rows(small, 1000, 100, fill).status().code, StatusCode::limit);
  EXPECT_EQ(small.budget.used(), 0u);
}

TEST(TraceLimits, a_time_that_has_passed_is_a_limit) {
  Context context;
  context.deadline = Deadline::in(-1);
  const Status status = trace(context, test::synthetic_photo(120)).status();
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.limit, "time");
}

TEST(TraceLimits, few_curves_are_allowed_few_are_made) {
  Context context;
  context.limits.curves = 5;
  const Result<Document> drawing = trace(context, test::synthetic_photo(120));
  ASSERT_TRUE(drawing.ok()) << to_string(drawing.status());
  EXPECT_LE(test::curve_count(*drawing), 5u);
  EXPECT_TRUE(validate(context, *drawing).ok());
}

}  // namespace
}  // namespace sfumato
