#include "sfumato/document/change.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <variant>
#include <vector>

#include "support/drawing.hpp"
#include "support/same_document.hpp"

namespace sfumato {
namespace {

using test::circle_curve;
using test::colored;
using test::kBlue;
using test::kRed;
using test::same_document;
using test::straight_curve;

Document two_layers() {
  Document document = test::one_layer({colored(straight_curve({10, 10}, {90, 80}), kRed, kBlue),
                                       colored(circle_curve({50, 50}, 20), kBlue, kRed)});
  document.layers.push_back({"other", {colored(circle_curve({20, 20}, 5), kRed, kBlue)}});
  document.stack.push_back(LayerInstance{1, {}});
  return document;
}

Curve inserted_curve() {
  return colored(straight_curve({0, 50}, {100, 50}), kBlue, kRed);
}

Change one_of(int kind) {
  Document document = two_layers();
  switch (kind) {
    case 0:
      return ReplaceCurve{0, 1, inserted_curve()};
    case 1:
      return InsertCurve{0, 1, inserted_curve()};
    case 2:
      return InsertCurve{1, 1, inserted_curve()};
    case 3:
      return RemoveCurve{0, 0};
    case 4:
      return RemoveCurve{1, 0};
    case 5:
      return ReplaceStack{{document.stack[1], document.stack[0]}};
    default:
      document.artboard = {{5, 5}, {70, 60}};
      document.layers.pop_back();
      document.stack.pop_back();
      return ReplaceDocument{std::move(document)};
  }
}

constexpr int kKinds = 7;

Change take(Result<Change> change) {
  EXPECT_TRUE(change.ok()) << to_string(change.status());
  return std::move(*change);
}

TEST(Change, is_taken_back_by_what_it_returns_and_made_again_by_what_that_returns) {
  for (int kind = 0; kind < kKinds; ++kind) {
    SCOPED_TRACE(kind);
    Document document = two_layers();
    const Change inverse = take(apply_change({}, document, one_of(kind)));
    const Document changed = document;
    EXPECT_FALSE(same_document(changed, two_layers()));
    const Change again = take(apply_change({}, document, inverse));
    EXPECT_TRUE(same_document(document, two_layers()));
    take(apply_change({}, document, again));
    EXPECT_TRUE(same_document(document, changed));
  }
}

TEST(Change, does_what_it_says) {
  Document document = two_layers();
  const std::vector<Curve> before = document.layers[0].curves;
  take(apply_change({}, document, InsertCurve{0, 1, inserted_curve()}));
  EXPECT_EQ(document.layers[0].curves, (std::vector{before[0], inserted_curve(), before[1]}));
  take(apply_change({}, document, InsertCurve{0, 3, before[0]}));
  EXPECT_EQ(document.layers[0].curves,
            (std::vector{before[0], inserted_curve(), before[1], before[0]}));
  take(apply_change({}, document, RemoveCurve{0, 0}));
  EXPECT_EQ(document.layers[0].curves, (std::vector{inserted_curve(), before[1], before[0]}));
  take(apply_change({}, document, ReplaceCurve{0, 2, before[1]}));
  EXPECT_EQ(document.layers[0].curves, (std::vector{inserted_curve(), before[1], before[1]}));
}

void expect_refused(const Context& context, const Change& change, StatusCode code) {
  Document document = two_layers();
  const auto result = apply_change(context, document, change);
  EXPECT_EQ(result.status().code, code) << to_string(result.status());
  EXPECT_TRUE(same_document(document, two_layers()));
}

TEST(Change, of_what_is_not_there_is_refused_and_changes_nothing) {
  constexpr std::uint32_t kHuge = std::numeric_limits<std::uint32_t>::max();
  for (const std::uint32_t layer : {2u, kHuge}) {
    expect_refused({}, ReplaceCurve{layer, 0, inserted_curve()}, StatusCode::bad_input);
    expect_refused({}, InsertCurve{layer, 0, inserted_curve()}, StatusCode::bad_input);
    expect_refused({}, RemoveCurve{layer, 0}, StatusCode::bad_input);
  }
  expect_refused({}, ReplaceCurve{0, 2, inserted_curve()}, StatusCode::bad_input);
  expect_refused({}, RemoveCurve{0, 2}, StatusCode::bad_input);
  expect_refused({}, RemoveCurve{0, kHuge}, StatusCode::bad_input);
  expect_refused({}, InsertCurve{0, 3, inserted_curve()}, StatusCode::bad_input);
  expect_refused({}, InsertCurve{0, kHuge, inserted_curve()}, StatusCode::bad_input);
}

TEST(Change, that_would_make_the_document_invalid_is_refused_and_changes_nothing) {
  Curve short_one = inserted_curve();
  short_one.control_points.pop_back();
  Curve far = inserted_curve();
  far.control_points[2].x = std::numeric_limits<double>::quiet_NaN();
  Curve shaderless = inserted_curve();
  shaderless.left.color = {ShaderKind::image_domain, {}, 0};
  for (const Curve& curve : {short_one, far, shaderless}) {
    expect_refused({}, ReplaceCurve{0, 0, curve}, StatusCode::bad_input);
    expect_refused({}, InsertCurve{0, 0, curve}, StatusCode::bad_input);
  }
  expect_refused({}, ReplaceStack{{LayerInstance{2, {}}}}, StatusCode::bad_input);
  expect_refused({}, ReplaceStack{{GroupBegin{}}}, StatusCode::bad_input);
  expect_refused({}, ReplaceDocument{}, StatusCode::bad_input);
}

TEST(Change, beyond_a_limit_is_refused_and_changes_nothing) {
  Context context;
  context.limits.curves = 3;
  expect_refused(context, InsertCurve{0, 0, inserted_curve()}, StatusCode::limit);
  Document document = two_layers();
  take(apply_change(context, document, ReplaceCurve{0, 0, inserted_curve()}));
}

/// Returns a layer of curves that use two of three shaders.
Document shaded_document() {
  Document document = two_layers();
  GradientFill gradient;
  gradient.stops.push_back({0, kRed, 1});
  for (int i = 0; i < 3; ++i) document.shaders.push_back({"paint", gradient});
  for (const std::uint32_t i : {0u, 1u})
    document.layers[0].curves[i].left.color = {ShaderKind::image_domain, {}, i};
  return document;
}

/// Returns curves that are valid, invalid, or beyond a limit.
std::vector<Curve> curves_to_judge() {
  std::vector<Curve> curves(9, inserted_curve());
  curves[1] = circle_curve({30, 30}, 10);
  curves[2].left.color.stops.stops = {{0, kRed}, {0.4, kBlue}, {1, kRed}};
  curves[3].left.color.stops.stops = {{0.5, kRed}, {0.4, kBlue}};
  curves[4].right.blur_radius.stops = {{0, -1.0f}};
  curves[5].weight = 0;
  for (std::uint32_t i = 0; i < 3; ++i)
    curves[6 + i].right.color = {ShaderKind::image_domain, {}, i + 1};
  return curves;
}

/// Returns the status of a check of the whole document with the change.
Status judged_as_a_whole(const Context& context, const Change& change) {
  Document document = shaded_document();
  if (const auto* replace = std::get_if<ReplaceCurve>(&change)) {
    document.layers[replace->layer].curves[replace->curve] = replace->value;
  } else if (const auto* insert = std::get_if<InsertCurve>(&change)) {
    std::vector<Curve>& curves = document.layers[insert->layer].curves;
    curves.insert(curves.begin() + insert->curve, insert->value);
  }
  return validate(context, document);
}

TEST(Change, of_a_curve_is_judged_as_the_whole_document_would_be) {
  int refused = 0, made = 0;
  for (int limit = 0; limit < 6; ++limit) {
    Context context;
    if (limit == 1) context.limits.control_points = 34;  // the present number
    if (limit == 2) context.limits.stops = 4;
    if (limit == 3) context.limits.stops_per_list = 2;
    if (limit == 4) context.limits.shaders_per_layer = 2;
    if (limit == 5) context.limits.curves = 3;
    ASSERT_TRUE(validate(context, shaded_document()).ok()) << limit;
    for (const Curve& curve : curves_to_judge()) {
      for (const Change& change :
           {Change(ReplaceCurve{0, 0, curve}), Change(ReplaceCurve{0, 1, curve}),
            Change(InsertCurve{0, 2, curve}), Change(ReplaceCurve{1, 0, curve})}) {
        Document document = shaded_document();
        const Status status = apply_change(context, document, change).status();
        const Status expected = judged_as_a_whole(context, change);
        EXPECT_EQ(status.code, expected.code) << limit;
        EXPECT_EQ(status.message, expected.message) << limit;
        ++(status ? made : refused);
      }
    }
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(made, 50);
}

TEST(Change, that_is_cancelled_changes_nothing) {
  Context context;
  context.cancel = true;
  for (int kind = 0; kind < kKinds; ++kind) {
    SCOPED_TRACE(kind);
    expect_refused(context, one_of(kind), StatusCode::cancelled);
  }
}

TEST(Change, knows_the_memory_of_what_it_brings) {
  EXPECT_EQ(bytes_of(Change(RemoveCurve{0, 0})), 0u);
  const std::size_t points = inserted_curve().control_points.size() * sizeof(Vec2);
  EXPECT_GE(bytes_of(Change(ReplaceCurve{0, 0, inserted_curve()})), points);
  EXPECT_GE(bytes_of(Change(InsertCurve{0, 0, inserted_curve()})), points);
  EXPECT_GE(bytes_of(one_of(6)), 2 * points);
}

}  // namespace
}  // namespace sfumato
