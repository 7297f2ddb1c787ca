#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/solve/solution.hpp"
#include "solve/circles.hpp"
#include "solve/diffused.hpp"
#include "solve/mean_difference.hpp"
#include "solve/solved.hpp"
#include "support/cancel_at.hpp"
#include "support/drawing.hpp"
#include "support/random_document.hpp"
#include "support/same_document.hpp"
#include "support/same_picture.hpp"
#include "support/sanitizers.hpp"
#include "support/soak.hpp"

/// Documents that are solved roughly while several curves move.
namespace sfumato {
namespace {

using test::circle_at;
using test::circle_curve;
using test::colored;
using test::difference_of;
using test::diffused;
using test::kBlue;
using test::kGreen;
using test::kRed;
using test::mean_difference;
using test::solved;

const auto kRoughDocuments =
    test::random_case_count<std::uint32_t>(SFUMATO_HAS_SANITIZER ? 3 : 10, 20);

LocalStroke stroke_at(Vec2 center) {
  const Curve circle = circle_at(center);
  return {{.control_points = circle.control_points,
           .left_color = circle.left.color.stops,
           .right_color = circle.right.color.stops,
           .influence_radius = {StopSpace::parameter, {{0, 4}}}},
          {}};
}

/// Returns two circles in a large one, two layers over them, and a local curve.
Document circles_in_layers() {
  Document document = test::one_layer({circle_at({30, 30}), circle_at({60, 40}),
                                       colored(circle_curve({50, 50}, 45), kBlue, kGreen)});
  document.layers.push_back({"above", {colored(circle_curve({70, 70}, 9), kGreen, kRed)}});
  document.layers.push_back(
      {"faint", {test::with_opacity(colored(circle_curve({20, 70}, 15), kRed, kGreen), 0, 1)}});
  document.stack.push_back(LayerInstance{1, {}, 0.5f});
  document.stack.push_back(LayerInstance{1, {1, 0, 0, 1, -30, 5}});
  document.stack.push_back(stroke_at({80, 20}));
  document.stack.push_back(LayerInstance{2, {}});
  return document;
}

void move_two(Context& context, Solution& solution, double by) {
  ASSERT_TRUE(solution.apply(context, ReplaceCurve{0, 0, circle_at({30 + by, 30})}).ok());
  ASSERT_TRUE(solution.apply(context, ReplaceCurve{0, 1, circle_at({60, 40 - by})}).ok());
}

bool is_exact(const Solution& solution, const DiffuseOptions& options = {}) {
  return difference_of(solution.picture(), diffused(solution.document(), options)).empty();
}

TEST(Rough, pictures_solve_the_layers_that_changed) {
  Context context;
  Solution solution = solved(context, circles_in_layers());
  const Picture before = solution.picture();
  const float* const values = solution.picture().layers[1].color.node_value.data();
  move_two(context, solution, 2);
  DiffuseStats rough, exact;
  ASSERT_TRUE(solution.solve_roughly(context, {}, &rough).ok());
  EXPECT_EQ(rough.curves, 3u);
  const PictureDelta delta = solution.take_delta();
  EXPECT_FALSE(delta.frame);
  EXPECT_EQ(delta.layers, std::vector<std::uint32_t>{0});
  EXPECT_TRUE(delta.rows.empty());
  EXPECT_EQ(solution.picture().layers[1].color.node_value.data(), values) << "not even copied";
  Picture other = before;
  other.layers[0] = solution.picture().layers[0];
  EXPECT_EQ(difference_of(solution.picture(), other), "");
  EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.5);
  ASSERT_TRUE(solution.solve(context, {}, &exact).ok());
  EXPECT_EQ(exact.curves, 3u);
  EXPECT_LT(2 * rough.nodes, exact.nodes);
  EXPECT_TRUE(is_exact(solution));
}

TEST(Rough, pictures_of_what_is_shown_already_stay) {
  Context context;
  Solution solution = solved(context, circles_in_layers());
  const auto solves_nothing = [&] {
    solution.take_delta();
    DiffuseStats stats;
    EXPECT_TRUE(solution.solve_roughly(context, {}, &stats).ok());
    return stats.curves == 0 && solution.take_delta().empty();
  };
  EXPECT_TRUE(solves_nothing());
  EXPECT_TRUE(is_exact(solution));
  move_two(context, solution, 1);
  ASSERT_TRUE(solution.solve_roughly(context, {}).ok());
  EXPECT_TRUE(solves_nothing());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({34, 31})}).ok());
  EXPECT_TRUE(solves_nothing()) << "a frame shows it";
  ASSERT_TRUE(solution.begin_color(context, {.layer = 1}).ok());
  ASSERT_TRUE(solution.color(context, Rgb{0.5f, 0.25f, 0}).ok());
  EXPECT_TRUE(solves_nothing()) << "a colour shows it";
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_TRUE(is_exact(solution));
}

TEST(Rough, pictures_have_the_stack_of_the_document) {
  Context context;
  Solution solution = solved(context, circles_in_layers());
  std::vector<StackItem> stack = circles_in_layers().stack;
  std::swap(stack[0], stack[4]);
  stack[3] = stroke_at({20, 80});
  ASSERT_TRUE(solution.apply(context, ReplaceStack{stack}).ok());
  ASSERT_TRUE(solution.solve_roughly(context, {}).ok());
  EXPECT_TRUE(is_exact(solution)) << "no layer has changed";
  std::get<LayerInstance>(stack[2]).artboard_from_layer = {3, 0, 0, 3, 0, 0};
  ASSERT_TRUE(solution.apply(context, ReplaceStack{stack}).ok());
  DiffuseStats stats;
  ASSERT_TRUE(solution.solve_roughly(context, {}, &stats).ok());
  EXPECT_EQ(stats.curves, 1u) << "the layer that is larger";
  EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.5);
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_TRUE(is_exact(solution));
}

TEST(Rough, pictures_may_be_the_first_and_of_other_options) {
  Context context;
  Solution solution = std::move(*Solution::create(context, circles_in_layers()));
  EXPECT_EQ(solution.solve_roughly(context, {.pixels_per_unit = 0}).code, StatusCode::bad_input);
  for (const DiffuseOptions& options :
       {DiffuseOptions{}, DiffuseOptions{.pixels_per_unit = 3},
        DiffuseOptions{.tolerance = 0.3, .max_error = 0},
        DiffuseOptions{.gather = {.method = gather::Method::rays, .rays_per_node = 4}}}) {
    DiffuseStats stats;
    ASSERT_TRUE(solution.solve_roughly(context, options, &stats).ok());
    EXPECT_EQ(stats.curves, 5u);
    EXPECT_LT(mean_difference(solution.picture(), diffused(circles_in_layers())), 0.5);
    ASSERT_TRUE(solution.solve(context, options).ok());
    EXPECT_TRUE(is_exact(solution, options));
  }
}

TEST(Rough, pictures_are_what_drags_begin_from) {
  Context context;
  Solution solution = solved(context, circles_in_layers());
  solution.expect_drags();
  move_two(context, solution, 2);
  ASSERT_TRUE(solution.solve_roughly(context, {}).ok());
  const Picture rough = solution.picture();
  ASSERT_TRUE(solution.begin_drag(context, 0, {1}).ok());
  EXPECT_EQ(difference_of(solution.picture(), rough), "");
  for (const Vec2 center : {Vec2{58, 41}, Vec2{40, 55}, Vec2{130, 40}}) {
    ASSERT_TRUE(solution.drag(context, {circle_at(center)}).ok());
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.5);
  }
  const auto triangles = solution.picture().layers[0].triangle_count();
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok()) << "another curve of the same layer";
  ASSERT_TRUE(solution.drag(context, {circle_at({35, 33})}).ok());
  EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.5);
  ASSERT_TRUE(solution.begin_color(context, {.layer = 0, .curve = 2}).ok())
      << "a colour of a third";
  ASSERT_TRUE(solution.color(context, Rgb{0.5f, 0.25f, 0}).ok());
  EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.5);
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_GT(solution.picture().layers[0].triangle_count(), triangles) << "the drag was rough";
  EXPECT_TRUE(is_exact(solution));
}

/// Makes an edit chosen by a seed. A refused edit changes nothing.
void edit(std::mt19937& random, Context& context, Solution& solution) {
  const Document& now = solution.document();
  const auto below = [&](std::size_t count) {
    return count == 0 ? 0u : static_cast<std::uint32_t>(random() % count);
  };
  const std::uint32_t layer = below(now.layers.size());
  const std::vector<Curve>& curves = now.layers[layer].curves;
  const std::uint32_t index = below(curves.size());
  if (curves.empty() || random() % 6 == 0) {
    const Vec2 center{20.0 + below(60), 30.0 + below(50)};
    static_cast<void>(solution.apply(context, InsertCurve{layer, index, circle_at(center)}));
    return;
  }
  Curve moved = curves[index];
  for (Vec2& p : moved.control_points) p = p + Vec2{0.5 * below(20) - 5, 3};
  switch (random() % 8) {
    case 0:
      static_cast<void>(solution.apply(context, RemoveCurve{layer, index}));
      break;
    case 1: {
      std::vector<StackItem> stack = now.stack;
      std::ranges::rotate(stack, stack.begin() + below(stack.size()));
      static_cast<void>(solution.apply(context, ReplaceStack{std::move(stack)}));
      break;
    }
    case 2:
      if (solution.begin_drag(context, layer, {index}).ok()) {
        ASSERT_TRUE(solution.drag(context, {moved}, nullptr, 1.0 * below(2)).ok());
      }
      break;
    case 3:
      if (solution.begin_color(context, {.layer = layer, .curve = index, .index = 0}).ok()) {
        ASSERT_TRUE(solution.color(context, Rgb{0.25f, 0.5f, 0.125f}).ok());
      }
      break;
    default:
      ASSERT_TRUE(solution.apply(context, ReplaceCurve{layer, index, std::move(moved)}).ok());
  }
}

TEST(Rough, pictures_of_any_edits_end_in_that_of_diffuse) {
  const DiffuseOptions options{.pixels_per_unit = 0.5, .max_error = 4};
  double sum = 0;
  int pictures = 0;
  for (std::uint32_t seed = 0; seed < kRoughDocuments; ++seed) {
    Context context;
    Solution solution = solved(context, test::random_document(700 + seed), options);
    if (seed % 2 == 0) solution.expect_drags();
    std::mt19937 random(seed);
    for (int step = 0; step < 6; ++step) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      for (std::uint32_t i = random() % 4; i > 0; --i) {
        ASSERT_NO_FATAL_FAILURE(edit(random, context, solution));
      }
      ASSERT_TRUE(solution.solve_roughly(context, options).ok());
      if (step % 3 == 1) {
        const Picture exact = diffused(solution.document(), options);
        const double missed = mean_difference(solution.picture(), exact, 96);
        EXPECT_LT(missed, 6);
        sum += missed;
        ++pictures;
      }
      if (step % 3 != 2) continue;
      ASSERT_TRUE(solution.solve(context, options).ok());
      ASSERT_TRUE(is_exact(solution, options));
    }
  }
  EXPECT_LT(sum / pictures, 1);
}

/// A viewer that follows the deltas shows the picture.
TEST(Rough, pictures_tell_what_is_new) {
  const DiffuseOptions options{.pixels_per_unit = 0.5, .max_error = 8};
  for (std::uint32_t seed = 0; seed < kRoughDocuments / 3; ++seed) {
    Context context;
    Solution solution = solved(context, test::random_document(800 + seed), options);
    std::mt19937 random(seed);
    std::vector<PatchLayer> copy = solution.picture().layers;
    for (int step = 0; step < 10; ++step) {
      ASSERT_NO_FATAL_FAILURE(edit(random, context, solution));
      const bool is_last = step % 5 == 4;
      ASSERT_TRUE(is_last ? solution.solve(context, options).ok()
                          : solution.solve_roughly(context, options).ok());
      for (const std::uint32_t i : solution.take_delta().layers) {
        copy[i] = solution.picture().layers[i];
      }
      Picture followed = solution.picture();
      followed.layers = copy;
      ASSERT_EQ(difference_of(solution.picture(), followed), "") << seed << ", " << step;
    }
  }
}

TEST(Rough, pictures_have_the_same_bits_for_any_thread_count) {
  const auto with_threads = [](int threads) {
    ThreadPool pool(threads);
    Context context{.executor = &pool};
    Solution solution = solved(context, circles_in_layers());
    move_two(context, solution, 3);
    EXPECT_TRUE(solution.solve_roughly(context, {}).ok());
    return solution.picture();
  };
  EXPECT_EQ(difference_of(with_threads(1), with_threads(3)), "");
}

TEST(Rough, pictures_that_are_cancelled_leave_the_last_one) {
  Context context;
  Solution solution = solved(context, circles_in_layers());
  const Picture before = solution.picture();
  move_two(context, solution, 2);
  int cancelled = 0;
  for (std::uint64_t poll = 1;; poll += 1 + poll / 16) {
    Context hurried;
    test::CancelAt watch(poll, hurried.cancel);
    hurried.poll_watch = &watch;
    const Status status = solution.solve_roughly(hurried, {});
    if (status.ok()) break;
    ++cancelled;
    ASSERT_EQ(status.code, StatusCode::cancelled);
    ASSERT_EQ(difference_of(solution.picture(), before), "");
    ASSERT_TRUE(solution.take_delta().empty());
  }
  EXPECT_GT(cancelled, 10);
  EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.5);
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_TRUE(is_exact(solution));
}

TEST(Rough, pictures_without_memory_leave_the_last_one) {
  std::size_t made = 0, refused = 0;
  for (std::size_t room = 0; made == 0 || room < 60'000; room += 1 + room / 4) {
    SCOPED_TRACE(room);
    Context context;
    Solution solution = solved(context, circles_in_layers());
    move_two(context, solution, 2);
    const Picture before = solution.picture();
    {
      ScopedCharge others;
      ASSERT_TRUE(others.add(context, context.budget.room() - room, "others").ok());
      const Status status = solution.solve_roughly(context, {});
      status.ok() ? ++made : ++refused;
      if (!status) {
        ASSERT_EQ(status.limit, "memory");
        ASSERT_EQ(difference_of(solution.picture(), before), "");
      }
    }
    ASSERT_TRUE(solution.solve(context, {}).ok());
    ASSERT_TRUE(is_exact(solution));
    ASSERT_EQ(context.budget.used(), bytes_of(solution.document()) + bytes_of(solution.picture()));
  }
  EXPECT_GT(refused, 5u);
}

}  // namespace
}  // namespace sfumato
