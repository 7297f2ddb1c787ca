// Pictures as files through the C interface.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "capi/handles.hpp"

namespace sfumato::test {
namespace {

constexpr const char* kSolving = "max-error=off scale=0.25 max-area=1";

class PictureFileOfC : public testing::Test {
 protected:
  ContextHandle context{sfumato_context_new("threads=1")};
  sfumato_context* c = context.get();
  DocumentHandle document = read_text(c, example("strokes.svg"));
  PictureHandle picture = solve(c, document.get(), kSolving);

  std::string bytes_of(const sfumato_picture* of) {
    sfumato_bytes* bytes = nullptr;
    EXPECT_EQ(sfumato_picture_write(c, of, &bytes), SFUMATO_OK) << sfumato_error_text(c);
    return text_of(BytesHandle(bytes).get());
  }
  PictureHandle read(const std::string& bytes) {
    sfumato_picture* out = nullptr;
    EXPECT_EQ(sfumato_picture_read(c, bytes.data(), bytes.size(), &out), SFUMATO_OK)
        << sfumato_error_text(c);
    return PictureHandle(out);
  }
  std::string exported(const sfumato_picture* of, const char* format) {
    sfumato_bytes* bytes = nullptr;
    EXPECT_EQ(sfumato_export(c, of, format, format == std::string("svg") ? "svg=vector" : nullptr,
                             &bytes),
              SFUMATO_OK)
        << sfumato_error_text(c);
    return text_of(BytesHandle(bytes).get());
  }
};

TEST_F(PictureFileOfC, a_picture_that_is_read_exports_what_the_other_does) {
  const std::string bytes = bytes_of(picture.get());
  const PictureHandle again = read(bytes);
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(bytes_of(again.get()), bytes);
  for (const char* format : {"png", "jpg", "pdf", "eps", "svg", "glb", "sfv"}) {
    EXPECT_EQ(exported(again.get(), format), exported(picture.get(), format)) << format;
  }
  // A page also holds curves for exact pixels, which a file of patches does not have.
  const std::string page = exported(again.get(), "html");
  EXPECT_NE(page.find("id=\"payload\""), std::string::npos);
  EXPECT_LT(page.size(), exported(picture.get(), "html").size());
  sfumato_bytes* bytes_out = nullptr;
  EXPECT_EQ(sfumato_exact_layer(c, again.get(), 0, &bytes_out), SFUMATO_BAD_USAGE);
}

TEST_F(PictureFileOfC, its_tables_and_numbers_are_those_of_the_other) {
  const PictureHandle again = read(bytes_of(picture.get()));
  double box[4], other[4];
  ASSERT_EQ(sfumato_picture_viewport(again.get(), box), SFUMATO_OK);
  ASSERT_EQ(sfumato_picture_viewport(picture.get(), other), SFUMATO_OK);
  EXPECT_TRUE(std::equal(box, box + 4, other));
  const std::uint32_t layers = sfumato_picture_layer_count(again.get());
  ASSERT_EQ(layers, sfumato_picture_layer_count(picture.get()));
  double triangles = 0;
  for (std::uint32_t layer = 0; layer < layers; ++layer) {
    for (std::uint32_t table = SFUMATO_VERTICES; table <= SFUMATO_OPACITY_VALUES; ++table) {
      sfumato_view view, expected, changes;
      ASSERT_EQ(sfumato_picture_table(again.get(), layer, table, &view), SFUMATO_OK);
      ASSERT_EQ(sfumato_picture_table(picture.get(), layer, table, &expected), SFUMATO_OK);
      EXPECT_EQ(view.rows, expected.rows);
      if (table == SFUMATO_TRIANGLES) triangles += static_cast<double>(view.rows);
      ASSERT_EQ(sfumato_picture_changes(again.get(), layer, table, &changes), SFUMATO_OK);
      EXPECT_EQ(changes.rows, view.rows > 0 ? 1u : 0u);
    }
  }
  EXPECT_EQ(sfumato_picture_statistic(again.get(), SFUMATO_SOLVED_TRIANGLES), triangles);
  EXPECT_EQ(sfumato_picture_statistic(again.get(), SFUMATO_WAITING_NODES), 0);
}

TEST_F(PictureFileOfC, it_follows_no_document) {
  const PictureHandle again = read(bytes_of(picture.get()));
  sfumato_view view{};
  const std::uint32_t curve = 0;
  EXPECT_EQ(sfumato_solve_again(c, document.get(), 0, again.get()), SFUMATO_BAD_USAGE);
  EXPECT_NE(std::string(sfumato_error_text(c)).find("read from a file"), std::string::npos);
  EXPECT_EQ(sfumato_solve_again(c, document.get(), 1, again.get()), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_solve_within(c, document.get(), 1, again.get()), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_expect_drag(c, again.get(), 0, &curve, 1), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_stop_response(c, again.get(), 0, 0, 0, 0, 0, &view), SFUMATO_BAD_USAGE);
  EXPECT_EQ(bytes_of(again.get()), bytes_of(picture.get()));
}

TEST_F(PictureFileOfC, it_outlives_its_context_and_gives_its_memory_back) {
  const std::string bytes = bytes_of(picture.get());
  PictureHandle again = read(bytes);
  context.reset();
  EXPECT_GT(sfumato_picture_layer_count(again.get()), 0u);
  again.reset();
  const ContextHandle small(sfumato_context_new("threads=1 max-memory=3"));
  ASSERT_LT(bytes.size(), 2u << 20);
  for (int i = 0; i < 20; ++i) {  // each fits, but not all together
    sfumato_picture* out = nullptr;
    ASSERT_EQ(sfumato_picture_read(small.get(), bytes.data(), bytes.size(), &out), SFUMATO_OK)
        << sfumato_error_text(small.get());
    sfumato_picture_free(out);
  }
  std::vector<PictureHandle> held;
  std::int32_t code = SFUMATO_OK;
  while (code == SFUMATO_OK && held.size() < 1000) {
    sfumato_picture* out = nullptr;
    code = sfumato_picture_read(small.get(), bytes.data(), bytes.size(), &out);
    if (out) held.emplace_back(out);
  }
  EXPECT_EQ(code, SFUMATO_LIMIT);
}

TEST_F(PictureFileOfC, wrong_calls_and_bytes_are_told) {
  const std::string bytes = bytes_of(picture.get());
  sfumato_picture* out = nullptr;
  sfumato_bytes* written = nullptr;
  EXPECT_EQ(sfumato_picture_write(c, nullptr, &written), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_picture_write(c, picture.get(), nullptr), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_picture_read(c, nullptr, 7, &out), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_picture_read(c, bytes.data(), bytes.size(), nullptr), SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_picture_read(c, nullptr, 0, &out), SFUMATO_BAD_INPUT);
  EXPECT_STREQ(sfumato_error_text(c), "not a solved picture");
  EXPECT_EQ(sfumato_picture_read(c, bytes.data(), bytes.size() - 1, &out), SFUMATO_BAD_INPUT);
  EXPECT_EQ(out, nullptr);
  EXPECT_EQ(written, nullptr);
}

}  // namespace
}  // namespace sfumato::test
