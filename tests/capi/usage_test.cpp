#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "capi/handles.hpp"

/// Mistakes of the caller: each call returns an error and changes nothing.
namespace sfumato::test {
namespace {

constexpr std::int32_t kUsage = SFUMATO_BAD_USAGE;

class CUsage : public testing::Test {
 protected:
  CUsage() {
    const double line[] = {0, 5, 3, 5, 6, 5, 10, 5}, red[] = {0, 1, 0, 0};
    sfumato_document* made = nullptr;
    EXPECT_EQ(sfumato_document_new(c, "artboard=0,0,10,10", &made), SFUMATO_OK);
    document.reset(made);
    EXPECT_EQ(sfumato_insert_curve(c, made, 0, 0, line, 4), SFUMATO_OK);
    EXPECT_EQ(stops(SFUMATO_LEFT, SFUMATO_COLOR, SFUMATO_STOPS, SFUMATO_PARAMETER, red, 1),
              SFUMATO_OK);
    before = written(c, made);
  }
  ~CUsage() override { EXPECT_EQ(written(c, document.get()), before); }

  std::int32_t stops(std::uint32_t side, std::uint32_t attribute, std::int32_t kind,
                     std::int32_t space, const double* rows, std::size_t count) {
    return sfumato_set_curve_stops(c, document.get(), 0, 0, side, attribute, kind, space, rows,
                                   count);
  }

  ContextHandle context{sfumato_context_new("threads=1")};
  sfumato_context* c = context.get();
  DocumentHandle document;
  std::string before;
};

TEST_F(CUsage, null_is_an_error_everywhere) {
  sfumato_document* d = document.get();
  sfumato_document* out_d = d;
  sfumato_picture* out_p = nullptr;
  sfumato_bytes* out_b = nullptr;
  sfumato_field* out_f = nullptr;
  sfumato_weights* out_w = nullptr;
  const double xy[8] = {};
  float rgba[4];
  double box[4];
  sfumato_view view;
  EXPECT_EQ(sfumato_read(nullptr, "", 0, nullptr, nullptr, &out_d), kUsage);
  EXPECT_EQ(out_d, nullptr);
  EXPECT_EQ(sfumato_read(c, nullptr, 1, nullptr, nullptr, &out_d), kUsage);
  EXPECT_EQ(sfumato_read(c, "", 0, nullptr, nullptr, nullptr), kUsage);
  const sfumato_loader loader{nullptr, nullptr};
  EXPECT_EQ(sfumato_read(c, "", 0, nullptr, &loader, &out_d), kUsage);
  EXPECT_EQ(sfumato_import_svg(nullptr, "", 0, nullptr, nullptr, &out_d), kUsage);
  EXPECT_EQ(sfumato_import_svg(c, nullptr, 1, nullptr, nullptr, &out_d), kUsage);
  EXPECT_EQ(sfumato_import_svg(c, "", 0, nullptr, nullptr, nullptr), kUsage);
  EXPECT_EQ(sfumato_document_new(nullptr, nullptr, &out_d), kUsage);
  EXPECT_EQ(sfumato_document_new(c, "artboard=0,0,1,1", nullptr), kUsage);
  EXPECT_EQ(sfumato_document_copy(c, nullptr, &out_d), kUsage);
  EXPECT_EQ(sfumato_document_copy(c, d, nullptr), kUsage);
  EXPECT_EQ(sfumato_document_write(c, nullptr, &out_b), kUsage);
  EXPECT_EQ(sfumato_document_write(c, d, nullptr), kUsage);
  EXPECT_EQ(sfumato_lint(c, nullptr, nullptr, &out_b), kUsage);
  EXPECT_EQ(sfumato_lint(c, d, nullptr, nullptr), kUsage);
  EXPECT_EQ(sfumato_lint(c, d, "json", &out_b), kUsage);
  EXPECT_EQ(sfumato_document_artboard(nullptr, box), kUsage);
  EXPECT_EQ(sfumato_document_artboard(d, nullptr), kUsage);
  EXPECT_EQ(sfumato_curve_source(nullptr, 0, 0, nullptr, nullptr), kUsage);
  EXPECT_EQ(sfumato_curve_points(nullptr, 0, 0, &view), kUsage);
  EXPECT_EQ(sfumato_curve_points(d, 0, 0, nullptr), kUsage);
  EXPECT_EQ(sfumato_set_curve_points(nullptr, d, 0, 0, xy, 4), kUsage);
  EXPECT_EQ(sfumato_set_curve_points(c, nullptr, 0, 0, xy, 4), kUsage);
  EXPECT_EQ(sfumato_set_curve_points(c, d, 0, 0, nullptr, 4), kUsage);
  EXPECT_EQ(sfumato_set_curve_stops(c, nullptr, 0, 0, 0, 0, 0, 0, nullptr, 0), kUsage);
  EXPECT_EQ(sfumato_set_curve_stops(c, d, 0, 0, 0, 0, SFUMATO_STOPS, 0, nullptr, 1), kUsage);
  EXPECT_EQ(sfumato_insert_curve(c, nullptr, 0, 0, xy, 4), kUsage);
  EXPECT_EQ(sfumato_insert_curve(c, d, 0, 0, nullptr, 4), kUsage);
  EXPECT_EQ(sfumato_remove_curve(c, nullptr, 0, 0), kUsage);
  EXPECT_EQ(sfumato_solve(c, nullptr, nullptr, &out_p), kUsage);
  EXPECT_EQ(sfumato_solve(c, d, nullptr, nullptr), kUsage);
  EXPECT_EQ(sfumato_solve_again(c, d, 0, nullptr), kUsage);
  EXPECT_EQ(sfumato_picture_viewport(nullptr, box), kUsage);
  EXPECT_EQ(sfumato_picture_table(nullptr, 0, 0, &view), kUsage);
  EXPECT_EQ(sfumato_picture_changes(nullptr, 0, 0, &view), kUsage);
  EXPECT_EQ(sfumato_picture_statistic(nullptr, SFUMATO_CURVES), 0);
  EXPECT_EQ(sfumato_raster(c, nullptr, nullptr, nullptr), kUsage);
  EXPECT_EQ(sfumato_export(c, nullptr, "png", nullptr, &out_b), kUsage);
  EXPECT_EQ(sfumato_encode(c, nullptr, "png", nullptr, &out_b), kUsage);
  EXPECT_EQ(sfumato_viewer_payload(c, nullptr, nullptr, &out_b), kUsage);
  EXPECT_EQ(sfumato_picture_stack(c, nullptr, nullptr, &out_b), kUsage);
  EXPECT_EQ(sfumato_exact_layer(c, nullptr, 0, &out_b), kUsage);
  EXPECT_EQ(sfumato_add_image(nullptr, "x", 1, nullptr), kUsage);
  EXPECT_EQ(sfumato_add_image(c, nullptr, 1, nullptr), kUsage);
  EXPECT_EQ(sfumato_add_image(c, "x", 0, nullptr), kUsage);
  EXPECT_EQ(sfumato_field_new(c, nullptr, 0, nullptr, &out_f), kUsage);
  EXPECT_EQ(sfumato_field_colors(c, nullptr, xy, 1, rgba), kUsage);
  EXPECT_EQ(sfumato_weights_new(c, nullptr, 0, SFUMATO_COLOR, nullptr, &out_w), kUsage);
  EXPECT_EQ(sfumato_weights_new(c, d, 0, SFUMATO_COLOR, nullptr, nullptr), kUsage);
  EXPECT_EQ(sfumato_weights_at(c, nullptr, xy, 1, 0), kUsage);
  EXPECT_EQ(sfumato_weights_table(nullptr, SFUMATO_WEIGHTS, &view), kUsage);
  EXPECT_EQ(sfumato_convert_colors(SFUMATO_SRGB, SFUMATO_OKLAB, nullptr, 1, box), kUsage);
  EXPECT_EQ(sfumato_curve_stops(nullptr, 0, 0, 0, 0, nullptr, nullptr, nullptr, 0), 0u);
}

TEST_F(CUsage, null_is_freed_and_looked_at_without_harm) {
  sfumato_context_free(nullptr);
  sfumato_document_free(nullptr);
  sfumato_picture_free(nullptr);
  sfumato_field_free(nullptr);
  sfumato_weights_free(nullptr);
  sfumato_bytes_free(nullptr);
  sfumato_cancel(nullptr);
  sfumato_resume(nullptr);
  sfumato_set_progress(nullptr, nullptr, nullptr);
  sfumato_error_place(nullptr, nullptr, nullptr);
  EXPECT_STREQ(sfumato_error_text(nullptr), "no context");
  EXPECT_STREQ(sfumato_error_file(nullptr), "");
  EXPECT_EQ(sfumato_warning(nullptr, 0), nullptr);
  EXPECT_EQ(sfumato_bytes_data(nullptr), nullptr);
  EXPECT_EQ(sfumato_bytes_size(nullptr), 0u);
  EXPECT_EQ(sfumato_layer_count(nullptr), 0u);
  EXPECT_EQ(sfumato_curve_count(nullptr, 0), 0u);
  EXPECT_EQ(sfumato_layer_id(nullptr, 0), nullptr);
  EXPECT_EQ(sfumato_curve_id(nullptr, 0, 0), nullptr);
  EXPECT_EQ(sfumato_picture_layer_count(nullptr), 0u);
}

TEST_F(CUsage, indices_past_the_end_are_errors) {
  sfumato_document* d = document.get();
  const double xy[8] = {};
  sfumato_view view;
  sfumato_field* field = nullptr;
  sfumato_weights* weights = nullptr;
  for (const std::uint32_t bad : {1u, UINT32_MAX}) {
    EXPECT_EQ(sfumato_curve_count(d, bad), 0u);
    EXPECT_EQ(sfumato_layer_id(d, bad), nullptr);
    EXPECT_EQ(sfumato_curve_id(d, 0, bad), nullptr);
    std::size_t offset = 9;
    EXPECT_EQ(sfumato_curve_source(d, bad, 0, &offset, nullptr), kUsage);
    EXPECT_EQ(sfumato_curve_source(d, 0, bad, nullptr, nullptr), kUsage);
    EXPECT_EQ(offset, 0u);
    EXPECT_EQ(sfumato_curve_points(d, bad, 0, &view), kUsage);
    EXPECT_EQ(sfumato_curve_points(d, 0, bad, &view), kUsage);
    EXPECT_EQ(view.data, nullptr);
    EXPECT_EQ(sfumato_set_curve_points(c, d, bad, 0, xy, 4), kUsage);
    EXPECT_EQ(sfumato_set_curve_points(c, d, 0, bad, xy, 4), kUsage);
    EXPECT_EQ(sfumato_insert_curve(c, d, bad, 0, xy, 4), kUsage);
    EXPECT_EQ(sfumato_remove_curve(c, d, bad, 0), kUsage);
    EXPECT_EQ(sfumato_remove_curve(c, d, 0, bad), kUsage);
    EXPECT_EQ(sfumato_field_new(c, d, bad, nullptr, &field), kUsage);
    EXPECT_EQ(sfumato_weights_new(c, d, bad, SFUMATO_COLOR, nullptr, &weights), kUsage);
  }
  EXPECT_EQ(sfumato_weights_new(c, d, 0, SFUMATO_BLUR, nullptr, &weights), kUsage);
  EXPECT_EQ(sfumato_insert_curve(c, d, 0, 2, xy, 4), kUsage);
  EXPECT_STREQ(sfumato_error_text(c), "there is no curve 2 in layer 0");
  const PictureHandle picture = solve(c, d);
  EXPECT_EQ(sfumato_picture_table(picture.get(), 1, 0, &view), kUsage);
  EXPECT_EQ(sfumato_picture_table(picture.get(), 0, 7, &view), kUsage);
  EXPECT_EQ(sfumato_picture_changes(picture.get(), 0, 7, &view), kUsage);
  EXPECT_EQ(sfumato_picture_changes(picture.get(), 1, 0, &view), kUsage);
  EXPECT_EQ(sfumato_picture_statistic(picture.get(), SFUMATO_BEGUN_LAYERS + 1), 0);
}

TEST_F(CUsage, numbers_that_no_document_has_are_errors) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double huge = 1e300;
  for (const double bad : {nan, huge, -huge, std::numeric_limits<double>::infinity()}) {
    const double xy[8] = {0, 0, 1, 1, 2, 2, 3, bad};
    const double row[4] = {0, bad, 0, 0}, offset[4] = {bad, 0, 0, 0};
    EXPECT_EQ(sfumato_set_curve_points(c, document.get(), 0, 0, xy, 4), SFUMATO_BAD_INPUT);
    EXPECT_EQ(sfumato_insert_curve(c, document.get(), 0, 0, xy, 4), SFUMATO_BAD_INPUT);
    for (const std::uint32_t attribute : {SFUMATO_COLOR, SFUMATO_OPACITY, SFUMATO_BLUR}) {
      EXPECT_EQ(stops(0, attribute, SFUMATO_STOPS, 0, row, 1), SFUMATO_BAD_INPUT) << attribute;
      EXPECT_EQ(stops(0, attribute, SFUMATO_STOPS, 0, offset, 1), SFUMATO_BAD_INPUT);
    }
  }
}

TEST_F(CUsage, counts_are_looked_at_before_the_numbers) {
  const double xy[8] = {0, 0, 1, 1, 2, 2, 3, 3};
  for (const std::size_t huge : {std::size_t{1} << 40, SIZE_MAX, SIZE_MAX / 16}) {
    EXPECT_EQ(sfumato_set_curve_points(c, document.get(), 0, 0, xy, huge), SFUMATO_LIMIT);
    EXPECT_EQ(sfumato_insert_curve(c, document.get(), 0, 0, xy, huge), SFUMATO_LIMIT);
    EXPECT_EQ(stops(0, 0, SFUMATO_STOPS, 0, xy, huge), SFUMATO_LIMIT);
  }
  for (const std::size_t wrong : {0, 1, 2, 3}) {
    EXPECT_EQ(sfumato_set_curve_points(c, document.get(), 0, 0, xy, wrong), SFUMATO_BAD_INPUT);
  }
}

TEST_F(CUsage, words_that_no_side_has_are_errors) {
  const double row[4] = {0, 1, 0, 0};
  EXPECT_EQ(stops(2, 0, SFUMATO_STOPS, 0, row, 1), kUsage);
  EXPECT_EQ(stops(0, 3, SFUMATO_STOPS, 0, row, 1), kUsage);
  EXPECT_EQ(stops(0, 0, SFUMATO_PAINT, 0, row, 1), kUsage);
  EXPECT_EQ(stops(0, 0, -1, 0, row, 1), kUsage);
  EXPECT_EQ(stops(0, 0, SFUMATO_STOPS, 2, row, 1), kUsage);
  EXPECT_EQ(stops(0, 0, SFUMATO_STOPS, -1, row, 1), kUsage);
  EXPECT_EQ(stops(0, 0, SFUMATO_STOPS, 0, row, 0), kUsage);
  EXPECT_EQ(stops(0, 0, SFUMATO_OPEN, 0, row, 1), kUsage);
  EXPECT_EQ(stops(0, SFUMATO_BLUR, SFUMATO_BARRIER, 0, nullptr, 0), kUsage);
}

TEST_F(CUsage, pixels_that_are_none_are_errors) {
  const PictureHandle picture = solve(c, document.get());
  std::uint8_t pixels[64];
  const sfumato_image good{pixels, 16, 4, 4, SFUMATO_RGBA8};
  const auto code = [&](sfumato_image image) {
    sfumato_bytes* bytes = nullptr;
    const std::int32_t encoded = sfumato_encode(c, &image, "png", nullptr, &bytes);
    sfumato_bytes_free(bytes);
    const std::int32_t drawn = sfumato_raster(c, picture.get(), &image, nullptr);
    EXPECT_EQ(encoded, drawn);
    EXPECT_EQ(sfumato_add_image(c, "x", 1, &image), drawn);
    return drawn;
  };
  EXPECT_EQ(code(good), SFUMATO_OK);
  EXPECT_EQ(code({nullptr, 16, 4, 4, SFUMATO_RGBA8}), kUsage);
  EXPECT_EQ(code({pixels, 15, 4, 4, SFUMATO_RGBA8}), kUsage);
  EXPECT_EQ(code({pixels, 0, 4, 4, SFUMATO_RGB8}), kUsage);
  EXPECT_EQ(code({pixels, SIZE_MAX, 4, 4, SFUMATO_RGB8}), kUsage);
  EXPECT_EQ(code({pixels, 16, 0, 4, SFUMATO_RGBA8}), kUsage);
  EXPECT_EQ(code({pixels, 16, 4, -4, SFUMATO_RGBA8}), kUsage);
  EXPECT_EQ(code({pixels, 16, INT32_MAX, 4, SFUMATO_RGBA8}), kUsage);
  EXPECT_EQ(code({pixels, 16, 4, 4, 4}), kUsage);
  EXPECT_EQ(code({pixels, 16, 4, 4, -1}), kUsage);
  sfumato_image wide{pixels, std::size_t{1} << 40, 1 << 30, 1, SFUMATO_RGB8};
  EXPECT_EQ(sfumato_raster(c, picture.get(), &wide, nullptr), SFUMATO_LIMIT);
}

TEST_F(CUsage, options_name_what_is_wrong_with_them) {
  const PictureHandle picture = solve(c, document.get());
  sfumato_picture* none = nullptr;
  sfumato_bytes* bytes = nullptr;
  const auto solve_error = [&](const char* options) {
    EXPECT_EQ(sfumato_solve(c, document.get(), options, &none), kUsage) << options;
    EXPECT_EQ(none, nullptr);
    return std::string(sfumato_error_text(c));
  };
  const auto export_error = [&](const char* format, const char* options) {
    EXPECT_EQ(sfumato_export(c, picture.get(), format, options, &bytes), kUsage) << options;
    return std::string(sfumato_error_text(c));
  };
  EXPECT_EQ(solve_error("max-eror=1"),
            "unknown option \"max-eror\" for this call; did you mean max-error?");
  EXPECT_EQ(solve_error("scale=1 width=4"), "scale: cannot be combined with width and height");
  EXPECT_EQ(solve_error("order=\"cubic"),
            "order: a quote that is not closed; add the closing quote");
  EXPECT_EQ(solve_error("method=pixels").substr(0, 8), "method: ");
  EXPECT_EQ(export_error("png", "svg=vector"), "svg: works with SVG only");
  EXPECT_EQ(export_error("svg", "force"), "force: works with svg=vector only");
  EXPECT_EQ(export_error("pdf", "viewport=0,0,1,1").substr(0, 10), "viewport: ");
  EXPECT_EQ(export_error("pgn", ""), "unknown format \"pgn\"; did you mean png?");
  EXPECT_EQ(export_error("", ""), "unknown format \"\"");
}

TEST_F(CUsage, a_context_of_wrong_options_says_so) {
  const ContextHandle wrong(sfumato_context_new("thread=2"));
  ASSERT_TRUE(wrong);
  EXPECT_STREQ(sfumato_error_text(wrong.get()),
               "unknown option \"thread\" for this call; did you mean threads?");
  sfumato_document* made = nullptr;
  EXPECT_EQ(sfumato_document_new(wrong.get(), "artboard=0,0,1,1", &made), kUsage);
  EXPECT_EQ(made, nullptr);
  sfumato_cancel(wrong.get());
  sfumato_resume(wrong.get());
  sfumato_set_progress(wrong.get(), nullptr, nullptr);
}

}  // namespace
}  // namespace sfumato::test
