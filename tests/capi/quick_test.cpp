#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "capi/quick_pictures.hpp"

/// Pictures of a document while a curve moves.
namespace sfumato::test {
namespace {

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

TEST_F(CQuick, pictures_say_which_rows_are_new) {
  document = read_text(c, example("evening.xml"));
  picture = solve(c, document.get(), kOptions);
  std::vector<Bytes> copies;
  for (std::uint32_t table = 0; table <= SFUMATO_OPACITY_VALUES; ++table)
    copies.push_back(table_of(table));
  for (int frame = 0; frame < 12; ++frame) {
    // Includes the former place, and frames that nobody renders.
    move(frame % 5 == 4 ? 0 : 3.0 * (frame % 3) - 2.5);
    ASSERT_EQ(again(frame == 7 ? 0 : 1), SFUMATO_OK) << sfumato_error_text(c);
    std::size_t rows = 0, all = 0;
    for (std::uint32_t table = 0; table <= SFUMATO_OPACITY_VALUES; ++table) {
      rows += renew(table, copies[table]);
      EXPECT_EQ(copies[table], table_of(table)) << "frame " << frame << ", table " << table;
      sfumato_view view{};
      EXPECT_EQ(sfumato_picture_table(picture.get(), 0, table, &view), SFUMATO_OK);
      all += view.rows;
    }
    const bool is_whole = frame == 0 || frame == 7 || frame == 8;
    EXPECT_EQ(rows == all, is_whole) << "frame " << frame;
  }
}

TEST_F(CQuick, pictures_within_a_time_go_on_where_they_stopped) {
  move(0.5);
  ASSERT_EQ(again(1), SFUMATO_OK);
  const auto waiting = [&] {
    return sfumato_picture_statistic(picture.get(), SFUMATO_WAITING_NODES);
  };
  EXPECT_EQ(waiting(), 0);
  move(2);
  ASSERT_EQ(sfumato_solve_within(c, document.get(), 0, picture.get()), SFUMATO_OK);
  const double left = waiting();
  EXPECT_GT(left, 0);
  Bytes values = table_of(SFUMATO_COLOR_VALUES);
  const Bytes before = values;
  while (const double now = waiting()) {
    ASSERT_EQ(sfumato_solve_within(c, document.get(), 0, picture.get()), SFUMATO_OK);
    ASSERT_LT(waiting(), now);
    renew(SFUMATO_COLOR_VALUES, values);
    ASSERT_EQ(values, table_of(SFUMATO_COLOR_VALUES)) << "the steps do not report all new rows";
  }
  EXPECT_NE(values, before);
  EXPECT_LT(mean_miss(), 0.5);
  ASSERT_EQ(sfumato_solve_within(c, document.get(), 0, picture.get()), SFUMATO_OK);
  EXPECT_EQ(new_rows(0), 0u) << "nothing is left";
  move(1);
  ASSERT_EQ(sfumato_solve_within(c, document.get(), 0, picture.get()), SFUMATO_OK);
  EXPECT_GT(waiting(), 0);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_EQ(waiting(), 0) << "without a time all is gathered";
  move(1);
  ASSERT_EQ(sfumato_solve_within(c, document.get(), HUGE_VAL, picture.get()), SFUMATO_OK);
  EXPECT_EQ(waiting(), 0);
  move(1);
  ASSERT_EQ(sfumato_solve_within(c, document.get(), 0, picture.get()), SFUMATO_OK);
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_EQ(waiting(), 0);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, pictures_within_no_time_are_refused) {
  for (const double seconds : {-1.0, -HUGE_VAL, std::nan("")}) {
    EXPECT_EQ(sfumato_solve_within(c, document.get(), seconds, picture.get()), SFUMATO_BAD_USAGE);
  }
  EXPECT_EQ(sfumato_solve_within(c, nullptr, 1, picture.get()), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_solve_within(c, document.get(), 1, nullptr), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_solve_within(nullptr, document.get(), 1, picture.get()), SFUMATO_BAD_USAGE);
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

TEST_F(CQuick, pictures_of_other_changes_are_rough) {
  const auto is_rough = [&] {
    EXPECT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
    EXPECT_LT(mean_miss(), 0.5);
    return !is_exact();
  };
  move(1, 0);
  move(1, 1);
  EXPECT_TRUE(is_rough()) << "two curves";
  ASSERT_EQ(sfumato_remove_curve(c, document.get(), 0, 2), SFUMATO_OK);
  move(1, 0);
  EXPECT_TRUE(is_rough()) << "a removal before a move";
  DocumentHandle second(read_text(c, example("evening.xml")));
  document.swap(second);
  EXPECT_TRUE(is_rough()) << "another document";
  document.swap(second);
  EXPECT_TRUE(is_rough()) << "and back";
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, rough_pictures_leave_other_layers_alone) {
  for (const double by : {1.0, 1.5}) {
    move(by, 0);
    move(by, 1);
    ASSERT_EQ(again(1), SFUMATO_OK);
    EXPECT_GT(new_rows(0), 0u);
    EXPECT_EQ(new_rows(1), 0u);
  }
  EXPECT_EQ(sfumato_picture_statistic(picture.get(), SFUMATO_WAITING_NODES), 0);
  ASSERT_EQ(sfumato_solve_within(c, document.get(), 0, picture.get()), SFUMATO_OK);
  EXPECT_EQ(new_rows(0), 0u) << "nothing has changed";
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_EQ(new_rows(1), 0u);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, pictures_of_another_curve_begin_from_a_rough_layer) {
  move(1, 0);
  ASSERT_EQ(again(1), SFUMATO_OK);
  for (int frame = 0; frame < 3; ++frame) {
    move(1, 1);
    ASSERT_EQ(again(1), SFUMATO_OK);
    EXPECT_FALSE(is_exact());
    EXPECT_LT(mean_miss(), 0.5);
  }
  sfumato_view triangles{};
  ASSERT_EQ(sfumato_picture_table(picture.get(), 0, SFUMATO_TRIANGLES, &triangles), SFUMATO_OK);
  const std::size_t rough = triangles.rows;
  ASSERT_EQ(again(0), SFUMATO_OK);
  ASSERT_EQ(sfumato_picture_table(picture.get(), 0, SFUMATO_TRIANGLES, &triangles), SFUMATO_OK);
  EXPECT_LT(rough, triangles.rows);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuick, pictures_do_not_depend_on_what_the_exact_one_kept) {
  const auto next = [&](const char* options) {
    move(-1);
    picture = solve(c, document.get(), options);
    move(1);
    EXPECT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
    return tables_of(picture.get());
  };
  move(1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  move(-1);
  ASSERT_EQ(again(0), SFUMATO_OK);
  move(1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  const std::string second = tables_of(picture.get());
  const auto is_same = [&](const char* options) { return next(options) == second; };
  EXPECT_TRUE(is_same("max-error=4"));
  EXPECT_TRUE(is_same("max-error=4 drags"));
  EXPECT_TRUE(is_same("max-error=4 drag-triangles=0"));
  EXPECT_TRUE(is_same("max-error=4 drag-triangles=9 drags"));
  EXPECT_EQ(sfumato_solve(c, document.get(), "drag-triangles=-1", nullptr), SFUMATO_BAD_USAGE);
  sfumato_field* field = nullptr;
  EXPECT_EQ(sfumato_field_new(c, document.get(), 0, "drags", &field), SFUMATO_BAD_USAGE);
}

TEST_F(CQuick, a_copy_of_the_document_is_another_one) {
  move(1);
  sfumato_document* copy = nullptr;
  ASSERT_EQ(sfumato_document_copy(c, document.get(), &copy), SFUMATO_OK);
  document.reset(copy);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_LT(mean_miss(), 0.5);
  move(-1);
  ASSERT_EQ(again(1), SFUMATO_OK) << "one curve of the copy";
  EXPECT_LT(mean_miss(), 0.5);
  ASSERT_EQ(again(0), SFUMATO_OK);
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

/// Pictures of a document while a stop gets other values.
class CQuickColors : public CQuick {
 protected:
  void set_colors(const std::vector<double>& rows, std::uint32_t side = SFUMATO_LEFT) {
    ASSERT_EQ(sfumato_set_curve_stops(c, document.get(), 0, 1, side, SFUMATO_COLOR, SFUMATO_STOPS,
                                      SFUMATO_ARC_LENGTH, rows.data(), rows.size() / 4),
              SFUMATO_OK);
  }

  /// Returns the tables of a layer that are new.
  std::vector<std::uint32_t> new_tables(std::uint32_t layer) const {
    std::vector<std::uint32_t> tables;
    for (std::uint32_t table = SFUMATO_VERTICES; table <= SFUMATO_OPACITY_VALUES; ++table) {
      sfumato_view view{};
      EXPECT_EQ(sfumato_picture_changes(picture.get(), layer, table, &view), SFUMATO_OK);
      if (view.rows > 0) tables.push_back(table);
    }
    return tables;
  }

  std::vector<float> numbers_of(std::uint32_t table, std::uint32_t layer = 0) const {
    sfumato_view view{};
    EXPECT_EQ(sfumato_picture_table(picture.get(), layer, table, &view), SFUMATO_OK);
    const auto* const data = static_cast<const float*>(view.data);
    return {data, data + view.rows * view.columns};
  }

  using Tables = std::vector<std::uint32_t>;
};

TEST_F(CQuickColors, change_tables_of_values_alone_after_the_first_time) {
  set_colors({0, 1, 0, 0, 1, 0, 0, 0.5});
  ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
  EXPECT_LT(mean_miss(), 0.1);
  EXPECT_GT(new_tables(0).size(), 3u);
  for (const double green : {0.25, 0.5, 1.0}) {
    set_colors({0, 1, 0, 0, 1, 0, green, 0.5});
    ASSERT_EQ(again(1), SFUMATO_OK);
    EXPECT_EQ(new_tables(0), Tables{SFUMATO_COLOR_VALUES});
    EXPECT_EQ(new_tables(1), Tables{});
    EXPECT_LT(mean_miss(), 0.25);
  }
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuickColors, take_a_side_whose_stops_change_alike_for_one) {
  set_colors({0, 1, 0.25, 0, 1, 0, 0.25, 1});
  ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
  set_colors({0, 1, 0.5, 0, 1, 0, 0.5, 1});
  ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
  EXPECT_EQ(new_tables(0), Tables{SFUMATO_COLOR_VALUES});
  EXPECT_LT(mean_miss(), 0.25);
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

/// The picture sums up the side's values, so their last bits differ from the document's.
TEST_F(CQuickColors, of_a_side_are_those_of_the_document_after_another_curve_has_moved) {
  for (int i = 1; i <= 12; ++i) {
    const double by = i / 19.0;
    set_colors({0, 0.07, 0.2, 0.33, 1, 0.25, 0.12, 0.18});
    ASSERT_EQ(again(0), SFUMATO_OK);
    set_colors({0, 0.07 + by, 0.2, 0.33 + by, 1, 0.25 + by, 0.12, 0.18 + by});
    ASSERT_EQ(again(1), SFUMATO_OK);
    move(0.5);
    ASSERT_EQ(again(1), SFUMATO_OK);
    ASSERT_EQ(again(0), SFUMATO_OK);
    ASSERT_TRUE(is_exact()) << i;
  }
}

TEST_F(CQuickColors, of_a_curve_whose_drag_is_expected_change_values_alone) {
  ASSERT_EQ(expect_drag(c, picture.get(), 0, {1}), SFUMATO_OK);
  for (const double green : {0.25, 0.5}) {
    set_colors({0, 1, 0, 0, 1, 0, green, 1});
    ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
    EXPECT_LT(mean_miss(), 0.25);
  }
  EXPECT_EQ(new_tables(0), Tables{SFUMATO_COLOR_VALUES});
}

TEST_F(CQuickColors, of_several_stops_are_those_of_a_curve_that_moves) {
  set_colors({0, 0, 0.25, 0, 1, 1, 0.5, 1});
  ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
  EXPECT_LT(mean_miss(), 0.5);
  set_colors({0, 0, 0.5, 0, 1, 1, 0.5, 1});
  ASSERT_EQ(again(1), SFUMATO_OK) << sfumato_error_text(c);
  EXPECT_LT(mean_miss(), 0.5);
  EXPECT_GT(new_tables(0).size(), 3u);
}

TEST_F(CQuickColors, of_other_stops_or_curves_begin_from_a_rough_layer) {
  set_colors({0, 1, 0, 0, 1, 0, 0, 0.5});
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_FALSE(is_exact());
  for (const double green : {0.5, 0.75}) {
    set_colors({0, 1, green, 0, 1, 0, 0, 0.5});
    ASSERT_EQ(again(1), SFUMATO_OK) << "the other stop";
    EXPECT_EQ(new_tables(0).size() == 1, green == 0.75);
    EXPECT_LT(mean_miss(), 0.5);
  }
  move(1, 1);
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_LT(mean_miss(), 0.5);
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

TEST_F(CQuickColors, follow_from_the_response_of_a_stop) {
  sfumato_view view{};
  ASSERT_EQ(sfumato_stop_response(c, picture.get(), 0, 1, SFUMATO_RIGHT, SFUMATO_COLOR, 0, &view),
            SFUMATO_OK)
      << sfumato_error_text(c);
  EXPECT_LT(mean_miss(), 0.1);
  const std::vector<float> before = numbers_of(SFUMATO_COLOR_VALUES);
  ASSERT_EQ(view.columns, 1u);
  ASSERT_EQ(3 * view.rows, before.size());
  const auto* const data = static_cast<const float*>(view.data);
  const std::vector<float> response(data, data + view.rows);
  EXPECT_EQ(sfumato_document_interpolation(document.get()), SFUMATO_SRGB);
  set_colors({0, 1, 0.5, 0.25}, SFUMATO_RIGHT);  // gold, #ffd700, before
  ASSERT_EQ(again(1), SFUMATO_OK);
  EXPECT_EQ(new_tables(0), Tables{SFUMATO_COLOR_VALUES});
  const std::vector<float> after = numbers_of(SFUMATO_COLOR_VALUES);
  for (std::size_t i = 0; i < response.size(); ++i) {
    ASSERT_EQ(after[3 * i], before[3 * i]);
    ASSERT_NEAR(after[3 * i + 1], before[3 * i + 1] + response[i] * (0.5f - 215 / 255.0f), 1e-6);
    ASSERT_NEAR(after[3 * i + 2], before[3 * i + 2] + response[i] * 0.25f, 1e-6);
  }
  ASSERT_EQ(sfumato_stop_response(c, picture.get(), 0, 1, SFUMATO_RIGHT, SFUMATO_COLOR, 0, &view),
            SFUMATO_OK);
  EXPECT_EQ(view.rows, response.size());
  EXPECT_EQ(new_rows(0), 0u);
}

TEST_F(CQuickColors, refuse_stops_that_are_not_there) {
  const auto response = [&](std::uint32_t curve, std::uint32_t attribute, std::uint32_t stop) {
    sfumato_view view{};
    const std::int32_t code =
        sfumato_stop_response(c, picture.get(), 0, curve, SFUMATO_LEFT, attribute, stop, &view);
    EXPECT_EQ(view.data == nullptr, code != SFUMATO_OK);
    return code;
  };
  EXPECT_EQ(response(3, SFUMATO_COLOR, 0), SFUMATO_BAD_USAGE);
  EXPECT_EQ(response(1, SFUMATO_COLOR, 2), SFUMATO_BAD_USAGE);
  EXPECT_EQ(response(1, SFUMATO_OPACITY, 0), SFUMATO_BAD_USAGE);
  EXPECT_EQ(response(1, SFUMATO_BLUR, 0), SFUMATO_BAD_USAGE);
  EXPECT_EQ(response(1, SFUMATO_COLOR, UINT32_MAX), SFUMATO_OK);
  sfumato_view view{};
  EXPECT_EQ(sfumato_stop_response(c, nullptr, 0, 1, 0, 0, 0, &view), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_stop_response(c, picture.get(), 0, 1, 0, 0, 0, nullptr), SFUMATO_BAD_USAGE);
}

/// Several kinds of edits at a time, compared with a picture that was solved at once.
TEST_F(CQuick, exact_pictures_follow_edits_of_any_number) {
  const double line[] = {5, 90, 30, 85, 60, 95, 90, 88};
  for (int step = 0; step < 12; ++step) {
    SCOPED_TRACE(step);
    if (step % 3 == 0) {
      ASSERT_EQ(sfumato_insert_curve(c, document.get(), 0, step % 2, line, 4), SFUMATO_OK);
    }
    move(0.5, 1);
    move(0.25, 0);
    if (step % 4 == 2) {
      ASSERT_EQ(sfumato_remove_curve(c, document.get(), 0, 0), SFUMATO_OK);
    }
    ASSERT_EQ(sfumato_set_curve_weight(c, document.get(), 0, 1, 1 + step), SFUMATO_OK);
    const bool quick = step % 5 == 4;
    ASSERT_EQ(again(quick), SFUMATO_OK) << sfumato_error_text(c);
    EXPECT_NE(is_exact(), quick);
  }
}

TEST_F(CQuick, exact_pictures_keep_layers_whose_edits_were_taken_back) {
  move(1, 0, 1);
  move(-1, 0, 1);
  move(1, 0, 0);
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
  EXPECT_GT(new_rows(0), 0u);
  EXPECT_EQ(new_rows(1), 0u);
}

TEST_F(CQuick, exact_pictures_follow_more_edits_than_are_noted) {
  for (int i = 0; i < 400; ++i) move(i % 2 == 0 ? 0.25 : -0.125, i % 3);
  ASSERT_EQ(again(0), SFUMATO_OK);
  EXPECT_TRUE(is_exact());
}

}  // namespace
}  // namespace sfumato::test
