#include "sfumato/export/pdf/pdf.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/text/number_text.hpp"
#include "export/support.hpp"
#include "raster/pictures.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "support/drawing.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

using test::Bytes;
using test::text_of;

Bytes exported_pdf(const Picture& picture, const PdfOptions& options = {}) {
  Context context;
  Result<Bytes> bytes = export_pdf(context, picture, options);
  EXPECT_TRUE(bytes.ok()) << to_string(bytes.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return bytes ? std::move(*bytes) : Bytes{};
}

/// Returns a layer of one colour, drawn with the instance's options.
Picture flat_picture(const PatchInstance& instance = {}) {
  Picture picture = test::make_picture(test::flat_layer(test::kPageBox, {0.2f, 0.4f, 0.8f}));
  picture.stack = {instance};
  return picture;
}

TEST(Pdf, a_unit_is_three_quarters_of_a_point) {
  EXPECT_NE(text_of(exported_pdf(flat_picture())).find("/MediaBox [0 0 60 45]"), std::string::npos);
}

TEST(Pdf, the_page_can_have_a_width) {
  PdfOptions options;
  options.page_width_pt = 200;
  EXPECT_NE(text_of(exported_pdf(flat_picture(), options)).find("/MediaBox [0 0 200 150]"),
            std::string::npos);
}

TEST(Pdf, pages_beyond_200_inches_have_a_larger_unit) {
  PdfOptions options;
  options.page_width_pt = 28800;
  const std::string text = text_of(exported_pdf(flat_picture(), options));
  EXPECT_NE(text.find("/MediaBox [0 0 14400 10800]"), std::string::npos);
  EXPECT_NE(text.find("/UserUnit 2 "), std::string::npos);
}

TEST(Pdf, vertices_that_no_triangle_has_do_not_widen_a_layer) {
  Picture picture = flat_picture();
  const Bytes before = exported_pdf(picture);
  picture.layers[0].vertex_position.push_back({1e6, -1e6});
  EXPECT_EQ(exported_pdf(picture), before);
}

TEST(Pdf, layers_are_pixels_where_that_is_asked_for) {
  for (PdfFlatten flatten : {PdfFlatten::always, PdfFlatten::automatic, PdfFlatten::never}) {
    Context context;
    ExportNotes notes;
    const auto bytes = export_pdf(context, flat_picture(), {.flatten = flatten}, &notes);
    ASSERT_TRUE(bytes.ok()) << to_string(bytes.status());
    const bool has_image = text_of(*bytes).find("/Subtype /Image") != std::string::npos;
    EXPECT_EQ(has_image, flatten == PdfFlatten::always);
    EXPECT_EQ(notes.triangle_count == 0, flatten == PdfFlatten::always);
    EXPECT_TRUE(notes.lost.empty());
  }
}

TEST(Pdf, layers_that_programs_would_take_minutes_for_are_pixels_and_it_is_told) {
  Picture picture = flat_picture();
  const std::size_t patches = picture.layers[0].triangle_count();
  for (bool is_dear : {false, true}) {
    picture.stack.resize(50'000 / patches + (is_dear ? 1 : 0), PatchInstance{});
    Context context;
    ExportNotes notes;
    const auto bytes = export_pdf(context, picture, {}, &notes);
    ASSERT_TRUE(bytes.ok()) << to_string(bytes.status());
    EXPECT_EQ(notes.triangle_count == 0, is_dear);
    EXPECT_EQ(notes.lost.size(), is_dear ? 1u : 0u);
  }
}

TEST(Pdf, a_layer_painted_often_is_stored_once) {
  Picture picture = flat_picture();
  const std::size_t once = exported_pdf(picture).size();
  for (int i = 1; i < 50; ++i)
    picture.stack.push_back(PatchInstance{0, {0.1, 0, 0, 0.1, 1.5 * i, 2}, 1, BlendMode::normal});
  EXPECT_LT(exported_pdf(picture).size(), once + 2000);
}

TEST(Pdf, the_title_may_be_in_any_script) {
  PdfOptions options;
  options.title = "Näve (\xF0\x9F\x90\x9E)";
  EXPECT_NE(text_of(exported_pdf(flat_picture(), options))
                .find("/Title <FEFF004E00E400760065002000"
                      "28D83DDC1E0029>"),
            std::string::npos);
}

TEST(Pdf, the_same_picture_gives_the_same_bytes) {
  ThreadPool pool(3);
  Context context;
  context.executor = &pool;
  const Picture picture = flat_picture({0, {}, 0.5f, BlendMode::multiply});
  const Result<Bytes> threaded = export_pdf(context, picture, {});
  ASSERT_TRUE(threaded.ok());
  EXPECT_EQ(*threaded, exported_pdf(picture));
}

TEST(Pdf, what_cannot_be_drawn_is_an_error) {
  Context context;
  EXPECT_EQ(export_pdf(context, Picture{}, {}).status().code, StatusCode::bad_input);
  PdfOptions no_width;
  no_width.page_width_pt = 0;
  EXPECT_EQ(export_pdf(context, flat_picture(), no_width).status().code, StatusCode::bad_input);
  Picture broken = flat_picture();
  broken.layers[0].triangle_vertex[0] = 99;
  EXPECT_EQ(export_pdf(context, broken, {}).status().code, StatusCode::bad_input);
}

TEST(Pdf, a_page_of_kilometres_is_an_error_that_says_its_size) {
  Context context;
  PdfOptions options;
  options.page_width_pt = 1e7;
  EXPECT_TRUE(export_pdf(context, flat_picture(), options).ok());
  for (const double width : {2e7, 1e300}) {
    options.page_width_pt = width;
    const auto pdf = export_pdf(context, flat_picture(), options);
    EXPECT_EQ(pdf.status().code, StatusCode::bad_input);
    EXPECT_TRUE(pdf.status().message.starts_with("the page would be " + number_text(width)))
        << pdf.status().message;
  }
}

TEST(Pdf, a_picture_of_nothing_is_an_empty_page) {
  Picture picture;
  picture.artboard = picture.viewport = test::kPageBox;
  EXPECT_LT(exported_pdf(picture).size(), 1000u);
  picture.layers.emplace_back();
  picture.stack.push_back(PatchInstance{});
  EXPECT_LT(exported_pdf(picture).size(), 1000u);
}

TEST(Pdf, memory_and_cancellation_end_the_work) {
  Context small;
  ASSERT_TRUE(small.budget.charge(small.budget.limit() - 1000, "the test").ok());
  EXPECT_EQ(export_pdf(small, flat_picture(), {}).status().code, StatusCode::limit);
  Context cancelled;
  cancelled.cancel = true;
  EXPECT_EQ(export_pdf(cancelled, flat_picture(), {}).status().code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato
