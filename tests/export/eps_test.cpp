#include "sfumato/export/eps/eps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "export/support.hpp"
#include "raster/pictures.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

using test::Bytes;
using test::text_of;

Bytes exported_eps(const Picture& picture, ExportNotes* notes = nullptr) {
  Context context;
  Result<Bytes> bytes = export_eps(context, picture, {}, notes);
  EXPECT_TRUE(bytes.ok()) << to_string(bytes.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return bytes ? std::move(*bytes) : Bytes{};
}

Picture two_flags() {
  Picture picture = test::make_picture(
      test::make_layer(test::jittered_grid(test::kPageBox, 3, 5), [](int, Vec2 p) {
        return Rgb{static_cast<float>(p.x / 80), 0.5f, static_cast<float>(p.y / 60)};
      }));
  picture.background = Rgb{0.9f, 0.8f, 0.1f};
  picture.stack = {PatchInstance{0, {0.4, 0, 0, 0.4, 4, 4}, 1, BlendMode::normal},
                   PatchInstance{0, {-0.4, 0.1, 0, 0.4, 70, 30}, 1, BlendMode::normal}};
  return picture;
}

/// Compares with Ghostscript at 192 dpi: two pixels per unit.
void expect_shown_by_ghostscript(const Picture& picture, double mean, int p99) {
  if (!test::has_program("gs")) GTEST_SKIP() << "no gs here";
  const auto shown = test::shown_by(exported_eps(picture), "in.eps",
                                    "gs -q -dSAFER -dBATCH -dNOPAUSE -dEPSCrop -r192 "
                                    "-sDEVICE=png16m -o OUT IN");
  ASSERT_TRUE(shown);
  const auto found =
      test::difference(*shown, test::reference(picture, shown->width, shown->height));
  EXPECT_LE(found.mean, mean);
  EXPECT_LE(found.p99, p99);
}

TEST(Eps, vertices_that_no_triangle_has_do_not_widen_a_layer) {
  Picture picture = two_flags();
  const Bytes before = exported_eps(picture);
  picture.layers[0].vertex_position.push_back({1e6, -1e6});
  EXPECT_TRUE(exported_eps(picture) == before);
}

TEST(Eps, the_box_is_the_viewport_in_points) {
  const std::string text = text_of(exported_eps(two_flags()));
  EXPECT_EQ(text.substr(0, 24), "%!PS-Adobe-3.0 EPSF-3.0\n");
  EXPECT_NE(text.find("\n%%BoundingBox: 0 0 60 45\n"), std::string::npos);
  EXPECT_NE(text.find("\n%%LanguageLevel: 3\n"), std::string::npos);
}

TEST(Eps, no_line_is_longer_than_255_characters) {
  const std::string text = text_of(exported_eps(two_flags()));
  std::size_t longest = 0;
  for (std::size_t begin = 0, end; begin < text.size(); begin = end + 1) {
    end = text.find('\n', begin);
    longest = std::max(longest, end - begin);
  }
  EXPECT_LE(longest, 255u);
}

TEST(Eps, instances_of_a_layer_look_as_they_do_to_us) {
  expect_shown_by_ghostscript(two_flags(), 2.8, 90);
}

TEST(Eps, what_must_be_composited_is_pixels_and_says_so) {
  Picture picture = two_flags();
  std::get<PatchInstance>(picture.stack[1]).opacity = 0.5f;
  ExportNotes notes;
  EXPECT_NE(text_of(exported_eps(picture, &notes)).find("/ImageType 1"), std::string::npos);
  ASSERT_EQ(notes.lost.size(), 1u);
  EXPECT_NE(notes.lost[0].find("PDF"), std::string::npos);
  expect_shown_by_ghostscript(picture, 0.6, 22);
}

TEST(Eps, the_lady_bug_looks_as_it_does_to_us) {
  const auto document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "no public scene lady_bug.xml";
  expect_shown_by_ghostscript(test::solved(*document), 0.8, 25);
}

TEST(Eps, what_cannot_be_drawn_is_an_error) {
  Context context;
  EXPECT_EQ(export_eps(context, Picture{}, {}).status().code, StatusCode::bad_input);
  Context small;
  ASSERT_TRUE(small.budget.charge(small.budget.limit() - 1000, "the test").ok());
  EXPECT_EQ(export_eps(small, two_flags(), {}).status().code, StatusCode::limit);
}

}  // namespace
}  // namespace sfumato
