#include <gtest/gtest.h>

#include <cstring>

#include "capi/handles.hpp"
#include "cli/run_command.hpp"
#include "support/places.hpp"

/// The places of curves in the text that they were read from.
namespace sfumato::test {
namespace {

/// A shape in defs that two layers use, parts of no length, and moves that draw nothing.
constexpr const char* kTwoLayersText = R"(<?xml version="1.0"?>
<!-- é --><svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 48"
  sf:version="1">
  <defs><path id="shared" d="M1 1 L9 9" sf:left="red"/></defs>
  <g sf:diffuse="true">
    <path d="M5 5 M0 0 L8 0 M3 3 L3 3 M0 4 L8 4" sf:left="red"/>
    <g><use href="#shared"/></g>
    <circle cx="20" cy="20" r="5" sf:left="blue"/>
  </g>
  <g sf:diffuse="true"><use href="#shared" x="5"/></g>
</svg>)";

struct Found {
  std::string element{};  ///< its first 12 bytes; empty: unknown
  std::uint32_t subpath = 0;

  friend bool operator==(const Found&, const Found&) = default;
};

std::ostream& operator<<(std::ostream& out, const Found& found) {
  return out << found.element << ' ' << found.subpath;
}

class CSource : public testing::Test {
 protected:
  DocumentHandle read(const std::string& given) {
    text = given;
    return read_text(context.get(), text);
  }

  Found find(const DocumentHandle& document, std::uint32_t layer, std::uint32_t curve) const {
    std::size_t offset = 9;
    Found found{"", 9};
    EXPECT_EQ(sfumato_curve_source(document.get(), layer, curve, &offset, &found.subpath),
              SFUMATO_OK);
    if (offset != 0) found.element = text.substr(offset, 12);
    return found;
  }

  ContextHandle context{sfumato_context_new("threads=1")};
  std::string text;
  const Found first{"<path d=\"M5 ", 0}, third{"<path d=\"M5 ", 2}, shared{"<path id=\"sh", 0},
      circle{"<circle cx=\"", 0}, none{};
};

TEST_F(CSource, is_the_element_and_the_subpath_of_a_curve) {
  for (const std::string& given :
       {std::string(kTwoLayersText), "\xEF\xBB\xBF" + std::string(kTwoLayersText)}) {
    const DocumentHandle document = read(given);
    EXPECT_EQ(find(document, 0, 0), first);
    EXPECT_EQ(find(document, 0, 1), third);
    EXPECT_EQ(find(document, 0, 2), shared);
    EXPECT_EQ(find(document, 0, 3), circle);
    EXPECT_EQ(find(document, 1, 0), shared);
  }
}

TEST_F(CSource, stays_with_its_curve_when_the_document_is_edited) {
  const DocumentHandle document = read(kTwoLayersText);
  sfumato_document* d = document.get();
  const double xy[8] = {0, 0, 1, 1, 2, 2, 3, 3};
  ASSERT_EQ(sfumato_insert_curve(context.get(), d, 0, 1, xy, 4), SFUMATO_OK);
  EXPECT_EQ(find(document, 0, 0), first);
  EXPECT_EQ(find(document, 0, 1), none);
  EXPECT_EQ(find(document, 0, 2), third);
  EXPECT_EQ(find(document, 0, 4), circle);
  ASSERT_EQ(sfumato_insert_curve(context.get(), d, 0, UINT32_MAX, xy, 4), SFUMATO_OK);
  EXPECT_EQ(find(document, 0, 5), none);
  ASSERT_EQ(sfumato_remove_curve(context.get(), d, 0, 0), SFUMATO_OK);
  EXPECT_EQ(find(document, 0, 1), third);
  ASSERT_EQ(sfumato_set_curve_points(context.get(), d, 0, 1, xy, 4), SFUMATO_OK);
  EXPECT_EQ(find(document, 0, 1), third);
  EXPECT_EQ(find(document, 1, 0), shared);
  sfumato_document* copied = nullptr;
  ASSERT_EQ(sfumato_document_copy(context.get(), d, &copied), SFUMATO_OK);
  const DocumentHandle copy(copied);
  EXPECT_EQ(find(copy, 0, 3), circle);
  EXPECT_NE(sfumato_remove_curve(context.get(), d, 0, 9), SFUMATO_OK);
  EXPECT_EQ(find(document, 0, 3), circle);
}

TEST_F(CSource, is_not_known_of_what_is_no_plain_text) {
  std::string utf16 = "\xFF\xFE";
  for (const char c : std::string(R"(<svg xmlns="http://www.w3.org/2000/svg")"
                                  R"( xmlns:sf="urn:sfumato:1" viewBox="0 0 9 9">)"
                                  R"(<g sf:diffuse="true"><path d="M0 0L9 9" sf:left="red"/></g>)"
                                  "</svg>")) {
    utf16 += c;
    utf16 += '\0';
  }
  const std::string packed =
      run_command({"/bin/bash", "-c", "gzip --stdout " + source_path("examples/fish.svg")}).out;
  ASSERT_EQ(packed.substr(0, 2), "\x1f\x8b");
  const double xy[8] = {0, 0, 1, 1, 2, 2, 3, 3};
  for (const std::string& given : {example("evening.xml"), utf16, packed}) {
    const DocumentHandle document = read(given);
    EXPECT_EQ(find(document, 0, 0), none);
    ASSERT_EQ(sfumato_insert_curve(context.get(), document.get(), 0, 0, xy, 4), SFUMATO_OK);
    ASSERT_EQ(sfumato_remove_curve(context.get(), document.get(), 0, 1), SFUMATO_OK);
    EXPECT_EQ(find(document, 0, 0), none);
  }
}

}  // namespace
}  // namespace sfumato::test
