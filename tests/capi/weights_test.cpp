#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "capi/handles.hpp"

/// Rows of weights times the values of the stops are the exact colours and opacities.
namespace sfumato::test {
namespace {

constexpr std::uint32_t kGridSide = 24;
constexpr std::size_t kPoints = kGridSide * kGridSide;

/// Sides with stops, gradients, opacities, a barrier, varying blur, and a line with the same colour
/// on both sides, in OKLab.
constexpr const char* kAll = R"svg(<svg xmlns="http://www.w3.org/2000/svg"
    xmlns:sf="urn:sfumato:1" viewBox="0 0 64 64" sf:version="1" sf:interpolation="oklab"
    sf:background="none"><defs>
  <linearGradient id="g" gradientUnits="userSpaceOnUse" x2="64"><stop stop-color="red"/>
    <stop offset="1" stop-color="#08f"/></linearGradient></defs>
  <g sf:diffuse="true">
    <path d="M-8 12C20 4 40 24 72 10" sf:left="gold" sf:right="url(#g)" sf:blur="1, 4"
          sf:left-opacity="1" sf:right-opacity="url(#g)"/>
    <path d="M-8 52C20 64 40 40 72 56" sf:left="#fff, #036 30%, teal" sf:right="none"
          sf:left-opacity="0.25, 1" sf:right-opacity="0.75"/>
    <path d="M20 33C30 33 34 33 44 33" sf:left="#a3a" sf:right="#a3a"/>
  </g></svg>)svg";

/// Returns centres of cells of the artboard.
std::vector<double> points_of(const sfumato_document* document) {
  double box[4];
  EXPECT_EQ(sfumato_document_artboard(document, box), SFUMATO_OK);
  std::vector<double> xy;
  for (std::size_t i = 0; i < kPoints; ++i) {
    xy.push_back(box[0] + (i % kGridSide + 0.377) / kGridSide * box[2]);
    xy.push_back(box[1] + (i / kGridSide + 0.619) / kGridSide * box[3]);
  }
  return xy;
}

WeightsHandle weights_of(sfumato_context* c, const sfumato_document* document,
                         std::uint32_t attribute = SFUMATO_COLOR, const char* options = nullptr) {
  sfumato_weights* made = nullptr;
  EXPECT_EQ(sfumato_weights_new(c, document, 0, attribute, options, &made), SFUMATO_OK)
      << sfumato_error_text(c);
  return WeightsHandle(made);
}

template <class T>
std::vector<T> table(const sfumato_weights* weights, std::uint32_t which, std::uint32_t columns) {
  sfumato_view view{};
  EXPECT_EQ(sfumato_weights_table(weights, which, &view), SFUMATO_OK);
  EXPECT_EQ(view.columns, columns);
  EXPECT_EQ(view.row_bytes, columns * sizeof(T));
  std::vector<T> values(view.rows * columns);
  if (!values.empty()) std::memcpy(values.data(), view.data, values.size() * sizeof(T));
  return values;
}

/// Returns the product of rows and these values of the columns.
std::vector<double> product(const sfumato_weights* weights, const std::vector<float>& value,
                            std::uint32_t channels) {
  const auto begin = table<std::uint32_t>(weights, SFUMATO_ROW_BEGINS, 1);
  const auto column = table<std::uint32_t>(weights, SFUMATO_COLUMNS, 1);
  const auto weight = table<float>(weights, SFUMATO_WEIGHTS, 1);
  const auto paint = table<float>(weights, SFUMATO_PAINT_VALUES, channels);
  EXPECT_EQ(begin.size(), kPoints + 1);
  std::vector<double> sums(paint.begin(), paint.end());
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    EXPECT_TRUE(std::is_sorted(column.begin() + begin[i], column.begin() + begin[i + 1]));
    for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k) {
      for (std::uint32_t c = 0; c < channels; ++c)
        sums[channels * i + c] += double{weight[k]} * value[channels * column[k] + c];
    }
  }
  return sums;
}

std::vector<float> field_of(sfumato_context* c, const sfumato_document* document,
                            const std::vector<double>& xy) {
  sfumato_field* made = nullptr;
  EXPECT_EQ(sfumato_field_new(c, document, 0, nullptr, &made), SFUMATO_OK);
  const FieldHandle field(made);
  std::vector<float> rgba(2 * xy.size());
  EXPECT_EQ(sfumato_field_colors(c, made, xy.data(), xy.size() / 2, rgba.data()), SFUMATO_OK);
  return rgba;
}

/// Returns the root mean square difference between the rows' colours and the field's colours, as
/// code values.
double difference(const sfumato_document* document, std::vector<double> sums,
                  const std::vector<float>& rgba) {
  EXPECT_EQ(sfumato_convert_colors(sfumato_document_interpolation(document), SFUMATO_SRGB,
                                   sums.data(), sums.size() / 3, sums.data()),
            SFUMATO_OK);
  double squares = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double d = std::clamp(sums[i], 0.0, 1.0) - double{rgba[i / 3 * 4 + i % 3]};
    squares += d * d;
  }
  return std::sqrt(squares / static_cast<double>(sums.size()));
}

// The gather of fields sums distant parts in groups, with an error of a hundredth of a code value.
// tests/gather/rows_test.cpp tests how exact rows are.
constexpr double kFieldError = 4e-5;

TEST(CWeights, times_the_stops_are_the_colours) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  for (const std::string& text : {std::string(kAll), example("evening.xml"), example("fish.svg")}) {
    const DocumentHandle document = read_text(c, text);
    const std::vector<double> xy = points_of(document.get());
    const WeightsHandle weights = weights_of(c, document.get());
    ASSERT_EQ(sfumato_weights_at(c, weights.get(), xy.data(), kPoints, 0), SFUMATO_OK)
        << sfumato_error_text(c);
    const auto value = table<float>(weights.get(), SFUMATO_COLUMN_VALUES, 3);
    EXPECT_LT(difference(document.get(), product(weights.get(), value, 3),
                         field_of(c, document.get(), xy)),
              kFieldError);
  }
}

TEST(CWeights, of_opacities_are_the_opacities) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, kAll);
  const std::vector<double> xy = points_of(document.get());
  const WeightsHandle weights = weights_of(c, document.get(), SFUMATO_OPACITY);
  ASSERT_EQ(sfumato_weights_at(c, weights.get(), xy.data(), kPoints, 0), SFUMATO_OK);
  const auto value = table<float>(weights.get(), SFUMATO_COLUMN_VALUES, 1);
  EXPECT_EQ(value, (std::vector<float>{1, 0.25f, 1, 0.75f}));
  const std::vector<double> sums = product(weights.get(), value, 1);
  const std::vector<float> rgba = field_of(c, document.get(), xy);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    if (rgba[4 * i + 3] == 0) continue;  // no colour is visible there
    EXPECT_NEAR(sums[i], rgba[4 * i + 3], 2e-4);
    ++seen;
  }
  EXPECT_GT(seen, kPoints / 2);
}

TEST(CWeights, hold_for_other_colours_of_the_stops) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("fish.svg"));
  sfumato_document* const d = document.get();
  const std::vector<double> xy = points_of(d);
  const WeightsHandle weights = weights_of(c, d);
  ASSERT_EQ(sfumato_weights_at(c, weights.get(), xy.data(), kPoints, 0), SFUMATO_OK);
  const auto stop = table<std::uint32_t>(weights.get(), SFUMATO_COLUMN_STOPS, 3);
  ASSERT_FALSE(stop.empty());
  std::vector<float> value;
  for (std::size_t i = 0; i < stop.size(); i += 3) {
    double row[4 * 64];
    std::int32_t kind = 0, space = 0;
    const std::size_t count =
        sfumato_curve_stops(d, 0, stop[i], stop[i + 1], SFUMATO_COLOR, &kind, &space, row, 64);
    ASSERT_LT(stop[i + 2], count);
    for (std::size_t k = 1; k < 4; ++k) {
      double& changed = row[4 * stop[i + 2] + k];
      changed = 1 - changed * static_cast<double>(k) / 4;
      value.push_back(static_cast<float>(changed));
    }
    ASSERT_EQ(sfumato_set_curve_stops(c, d, 0, stop[i], stop[i + 1], SFUMATO_COLOR, kind, space,
                                      row, count),
              SFUMATO_OK);
  }
  EXPECT_LT(difference(d, product(weights.get(), value, 3), field_of(c, d, xy)), kFieldError);
}

TEST(CWeights, add_up_to_one_and_are_the_same_for_any_number_of_threads) {
  const ContextHandle context = context_of("threads=3"), alone = context_of("threads=1");
  const DocumentHandle document = read_text(context.get(), example("evening.xml"));
  const std::vector<double> xy = points_of(document.get());
  for (const double negligible : {0.0, 1e-3}) {
    const WeightsHandle weights = weights_of(context.get(), document.get());
    const WeightsHandle again = weights_of(alone.get(), document.get(), 0, "scale=1");
    for (const auto& [c, w] :
         {std::pair(context.get(), weights.get()), std::pair(alone.get(), again.get())})
      ASSERT_EQ(sfumato_weights_at(c, w, xy.data(), kPoints, negligible), SFUMATO_OK);
    const std::vector<float> ones(table<float>(weights.get(), SFUMATO_COLUMN_VALUES, 3).size() / 3,
                                  1.0f);
    const auto begin = table<std::uint32_t>(weights.get(), SFUMATO_ROW_BEGINS, 1);
    const auto weight = table<float>(weights.get(), SFUMATO_WEIGHTS, 1);
    for (std::size_t i = 0; i < kPoints; ++i) {
      double sum = 0;
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k) sum += double{weight[k]};
      EXPECT_NEAR(sum, 1, 1e-6);
    }
    EXPECT_EQ(weight, table<float>(again.get(), SFUMATO_WEIGHTS, 1));
    EXPECT_EQ(begin, table<std::uint32_t>(again.get(), SFUMATO_ROW_BEGINS, 1));
  }
}

TEST(CWeights, keep_their_rows_where_points_are_wrong) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, kAll);
  const std::vector<double> xy = points_of(document.get());
  const WeightsHandle weights = weights_of(c, document.get());
  ASSERT_EQ(sfumato_weights_at(c, weights.get(), xy.data(), kPoints, 0), SFUMATO_OK);
  const auto before = table<float>(weights.get(), SFUMATO_WEIGHTS, 1);
  for (const double bad : {1e9, -1e300, std::numeric_limits<double>::quiet_NaN()}) {
    const double outside[] = {bad, 3};
    EXPECT_EQ(sfumato_weights_at(c, weights.get(), outside, 1, 0), SFUMATO_BAD_INPUT);
  }
  EXPECT_EQ(sfumato_weights_at(c, weights.get(), nullptr, 1, 0), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_weights_at(c, weights.get(), xy.data(), SIZE_MAX / 4, 0), SFUMATO_BAD_USAGE);
  for (const double bad : {-1.0, 1.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(sfumato_weights_at(c, weights.get(), xy.data(), 1, bad), SFUMATO_BAD_USAGE);
  sfumato_cancel(c);
  EXPECT_EQ(sfumato_weights_at(c, weights.get(), xy.data(), kPoints, 0), SFUMATO_CANCELLED);
  sfumato_resume(c);
  EXPECT_EQ(table<float>(weights.get(), SFUMATO_WEIGHTS, 1), before);
  sfumato_view view{};
  EXPECT_EQ(sfumato_weights_table(weights.get(), SFUMATO_PAINT_VALUES + 1, &view),
            SFUMATO_BAD_USAGE);
  sfumato_weights* none = nullptr;
  EXPECT_EQ(sfumato_weights_new(c, document.get(), 0, SFUMATO_COLOR, "ends=soft", &none),
            SFUMATO_BAD_USAGE);
  EXPECT_EQ(none, nullptr);
  ASSERT_EQ(sfumato_weights_at(c, weights.get(), nullptr, 0, 0), SFUMATO_OK);
  EXPECT_TRUE(table<float>(weights.get(), SFUMATO_WEIGHTS, 1).empty());
}

TEST(CWeights, are_charged_and_outlive_their_contexts) {
  ContextHandle context = context_of();
  const ContextHandle small = context_of("threads=1 max-memory=1");
  DocumentHandle document = read_text(context.get(), example("evening.xml"));
  std::vector<double> xy = points_of(document.get());
  const WeightsHandle weights = weights_of(context.get(), document.get());
  document.reset();
  context.reset();
  std::vector<double> many;
  for (int i = 0; i < 200; ++i) many.insert(many.end(), xy.begin(), xy.end());
  EXPECT_EQ(sfumato_weights_at(small.get(), weights.get(), many.data(), many.size() / 2, 0),
            SFUMATO_LIMIT);
  const ContextHandle other = context_of();
  EXPECT_EQ(sfumato_weights_at(other.get(), weights.get(), xy.data(), kPoints, 0), SFUMATO_OK);
}

TEST(CColors, are_converted_there_and_back) {
  std::array<double, 6> colors{0.2, 0.4, 0.6, 1, 1, 1}, converted{};
  for (const std::int32_t space : {SFUMATO_SRGB, SFUMATO_LINEAR, SFUMATO_OKLAB}) {
    ASSERT_EQ(sfumato_convert_colors(SFUMATO_SRGB, space, colors.data(), 2, converted.data()),
              SFUMATO_OK);
    EXPECT_NEAR(converted[3], 1, 1e-6);
    EXPECT_NEAR(converted[5], space == SFUMATO_OKLAB ? 0 : 1, 1e-6);
    ASSERT_EQ(sfumato_convert_colors(space, SFUMATO_SRGB, converted.data(), 2, converted.data()),
              SFUMATO_OK);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(converted[i], colors[i], 1e-5);
  }
  EXPECT_EQ(sfumato_convert_colors(3, 0, colors.data(), 2, converted.data()), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_convert_colors(0, -1, colors.data(), 2, converted.data()), SFUMATO_BAD_USAGE);
}

}  // namespace
}  // namespace sfumato::test
