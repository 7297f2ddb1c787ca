// The kind of a file, from its first bytes.
#include "codecs/file_kind.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sfumato::test {
namespace {

using codecs::file_kind;
using codecs::FileKind;

TEST(FileKindOf, bytes_is_what_their_beginning_says) {
  EXPECT_EQ(file_kind("\x89PNG\r\n\x1a\n and so on"), FileKind::png);
  EXPECT_EQ(file_kind("\xff\xd8\xff\xe0"), FileKind::jpeg);
  EXPECT_EQ(file_kind("RIFF\x01\x01\x01\x01WEBPVP8L"), FileKind::webp);
  EXPECT_EQ(file_kind("RIFF\x01\x01\x01\x01WAVEfmt "), FileKind::unknown);
  EXPECT_EQ(file_kind("GIF89a"), FileKind::gif);
  EXPECT_EQ(file_kind({"\0\0\0<ftypavif", 12}), FileKind::heif);
  EXPECT_EQ(file_kind({"MM\0*", 4}), FileKind::tiff);
  EXPECT_EQ(file_kind("%PDF-1.4"), FileKind::pdf);
  EXPECT_EQ(file_kind("\x1f\x8b\x08"), FileKind::gzip);
  EXPECT_EQ(file_kind("PK\x03\x04"), FileKind::zip);
}

TEST(FileKindOf, xml_is_found_behind_blanks_and_marks) {
  for (const char* text :
       {"<svg/>", " \n<svg/>", "\xEF\xBB\xBF<svg/>", "<!--ftyp-->", "\xFF\xFE<"}) {
    EXPECT_EQ(file_kind(text), FileKind::xml) << text;
  }
  EXPECT_EQ(file_kind({"\0<\0s", 4}), FileKind::xml);
}

TEST(FileKindOf, few_bytes_and_other_text_is_unknown) {
  EXPECT_EQ(file_kind(""), FileKind::empty);
  for (const char* text : {"hello", "\x89PN", "RIFF", "G", "   "}) {
    EXPECT_EQ(file_kind(text), FileKind::unknown) << text;
  }
  EXPECT_EQ(codecs::kind_text(FileKind::unknown), "");
}

}  // namespace
}  // namespace sfumato::test
