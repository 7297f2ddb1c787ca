#include <gtest/gtest.h>

#include "capi/handles.hpp"
#include "cli/run_command.hpp"

/// sfumato_import_svg() makes the document that `sfumato init --from` writes.
namespace sfumato::test {
namespace {

constexpr const char* kOrdinary = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 30">
  <rect id="box" x="5" y="5" width="20" height="10" fill="#c04030"/>
  <circle cx="30" cy="20" r="5" fill="none" stroke="#123456" stroke-width="2"/>
  <text x="5" y="5">left out</text>
</svg>)";

constexpr const char* kPatterned =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 30">
  <pattern id="inner" width="4" height="4" patternUnits="userSpaceOnUse"><rect width="2" height="4"
    fill="#08f"/></pattern>
  <pattern id="dots" width="8" height="8" patternUnits="userSpaceOnUse"><circle cx="4" cy="4" r="3"
    fill="#c04030"/><rect width="8" height="2" fill="url(#inner)"/></pattern>
  <rect x="5" y="5" width="30" height="20" fill="url(#dots)"/>
</svg>)svg";

std::int32_t import_text(sfumato_context* context, const std::string& text, DocumentHandle& out) {
  sfumato_document* document = nullptr;
  const std::int32_t code =
      sfumato_import_svg(context, text.data(), text.size(), "in.svg", nullptr, &document);
  out.reset(document);
  return code;
}

TEST(CImport, makes_the_document_of_the_command) {
  const ContextHandle context = context_of();
  DocumentHandle document;
  ASSERT_EQ(import_text(context.get(), kOrdinary, document), SFUMATO_OK);
  sfumato_bytes* written = nullptr;
  ASSERT_EQ(sfumato_document_write(context.get(), document.get(), &written), SFUMATO_OK);
  const std::string text = text_of(BytesHandle(written).get());
  EXPECT_EQ(text, run_sfumato({"init", "-", "--from", "-"}, kOrdinary).out);
  EXPECT_NE(text.find("id=\"box\""), std::string::npos);
}

TEST(CImport, patterns_of_shapes_are_the_textures_of_the_command) {
  const ContextHandle context = context_of();
  DocumentHandle document;
  ASSERT_EQ(import_text(context.get(), kPatterned, document), SFUMATO_OK);
  EXPECT_NE(std::string(sfumato_warning(context.get(), 0)).find("becomes a texture"),
            std::string::npos);
  EXPECT_EQ(sfumato_warning(context.get(), 1), nullptr);
  sfumato_bytes* written = nullptr;
  ASSERT_EQ(sfumato_document_write(context.get(), document.get(), &written), SFUMATO_OK);
  const std::string text = text_of(BytesHandle(written).get());
  EXPECT_EQ(text, run_sfumato({"init", "-", "--from", "-"}, kPatterned).out);
  EXPECT_NE(text.find("<pattern"), std::string::npos);
}

TEST(CImport, names_what_it_leaves_out) {
  const ContextHandle context = context_of();
  DocumentHandle document;
  ASSERT_EQ(import_text(context.get(), kOrdinary, document), SFUMATO_OK);
  const char* warning = sfumato_warning(context.get(), 0);
  ASSERT_NE(warning, nullptr);
  EXPECT_EQ(std::string(warning).rfind("in.svg:4:3: ", 0), 0u) << warning;
  EXPECT_EQ(sfumato_warning(context.get(), 1), nullptr);
}

TEST(CImport, broken_text_is_an_error_with_its_place) {
  const ContextHandle context = context_of();
  DocumentHandle document;
  EXPECT_EQ(import_text(context.get(), "<svg>\n<rect", document), SFUMATO_BAD_INPUT);
  EXPECT_EQ(document, nullptr);
  EXPECT_STREQ(sfumato_error_file(context.get()), "in.svg");
  const ContextHandle small = context_of("limit.curves=1");
  EXPECT_EQ(import_text(small.get(), kOrdinary, document), SFUMATO_LIMIT);
}

}  // namespace
}  // namespace sfumato::test
