// Sparse matrices compared with dense ones, bounded least squares compared with closed forms, and
// dropped stops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "sfumato/base/native/thread_pool.hpp"
#include "trace/fit/bounded_solve.hpp"
#include "trace/fit/prune.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/traced_curves.hpp"

namespace sfumato::tracing {
namespace {

/// A dense matrix, row by row.
struct Dense {
  std::size_t rows, columns;
  std::vector<double> value;
  double& at(std::size_t i, std::size_t j) { return value[i * columns + j]; }
  double at(std::size_t i, std::size_t j) const { return value[i * columns + j]; }
};

Dense zeros(std::size_t rows, std::size_t columns) {
  return {rows, columns, std::vector<double>(rows * columns)};
}

Dense random_dense(std::size_t rows, std::size_t columns, std::uint32_t seed) {
  std::mt19937 random(seed);
  Dense out = zeros(rows, columns);
  for (double& value : out.value) {
    if (random() % 8 == 0) value = static_cast<double>(random() % 2001) / 1000 - 1;
  }
  return out;
}

template <class Value>
Value take(Result<Value> result) {
  EXPECT_TRUE(result.ok()) << to_string(result.status());
  return std::move(*result);
}

SparseMatrix sparse_of(Context& context, const Dense& dense) {
  return take(build_rows(context, dense.rows, static_cast<std::uint32_t>(dense.columns),
                         [&](std::size_t i, RowSummer& sum) {
                           for (std::size_t j = dense.columns; j-- > 0;) {
                             const auto half = static_cast<float>(dense.at(i, j) / 2);
                             if (half == 0) continue;
                             sum.add(static_cast<std::uint32_t>(j), half);
                             sum.add(static_cast<std::uint32_t>(j), half);
                           }
                         }));
}

void expect_equal(const SparseMatrix& matrix, const Dense& dense) {
  ASSERT_EQ(matrix.row_count(), dense.rows);
  ASSERT_EQ(matrix.column_count, dense.columns);
  Dense listed = zeros(dense.rows, dense.columns);
  for (std::uint32_t i = 0; i < matrix.row_count(); ++i) {
    for (std::uint32_t k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k) {
      if (k > matrix.begin[i]) {
        ASSERT_LT(matrix.column[k - 1], matrix.column[k]);
      }
      listed.at(i, matrix.column[k]) += double{matrix.value[k]};
    }
  }
  for (std::size_t i = 0; i < dense.value.size(); ++i) {
    ASSERT_NEAR(listed.value[i], dense.value[i], 1e-4);
  }
}

TEST(Sparse, lists_the_entries_of_rows) {
  const Dense dense = random_dense(300, 130, 1);
  Context context;
  expect_equal(sparse_of(context, dense), dense);
  expect_equal(sparse_of(context, zeros(5, 3)), zeros(5, 3));
}

TEST(Sparse, transposes) {
  // Several threads transpose tall ones in slices.
  for (const auto& [rows, columns] : {std::pair<std::size_t, std::size_t>{300, 130}, {20000, 7}}) {
    const Dense dense = random_dense(rows, columns, 2);
    Dense expected = zeros(columns, rows);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) expected.at(j, i) = dense.at(i, j);
    }
    ThreadPool pool(2);
    Context context{.executor = &pool};
    expect_equal(take(transposed(context, sparse_of(context, dense))), expected);
  }
}

TEST(Sparse, multiplies_and_adds) {
  const Dense a = random_dense(200, 70, 3), b = random_dense(70, 90, 4);
  Dense expected = zeros(200, 90);
  for (std::size_t i = 0; i < 200; ++i) {
    for (std::size_t j = 0; j < 90; ++j) {
      for (std::size_t k = 0; k < 70; ++k) expected.at(i, j) += a.at(i, k) * b.at(k, j);
    }
  }
  Context context;
  expect_equal(take(product(context, sparse_of(context, a), sparse_of(context, b))), expected);
  const Dense c = random_dense(200, 70, 5);
  Dense sum = a;
  for (std::size_t i = 0; i < sum.value.size(); ++i) sum.value[i] += c.value[i];
  expect_equal(take(sum_of(context, sparse_of(context, a), sparse_of(context, c))), sum);
}

TEST(Sparse, makes_the_normal_matrix_with_weights_and_without) {
  const Dense a = random_dense(400, 90, 6);
  std::vector<float> weights;
  std::mt19937 random(7);
  for (int i = 0; i < 400; ++i) weights.push_back(static_cast<float>(random() % 100) / 50);
  Context context;
  const SparseMatrix matrix = sparse_of(context, a);
  const SparseMatrix transpose = take(transposed(context, matrix));
  for (const bool has_weights : {false, true}) {
    Dense expected = zeros(90, 90);
    for (std::size_t r = 0; r < 400; ++r) {
      const double weight = has_weights ? double{weights[r]} : 1.0;
      for (std::size_t i = 0; i < 90; ++i) {
        for (std::size_t j = 0; j < 90; ++j) expected.at(i, j) += weight * a.at(r, i) * a.at(r, j);
      }
    }
    const std::span<const float> used =
        has_weights ? std::span<const float>(weights) : std::span<const float>();
    expect_equal(take(normal_matrix(context, matrix, transpose, used)), expected);
  }
}

TEST(Sparse, multiplies_four_channels_side_by_side) {
  const Dense a = random_dense(700, 60, 8);
  std::vector<FourFloats> x, out(700);
  for (std::size_t j = 0; j < 60; ++j) {
    const auto v = static_cast<float>(j) / 60;
    x.push_back({v, 1 - v, v * v, 1});
  }
  Context context;
  ASSERT_TRUE(multiply(context, sparse_of(context, a), x, out).ok());
  for (std::size_t i = 0; i < 700; ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      double sum = 0;
      for (std::size_t j = 0; j < 60; ++j) sum += a.at(i, j) * double{x[j][c]};
      ASSERT_NEAR(out[i][c], sum, 1e-4);
    }
  }
}

FourFloats all(float value) {
  return {value, value, value, value};
}

/// Two unknowns, the same problem in all channels.
struct TwoUnknowns {
  Dense normal = zeros(2, 2);
  float b0 = 0, b1 = 0, pull = 0, even = 0;
  float low = -100, high = 100;

  std::vector<FourFloats> solve(float start = 0) const {
    Context context;
    const SparseMatrix matrix = sparse_of(context, normal);
    const std::vector<FourFloats> right{all(b0), all(b1)}, lows(2, all(low)), highs(2, all(high));
    const std::vector<std::uint8_t> has_next{1, 0};
    const std::vector<float> pulls(2, pull);
    std::vector<FourFloats> x(2, all(start));
    const Status status =
        solve_bounded(context, {matrix, right, has_next, lows, highs, pulls, even, {}}, x);
    EXPECT_TRUE(status.ok()) << to_string(status);
    return x;
  }
};

void expect_near(const std::vector<FourFloats>& x, double x0, double x1) {
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_NEAR(x[0][c], x0, 1e-3);
    EXPECT_NEAR(x[1][c], x1, 1e-3);
  }
}

TEST(SolveBounded, solves_the_normal_equations) {
  TwoUnknowns two{.normal = {2, 2, {2, 1, 1, 3}}, .b0 = 4, .b1 = 7};
  expect_near(two.solve(), 1, 2);
  expect_near(two.solve(50), 1, 2);
}

TEST(SolveBounded, is_pulled_to_where_it_begins) {
  TwoUnknowns two{.normal = {2, 2, {1, 0, 0, 1}}, .b0 = 4, .b1 = 8, .pull = 3};
  expect_near(two.solve(2), (4 + 3 * 2) / 4.0, (8 + 3 * 2) / 4.0);
}

TEST(SolveBounded, evens_out_neighbours) {
  TwoUnknowns two{.normal = {2, 2, {1, 0, 0, 1}}, .b0 = 0, .b1 = 3, .even = 1};
  expect_near(two.solve(), 1, 2);
}

TEST(SolveBounded, keeps_bounds_and_solves_for_the_rest) {
  TwoUnknowns two{.normal = {2, 2, {2, 1, 1, 2}}, .b0 = 6, .b1 = 3, .low = 0, .high = 2};
  // Without bounds (3, 0); with the first fixed at 2, the second is (3 - 2) / 2.
  expect_near(two.solve(), 2, 0.5);
}

TEST(SolveBounded, keeps_bounds_in_large_problems) {
  const Dense a = random_dense(500, 80, 9);
  Context context;
  const SparseMatrix matrix = sparse_of(context, a);
  const SparseMatrix transpose = take(transposed(context, matrix));
  const SparseMatrix normal = take(normal_matrix(context, matrix, transpose, {}));
  std::mt19937 random(10);
  std::vector<FourFloats> right(80), low(80, all(0)), high(80, all(1)), x(80, all(0.5f));
  for (FourFloats& b : right) b = all(static_cast<float>(random() % 2000) / 50 - 20);
  const std::vector<std::uint8_t> has_next(80, 0);
  const std::vector<float> pull(80, 0.01f);
  ASSERT_TRUE(solve_bounded(context, {normal, right, has_next, low, high, pull, 0, {}}, x).ok());
  int held = 0;
  for (const FourFloats& value : x) {
    for (const float v : value) {
      ASSERT_GE(v, 0);
      ASSERT_LE(v, 1);
      held += v == 0 || v == 1;
    }
  }
  EXPECT_GT(held, 20);
}

/// Returns a curve whose sides have stops at random places.
TracedCurve with_stops(std::size_t left, std::size_t right, std::uint32_t seed) {
  std::mt19937 random(seed);
  TracedCurve curve = test::traced(test::straight_curve({0, 0}, {50, 0}));
  for (const int s : {0, 1}) {
    SideStops& side = curve.side[static_cast<std::size_t>(s)];
    side = {};
    for (std::size_t i = 0; i < (s == 0 ? left : right); ++i) {
      side.place.push_back(static_cast<double>(random() % 1000) / 1000);
      const auto v = static_cast<float>(random() % 256) / 255;
      side.value.push_back({v, 1 - v, v * v, 1});
    }
    std::ranges::sort(side.place);
  }
  return curve;
}

/// Returns a curve whose left side has these values, evenly spaced, and its right side two stops.
TracedCurve with_left(const std::vector<SideValue>& values) {
  TracedCurve curve = test::traced(test::straight_curve({0, 0}, {50, 0}));
  SideStops& side = curve.side[0];
  side = {};
  for (const SideValue& value : values) {
    side.place.push_back(static_cast<double>(side.place.size()) / (values.size() - 1.0));
    side.value.push_back(value);
  }
  return curve;
}

SideValue grey(float v) {
  return {v, v, v, 1};
}

constexpr double kAnyCost = std::numeric_limits<double>::infinity();

TEST(PruneStops, gives_what_lies_between_those_that_are_left) {
  std::vector<TracedCurve> curves{with_stops(9, 1, 1), with_stops(0, 12, 2), with_stops(2, 7, 3)};
  const std::vector<float> weight(9 + 1 + 12 + 2 + 7, 1.0f);
  const std::vector<std::uint8_t> goes = stops_to_prune(curves, {weight, {}}, {0.3, kAnyCost});
  ASSERT_EQ(goes.size(), weight.size());
  EXPECT_GT(std::ranges::count(goes, 1), 3);
  EXPECT_LE(std::ranges::count(goes, 1), static_cast<std::ptrdiff_t>(0.3 * 31));
  Context context;
  const SparseMatrix matrix = take(values_without(context, curves, goes));
  std::vector<TracedCurve> pruned = curves;
  prune_stops(goes, pruned);
  std::vector<FourFloats> left, all_values(weight.size());
  for (const TracedCurve& curve : pruned) {
    for (const SideStops& side : curve.side) {
      left.insert(left.end(), side.value.begin(), side.value.end());
    }
  }
  ASSERT_EQ(matrix.column_count, left.size());
  ASSERT_TRUE(multiply(context, matrix, left, all_values).ok());
  std::size_t stop = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const std::size_t s : {0u, 1u}) {
      for (const double place : curves[i].side[s].place) {
        const SideValue expected = value_at(pruned[i].side[s], place);
        for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(all_values[stop][c], expected[c], 1e-5);
        ++stop;
      }
    }
  }
}

TEST(PruneStops, leaves_out_what_changes_least_but_no_neighbours_and_no_ends) {
  const TracedCurve curve = with_left({grey(0.0f), grey(0.1f), grey(0.2f), grey(0.9f), grey(0.0f)});
  const std::vector<float> weight(7, 1.0f);
  const std::vector<std::uint8_t> goes =
      stops_to_prune(std::span(&curve, 1), {weight, {}}, {1, kAnyCost});
  EXPECT_EQ(goes, (std::vector<std::uint8_t>{0, 1, 0, 1, 0, 0, 0}));
  EXPECT_EQ(
      std::ranges::count(stops_to_prune(std::span(&curve, 1), {weight, {}}, {0, kAnyCost}), 1), 0);
}

TEST(PruneStops, leaves_out_what_together_costs_no_more_than_it_may) {
  const TracedCurve curve = with_left({grey(0.0f), grey(0.1f), grey(0.0f), grey(0.5f), grey(0.0f)});
  const std::vector<float> weight(7, 10.0f);
  const auto goes_for = [&](double cost) {
    return stops_to_prune(std::span(&curve, 1), {weight, {}}, {1, cost});
  };
  const double first = 3 * 0.01 * 10, both = first + 3 * 0.25 * 10;
  EXPECT_EQ(goes_for(0.9 * first), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(goes_for(0.9 * both), (std::vector<std::uint8_t>{0, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(goes_for(1.1 * both), (std::vector<std::uint8_t>{0, 1, 0, 1, 0, 0, 0}));
}

TEST(PruneStops, counts_what_opacity_changes_where_it_counts) {
  const TracedCurve curve = with_left({{0, 0, 0, 0}, {0, 0, 0, 0.5f}, {0, 0, 0, 0}});
  const std::vector<float> weight(5, 1.0f);
  const auto count = [&](const PruneWeights& weights, double cost) {
    return std::ranges::count(stops_to_prune(std::span(&curve, 1), weights, {1, cost}), 1);
  };
  EXPECT_EQ(count({weight, {}}, 0), 1);
  EXPECT_EQ(count({weight, weight}, 0.2), 0);
  EXPECT_EQ(count({weight, weight}, 0.3), 1);
}

}  // namespace
}  // namespace sfumato::tracing
