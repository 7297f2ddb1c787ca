// The kind of a file, from its root element; gzip.
#include "sfumato/formats/read_document.hpp"

#include <gtest/gtest.h>

#include "formats/svg/svg_support.hpp"
#include "sfumato/base/limits.hpp"
#include "support/gzip.hpp"

namespace sfumato::test {
namespace {

const std::string kCurveSet = "<curve_set image_width='3' image_height='2'/>";

Result<ReadDocument> read_any(const std::string& bytes) {
  Context context;
  Result<ReadDocument> result = read_document(context, bytes, "a");
  EXPECT_EQ(context.budget.used(), 0u);
  return result;
}

std::string message_of(const std::string& bytes) {
  return to_string(read_any(bytes).status());
}

TEST(ReadDocument, root_element_tells_the_format) {
  EXPECT_EQ(read_any(svg(""))->format, DocumentFormat::svg);
  EXPECT_EQ(read_any(kCurveSet)->format, DocumentFormat::orzan);
  EXPECT_EQ(read_any("<scene image_width='3' image_height='2'/>")->format, DocumentFormat::orzan);
}

TEST(ReadDocument, what_stands_before_the_root_is_passed) {
  const std::string before =
      "\xEF\xBB\xBF<?xml version='1.0'?>\n<!-- <curve_set> -->\n<!DOCTYPE svg [<!ENTITY a '>'> "
      "]>\n";
  EXPECT_TRUE(read_any(before + svg("")).ok()) << message_of(before + svg(""));
  EXPECT_TRUE(read_any("<!DOCTYPE CurveSetXML>\n" + kCurveSet).ok());
  EXPECT_TRUE(read_any("<svg:svg xmlns:svg='http://www.w3.org/2000/svg' viewBox='0 0 9 9'/>").ok());
}

TEST(ReadDocument, other_documents_are_refused_with_their_place) {
  EXPECT_EQ(message_of("\n <html></html>"),
            "a:2:2: the document is a <html>; use <svg>, or Orzan's <curve_set> or <scene>");
  EXPECT_EQ(message_of("<!-- <html> -->\n<x:html xmlns:x='urn:x'/>"),
            "a:2:1: the document is a <html>; use <svg>, or Orzan's <curve_set> or <scene>");
  EXPECT_EQ(message_of("text\n<html/>"),
            "a:2:1: the document is a <html>; use <svg>, or Orzan's <curve_set> or <scene>");
  EXPECT_EQ(message_of(""), "a: the file is empty; use an SVG or Orzan XML file");
  EXPECT_EQ(message_of("hello"), "a: no XML element found; use an SVG or Orzan XML file");
  EXPECT_EQ(message_of("<!-- <svg>"), "a:1:10: the XML is cut short: Error parsing comment");
}

TEST(ReadDocument, text_in_utf16_is_read) {
  std::string wide = "\xFF\xFE";
  for (const char c : svg("")) {
    wide += c;
    wide += '\0';
  }
  EXPECT_TRUE(read_any(wide).ok()) << message_of(wide);
}

TEST(ReadDocument, gzip_is_unpacked) {
  EXPECT_EQ(read_any(gzipped(svg("")))->format, DocumentFormat::svg);
  EXPECT_EQ(read_any(gzipped(kCurveSet))->format, DocumentFormat::orzan);
  EXPECT_EQ(message_of(gzipped("<html/>")),
            "a:1:1: the document is a <html>; use <svg>, or Orzan's <curve_set> or <scene>");
}

TEST(ReadDocument, damaged_gzip_is_refused) {
  const std::string packed = gzipped(svg(""));
  EXPECT_EQ(message_of(packed.substr(0, packed.size() / 2)), "a: the gzip data are cut short");
  EXPECT_EQ(message_of(packed.substr(0, 2)), "a: the gzip data are cut short");
  std::string changed = packed;
  changed[packed.size() - 6] ^= 1;
  EXPECT_EQ(message_of(changed), "a: the gzip data are damaged");
  EXPECT_EQ(message_of("\x1f\x8bhello, this is no gzip"), "a: the gzip data are damaged");
}

/// Returns the message of reading with another limit; empty if it can be read.
std::string message_with(const std::string& bytes, std::size_t Limits::*limit, std::size_t value) {
  Context context;
  context.limits.*limit = value;
  const Result<ReadDocument> read = read_document(context, bytes, "a");
  EXPECT_EQ(context.budget.used(), 0u);
  return read ? std::string() : to_string(read.status());
}

TEST(ReadDocument, gzip_bomb_is_refused) {
  const std::string bomb = gzipped(std::string(limits::kInputBytes + 1, ' '));
  EXPECT_LT(bomb.size(), 100'000u);
  EXPECT_EQ(read_any(bomb).status().code, StatusCode::limit);
  const std::size_t most = limits::kUnpackRatio * bomb.size() + limits::kUnpackedSlack;
  EXPECT_EQ(message_of(bomb),
            "a: unpacks to " + std::to_string(most) +
                " bytes and more: more than the limit of 200 bytes of each packed byte");
  EXPECT_EQ(message_with(bomb, &Limits::unpack_ratio, 1032),
            "a: unpacks to more than the limit of 67108864 bytes");
}

TEST(ReadDocument, unpacked_gzip_takes_its_room_from_the_budget) {
  const std::string packed = gzipped(std::string(1'000'000, ' '));
  Context context{.budget = Budget(1'000'000)};
  const Status status = read_document(context, packed, "a").status();
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_NE(status.message.find("unpacked gzip"), std::string::npos) << status.message;
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(ReadDocument, gzip_up_to_the_limits_is_read) {
  const std::string largest = gzipped(svg("") + std::string(limits::kInputBytes - 200, ' '));
  EXPECT_EQ(message_with(largest, &Limits::unpack_ratio, 1032), "");
  const std::string small = gzipped(svg("") + std::string(limits::kUnpackedSlack, ' '));
  EXPECT_LT(small.size() * 500, limits::kUnpackedSlack);
  EXPECT_EQ(message_of(small), "");
}

TEST(ReadDocument, a_lower_limit_of_bytes_is_kept) {
  const std::string text = svg("") + std::string(1000, ' ');
  for (const std::string& bytes : {text, gzipped(text)}) {
    EXPECT_EQ(message_with(bytes, &Limits::input_bytes, text.size()), "");
    EXPECT_NE(message_with(bytes, &Limits::input_bytes, text.size() - 1), "");
  }
}

TEST(ReadDocument, attributes_of_one_element_are_limited) {
  const auto with_attributes = [](std::size_t count) {
    std::string attributes;
    for (std::size_t i = 0; i < count; ++i) attributes += " a" + std::to_string(i) + "='1'";
    return svg("<desc" + attributes + "/>");
  };
  EXPECT_EQ(message_of(with_attributes(limits::kXmlAttributes)), "");
  EXPECT_EQ(read_any(with_attributes(limits::kXmlAttributes + 1)).status().code, StatusCode::limit);
}

}  // namespace
}  // namespace sfumato::test
