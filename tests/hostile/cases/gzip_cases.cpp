// Gzipped documents that unpack to too much, to nothing, or not at all.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string header(unsigned char flags) {
  std::string bytes = "\x1f\x8b\x08";
  bytes += static_cast<char>(flags);
  return bytes + std::string(4, '\0') + "\x02\x03";
}

void add_gzip_bombs(Family& family) {
  family.add("bomb_of_blanks_2_gib", kLimit, "unpacks to more than the limit of 67108864 bytes",
             [] { return gzip_of_byte(' ', std::size_t{2} << 30); });
  family.add("bomb_of_zeros_100_mib", kLimit, "bytes of each packed byte",
             [] { return gzip_of_byte('\0', 100 << 20); });
  family.add("bomb_within_the_limit", kLimit, "bytes of each packed byte",
             [] { return gzip_of_byte(' ', 63 << 20); });
  family.add("bomb_of_brackets", kLimit, "bytes of each packed byte",
             [] { return gzip_of_byte('<', 63 << 20); });
  family.add("bomb_of_equal_signs", kLimit, "bytes of each packed byte",
             [] { return gzip(svg(std::string(60 << 20, '=') + kLayer)); });
  family.add("bomb_of_elements", kLimit, "more than the limit of",
             [] { return gzip(svg(repeated("<g/>", 9'000'000))); });
  family.add("bomb_in_a_bomb", kBadInput, "in.svg",
             [] { return gzip(gzip_of_byte(' ', std::size_t{1} << 30)); });
  family.add("bomb_of_nesting", kLimit, "bytes of each packed byte",
             [] { return gzip(svg(repeated("<g>", kMillion) + repeated("</g>", kMillion))); });
  family.add("bomb_from_standard_input", kLimit, "bytes of each packed byte", "")
      .run({"info", "-"})
      .input = gzip_of_byte(' ', 80 << 20);
}

void add_damaged(Family& family) {
  const std::string good = gzip(svg(kLayer + "<!--" + numbered("", 2000, ",") + "-->"));
  family.add("whole", kDone, "", good);
  for (std::size_t i = 2; i < good.size(); i += good.size() / 16) {
    family.add("cut_at_" + std::to_string(i), kBadInput, "the gzip data are cut short",
               good.substr(0, i));
  }
  family.add("cut_before_the_checksum", kBadInput, "the gzip data are cut short",
             good.substr(0, good.size() - 8));
  const auto changed = [&good](std::size_t at) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    return bytes;
  };
  family.add("checksum_is_wrong", kBadInput, "the gzip data are damaged", changed(good.size() - 8));
  family.add("length_is_wrong", kBadInput, "the gzip data are damaged", changed(good.size() - 2));
  family.add("method_is_unknown", kBadInput, "the gzip data are damaged", changed(2));
  family.add("flags_are_reserved", kBadInput, "the gzip data are damaged", header(0xE0) + "xyz");
  family.add("middle_is_changed", kBadInput, "the gzip data are damaged", changed(good.size() / 2));
  family.add("only_the_signature", kBadInput, "the gzip data are cut short", "\x1f\x8b");
  family.add("only_the_header", kBadInput, "the gzip data are cut short", header(0));
  family.add("name_without_end", kBadInput, "the gzip data are cut short",
             header(8) + repeated("a", kMillion));
  family.add("extra_field_that_lies", kBadInput, "the gzip data are cut short",
             header(4) + "\xff\xff");
  family.add("nothing_packed", kBadInput, "the file is empty", gzip(""));
  family.add("one_blank", kBadInput, "no XML element found", gzip(" "));
  family.add("blocks_of_nothing", kBadInput, "in.svg", [] {
    // A million empty stored blocks.
    return header(0) + repeated(std::string("\0\0\0\xff\xff", 5), kMillion);
  });
}

void add_joined(Family& family) {
  const std::string text = svg(kLayer);
  family.add("bytes_behind", kDone, "", gzip(text) + "and more");
  family.add("zeros_behind", kDone, "", gzip(text) + std::string(9999, '\0'));
  family.add("packed_twice", kBadInput, "in.svg", gzip(gzip(text)));
  family.add("two_members", kDone, "", gzip(text.substr(0, 80)) + gzip(text.substr(80)));
  family.add("an_empty_member_first", kDone, "", gzip("") + gzip(text));
  family.add("empty_members_100000", kBadInput, "the file is empty",
             [] { return repeated(gzip(""), 100'000); });
  family.add("members_of_one_byte", kDone, "", [text] {
    std::string packed;
    for (const char c : text) packed += gzip(std::string(1, c));
    return packed;
  });
  family.add("second_member_cut", kBadInput, "the gzip data are cut short",
             gzip(text.substr(0, 80)) + gzip(text.substr(80)).substr(0, 40));
  family.add("second_member_is_a_bomb", kLimit, "bytes of each packed byte",
             [text] { return gzip(text) + gzip_of_byte(' ', 100 << 20); });
  family.add("documents_side_by_side", kDone, "", gzip(text) + gzip(text));
}

void add_gzip_cases(Family& family) {
  add_gzip_bombs(family);
  add_damaged(family);
  add_joined(family);
}

const Register kGzip("gzip", add_gzip_cases);

}  // namespace
}  // namespace sfumato::hostile
