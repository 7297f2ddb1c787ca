#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "solve/diffused.hpp"
#include "solve/solved.hpp"
#include "support/random_document.hpp"
#include "support/same_picture.hpp"

namespace sfumato {
namespace {

bool is_same(const ExactEnd& a, const ExactEnd& b) {
  return a.position == b.position && a.direction == b.direction && a.bend == b.bend &&
         a.reach == b.reach && a.weight == b.weight && a.blur_positive == b.blur_positive &&
         a.blur_negative == b.blur_negative && std::ranges::equal(a.positive, b.positive) &&
         std::ranges::equal(a.negative, b.negative);
}

bool is_same(const ExactField& a, const ExactField& b) {
  const auto same_end = [](const ExactEnd& x, const ExactEnd& y) { return is_same(x, y); };
  return a.channel_count == b.channel_count && a.edge == b.edge &&
         test::same_bits(a.side, b.side) && std::ranges::equal(a.end, b.end, same_end);
}

/// Returns the difference of two layers as rays meet them; empty: none.
std::string difference_of(const ExactLayer& a, const ExactLayer& b) {
  if (a.tolerance != b.tolerance) return "tolerance";
  if (!test::same_bits(a.vertex_position, b.vertex_position)) return "vertices";
  if (a.triangle_vertex != b.triangle_vertex) return "triangles";
  if (a.field.size() != b.field.size()) return "fields";
  for (std::size_t i = 0; i < a.field.size(); ++i)
    if (!is_same(a.field[i], b.field[i])) return "field " + std::to_string(i);
  return "";
}

void expect_exact_layers_as_diffused(Solution& solution, DiffuseOptions options) {
  Context context;
  ASSERT_TRUE(solution.solve(context, options));
  options.exact_fields = true;
  const Picture expected = test::diffused(solution.document(), options);
  for (std::uint32_t i = 0; i < expected.layers.size(); ++i) {
    const Result<ExactLayer> exact = solution.exact_layer(context, i);
    ASSERT_TRUE(exact) << to_string(exact.status());
    EXPECT_EQ(difference_of(*exact, expected.layers[i].exact), "") << "layer " << i;
  }
}

TEST(ExactLayerOfASolution, is_that_of_diffuse_after_changes_too) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Context context;
    Document document = test::random_document(seed);
    Solution solution = test::solution_of(context, std::move(document));
    DiffuseOptions options;
    options.pixels_per_unit = seed % 3 == 0 ? 4 : 1;
    expect_exact_layers_as_diffused(solution, options);
    const Document& now = solution.document();
    if (now.layers.empty() || now.layers[0].curves.empty()) continue;
    Curve moved = now.layers[0].curves[0];
    for (Vec2& point : moved.control_points) point = point + Vec2{0.5, 0.25};
    ASSERT_TRUE(solution.apply(context, ReplaceCurve{0, 0, std::move(moved)}));
    expect_exact_layers_as_diffused(solution, options);
  }
}

TEST(ExactLayerOfASolution, is_refused_where_none_is_solved) {
  Context context;
  Solution solution = test::solution_of(context, test::random_document(3));
  const auto code = [&](std::uint32_t layer) {
    return solution.exact_layer(context, layer).status().code;
  };
  EXPECT_EQ(code(0), StatusCode::bad_input);
  ASSERT_TRUE(solution.solve(context, {}));
  EXPECT_EQ(code(0), StatusCode::ok);
  EXPECT_EQ(code(1000), StatusCode::bad_input);
  const Curve same = solution.document().layers[0].curves[0];
  ASSERT_TRUE(solution.apply(context, ReplaceCurve{0, 0, same}));
  EXPECT_EQ(code(0), StatusCode::bad_input);
}

}  // namespace
}  // namespace sfumato
