#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "capi/handles.hpp"

/// Drawings traced from pictures.
namespace sfumato::test {
namespace {

/// Returns a disc on a ramp: red inside, blue to green around it.
std::vector<std::uint8_t> disc(int side) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int dx = 2 * x - side, dy = 2 * y - side;
      const bool is_inside = dx * dx + dy * dy < side * side / 4;
      const auto ramp = static_cast<std::uint8_t>(200 * x / side);
      const std::uint8_t inside[] = {220, 40, 30, 255};
      const std::uint8_t outside[] = {20, ramp, static_cast<std::uint8_t>(220 - ramp), 255};
      pixels.insert(pixels.end(), is_inside ? inside : outside, (is_inside ? inside : outside) + 4);
    }
  }
  return pixels;
}

constexpr int kPhotoSide = 64;
constexpr std::size_t kRowBytes = std::size_t{4} * kPhotoSide;

struct Told {
  sfumato_context* context = nullptr;
  std::vector<sfumato_trace_state> states;
  std::vector<std::string> drawings;
  bool cancels = false;
};

void tell(void* user, const sfumato_trace_state* state, const sfumato_document* drawing) {
  auto& told = *static_cast<Told*>(user);
  told.states.push_back(*state);
  told.drawings.push_back(written(told.context, drawing));
  if (told.cancels) sfumato_cancel(told.context);
}

class CTrace : public testing::Test {
 protected:
  std::int32_t trace(const char* options, const sfumato_trace_watch* watch = nullptr) {
    sfumato_document* out = nullptr;
    const std::int32_t code = sfumato_trace(context.get(), &image, options, watch, &out);
    document.reset(out);
    EXPECT_EQ(code == SFUMATO_OK, out != nullptr);
    return code;
  }

  /// Returns the mean square difference between the drawing's and the picture's pixels, in code
  /// values.
  double error() {
    const PictureHandle picture = solve(context.get(), document.get(), "width=64");
    std::vector<std::uint8_t> drawn(pixels.size());
    const sfumato_image into{drawn.data(), kRowBytes, kPhotoSide, kPhotoSide, SFUMATO_RGBA8};
    EXPECT_EQ(sfumato_raster(context.get(), picture.get(), &into, ""), SFUMATO_OK);
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const double difference = static_cast<double>(drawn[i]) - pixels[i];
      sum += difference * difference;
    }
    return sum / static_cast<double>(pixels.size());
  }

  ContextHandle context{sfumato_context_new("threads=1")};
  std::vector<std::uint8_t> pixels = disc(kPhotoSide);
  sfumato_image image{pixels.data(), kRowBytes, kPhotoSide, kPhotoSide, SFUMATO_RGBA8};
  DocumentHandle document;
};

TEST_F(CTrace, of_a_picture_looks_like_it) {
  ASSERT_EQ(trace(nullptr), SFUMATO_OK) << sfumato_error_text(context.get());
  double box[4];
  sfumato_document_artboard(document.get(), box);
  EXPECT_EQ(box[2], kPhotoSide);
  EXPECT_EQ(box[3], kPhotoSide);
  EXPECT_GE(sfumato_curve_count(document.get(), 0), 2U);
  EXPECT_LT(error(), 100);  // 28 dB
}

TEST_F(CTrace, of_rows_that_are_padded_is_the_same) {
  ASSERT_EQ(trace(nullptr), SFUMATO_OK);
  const std::string text = written(context.get(), document.get());
  std::vector<std::uint8_t> padded;
  for (std::size_t y = 0; y < kPhotoSide; ++y) {
    const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(y * kRowBytes);
    padded.insert(padded.end(), row, row + kRowBytes);
    padded.insert(padded.end(), 12, std::uint8_t{77});
  }
  image.pixels = padded.data();
  image.row_bytes = kRowBytes + 12;
  ASSERT_EQ(trace(nullptr), SFUMATO_OK);
  EXPECT_EQ(written(context.get(), document.get()), text);
}

TEST_F(CTrace, has_as_many_points_as_detail_says) {
  ASSERT_EQ(trace("detail=0"), SFUMATO_OK);
  const std::string rough = written(context.get(), document.get());
  ASSERT_EQ(trace("points=250"), SFUMATO_OK);
  EXPECT_EQ(written(context.get(), document.get()), rough);
}

TEST_F(CTrace, has_a_layer_of_texture_where_that_is_asked_for) {
  ASSERT_EQ(trace("points=60"), SFUMATO_OK);
  EXPECT_EQ(written(context.get(), document.get()).find("hard-light"), std::string::npos);
  ASSERT_EQ(trace("points=60 texture"), SFUMATO_OK);
  EXPECT_NE(written(context.get(), document.get()).find("hard-light"), std::string::npos);
}

TEST_F(CTrace, tells_of_its_rounds_with_a_drawing_to_be_read) {
  Told told{context.get(), {}, {}};
  const sfumato_trace_watch watch{tell, &told};
  ASSERT_EQ(trace("", &watch), SFUMATO_OK);
  ASSERT_GE(told.states.size(), 1U);
  EXPECT_EQ(told.states[0].round, 0U);
  EXPECT_GT(told.states[0].round_count, 0U);
  EXPECT_GE(told.states[0].curves, 1U);
  EXPECT_GT(told.states.back().psnr_db, 20);
  EXPECT_GE(told.states.back().control_points, told.states[0].control_points);
  EXPECT_NE(told.drawings[0].find("<path"), std::string::npos);
}

TEST_F(CTrace, ends_where_the_watch_cancels) {
  Told told{context.get(), {}, {}, true};
  const sfumato_trace_watch watch{tell, &told};
  EXPECT_EQ(trace("", &watch), SFUMATO_CANCELLED);
  EXPECT_EQ(told.states.size(), 1U);
  EXPECT_EQ(trace(""), SFUMATO_CANCELLED);
  sfumato_resume(context.get());
  EXPECT_EQ(trace(""), SFUMATO_OK);
}

TEST_F(CTrace, with_wrong_arguments_is_bad_usage_that_names_them) {
  EXPECT_EQ(trace("pionts=5"), SFUMATO_BAD_USAGE);
  EXPECT_NE(std::string(sfumato_error_text(context.get())).find("points"), std::string::npos);
  for (const char* wrong : {"points=0", "detail=1.5", "detail=-1", "psnr=0", "smooth=-1",
                            "smooth=33", "stops=none", "blur=1", "max-side=15", "max-curves=0",
                            "seed=-1", "edges-only=yes", "texture=1", "points=300 detail=0.5"}) {
    EXPECT_EQ(trace(wrong), SFUMATO_BAD_USAGE) << wrong;
  }
  const sfumato_trace_watch none{nullptr, nullptr};
  EXPECT_EQ(trace("", &none), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_trace(context.get(), &image, "", nullptr, nullptr), SFUMATO_BAD_USAGE);
  sfumato_document* out = nullptr;
  EXPECT_EQ(sfumato_trace(nullptr, &image, "", nullptr, &out), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_trace(context.get(), nullptr, "", nullptr, &out), SFUMATO_BAD_USAGE);
  image.row_bytes = 1;
  EXPECT_EQ(trace(""), SFUMATO_BAD_USAGE);
}

TEST_F(CTrace, gives_a_drawing_the_colors_of_a_picture) {
  const DocumentHandle drawing = read_text(context.get(), R"(<svg
      xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 8 8">
      <g sf:diffuse="true"><path id="one" d="M-1 4 L9 4" sf:left="red" sf:right="red"/></g>
    </svg>)");
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    const bool is_above = i < pixels.size() / 2;
    pixels[i] = is_above ? 0 : 255;
    pixels[i + 1] = is_above ? 204 : 255;
    pixels[i + 2] = is_above ? 51 : 0;
  }
  const auto fit = [&](const char* options) {
    sfumato_document* out = nullptr;
    const std::int32_t code =
        sfumato_fit_colors(context.get(), drawing.get(), &image, options, &out);
    document.reset(out);
    EXPECT_EQ(code == SFUMATO_OK, out != nullptr);
    return code;
  };
  ASSERT_EQ(fit("blur=off"), SFUMATO_OK) << sfumato_error_text(context.get());
  double left[4] = {}, right[4] = {};
  sfumato_curve_stops(document.get(), 0, 0, SFUMATO_LEFT, SFUMATO_COLOR, nullptr, nullptr, left, 1);
  sfumato_curve_stops(document.get(), 0, 0, SFUMATO_RIGHT, SFUMATO_COLOR, nullptr, nullptr, right,
                      1);
  EXPECT_NEAR(left[1], 0, 0.02);
  EXPECT_NEAR(left[2], 0.8, 0.02);
  EXPECT_NEAR(right[1], 1, 0.02);
  EXPECT_NEAR(right[3], 0, 0.02);
  EXPECT_STREQ(sfumato_curve_id(document.get(), 0, 0), "one");
  std::size_t at = 0, at_before = 0;
  sfumato_curve_source(document.get(), 0, 0, &at, nullptr);
  sfumato_curve_source(drawing.get(), 0, 0, &at_before, nullptr);
  EXPECT_EQ(at, at_before);
  EXPECT_GT(at, 0U);
  EXPECT_EQ(fit("only=0:0"), SFUMATO_OK) << sfumato_error_text(context.get());
  EXPECT_EQ(fit("only=0:0 keep-colors"), SFUMATO_OK);
  EXPECT_EQ(fit("only=0:1"), SFUMATO_BAD_INPUT);
  EXPECT_EQ(fit("keep-colors blur=off"), SFUMATO_BAD_INPUT);
  for (const char* wrong : {"only=", "only=0", "only=0:", "only=0:0,", "only=:0", "only=0:-1",
                            "only=0:0;0:0", "only=0:4294967296", "keep-colors=1"}) {
    EXPECT_EQ(fit(wrong), SFUMATO_BAD_USAGE) << wrong;
  }
  EXPECT_EQ(fit("points=5"), SFUMATO_BAD_USAGE);
  image.width = 0;
  EXPECT_EQ(fit(""), SFUMATO_BAD_USAGE);
  sfumato_document* out = nullptr;
  EXPECT_EQ(sfumato_fit_colors(context.get(), nullptr, &image, "", &out), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_document_new(context.get(), "artboard=0,0,8,8", &out), SFUMATO_OK);
  const DocumentHandle empty(out);
  image.width = kPhotoSide;
  EXPECT_EQ(sfumato_fit_colors(context.get(), empty.get(), &image, "", &out), SFUMATO_BAD_INPUT);
}

TEST_F(CTrace, that_needs_more_than_there_is_is_a_limit) {
  const ContextHandle small(sfumato_context_new("threads=1 max-memory=1"));
  const std::vector<std::uint8_t> large(std::size_t{4} * 1024 * 1024);
  const sfumato_image big{const_cast<std::uint8_t*>(large.data()), 4096, 1024, 1024, SFUMATO_RGBA8};
  sfumato_document* out = nullptr;
  EXPECT_EQ(sfumato_trace(small.get(), &big, "", nullptr, &out), SFUMATO_LIMIT);
  EXPECT_EQ(out, nullptr);
  const ContextHandle narrow(sfumato_context_new("threads=1 limit.image-side=63"));
  EXPECT_EQ(sfumato_trace(narrow.get(), &image, "", nullptr, &out), SFUMATO_LIMIT);
}

}  // namespace
}  // namespace sfumato::test
