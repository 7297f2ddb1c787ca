#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
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

/// Drags of curves in a document with a solution.
namespace sfumato {
namespace {

using test::circle_at;
using test::circle_curve;
using test::circles;
using test::colored;
using test::difference_of;
using test::diffused;
using test::expecting_drags;
using test::kGreen;
using test::kRed;
using test::mean_difference;
using test::solved;

constexpr std::uint64_t kDraggedDocuments = SFUMATO_HAS_SANITIZER ? 2 : 10;

TEST(Drag, shows_the_curve_where_it_is) {
  Context context;
  Solution solution = solved(context, circles());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  EXPECT_TRUE(solution.take_delta().empty());
  for (const Vec2 at : {Vec2{35, 33}, Vec2{60, 60}, Vec2{-8, 50}, Vec2{110, 110}, Vec2{30, 30}}) {
    SCOPED_TRACE(std::to_string(at.x));
    DiffuseStats stats;
    ASSERT_TRUE(solution.drag(context, {circle_at(at)}, &stats).ok());
    EXPECT_EQ(solution.document().layers[0].curves[0], circle_at(at));
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.3);
    EXPECT_GT(stats.nodes, 0u);
    const PictureDelta delta = solution.take_delta();
    EXPECT_FALSE(delta.frame);
    EXPECT_EQ(delta.layers, std::vector<std::uint32_t>{0});
  }
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
}

TEST(Drag, depends_on_where_the_curve_is_alone) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({41, 37})}).ok());
  const Picture straight = solution.picture();
  ASSERT_TRUE(solution.drag(context, {circle_at({80, 20})}).ok());
  EXPECT_NE(difference_of(solution.picture(), straight), "");
  ASSERT_TRUE(solution.solve(context, {}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({150, 20})}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({41, 37})}).ok());
  EXPECT_EQ(difference_of(solution.picture(), straight), "");
}

TEST(Drag, leaves_nothing_to_say_of_layers_that_are_gone) {
  Context context;
  Document document = test::one_layer({colored(circle_curve({70, 70}, 9), kGreen, kRed)});
  document.layers.push_back(circles().layers[0]);
  document.stack.push_back(LayerInstance{1, {}, 1});
  Solution solution = expecting_drags(context, document);
  ASSERT_TRUE(solution.begin_drag(context, 1, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({41, 37})}).ok());
  EXPECT_TRUE(solution.take_delta().rows.empty()) << "a whole layer is new";
  ASSERT_TRUE(solution.drag(context, {circle_at({42, 37})}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({43, 38})}).ok());
  document.layers.pop_back();
  document.stack.pop_back();
  ASSERT_TRUE(solution.apply(context, ReplaceDocument{document}).ok());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  const PictureDelta delta = solution.take_delta();
  EXPECT_TRUE(delta.frame);
  EXPECT_TRUE(delta.rows.empty());
}

/// Returns the largest difference of layers with the same tables, in code values.
float most_code_values(const PatchLayer& a, const PatchLayer& b) {
  EXPECT_EQ(a.triangle_vertex, b.triangle_vertex);
  EXPECT_EQ(a.color.triangle_node, b.color.triangle_node);
  return 255 * test::largest_difference(a.color, b.color);
}

TEST(Drag, without_time_waits_with_what_has_a_color) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  DiffuseStats exact, hurried, rest;
  ASSERT_TRUE(solution.drag(context, {circle_at({42, 40})}, &exact).ok());
  EXPECT_EQ(solution.waiting_nodes(), 0u);
  const PatchLayer whole = solution.picture().layers[0];
  ASSERT_TRUE(solution.drag(context, {circle_at({60, 60})}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({42, 40})}, &hurried, 0).ok());
  const std::size_t left = solution.waiting_nodes();
  EXPECT_GT(left, 0u);
  EXPECT_EQ(hurried.nodes + left, exact.nodes);
  EXPECT_GT(most_code_values(solution.picture().layers[0], whole), 1);
  ASSERT_TRUE(solution.drag_more(context, &rest).ok());
  EXPECT_EQ(solution.waiting_nodes(), 0u);
  EXPECT_EQ(rest.nodes, left);
  EXPECT_LT(most_code_values(solution.picture().layers[0], whole), 0.5);
  ASSERT_TRUE(solution.drag_more(context, &rest).ok());
  EXPECT_EQ(rest.nodes, left) << "nothing is left";
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
}

/// A small step changes little if the last frame's values are shown, and much if the values without
/// the curve were shown.
TEST(Drag, shows_what_waits_as_the_last_frame_did) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({42, 40})}).ok());
  for (int step = 1; step < 4; ++step) {
    ASSERT_TRUE(solution.drag(context, {circle_at({42 + 0.01 * step, 40})}, nullptr, 0).ok());
    EXPECT_GT(solution.waiting_nodes(), 0u);
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.3) << step;
  }
}

TEST(Drag, goes_on_a_little_at_a_time_with_what_matters_most) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({42, 40})}, nullptr, 0).ok());
  const Picture exact = diffused(solution.document());
  std::vector<double> missed{mean_difference(solution.picture(), exact)};
  while (const std::size_t left = solution.waiting_nodes()) {
    ASSERT_TRUE(solution.drag_more(context, nullptr, 0).ok());
    ASSERT_LT(solution.waiting_nodes(), left);
    missed.push_back(mean_difference(solution.picture(), exact));
  }
  ASSERT_GT(missed.size(), 2u);
  EXPECT_LT(missed[1] - missed.back(), 0.7 * (missed[0] - missed.back()));
  EXPECT_LT(missed.back(), 0.3);
}

TEST(Drag, with_and_without_time_ends_alike_whatever_is_dragged) {
  std::size_t waited = 0;
  constexpr std::uint64_t kFirst = 12;  // in which nodes may wait
  for (std::uint64_t seed = kFirst; seed < kFirst + kDraggedDocuments / 2; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    DiffuseOptions options;
    options.max_error = 4;
    Solution patient = solved(context, test::random_document(300 + seed), options);
    Solution hasty = solved(context, patient.document(), options);
    const auto layer = static_cast<std::uint32_t>(random() % patient.document().layers.size());
    const auto count = patient.document().layers[layer].curves.size();
    if (count == 0) continue;
    const auto curve = static_cast<std::uint32_t>(random() % count);
    ASSERT_TRUE(patient.begin_drag(context, layer, {curve}).ok());
    ASSERT_TRUE(hasty.begin_drag(context, layer, {curve}).ok());
    for (int frame = 0; frame < 4; ++frame) {
      Curve moved = patient.document().layers[layer].curves[curve];
      for (Vec2& p : moved.control_points) p = p + Vec2{double(random() % 20) - 10, 3};
      ASSERT_TRUE(patient.drag(context, {moved}).ok());
      ASSERT_TRUE(hasty.drag(context, {moved}, nullptr, 0).ok());
      waited += hasty.waiting_nodes();
      while (frame % 2 == 1 && hasty.waiting_nodes() > 0) {
        ASSERT_TRUE(hasty.drag_more(context, nullptr, 0).ok());
      }
      if (hasty.waiting_nodes() > 0) continue;
      EXPECT_LT(mean_difference(patient.picture(), hasty.picture()), 0.05) << frame;
    }
    ASSERT_TRUE(hasty.solve(context, options).ok());
    ASSERT_EQ(difference_of(hasty.picture(), diffused(hasty.document(), options)), "");
  }
  EXPECT_GT(waited, 0u);
}

TEST(Drag, that_is_cancelled_going_on_leaves_what_was_left) {
  Context owner;
  Solution solution = expecting_drags(owner, circles());
  ASSERT_TRUE(solution.begin_drag(owner, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(owner, {circle_at({42, 40})}, nullptr, 0).ok());
  const std::size_t left = solution.waiting_nodes();
  const Picture picture = solution.picture();
  int cancelled = 0;
  for (std::uint64_t poll = 1;; poll += 1 + poll / 16) {
    test::CancelAt watch(poll, owner.cancel);
    owner.poll_watch = &watch;
    const Status status = solution.drag_more(owner);
    owner.poll_watch = nullptr;
    owner.cancel = false;
    if (status.ok()) break;
    ++cancelled;
    ASSERT_EQ(status.code, StatusCode::cancelled);
    ASSERT_EQ(solution.waiting_nodes(), left);
    ASSERT_EQ(difference_of(solution.picture(), picture), "");
  }
  EXPECT_GT(cancelled, 5);
  EXPECT_EQ(solution.waiting_nodes(), 0u);
}

/// Wherever memory runs out in a frame, the waiting values are from the previous frame.
TEST(Drag, that_fails_goes_on_with_the_curve_as_it_was) {
  Context owner;
  Solution solution = expecting_drags(owner, circles());
  ASSERT_TRUE(solution.begin_drag(owner, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(owner, {circle_at({42, 40})}, nullptr, 0).ok());
  ASSERT_TRUE(solution.drag(owner, {circle_at({42, 40})}, nullptr, 0).ok());
  const std::size_t free = owner.budget.room();
  int failed = 0;
  for (std::size_t room = 0; room < free; room += 1 + room / 3) {
    ASSERT_TRUE(solution.drag(owner, {circle_at({42, 40})}, nullptr, 0).ok());
    ASSERT_GT(solution.waiting_nodes(), 0u);
    {
      const std::size_t now = owner.budget.room();
      if (room >= now || room > std::size_t{8} << 20) break;
      ScopedCharge charge;
      ASSERT_TRUE(charge.add(owner, now - room, "a test").ok());
      if (solution.drag(owner, {circle_at({60, 60})}, nullptr, 0).ok()) continue;
    }
    ++failed;
    EXPECT_EQ(solution.document().layers[0].curves[0], circle_at({42, 40}));
    ASSERT_TRUE(solution.drag_more(owner).ok());
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.3) << room;
  }
  EXPECT_GT(failed, 0);
}

TEST(Drag, takes_the_same_memory_frame_after_frame) {
  for (const double seconds : {0.0, std::numeric_limits<double>::infinity()}) {
    SCOPED_TRACE(seconds);
    Context context;
    Solution solution = expecting_drags(context, circles());
    ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
    std::size_t most = 0;
    for (int frame = 0; frame < 60; ++frame) {
      const Vec2 center{42.0 + frame % 5, 40.0 - frame % 3};
      ASSERT_TRUE(solution.drag(context, {circle_at(center)}, nullptr, seconds).ok());
      if (frame % 4 == 0) {
        ASSERT_TRUE(solution.drag_more(context, nullptr, 0).ok());
      }
      solution.take_delta();
      if (frame < 30) most = std::max(most, context.budget.used());
      EXPECT_LE(context.budget.used(), most) << frame;
    }
  }
}

TEST(Drag, refuses_times_that_are_none) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  EXPECT_EQ(solution.drag_more(context).code, StatusCode::bad_input) << "nothing is dragged";
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  EXPECT_TRUE(solution.drag_more(context).ok()) << "nothing is left";
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double seconds : {-1.0, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(solution.drag(context, {circle_at({42, 40})}, nullptr, seconds).code,
              StatusCode::bad_input);
    EXPECT_EQ(solution.drag_more(context, nullptr, seconds).code, StatusCode::bad_input);
  }
  EXPECT_EQ(solution.document().layers[0].curves[0], circle_at({30, 30}));
}

/// Also if the next frame is within it again.
TEST(Drag, beyond_all_room_is_solved_roughly) {
  Context context;
  Solution solution = solved(context, circles());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  DiffuseStats exact, rough;
  for (const Vec2 center : {Vec2{9000, -9000}, Vec2{40, 40}, Vec2{-9000, 9000}}) {
    ASSERT_TRUE(solution.drag(context, {circle_at(center)}, &rough).ok());
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.3);
  }
  ASSERT_TRUE(solution.solve(context, {}, &exact).ok());
  EXPECT_EQ(exact.curves, 2u) << "the layer was not exact";
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
}

TEST(Drag, takes_little_beyond_the_picture_too) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  DiffuseStats solve;
  ASSERT_TRUE(diffuse(context, solution.document(), {}, &solve).ok());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({150, 40})}).ok());
  for (const Vec2 center : {Vec2{160, 30}, Vec2{-60, 50}, Vec2{30, 40}}) {
    DiffuseStats frame;
    ASSERT_TRUE(solution.drag(context, {circle_at(center)}, &frame).ok());
    const bool is_outside = center.x < 0 || center.x > 100;
    EXPECT_TRUE(!is_outside || frame.nodes < solve.nodes) << center.x << ": " << frame.nodes;
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.3) << center.x;
  }
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
}

TEST(Drag, begins_from_what_solve_left_or_solves_the_layer) {
  Context owner, visitor;
  ThreadPool threads(3);
  owner.executor = &threads;
  Solution known = expecting_drags(owner, circles()), unknown = solved(owner, circles());
  for (const std::uint32_t layer : {0u, 1u}) {
    ASSERT_TRUE(known.begin_drag(owner, layer, {0}).ok());
    ASSERT_TRUE(unknown.begin_drag(visitor, layer, {0}).ok());
    ASSERT_TRUE(known.drag(owner, {circle_at({44, 52})}).ok());
    ASSERT_TRUE(unknown.drag(visitor, {circle_at({44, 52})}).ok());
    EXPECT_LT(mean_difference(known.picture(), unknown.picture()), 0.1);
    ASSERT_TRUE(known.solve(owner, {}).ok());
    ASSERT_TRUE(unknown.solve(visitor, {}).ok());
    EXPECT_EQ(difference_of(known.picture(), unknown.picture()), "");
  }
  unknown.end_drag();
  EXPECT_EQ(visitor.budget.used(), 0u);
}

/// The reused data follows its layer to another place, and is not used if the layer is shown in
/// another way.
TEST(Drag, begins_from_what_is_known_of_the_layer_as_it_is_shown) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  Document other = circles();
  std::swap(other.layers[0], other.layers[1]);
  other.stack = {LayerInstance{1, {}}, LayerInstance{0, {}, 0.5f}};
  ASSERT_TRUE(solution.apply(context, ReplaceDocument{other}).ok());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  for (const double scale : {1.0, 3.0}) {
    other.stack[0] = LayerInstance{1, Affine{scale, 0, 0, scale, 0, 0}};
    ASSERT_TRUE(solution.apply(context, ReplaceStack{other.stack}).ok());
    ASSERT_TRUE(solution.solve(context, {}).ok());
    ASSERT_TRUE(solution.begin_drag(context, 1, {0}).ok());
    ASSERT_TRUE(solution.drag(context, {circle_at({34, 32})}).ok());
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.3) << scale;
    ASSERT_TRUE(solution.solve(context, {}).ok());
  }
}

TEST(Drag, whose_begin_is_cancelled_begins_as_well_the_next_time) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  const std::size_t used = context.budget.used();
  int cancelled = 0;
  for (std::uint64_t poll = 1;; poll += 1 + poll / 16) {
    test::CancelAt watch(poll, context.cancel);
    context.poll_watch = &watch;
    const Status status = solution.begin_drag(context, 0, {0});
    context.poll_watch = nullptr;
    context.cancel = false;
    if (status.ok()) break;
    ++cancelled;
    ASSERT_EQ(status.code, StatusCode::cancelled);
    ASSERT_EQ(context.budget.used(), used) << poll;
  }
  EXPECT_GT(cancelled, 20);
  ASSERT_TRUE(solution.drag(context, {circle_at({34, 32})}).ok());
  EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 0.3);
}

TEST(Drag, ends_with_other_changes) {
  Context context;
  Solution solution = solved(context, circles());
  EXPECT_EQ(solution.drag(context, {circle_at({30, 30})}).code, StatusCode::bad_input);
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.apply(context, RemoveCurve{0, 1}).ok());
  EXPECT_EQ(solution.drag(context, {circle_at({30, 30})}).code, StatusCode::bad_input);
  EXPECT_EQ(solution.begin_drag(context, 0, {0}).code, StatusCode::bad_input) << "not solved";
  ASSERT_TRUE(solution.solve(context, {}).ok());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  solution.end_drag();
  EXPECT_EQ(solution.drag(context, {circle_at({30, 30})}).code, StatusCode::bad_input);
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  DiffuseOptions finer;
  finer.pixels_per_unit = 2;
  ASSERT_TRUE(solution.solve(context, finer).ok());
  EXPECT_EQ(solution.drag(context, {circle_at({30, 30})}).code, StatusCode::bad_input);
}

TEST(Drag, refuses_what_is_not_there_and_what_is_no_curve) {
  Context context;
  Solution solution = solved(context, circles());
  EXPECT_EQ(solution.begin_drag(context, 2, {0}).code, StatusCode::bad_input);
  EXPECT_EQ(solution.begin_drag(context, 0, {2}).code, StatusCode::bad_input);
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  const Document before = solution.document();
  const Picture picture = solution.picture();
  Curve bad = circle_at({30, 30});
  bad.control_points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solution.drag(context, {bad}).code, StatusCode::bad_input);
  bad.control_points.clear();
  EXPECT_EQ(solution.drag(context, {bad}).code, StatusCode::bad_input);
  EXPECT_EQ(solution.document().layers[0].curves, before.layers[0].curves);
  EXPECT_EQ(difference_of(solution.picture(), picture), "");
}

TEST(Drag, of_a_layer_that_nothing_shows_changes_the_document_alone) {
  Context context;
  Document document = circles();
  document.stack.pop_back();
  Solution solution = solved(context, document);
  ASSERT_TRUE(solution.begin_drag(context, 1, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({10, 10})}).ok());
  EXPECT_EQ(solution.document().layers[1].curves[0], circle_at({10, 10}));
  EXPECT_TRUE(solution.take_delta().empty());
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
}

TEST(Drag, that_is_cancelled_leaves_everything_as_it_was) {
  Context owner;
  Solution solution = solved(owner, circles());
  ASSERT_TRUE(solution.begin_drag(owner, 0, {0}).ok());
  const Picture picture = solution.picture();
  int cancelled = 0;
  for (std::uint64_t poll = 1;; poll += 1 + poll / 16) {
    Context context;
    test::CancelAt watch(poll, context.cancel);
    context.poll_watch = &watch;
    const Status status = solution.drag(context, {circle_at({44, 52})});
    if (status.ok()) break;
    ++cancelled;
    ASSERT_EQ(status.code, StatusCode::cancelled);
    ASSERT_EQ(solution.document().layers[0].curves[0], circle_at({30, 30}));
    ASSERT_EQ(difference_of(solution.picture(), picture), "");
  }
  EXPECT_GT(cancelled, 20);
  ASSERT_TRUE(solution.solve(owner, {}).ok());
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
}

TEST(Drag, gives_back_all_memory) {
  Context context;
  {
    Solution solution = expecting_drags(context, circles());
    const std::size_t solved_bytes = context.budget.used();
    ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
    EXPECT_GT(context.budget.used(), solved_bytes);
    ASSERT_TRUE(solution.drag(context, {circle_at({44, 52})}).ok());
    solution.end_drag();
    ASSERT_TRUE(solution.drag(context, {}).code == StatusCode::bad_input);
    ASSERT_TRUE(solution.solve(context, {}).ok());
    ASSERT_TRUE(solution.apply(context, ReplaceCurve{0, 0, circle_at({30, 30})}).ok());
    ASSERT_TRUE(solution.solve(context, {}).ok());
    EXPECT_EQ(context.budget.used(), solved_bytes);
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Drag, ends_in_the_picture_of_diffuse_whatever_is_dragged) {
  for (std::uint64_t seed = 0; seed < kDraggedDocuments; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    DiffuseOptions options;
    options.max_error = 4;
    Solution solution = solved(context, test::random_document(100 + seed), options);
    const auto layers = static_cast<std::uint32_t>(solution.document().layers.size());
    for (int drag = 0; drag < 3; ++drag) {
      const auto layer = static_cast<std::uint32_t>(random() % layers);
      const auto count = solution.document().layers[layer].curves.size();
      if (count == 0) continue;
      const auto curve = static_cast<std::uint32_t>(random() % count);
      const Status begun = solution.begin_drag(context, layer, {curve});
      ASSERT_TRUE(begun.ok()) << to_string(begun);
      for (int frame = 0; frame < 3; ++frame) {
        Curve moved = solution.document().layers[layer].curves[curve];
        for (Vec2& p : moved.control_points) p = p + Vec2{double(random() % 30) - 15, 7};
        const Status status = solution.drag(context, {moved});
        ASSERT_TRUE(status.ok()) << to_string(status);
      }
      ASSERT_TRUE(solution.solve(context, options).ok());
      ASSERT_EQ(difference_of(solution.picture(), diffused(solution.document(), options)), "");
    }
  }
}

}  // namespace
}  // namespace sfumato
