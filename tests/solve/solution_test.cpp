#include "sfumato/solve/solution.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <set>

#include "sfumato/base/native/thread_pool.hpp"
#include "solve/diffused.hpp"
#include "solve/solved.hpp"
#include "support/cancel_at.hpp"
#include "support/drawing.hpp"
#include "support/random_document.hpp"
#include "support/same_document.hpp"
#include "support/same_picture.hpp"

namespace sfumato {
namespace {

using test::circle_curve;
using test::colored;
using test::difference_of;
using test::diffused;
using test::kBlue;
using test::kGreen;
using test::kRed;
using test::solution_of;
using test::straight_curve;

using Layers = std::vector<std::uint32_t>;

void expect_as_diffused(const Solution& solution, const DiffuseOptions& options) {
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document(), options)), "");
}

/// Returns three layers with one circle each; the second layer is painted twice.
Document three_layers() {
  Document document = test::one_layer({colored(circle_curve({50, 50}, 40), kRed, kBlue)});
  document.layers.push_back({"second", {colored(circle_curve({30, 30}, 10), kBlue, kGreen)}});
  document.layers.push_back({"third", {colored(straight_curve({5, 5}, {90, 95}), kGreen, kRed)}});
  document.stack = {LayerInstance{0, {}}, LayerInstance{1, {}},
                    LayerInstance{1, {1, 0, 0, 1, 20, 10}}, LayerInstance{2, {}, 0.5f}};
  return document;
}

/// Returns the number of curves that were flattened: none if nothing was solved.
std::uint64_t curves_solved(Context& context, Solution& solution,
                            const DiffuseOptions& options = {}) {
  DiffuseStats stats;
  const Status status = solution.solve(context, options, &stats);
  EXPECT_TRUE(status.ok()) << to_string(status);
  return stats.curves;
}

Change take(Result<Change> change) {
  EXPECT_TRUE(change.ok()) << to_string(change.status());
  return std::move(*change);
}

TEST(Solution, has_the_picture_of_diffuse) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  EXPECT_TRUE(solution.picture().layers.empty());
  EXPECT_EQ(curves_solved(context, solution), 3u);
  expect_as_diffused(solution, {});
}

TEST(Solution, solves_only_the_layer_whose_curve_changed) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_EQ(curves_solved(context, solution), 0u);
  take(
      solution.apply(context, ReplaceCurve{1, 0, colored(circle_curve({40, 35}, 8), kBlue, kRed)}));
  EXPECT_EQ(curves_solved(context, solution), 1u);
  expect_as_diffused(solution, {});
  take(solution.apply(context, InsertCurve{2, 0, colored(circle_curve({70, 20}, 5), kRed, kBlue)}));
  EXPECT_EQ(curves_solved(context, solution), 2u);
  expect_as_diffused(solution, {});
  take(solution.apply(context, RemoveCurve{2, 1}));
  EXPECT_EQ(curves_solved(context, solution), 1u);
  expect_as_diffused(solution, {});
}

TEST(Solution, solves_a_layer_again_where_it_is_shown_at_another_scale_only) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  std::vector<StackItem> stack = solution.document().stack;
  std::swap(stack[0], stack[3]);
  std::get<LayerInstance>(stack[1]).opacity = 0.25f;
  take(solution.apply(context, ReplaceStack{stack}));
  EXPECT_EQ(curves_solved(context, solution), 0u);
  expect_as_diffused(solution, {});
  std::get<LayerInstance>(stack[0]).artboard_from_layer = {3, 0, 0, 3, 0, 0};
  take(solution.apply(context, ReplaceStack{stack}));
  EXPECT_EQ(curves_solved(context, solution), 1u);
  expect_as_diffused(solution, {});
}

TEST(Solution, keeps_the_layers_that_another_document_has_too) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  Document inserted = three_layers();
  inserted.layers.insert(inserted.layers.begin() + 1,
                         Layer{"new", {colored(circle_curve({60, 60}, 9), kRed, kGreen)}});
  for (StackItem& item : inserted.stack) {
    if (auto& instance = std::get<LayerInstance>(item); instance.layer > 0) ++instance.layer;
  }
  inserted.stack.push_back(LayerInstance{1, {}});
  take(solution.apply(context, ReplaceDocument{inserted}));
  EXPECT_EQ(curves_solved(context, solution), 1u);
  expect_as_diffused(solution, {});
  take(solution.apply(context, ReplaceDocument{three_layers()}));
  EXPECT_EQ(curves_solved(context, solution), 0u);
  expect_as_diffused(solution, {});
}

TEST(Solution, keeps_layers_that_changed_places_where_they_have_names) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  Document swapped = three_layers();
  std::swap(swapped.layers[1], swapped.layers[2]);
  for (StackItem& item : swapped.stack) {
    auto& instance = std::get<LayerInstance>(item);
    if (instance.layer > 0) instance.layer = 3 - instance.layer;
  }
  take(solution.apply(context, ReplaceDocument{swapped}));
  EXPECT_EQ(curves_solved(context, solution), 0u);
  expect_as_diffused(solution, {});
}

TEST(Solution, solves_all_again_for_other_options_artboards_and_interpolations) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  DiffuseOptions finer{.pixels_per_unit = 4};
  EXPECT_EQ(curves_solved(context, solution, finer), 3u);
  expect_as_diffused(solution, finer);
  DiffuseOptions nearer = finer;
  nearer.viewport = Box{{20, 20}, {60, 60}};
  EXPECT_EQ(curves_solved(context, solution, nearer), 3u);
  expect_as_diffused(solution, nearer);
  Document document = three_layers();
  document.interpolation = InterpolationSpace::oklab;
  take(solution.apply(context, ReplaceDocument{document}));
  EXPECT_EQ(curves_solved(context, solution, nearer), 3u);
  expect_as_diffused(solution, nearer);
}

/// Returns a change chosen by a seed, with curves and items of other random documents.
Change random_change(std::mt19937& random, const Document& now) {
  const Document other = test::random_document(random() % 1000);
  const auto below = [&](std::size_t count) {
    return count == 0 ? 0u : static_cast<std::uint32_t>(random() % count);
  };
  const std::uint32_t layer = below(now.layers.size());
  const std::size_t curves = now.layers.empty() ? 0 : now.layers[layer].curves.size();
  Curve curve =
      colored(circle_curve({20.0 + below(60), 30.0 + below(50)}, 2.0 + below(20)), kRed, kBlue);
  switch (random() % 8) {
    case 0:
      return RemoveCurve{layer, below(curves)};
    case 1:
    case 2:
      return InsertCurve{layer, below(curves + 1), std::move(curve)};
    case 3: {
      std::vector<StackItem> stack = now.stack;
      if (!stack.empty()) stack.erase(stack.begin() + below(stack.size()));
      return ReplaceStack{std::move(stack)};
    }
    case 4:
      return ReplaceDocument{other};
    default:
      return ReplaceCurve{layer, below(curves), std::move(curve)};
  }
}

TEST(Solution, is_that_of_diffuse_after_any_changes) {
  const DiffuseOptions options{.pixels_per_unit = 0.5, .max_error = 8};
  std::size_t applied = 0, refused = 0;
  for (std::uint32_t seed = 0; seed < 25; ++seed) {
    Context context;
    Solution solution = solution_of(context, test::random_document(seed));
    std::mt19937 random(seed);
    for (int step = 0; step < 6; ++step) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      for (std::uint32_t i = random() % 3; i > 0; --i) {
        const auto inverse = solution.apply(context, random_change(random, solution.document()));
        inverse ? ++applied : ++refused;
        if (inverse && random() % 4 == 0) take(solution.apply(context, *inverse));
      }
      ASSERT_TRUE(solution.solve(context, options).ok());
      ASSERT_NO_FATAL_FAILURE(expect_as_diffused(solution, options));
    }
  }
  EXPECT_GT(applied, 100u);
  EXPECT_GT(refused, 1u);
}

TEST(Solution, tells_what_is_new) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  EXPECT_TRUE(solution.take_delta().empty());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  PictureDelta delta = solution.take_delta();
  EXPECT_TRUE(delta.frame);
  EXPECT_EQ(delta.layers, (Layers{0, 1, 2}));
  EXPECT_TRUE(solution.take_delta().empty());
  take(solution.apply(context, RemoveCurve{1, 0}));
  EXPECT_TRUE(solution.take_delta().empty());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  take(solution.apply(context, RemoveCurve{0, 0}));
  ASSERT_TRUE(solution.solve(context, {}).ok());
  delta = solution.take_delta();
  EXPECT_FALSE(delta.frame);
  EXPECT_EQ(delta.layers, (Layers{0, 1}));
  take(solution.apply(context, ReplaceStack{}));
  ASSERT_TRUE(solution.solve(context, {}).ok());
  delta = solution.take_delta();
  EXPECT_TRUE(delta.frame);
}

/// A copy that follows the deltas equals the picture.
TEST(Solution, told_of_what_is_new_a_copy_stays_equal) {
  const DiffuseOptions options{.pixels_per_unit = 0.5, .max_error = 8};
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Context context;
    Solution solution = solution_of(context, test::random_document(seed));
    std::mt19937 random(seed);
    Picture copy;
    for (int step = 0; step < 8; ++step) {
      const auto changed = solution.apply(context, random_change(random, solution.document()));
      if (random() % 2 != 0 && changed.ok()) continue;
      ASSERT_TRUE(solution.solve(context, options).ok());
      const PictureDelta delta = solution.take_delta();
      const Picture& picture = solution.picture();
      if (delta.frame) {
        std::vector<PatchLayer> layers = std::move(copy.layers);
        copy = picture;
        copy.layers = std::move(layers);
        copy.layers.resize(picture.layers.size());
      }
      for (const std::uint32_t i : delta.layers) copy.layers[i] = picture.layers[i];
      ASSERT_EQ(difference_of(copy, picture), "") << "seed " << seed << ", step " << step;
    }
  }
}

TEST(Solution, that_is_cancelled_keeps_its_picture_and_what_was_done) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  const Picture before = solution.picture();
  for (std::uint32_t layer = 0; layer < 3; ++layer) {
    take(solution.apply(context,
                        ReplaceCurve{layer, 0, colored(circle_curve({50, 45}, 12), kRed, kGreen)}));
  }
  std::uint64_t solved = 0;
  int cancelled = 0;
  for (std::uint64_t poll = 40; cancelled < 500; poll += poll / 4) {
    Context hurried;
    test::CancelAt watch(poll, hurried.cancel);
    hurried.poll_watch = &watch;
    DiffuseStats stats;
    const Status status = solution.solve(hurried, {}, &stats);
    solved += stats.curves;
    if (status.ok()) break;
    ++cancelled;
    ASSERT_EQ(status.code, StatusCode::cancelled);
    ASSERT_EQ(difference_of(solution.picture(), before), "");
    ASSERT_TRUE(solution.take_delta().layers.empty() || cancelled == 1);
  }
  EXPECT_GT(cancelled, 3);
  EXPECT_GE(solved, 3u);
  expect_as_diffused(solution, {});
}

/// Cancels when all work is reported as done.
class CancelAtTheEnd : public Progress {
 public:
  explicit CancelAtTheEnd(CancelFlag& cancel) : cancel_(cancel) {}
  void report(std::string_view, double fraction) override {
    if (fraction > 0.999) cancel_.store(true);
  }

 private:
  CancelFlag& cancel_;
};

TEST(Solution, that_is_cancelled_when_all_is_solved_has_the_picture_next_time) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  for (int threads : {1, 2, 4}) {
    take(solution.apply(
        context, ReplaceCurve{1, 0, colored(circle_curve({30.0 + threads, 40}, 9), kRed, kBlue)}));
    ThreadPool pool(threads);
    Context hurried{.executor = &pool};
    CancelAtTheEnd progress(hurried.cancel);
    hurried.progress = &progress;
    static_cast<void>(solution.solve(hurried, {}));
    ASSERT_TRUE(solution.solve(context, {}).ok());
    expect_as_diffused(solution, {});
  }
}

TEST(Solution, a_refused_change_changes_nothing) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  static_cast<void>(solution.take_delta());
  const std::size_t used = context.budget.used();
  EXPECT_EQ(solution.apply(context, RemoveCurve{1, 1}).status().code, StatusCode::bad_input);
  EXPECT_EQ(solution.apply(context, ReplaceDocument{}).status().code, StatusCode::bad_input);
  EXPECT_TRUE(test::same_document(solution.document(), three_layers()));
  EXPECT_EQ(context.budget.used(), used);
  EXPECT_EQ(curves_solved(context, solution), 0u);
  EXPECT_TRUE(solution.take_delta().empty());
}

TEST(Solution, holds_no_more_than_its_document_and_picture) {
  Context context;
  {
    Solution solution = solution_of(context, three_layers());
    for (int round = 0; round < 5; ++round) {
      Context change;  // may end before the solution
      const double x = 30 + 5 * round;
      take(solution.apply(change,
                          ReplaceCurve{1, 0, colored(circle_curve({x, 30}, 9), kRed, kBlue)}));
      ASSERT_TRUE(solution.solve(change, {}).ok());
      EXPECT_EQ(change.budget.used(), 0u);
      EXPECT_EQ(context.budget.used(),
                bytes_of(solution.document()) + bytes_of(solution.picture()));
    }
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Solution, without_memory_for_a_change_is_as_it_was) {
  Context context{.budget = Budget(std::size_t{64} << 10)};
  Solution solution = solution_of(context, three_layers());
  Curve large = colored(straight_curve({0, 0}, {90, 90}), kRed, kBlue);
  const std::vector<Vec2> points = large.control_points;
  for (int i = 0; i < 2000; ++i) {
    large.control_points.insert(large.control_points.end(), points.begin() + 1, points.end());
  }
  for (const Change& change :
       {Change(ReplaceCurve{0, 0, large}), Change(InsertCurve{1, 0, large})}) {
    const auto result = solution.apply(context, change);
    EXPECT_EQ(result.status().limit, "memory");
    EXPECT_TRUE(test::same_document(solution.document(), three_layers()));
  }
  EXPECT_EQ(context.budget.used(), bytes_of(solution.document()));
}

/// Returns the charges beside document and picture.
std::size_t kept_for_drags(const Context& context, const Solution& solution) {
  return context.budget.used() - bytes_of(solution.document()) - bytes_of(solution.picture());
}

TEST(Solution, keeps_what_drags_begin_from_if_they_are_expected) {
  Context context, visitor;
  Solution solution = solution_of(context, three_layers());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_EQ(kept_for_drags(context, solution), 0u);
  solution.expect_drags();
  const Change change = ReplaceCurve{1, 0, colored(circle_curve({60, 60}, 9), kRed, kBlue)};
  take(solution.apply(context, change));
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_GT(kept_for_drags(context, solution), 0u);
  take(solution.apply(context, change));
  ASSERT_TRUE(solution.solve(visitor, {}).ok());
  EXPECT_EQ(kept_for_drags(context, solution), 0u);
  EXPECT_EQ(visitor.budget.used(), 0u);
}

TEST(Solution, gives_up_what_it_keeps_for_drags_where_memory_is_needed) {
  Context context;
  Solution solution = solution_of(context, three_layers());
  solution.expect_drags();
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_GT(kept_for_drags(context, solution), 0u);
  const std::size_t others = context.budget.room();
  ASSERT_TRUE(context.budget.charge(others, "others").ok());
  const Change change = ReplaceCurve{1, 0, colored(circle_curve({60, 60}, 9), kRed, kBlue)};
  EXPECT_TRUE(solution.apply(context, change).ok());
  EXPECT_EQ(kept_for_drags(context, solution), others);
}

/// Memory that suffices without drags also suffices when drags are expected.
TEST(Solution, that_expects_drags_needs_no_more_memory) {
  const auto least_room = [](bool expects_drags) {
    std::size_t room = 1000;
    for (;; room += room / 32) {
      Context context{.budget = Budget(room)};
      Result<Solution> solution = Solution::create(context, three_layers());
      if (!solution) continue;
      if (expects_drags) solution->expect_drags();
      if (solution->solve(context, {}).ok()) return room;
    }
  };
  EXPECT_EQ(least_room(true), least_room(false));
}

/// With any amount of memory, a change succeeds or leaves everything as it was, and so does a
/// solve; exactly the memory in use is charged.
TEST(Solution, with_little_memory_goes_on_or_is_as_it_was) {
  std::size_t made = 0, refused = 0, solved = 0;
  for (std::size_t room = 0; room < 60'000; room += 1 + room / 16) {
    SCOPED_TRACE(room);
    Context context;
    Solution solution = solution_of(context, three_layers());
    ASSERT_TRUE(solution.solve(context, {}).ok());
    const std::size_t others = context.budget.room() - room;
    ASSERT_TRUE(context.budget.charge(others, "others").ok());
    for (const Change& change :
         {Change(InsertCurve{1, 1, colored(circle_curve({60, 60}, 9), kRed, kBlue)}),
          Change(ReplaceStack{three_layers().stack}), Change(RemoveCurve{0, 0})}) {
      const Document before = solution.document();
      const auto result = solution.apply(context, change);
      result ? ++made : ++refused;
      if (!result) {
        ASSERT_EQ(result.status().limit, "memory");
        ASSERT_TRUE(test::same_document(solution.document(), before));
      }
      if (solution.solve(context, {}).ok()) {
        ++solved;
        ASSERT_NO_FATAL_FAILURE(expect_as_diffused(solution, {}));
        ASSERT_EQ(context.budget.used() - others,
                  bytes_of(solution.document()) + bytes_of(solution.picture()));
      }
    }
    context.budget.release(others);
    ASSERT_TRUE(solution.solve(context, {}).ok());
    ASSERT_NO_FATAL_FAILURE(expect_as_diffused(solution, {}));
  }
  EXPECT_GT(made, 20u);
  EXPECT_GT(refused, 20u);
  EXPECT_GT(solved, 20u);
}

TEST(Solution, of_a_wrong_document_or_options_is_refused) {
  Context context;
  EXPECT_EQ(Solution::create(context, Document{}).status().code, StatusCode::bad_input);
  Solution solution = solution_of(context, three_layers());
  EXPECT_EQ(solution.solve(context, {.pixels_per_unit = 0}).code, StatusCode::bad_input);
  EXPECT_EQ(curves_solved(context, solution), 3u);
}

TEST(Solution, can_be_moved) {
  Context context;
  Solution first = solution_of(context, three_layers());
  ASSERT_TRUE(first.solve(context, {}).ok());
  Solution second(std::move(first));
  first = solution_of(context, test::one_layer({}));
  std::swap(first, second);
  EXPECT_EQ(first.picture().layers.size(), 3u);
  EXPECT_EQ(second.document().layers.size(), 1u);
}

}  // namespace
}  // namespace sfumato
