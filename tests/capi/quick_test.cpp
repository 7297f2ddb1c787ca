#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "capi/handles.hpp"

/// Pictures of a document of which a curve moves.
namespace sfumato::test {
namespace {

constexpr const char* kOptions = "max-error=4";
constexpr std::uint32_t kWidth = 96, kHeight = 96;

/// Three curves in a layer, one in another.
constexpr const char* kDrawing =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 96 96'>"
    "<g sf:diffuse='true'>"
    "<path d='M10 20C40 10 60 30 86 18' sf:left='#fff' sf:right='#036'/>"
    "<path d='M12 50C30 70 60 30 84 52' sf:left='red,blue' sf:right='gold'/>"
    "<path d='M30 80L70 84' sf:left='green' sf:right='black'/></g>"
    "<g sf:diffuse='true'><path d='M40 40C60 40 60 60 40 60' sf:left='#fff' sf:right='#333'"
    " sf:opacity='0.5'/></g></svg>";

class CQuick : public testing::Test {
 protected:
  void move(double by, std::uint32_t curve = 0, std::uint32_t layer = 0) {
    sfumato_view view{};
    ASSERT_EQ(sfumato_curve_points(document.get(), layer, curve, &view), SFUMATO_OK);
    std::vector<double> xy(static_cast<const double*>(view.data),
                           static_cast<const double*>(view.data) + 2 * view.rows);
    for (double& number : xy) number += by;
    ASSERT_EQ(sfumato_set_curve_points(c, document.get(), layer, curve, xy.data(), view.rows),
              SFUMATO_OK);
  }

  std::int32_t again(std::int32_t quick) {
    return sfumato_solve_again(c, document.get(), quick, picture.get());
  }

  bool is_exact() const {
    return tables_of(picture.get()) == tables_of(solve(c, document.get(), kOptions).get());
  }

  std::vector<std::uint8_t> pixels_of(const sfumato_picture* of) const {
    std::vector<std::uint8_t> pixels(3 * kWidth * kHeight);
    const sfumato_image image{pixels.data(), 3 * kWidth, kWidth, kHeight, SFUMATO_RGB8};
    EXPECT_EQ(sfumato_raster(c, of, &image, "background=white"), SFUMATO_OK);
    return pixels;
  }

  /// The mean difference of all pixels from those of the exact picture, in code values.
  double mean_miss() const {
    const std::vector<std::uint8_t> shown = pixels_of(picture.get());
    const std::vector<std::uint8_t> exact = pixels_of(solve(c, document.get(), kOptions).get());
    double sum = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) sum += std::abs(shown[i] - exact[i]);
    return sum / static_cast<double>(shown.size());
  }

  /// Rows that are new, in all tables of a layer.
  std::uint32_t new_rows(std::uint32_t layer) const {
    std::uint32_t rows = 0;
    for (std::uint32_t table = SFUMATO_VERTICES; table <= SFUMATO_OPACITY_VALUES; ++table) {
      sfumato_view view{};
      EXPECT_EQ(sfumato_picture_changes(picture.get(), layer, table, &view), SFUMATO_OK);
      const auto* const range = static_cast<const std::uint32_t*>(view.data);
      if (range) rows += range[1] - range[0];
    }
    return rows;
  }

  ContextHandle context{sfumato_context_new("threads=1")};
  sfumato_context* c = context.get();
  DocumentHandle document = read_text(c, kDrawing);
  PictureHandle picture = solve(c, document.get(), kOptions);
};

TEST_F(CQuick, pictures_show_a_curve_that_moves) {
  for (const double by : {0.5, -1.5, 3.0}) {
    move(by);
    ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
    EXPECT_FALSE(is_exact()) << by;
    EXPECT_LT(mean_miss(), 0.5) << by;
    EXPECT_GT(new_rows(0), 0u);
    EXPECT_EQ(new_rows(1), 0u);
  }
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, pictures_show_new_colours_of_the_curve) {
  const double rows[] = {0, 1, 0, 0, 1, 0, 1, 0};
  ASSERT_EQ(sfumato_set_curve_stops(c, document.get(), 0, 0, SFUMATO_LEFT, SFUMATO_COLOR,
                                    SFUMATO_STOPS, SFUMATO_ARC_LENGTH, rows, 2),
            SFUMATO_OK);
  move(1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_FALSE(is_exact());
  EXPECT_LT(mean_miss(), 0.5);
}

TEST_F(CQuick, pictures_of_what_did_not_change_stay) {
  const std::string before = tables_of(picture.get());
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_EQ(tables_of(picture.get()), before);
  EXPECT_EQ(new_rows(0), 0u);
  move(1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  const std::string moved = tables_of(picture.get());
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_EQ(tables_of(picture.get()), moved);
  EXPECT_EQ(new_rows(0), 0u);
}

TEST_F(CQuick, pictures_of_other_changes_are_exact) {
  move(1, 0);
  move(1, 1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_TRUE(is_exact()) << "two curves";
  ASSERT_EQ(sfumato_remove_curve(c, document.get(), 0, 2), SFUMATO_OK);
  move(1, 0);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_TRUE(is_exact()) << "a removal before a move";
  document = read_text(c, example("evening.xml"));
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_TRUE(is_exact()) << "another document";
}

TEST_F(CQuick, pictures_of_another_curve_begin_with_an_exact_one) {
  move(1, 0);
  ASSERT_EQ(again(1), SFUMATO_OK);
  move(1, 1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
  move(1, 1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_FALSE(is_exact());
  EXPECT_LT(mean_miss(), 0.5);
}

TEST_F(CQuick, a_copy_of_the_document_is_another_one) {
  move(1);
  sfumato_document* copy = nullptr;
  ASSERT_EQ(sfumato_document_copy(c, document.get(), &copy), SFUMATO_OK);
  document.reset(copy);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, pictures_outlive_the_context_that_made_them) {
  ContextHandle other(sfumato_context_new("threads=1"));
  move(1);
  ASSERT_EQ(sfumato_solve_again(other.get(), document.get(), 1, picture.get()), SFUMATO_OK);
  other.reset();
  move(1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_LT(mean_miss(), 0.5);
}

TEST_F(CQuick, pictures_that_fail_leave_what_was_there) {
  move(1);
  const std::string before = tables_of(picture.get());
  sfumato_cancel(c);
  EXPECT_EQ(again(1), SFUMATO_CANCELLED);
  EXPECT_EQ(tables_of(picture.get()), before);
  sfumato_resume(c);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_LT(mean_miss(), 0.5);
}

}  // namespace
}  // namespace sfumato::test
