// Byte order marks, UTF-16 and UTF-32, bytes that are not UTF-8, zeros.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

const std::string kMark = "\xEF\xBB\xBF";

std::string with_zeros(std::string text, char mark) {
  for (char& c : text) c = c == mark ? '\0' : c;
  return text;
}

void add_marks(Family& family) {
  const std::string good = svg(kLayer);
  family.add("mark", kDone, "", kMark + good);
  family.add("two_marks", kDone, "", kMark + kMark + good);
  family.add("only_a_mark", kBadInput, "in.svg: error: no XML element found", kMark);
  family.add("half_a_mark", kDone, "", "\xEF\xBB" + good);
  family.add("utf16_little", kDone, "", utf16(good, false));
  family.add("utf16_big", kDone, "", utf16(good, true));
  family.add("utf16_that_says_utf8", kDone, "",
             utf16("<?xml version='1.0' encoding='UTF-8'?>" + good, false));
  family.add("utf16_cut_in_a_unit", kBadInput, "in.svg",
             utf16(good, false).substr(0, good.size() + 1));
  family.add("utf16_only_a_mark", kBadInput, "in.svg", "\xFF\xFE");
  family.add("utf16_half_surrogates", kDone, "", [good] {
    std::string text = utf16(good, false);
    const std::string lone = "\x3D\xD8";
    const std::size_t end = text.size() - 2 * std::string("</svg>\n").size();
    return text.substr(0, end) + repeated(lone, 999) + text.substr(end);
  });
  family.add("utf16_mark_before_utf8", kBadInput, "in.svg", "\xFF\xFE" + good);
  family.add("utf16_of_16_mib", kDone, "",
             [] { return utf16(svg(std::string(8 << 20, ' ') + kLayer), false); });
  family.add("utf32_mark", kBadInput, "in.svg", std::string("\xFF\xFE\0\0", 4) + good);
  family.add("declared_utf16", kDone, "", "<?xml version='1.0' encoding='UTF-16'?>" + good);
  family.add("declared_ebcdic", kDone, "", "<?xml version='1.0' encoding='IBM037'?>" + good);
  family.add("declared_latin1", kDone, "",
             "<?xml version='1.0' encoding='ISO-8859-1'?>" + svg("<g id='\xE4'/>" + kLayer));
  family.add("declared_nonsense", kDone, "",
             "<?xml version='1.0' encoding='" + repeated("x", 99'999) + "'?>" + good);
  family.add("ebcdic", kBadInput, "in.svg", "\x4C\xA2\xA5\x87\x61\x6E");
}

void add_invalid(Family& family) {
  const struct {
    const char* name;
    std::string bytes;
  } kinds[] = {{"lone_continuation", "\x80"},
               {"overlong_slash", "\xC0\xAF"},
               {"overlong_zero", "\xC0\x80"},
               {"surrogate", "\xED\xA0\x80"},
               {"beyond_unicode", "\xF4\x90\x80\x80"},
               {"byte_fe", "\xFE"},
               {"byte_ff", "\xFF"},
               {"cut_sequence", "\xE2\x82"},
               {"five_bytes", "\xF8\x88\x80\x80\x80"}};
  for (const auto& [name, bytes] : kinds) {
    const std::string label = name;
    family.add(label + "_in_text", kDone, "", svg(bytes + kLayer));
    family.add(label + "_in_an_id", kDone, "", svg("<g id='" + bytes + "'/>" + kLayer));
    family.add(label + "_in_a_colour", kBadInput, "sf:left of <path>",
               curve("sf:left='" + bytes + "'"));
    family.add(label + "_in_a_path", kBadInput, "d of <path>", path("M0 0" + bytes));
    family.add(label + "_in_a_name", kDone, "is not read; such elements are ignored",
               svg("<" + bytes + "/>" + kLayer));
  }
  family
      .add("bytes_in_an_id_written_back", kDone, "",
           svg("<g sf:diffuse='true' id='\xFF\xFE\x80'><path id='\xC0' d='M9 9h9' "
               "sf:left='red'/></g>"))
      .run({"convert", "in.svg", "-o", "out.svg"});
}

void add_zeros(Family& family) {
  const std::string good = svg(kLayer);
  family.add("only_zeros", kBadInput, "in.svg", std::string(9999, '\0'));
  family.add("zero_first", kBadInput, "in.svg", std::string(1, '\0') + good);
  family.add("zero_last", kDone, "", good + std::string(1, '\0'));
  family.add("zero_in_text", kBadInput, "in.svg", with_zeros(svg("~" + kLayer), '~'));
  family.add("zero_in_a_name", kBadInput, "in.svg", with_zeros(svg("<a~b/>" + kLayer), '~'));
  family.add("zero_in_an_attribute", kBadInput, "in.svg", with_zeros(curve("sf:left='re~d'"), '~'));
  family.add("zero_as_a_reference", kDone, "", svg("<g id='a&#0;b'/>" + kLayer));
  family.add("control_characters_in_text", kDone, "", svg("\x01\x02\x1b[2J\x7f" + kLayer));
  family.add("control_characters_in_a_message", kBadInput, "sf:left of <path>",
             curve("sf:left='\x1b]0;x\x07'"));
  family.add("line_ends_in_a_message", kBadInput, "sf:left of <path>",
             curve("sf:left='a&#10;in.svg:1:1: error: b'"));
  family.add("right_to_left_mark_in_a_message", kBadInput, "sf:left of <path>",
             curve("sf:left='\xE2\x80\xAE"
                   "der'"));
}

void add_encodings_cases(Family& family) {
  add_marks(family);
  add_invalid(family);
  add_zeros(family);
}

const Register kEncodings("encodings", add_encodings_cases);

}  // namespace
}  // namespace sfumato::hostile
