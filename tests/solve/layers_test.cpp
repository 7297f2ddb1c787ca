#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <mutex>
#include <string>
#include <vector>

#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/drawing.hpp"

// Layers, and the fields of each, that are solved in parallel (solve/layers/layer_runs.hpp).
namespace sfumato {
namespace {

using test::circle_curve;
using test::colored;
using test::straight_curve;
using test::with_opacity;

/// Claims to have threads, and runs everything in the calling one.
class Alone : public Executor {
 public:
  explicit Alone(int threads = 4) : threads_(threads) {}
  int thread_count() const override { return threads_; }

 private:
  int threads_;
};

class Backwards final : public Alone {
 public:
  void run(std::size_t task_count, FunctionRef<void(std::size_t)> task) override {
    for (std::size_t i = task_count; i > 0; --i) task(i - 1);
  }
};

/// Returns layers of different sizes: each third has its own mask, the fifth is empty.
Document layers(std::uint32_t count) {
  Document document;
  document.artboard = {{0, 0}, {100, 100}};
  for (std::uint32_t i = 0; i < count; ++i) {
    std::vector<Curve> curves;
    for (std::uint32_t k = 0; i != 4 && k <= (5 * i) % 7; ++k) {
      const Vec2 center{20.0 + 9 * k + i, 30.0 + 5 * k};
      curves.push_back(colored(circle_curve(center, 5 + k), test::kRed, test::kGreen));
    }
    if (i % 3 == 0) curves.push_back(with_opacity(straight_curve({50, -20}, {60, 120}), 1, 0.5));
    document.layers.push_back({"layer " + std::to_string(i), curves});
    document.stack.push_back(LayerInstance{i, {}});
  }
  return document;
}

void expect_equal(const PatchField& a, const PatchField& b) {
  EXPECT_EQ(a.channel_count, b.channel_count);
  EXPECT_EQ(a.triangle_node, b.triangle_node);
  EXPECT_EQ(a.node_value, b.node_value);
  EXPECT_EQ(a.shader, b.shader);
}

void expect_equal(const Picture& a, const Picture& b) {
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(a.layers[i].frame, b.layers[i].frame);
    EXPECT_EQ(a.layers[i].vertex_position, b.layers[i].vertex_position);
    EXPECT_EQ(a.layers[i].triangle_vertex, b.layers[i].triangle_vertex);
    EXPECT_EQ(a.layers[i].edge_is_curve, b.layers[i].edge_is_curve);
    expect_equal(a.layers[i].color, b.layers[i].color);
    expect_equal(a.layers[i].opacity, b.layers[i].opacity);
  }
}

/// Calls check(executor) with several executors of every kind.
template <class Check>
void for_each_executor(Check check) {
  Alone alone, many(100);
  Backwards backwards;
  ThreadPool two(2), three(3), twenty(20);
  for (Executor* executor :
       std::initializer_list<Executor*>{&alone, &many, &backwards, &two, &three, &twenty}) {
    check(executor);
  }
}

TEST(Layers, side_by_side_are_those_that_come_one_after_another) {
  const Document document = layers(12);
  Context one;
  DiffuseStats expected_stats;
  const Result<Picture> expected = diffuse(one, document, {}, &expected_stats);
  ASSERT_TRUE(expected.ok()) << expected.status().message;
  EXPECT_EQ(expected->layers[4].triangle_count(), 0u);
  EXPECT_EQ(expected->layers[3].opacity.channel_count, 1);
  for_each_executor([&](Executor* executor) {
    Context context{.executor = executor};
    DiffuseStats stats;
    const Result<Picture> picture = diffuse(context, document, {}, &stats);
    ASSERT_TRUE(picture.ok()) << picture.status().message;
    expect_equal(*expected, *picture);
    EXPECT_EQ(stats.curves, expected_stats.curves);
    EXPECT_EQ(stats.triangles, expected_stats.triangles);
    EXPECT_EQ(stats.nodes, expected_stats.nodes);
    EXPECT_EQ(context.budget.used(), 0u);
  });
}

TEST(Layers, the_first_that_fails_says_why) {
  Document document = layers(9);
  for (const std::uint32_t i : {2u, 6u, 7u}) {
    auto& instance = std::get<LayerInstance>(document.stack[i]);
    instance.artboard_from_layer = {1e-7, 0, 0, 1e-7, 0, 0};
  }
  for_each_executor([&](Executor* executor) {
    Context context{.executor = executor};
    const Status status = diffuse(context, document, {}).status();
    EXPECT_EQ(status.code, StatusCode::limit);
    EXPECT_NE(status.message.find("\"layer 2\""), std::string::npos) << status.message;
    EXPECT_EQ(context.budget.used(), 0u);
  });
}

/// Returns the memory that one thread needs, within a percent.
std::size_t least_budget(const Document& document, const DiffuseOptions& options) {
  std::size_t enough = std::size_t{1} << 30, too_small = 0;
  while (enough - too_small > enough / 100) {
    const std::size_t middle = too_small + (enough - too_small) / 2;
    Context context{.budget = Budget(middle)};
    (diffuse(context, document, options).ok() ? enough : too_small) = middle;
  }
  return enough;
}

TEST(Layers, what_is_enough_memory_for_one_thread_is_enough_for_many) {
  const Document document = layers(9);
  const DiffuseOptions options{.max_error = 0};
  const std::size_t budget = least_budget(document, options);
  Context one;
  const Result<Picture> expected = diffuse(one, document, options);
  ASSERT_TRUE(expected.ok());
  for_each_executor([&](Executor* executor) {
    Context context{.executor = executor, .budget = Budget(budget)};
    const Result<Picture> picture = diffuse(context, document, options);
    ASSERT_TRUE(picture.ok()) << picture.status().message;
    expect_equal(*expected, *picture);
    EXPECT_EQ(context.budget.used(), 0u);

    Context poor{.executor = executor, .budget = Budget(budget / 2)};
    const Status status = diffuse(poor, document, options).status();
    EXPECT_EQ(status.code, StatusCode::limit);
    EXPECT_EQ(status.limit, "memory");
    EXPECT_EQ(poor.budget.used(), 0u);
  });
}

/// Records its reports, and cancels after some of them.
class Listener final : public Progress {
 public:
  explicit Listener(CancelFlag* cancel = nullptr) : cancel_(cancel) {}

  void report(std::string_view, double fraction) override {
    const std::lock_guard lock(mutex_);
    told_.push_back(fraction);
    if (cancel_ && told_.size() == 9) *cancel_ = true;
  }

  const std::vector<double>& told() const { return told_; }

 private:
  std::mutex mutex_;
  std::vector<double> told_;
  CancelFlag* cancel_;
};

TEST(Layers, that_are_cancelled_in_the_midst_give_no_picture) {
  const Document document = layers(12);
  for_each_executor([&](Executor* executor) {
    Context context{.executor = executor};
    Listener listener(&context.cancel);
    context.progress = &listener;
    EXPECT_EQ(diffuse(context, document, {}).status().code, StatusCode::cancelled);
    EXPECT_GE(listener.told().size(), 9u);
    EXPECT_EQ(context.budget.used(), 0u);
  });
}

TEST(Layers, are_one_whole_whose_progress_never_falls) {
  const Document document = layers(12);
  for_each_executor([&](Executor* executor) {
    Context context{.executor = executor};
    Listener listener;
    context.progress = &listener;
    ASSERT_TRUE(diffuse(context, document, {}).ok());
    const std::vector<double>& told = listener.told();
    EXPECT_GT(told.size(), 12u);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_GE(told.front(), 0);
    EXPECT_LE(told.back(), 1);
  });
}

}  // namespace
}  // namespace sfumato
