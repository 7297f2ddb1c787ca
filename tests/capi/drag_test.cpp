#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "capi/quick_pictures.hpp"

/// Drags that are expected, and drags of several curves.
namespace sfumato::test {
namespace {

/// Forty short curves in a layer.
std::string many_curves() {
  std::string text =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 96 96'>"
      "<g sf:diffuse='true'>";
  for (int i = 0; i < 40; ++i) {
    text += "<path d='M" + std::to_string(8 + 11 * (i % 8)) + " " +
            std::to_string(10 + 18 * (i / 8)) + "q4 5 8 0' sf:left='" +
            (i % 2 == 0 ? "red" : "gold") + "' sf:right='" + (i % 3 == 0 ? "navy" : "teal") + "'/>";
  }
  return text + "</g></svg>";
}

TEST_F(CQuick, pictures_show_several_curves_that_move_together) {
  document = read_text(c, many_curves());
  picture = solve(c, document.get(), kOptions);
  ASSERT_EQ(expect_drag(c, picture.get(), 0, {21, 3}), SFUMATO_OK);
  const std::uint32_t all = new_rows(0);
  for (int frame = 0; frame < 4; ++frame) {
    const double by = 1.5 - frame;
    move(by, 3);
    if (frame != 2) move(by, 21);
    ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
    EXPECT_LT(mean_miss(), 0.5) << by;
    if (frame == 0) continue;
    EXPECT_LT(new_rows(0), all / 2) << "only the curves' surroundings are new";
  }
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

/// Rough pictures are quicker then.
TEST_F(CQuick, pictures_of_many_curves_that_move_are_rough) {
  document = read_text(c, many_curves());
  picture = solve(c, document.get(), kOptions);
  for (int frame = 0; frame < 2; ++frame) {
    for (const std::uint32_t curve : {3u, 10u, 21u}) move(1, curve);
    ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
    EXPECT_LT(mean_miss(), 3);
  }
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, a_drag_that_is_expected_leaves_the_picture_and_begins_at_once) {
  const std::string before = tables_of(picture.get());
  ASSERT_EQ(expect_drag(c, picture.get(), 0, {1}), SFUMATO_OK);
  ASSERT_EQ(expect_drag(c, picture.get(), 0, {0}), SFUMATO_OK);
  EXPECT_TRUE(tables_of(picture.get()) == before);
  EXPECT_TRUE(is_exact());
  move(2);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_LT(mean_miss(), 0.5);
  EXPECT_GT(new_rows(0), 0u);
  EXPECT_EQ(new_rows(1), 0u);
  const std::string moved = tables_of(picture.get());
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
  move(-2);
  ASSERT_EQ(again(0), SFUMATO_OK);
  move(2);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_TRUE(tables_of(picture.get()) == moved) << "as without it";
}

TEST_F(CQuick, other_changes_than_the_drag_that_is_expected_are_shown_too) {
  ASSERT_EQ(expect_drag(c, picture.get(), 0, {1}), SFUMATO_OK);
  move(2, 0);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_LT(mean_miss(), 0.5);
  ASSERT_EQ(expect_drag(c, picture.get(), 0, {0}), SFUMATO_OK) << "the layer is rough";
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
  ASSERT_EQ(expect_drag(c, picture.get(), 0, {0}), SFUMATO_OK);
  ASSERT_EQ(sfumato_remove_curve(c, document.get(), 0, 0), SFUMATO_OK);
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, drags_are_shown_whatever_failed_before) {
  sfumato_cancel(c);
  EXPECT_EQ(expect_drag(c, picture.get(), 0, {0}), SFUMATO_CANCELLED);
  sfumato_resume(c);
  for (int i = 0; i < 2; ++i) ASSERT_EQ(expect_drag(c, picture.get(), 0, {0}), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
  move(2);
  sfumato_cancel(c);
  EXPECT_EQ(again(0), SFUMATO_CANCELLED);
  sfumato_resume(c);
  EXPECT_EQ(expect_drag(c, picture.get(), 0, {0}), SFUMATO_OK) << "the picture is there";
  move(2);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_LT(mean_miss(), 0.5);
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, drags_of_no_curve_are_not_expected) {
  EXPECT_EQ(expect_drag(c, picture.get(), 0, {99}), SFUMATO_BAD_INPUT);
  EXPECT_EQ(expect_drag(c, picture.get(), 99, {0}), SFUMATO_BAD_INPUT);
  EXPECT_EQ(expect_drag(c, picture.get(), 0, {}), SFUMATO_BAD_INPUT);
  EXPECT_EQ(expect_drag(c, picture.get(), 0, {1, 1}), SFUMATO_BAD_INPUT);
  EXPECT_EQ(sfumato_expect_drag(c, picture.get(), 0, nullptr, 1), SFUMATO_BAD_USAGE);
  EXPECT_EQ(expect_drag(c, nullptr, 0, {0}), SFUMATO_BAD_USAGE);
  EXPECT_EQ(expect_drag(nullptr, picture.get(), 0, {0}), SFUMATO_BAD_USAGE);
  EXPECT_TRUE(is_exact());
}

}  // namespace
}  // namespace sfumato::test
