#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "capi/handles.hpp"

/// Frames of films.
namespace sfumato::test {
namespace {

constexpr std::int32_t kFilmSide = 160;  ///< pixels
constexpr int kFrames = 12;

struct Disc {
  double x, y, radius;
};

/// Discs inside rings that no moving curve enters: their pixels must not change.
constexpr Disc kStill[] = {{24, 30, 10}, {74, 74, 9}};

/// Returns a closed path of four pieces.
std::string circle(double x, double y, double r, const std::string& rest) {
  const auto at = [](double px, double py) {
    return std::to_string(px) + ' ' + std::to_string(py) + ' ';
  };
  const double k = 0.5523 * r;
  return "<path d='M" + at(x + r, y) + 'C' + at(x + r, y + k) + at(x + k, y + r) + at(x, y + r) +
         'C' + at(x - k, y + r) + at(x - r, y + k) + at(x - r, y) + 'C' + at(x - r, y - k) +
         at(x - k, y - r) + at(x, y - r) + 'C' + at(x + k, y - r) + at(x + r, y - k) +
         at(x + r, y) + "' " + rest + "/>";
}

/// Returns a disc (curve 2 of layer 0) that moves past two rings, and a layer of one curve.
std::string drawing(double x, double y) {
  const std::string varied = "sf:left='red' sf:right='lime, #e6e619 30%, blue'";
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' sf:version='1' "
         "viewBox='0 0 100 100'><g sf:diffuse='true'>" +
         circle(50, 50, 46, "sf:left='blue' sf:right='lime'") + circle(24, 30, 13, varied) +
         circle(x, y, 7, "sf:left='gold' sf:right='navy' sf:blur='2'") +
         circle(74, 74, 14, varied + " sf:blur='3'") +
         circle(74, 74, 3, "sf:left='lime' sf:right='red'") +
         "</g><g sf:diffuse='true'><path d='M2 96 C30 93 60 99 98 96' sf:left='none' "
         "sf:right='teal'/></g></svg>";
}

std::string frame_drawing(int frame) {
  return drawing(46 + 0.5 * frame, 18 + 4 * frame);
}

std::vector<std::uint8_t> pixels_of(sfumato_context* context, const sfumato_picture* picture) {
  std::vector<std::uint8_t> pixels(std::size_t{kFilmSide} * kFilmSide * 3);
  const sfumato_image image{pixels.data(), std::size_t{kFilmSide} * 3, kFilmSide, kFilmSide,
                            SFUMATO_RGB8};
  EXPECT_EQ(sfumato_raster(context, picture, &image, "background=white"), SFUMATO_OK);
  return pixels;
}

/// Returns the largest difference of a channel, inside the discs or anywhere.
int largest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b,
                       bool anywhere = false) {
  int largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto column = static_cast<double>(i / 3 % kFilmSide),
               row = static_cast<double>(i / 3 / kFilmSide);
    const double x = (column + 0.5) * 100 / kFilmSide, y = (row + 0.5) * 100 / kFilmSide;
    const auto holds = [&](const Disc& d) { return std::hypot(x - d.x, y - d.y) < d.radius; };
    if (anywhere || std::ranges::any_of(kStill, holds)) {
      largest = std::max(largest, std::abs(int{a[i]} - int{b[i]}));
    }
  }
  return largest;
}

class CFilm : public testing::Test {
 protected:
  CFilm() : picture(solve(c, document_of(0).get(), "coherent max-error=1")) {}

  DocumentHandle document_of(int frame) const { return read_text(c, frame_drawing(frame)); }
  std::int32_t next(int frame) const {
    return sfumato_solve_next(c, document_of(frame).get(), picture.get());
  }
  double count(sfumato_statistic which) const {
    return sfumato_picture_statistic(picture.get(), which);
  }

  ContextHandle context{sfumato_context_new("threads=2")};
  sfumato_context* c = context.get();
  PictureHandle picture;
};

TEST_F(CFilm, where_nothing_moves_pixels_differ_by_a_code_value) {
  EXPECT_EQ(count(SFUMATO_BEGUN_LAYERS), 2);
  const auto first = pixels_of(c, picture.get());
  auto before = first;
  for (int frame = 1; frame < kFrames; ++frame) {
    ASSERT_EQ(next(frame), SFUMATO_OK) << sfumato_error_text(c);
    EXPECT_EQ(count(SFUMATO_KEPT_LAYERS), 1) << frame;
    EXPECT_EQ(count(SFUMATO_CONTINUED_LAYERS), 1) << frame;
    EXPECT_EQ(count(SFUMATO_BEGUN_LAYERS), 0) << frame;
    const auto now = pixels_of(c, picture.get());
    EXPECT_LE(largest_difference(before, now), 1) << frame;
    EXPECT_LE(largest_difference(first, now), 1) << frame;
    EXPECT_GT(largest_difference(before, now, true), 20) << "something moves, " << frame;
    before = now;
  }
}

TEST_F(CFilm, edits_make_frames_too) {
  const DocumentHandle document = document_of(0);
  ASSERT_EQ(sfumato_solve_next(c, document.get(), picture.get()), SFUMATO_OK);
  EXPECT_EQ(count(SFUMATO_KEPT_LAYERS), 2);
  const auto before = pixels_of(c, picture.get());
  sfumato_view view{};
  ASSERT_EQ(sfumato_curve_points(document.get(), 0, 2, &view), SFUMATO_OK);
  std::vector<double> xy(static_cast<const double*>(view.data),
                         static_cast<const double*>(view.data) + 2 * view.rows);
  for (double& number : xy) number += 2;
  ASSERT_EQ(sfumato_set_curve_points(c, document.get(), 0, 2, xy.data(), xy.size() / 2),
            SFUMATO_OK);
  ASSERT_EQ(sfumato_solve_next(c, document.get(), picture.get()), SFUMATO_OK);
  EXPECT_EQ(count(SFUMATO_CONTINUED_LAYERS), 1);
  const auto after = pixels_of(c, picture.get());
  EXPECT_LE(largest_difference(before, after), 1);
  EXPECT_GT(largest_difference(before, after, true), 20);
  sfumato_view changes{};
  ASSERT_EQ(sfumato_picture_changes(picture.get(), 1, SFUMATO_TRIANGLES, &changes), SFUMATO_OK);
  EXPECT_EQ(changes.rows, 0u) << "of the layer that was kept";
  ASSERT_EQ(sfumato_picture_changes(picture.get(), 0, SFUMATO_TRIANGLES, &changes), SFUMATO_OK);
  EXPECT_GT(changes.rows, 0u);
}

TEST_F(CFilm, the_exact_picture_is_there_again_when_asked_for) {
  ASSERT_EQ(next(1), SFUMATO_OK);
  const DocumentHandle document = document_of(1);
  const std::string exact = tables_of(solve(c, document.get(), "max-error=1").get());
  EXPECT_NE(tables_of(picture.get()), exact);
  ASSERT_EQ(sfumato_solve_again(c, document.get(), 0, picture.get()), SFUMATO_OK);
  EXPECT_EQ(tables_of(picture.get()), exact);
  EXPECT_EQ(count(SFUMATO_BEGUN_LAYERS), 0) << "it is no frame";
}

TEST_F(CFilm, another_drawing_begins_anew) {
  const DocumentHandle other = read_text(c, example("evening.xml"));
  ASSERT_EQ(sfumato_solve_next(c, other.get(), picture.get()), SFUMATO_OK);
  EXPECT_EQ(count(SFUMATO_BEGUN_LAYERS), sfumato_layer_count(other.get()));
  EXPECT_EQ(tables_of(picture.get()),
            tables_of(solve(c, other.get(), "coherent max-error=1").get()));
}

TEST_F(CFilm, another_context_has_no_mesh_to_go_on_with) {
  ContextHandle other(sfumato_context_new("threads=1"));
  const DocumentHandle document = document_of(1);
  ASSERT_EQ(sfumato_solve_next(other.get(), document.get(), picture.get()), SFUMATO_OK);
  EXPECT_EQ(count(SFUMATO_BEGUN_LAYERS), 1);
  other.reset();
  ASSERT_EQ(next(2), SFUMATO_OK);
  context.reset();
  EXPECT_EQ(sfumato_picture_layer_count(picture.get()), 2u) << "it outlives its context";
}

TEST_F(CFilm, what_fails_leaves_the_frame_before) {
  const std::string before = tables_of(picture.get());
  const ContextHandle small(sfumato_context_new("threads=1 limit.segments=2"));
  const DocumentHandle document = document_of(1);
  EXPECT_EQ(sfumato_solve_next(small.get(), document.get(), picture.get()), SFUMATO_LIMIT);
  EXPECT_EQ(tables_of(picture.get()), before);
  sfumato_cancel(c);
  EXPECT_EQ(sfumato_solve_next(c, document.get(), picture.get()), SFUMATO_CANCELLED);
  EXPECT_EQ(tables_of(picture.get()), before);
  sfumato_resume(c);
  EXPECT_EQ(sfumato_solve_next(c, document.get(), picture.get()), SFUMATO_OK);
  EXPECT_NE(tables_of(picture.get()), before);
}

TEST_F(CFilm, what_is_no_film_is_bad_usage) {
  const DocumentHandle document = document_of(1);
  EXPECT_EQ(sfumato_solve_next(c, nullptr, picture.get()), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_solve_next(c, document.get(), nullptr), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_solve_next(nullptr, document.get(), picture.get()), SFUMATO_BAD_USAGE);
  const PictureHandle alone = solve(c, document.get(), "max-error=1");
  EXPECT_EQ(sfumato_solve_next(c, document.get(), alone.get()), SFUMATO_BAD_USAGE);
  EXPECT_NE(std::string(sfumato_error_text(c)).find("coherent"), std::string::npos);
  sfumato_picture* none = nullptr;
  EXPECT_EQ(sfumato_solve(c, document.get(), "coherent method=rays", &none), SFUMATO_BAD_USAGE);
  EXPECT_STREQ(sfumato_error_text(c), "coherent: works with method=exact only");
  EXPECT_EQ(sfumato_solve(c, document.get(), "coherent=1", &none), SFUMATO_BAD_USAGE);
  sfumato_field* field = nullptr;
  EXPECT_EQ(sfumato_field_new(c, document.get(), 0, "coherent", &field), SFUMATO_BAD_USAGE);
  sfumato_bytes* bytes = nullptr;
  ASSERT_EQ(sfumato_picture_write(c, picture.get(), &bytes), SFUMATO_OK);
  const BytesHandle file(bytes);
  ASSERT_EQ(sfumato_picture_read(c, sfumato_bytes_data(bytes), sfumato_bytes_size(bytes), &none),
            SFUMATO_OK);
  const PictureHandle read(none);
  EXPECT_EQ(sfumato_solve_next(c, document.get(), read.get()), SFUMATO_BAD_USAGE);
}

}  // namespace
}  // namespace sfumato::test
