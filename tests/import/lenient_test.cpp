// Mistakes of an ordinary SVG that do not cause a refusal.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "formats/each_text.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

std::string drawing(const std::string& content,
                    const std::string& attributes = "viewBox=\"0 0 100 100\"") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:sf=\"urn:sfumato:1\" " +
         attributes + ">\n" + content + "\n</svg>";
}

ImportedSvg import_text(const std::string& text, const Limits& limits = {}) {
  Context context{.limits = limits};
  Result<ImportedSvg> made = import_svg(context, text, "a.svg");
  EXPECT_TRUE(made) << (made ? "" : to_string(made.status())) << "\n" << text;
  return made ? std::move(*made) : ImportedSvg{};
}

const std::string kDot = "<circle id='dot' cx='50' cy='50' r='20' fill='#f00'/>";

/// Returns the ids of the curves, in the order of the layers.
std::string ids_of(const ImportedSvg& made) {
  std::string ids;
  for (const Layer& layer : made.document.layers) {
    for (const Curve& curve : layer.curves) ids += curve.id + ' ';
  }
  return ids;
}

/// Returns the ids, then the first warning, of a drawing that begins with an element on line 2.
std::string read_beside(const std::string& element) {
  const ImportedSvg made = import_text(drawing(element + "\n" + kDot));
  const std::string warning = made.warnings.empty() ? "no warning" : to_string(made.warnings[0]);
  return ids_of(made) + warning;
}

TEST(LenientImport, a_mistake_costs_the_element_and_a_warning_says_where) {
  const std::initializer_list<std::string> elements{
      "<rect width='-5' height='9'/>",
      "<rect width='9' height='9' x='2parsec'/>",
      "<rect width='9' height='nine'/>",
      "<circle r='-1'/>",
      "<use href='#nothing'/>",
      "<use href='other.svg#a'/>",
      "<use href='https://example.org/a.svg#a'/>",
      "<use/>",
      "<use href='#dot' x='far'/>",
      "<g id='loop'><use href='#loop'/></g>",
      "<svg viewBox='0 0 1'><rect width='9' height='9'/></svg>",
      "<svg viewBox='0 0 9 9' width='wide'><rect width='9' height='9'/></svg>",
      "<g transform='scale(1e7) scale(1e7)'><rect width='9' height='9'/></g>"};
  for (const std::string& element : elements) {
    const std::string read = read_beside(element);
    EXPECT_EQ(read.substr(0, 12), "dot a.svg:2:") << element << " → " << read;
    EXPECT_NE(read.find("is left out: "), std::string::npos) << element << " → " << read;
  }
}

TEST(LenientImport, a_transform_that_cannot_be_read_is_ignored) {
  for (const char* transform : {"translate(NaN NaN)", "rotate(1", "scale()", "matrix(1 0 0 1)"}) {
    const ImportedSvg made =
        import_text(drawing("<g transform='" + std::string(transform) + "'>" + kDot + "</g>"));
    ASSERT_EQ(ids_of(made), "dot ") << transform;
    EXPECT_EQ(made.document.layers[0].curves[0].control_points[0], (Vec2{70, 50}));
    ASSERT_EQ(made.warnings.size(), 1u);
    EXPECT_EQ(to_string(made.warnings[0]).substr(0, 29), "a.svg:2:1: transform of <g>: ");
  }
}

TEST(LenientImport, other_values_that_cannot_be_read_are_ignored) {
  EXPECT_EQ(read_beside("<g opacity='much'><circle id='a' r='5'/></g>"),
            "a dot a.svg:2:1: opacity of <g> is \"much\"; use a number from 0 to 1 or a "
            "percentage; it is ignored");
  EXPECT_EQ(read_beside("<svg viewBox='0 0 50 50' width='auto'><circle id='a' r='5'/></svg>")
                .substr(0, 6),
            "a dot ");
}

TEST(LenientImport, each_kind_of_mistake_is_told_once) {
  const ImportedSvg made = import_text(drawing(
      "<use href='#a'/><use href='#b'/><rect width='-1' height='1'/><rect width='-2' height='1'/>"
      "<rect height='1' width='1' x='1e9'/>"));
  EXPECT_EQ(made.warnings.size(), 3u);
}

TEST(LenientImport, what_reaches_beyond_the_coordinates_is_left_out) {
  const std::initializer_list<std::string> elements{
      "<rect x='1e7' width='20' height='20'/>",
      "<g transform='translate(9e6)'><circle cx='9e6' r='5'/></g>",
      "<path d='M1e7 0v9' stroke='red' stroke-width='9'/>"};
  for (const std::string& element : elements) {
    const std::string read = read_beside(element);
    EXPECT_EQ(read.substr(0, 12), "dot a.svg:2:") << element << " → " << read;
    EXPECT_NE(read.find("farther than 10000000 from the origin"), std::string::npos) << read;
  }
}

TEST(LenientImport, content_of_sfumato_is_not_forgiven) {
  const std::initializer_list<std::string> contents{
      "<g sf:diffuse='true' transform='scale(x)'><path d='M0 0h9' sf:left='red'/></g>",
      "<g sf:diffuse='true'><path d='M0 0h' sf:left='red'/></g>",
      "<g sf:diffuse='true'><path d='M0 0h9' sf:left='nothing'/></g>",
      "<path d='M0 0h9' sf:radius='3' sf:left='red' transform='skew(1)'/>",
      "<g sf:diffuse='maybe'/>",
      "<g sf:no='1'/>"};
  for (const std::string& content : contents) {
    Context context;
    const Result<ImportedSvg> made = import_svg(context, drawing(content), "a.svg");
    ASSERT_FALSE(made) << content;
    EXPECT_EQ(made.status().code, StatusCode::bad_input) << content;
  }
}

TEST(LenientImport, a_switch_draws_its_first_child_that_can_be_drawn) {
  const auto chosen = [](const std::string& children) {
    return ids_of(import_text(drawing("<switch>" + children + "</switch>")));
  };
  const std::string a = "<circle id='a' r='5'/>", b = "<circle id='b' r='6'/>";
  EXPECT_EQ(chosen(a + b), "a ");
  EXPECT_EQ(chosen("<!-- --> <foreignObject requiredExtensions='x'/>" + a + b), "a ");
  EXPECT_EQ(chosen("<foreignObject width='9' height='9'/>" + a + b), "a ");
  EXPECT_EQ(chosen("<unknown/><title>t</title>" + a + b), "a ");
  EXPECT_EQ(chosen("<g requiredExtensions='http://x/'>" + a + "</g><g>" + b + a + "</g>"), "b a ");
  EXPECT_EQ(chosen("<g requiredFeatures='http://x/'>" + a + "</g>" + b), "a ");
  EXPECT_EQ(chosen("<g display='none'>" + a + "</g>" + b), "");
  EXPECT_EQ(chosen("<switch><g systemLanguage='de'/></switch>" + a), "");
  EXPECT_EQ(chosen(""), "");
}

TEST(LenientImport, a_switch_passes_over_what_is_never_drawn) {
  for (const std::string first : {"<desc>d</desc>", "<title>t</title>", "<metadata/>", "<defs/>",
                                  "<style/>", "<symbol/>", "<desc/><title/><metadata/>"}) {
    const ImportedSvg made =
        import_text(drawing("<switch>" + first + "<circle id='a' r='5'/></switch>"));
    EXPECT_EQ(ids_of(made), "a ") << first;
    EXPECT_TRUE(made.warnings.empty()) << first;
  }
}

TEST(LenientImport, a_use_of_what_is_around_it_draws_nothing) {
  const std::string a = "<circle id='a' r='5'/>";
  EXPECT_EQ(ids_of(import_text(drawing("<g id='g'><use href='#g'/>" + a + "</g>"))), "a ");
  EXPECT_EQ(ids_of(import_text(drawing("<g id='g'><use href='#h'/>" + a +
                                       "</g><defs><g id='h'><use href='#g'/></g></defs>"))),
            "a ");
}

TEST(LenientImport, an_svg_for_others_is_empty_with_a_warning) {
  const ImportedSvg made =
      import_text(drawing("<circle r='5'/>", "viewBox='0 0 9 9' systemLanguage='de'"));
  EXPECT_EQ(ids_of(made), "");
  EXPECT_EQ(made.warnings.size(), 1u);
}

TEST(LenientImport, a_switch_is_a_group) {
  const ImportedSvg made = import_text(
      drawing("<switch fill='#00f' transform='translate(9)'><circle id='a' r='5'/></switch>"));
  ASSERT_EQ(ids_of(made), "a ");
  EXPECT_EQ(made.document.layers[0].curves[0].control_points[0], (Vec2{14, 0}));
}

TEST(LenientImport, languages_are_chosen_for_readers_of_english) {
  const auto is_drawn = [](const std::string& languages) -> std::string {
    const std::string circle = "<circle id='a' r='5' systemLanguage='" + languages + "'/>";
    const std::string alone = ids_of(import_text(drawing(circle)));
    EXPECT_EQ(ids_of(import_text(drawing("<switch>" + circle + "</switch>"))), alone);
    return alone.empty() ? "no" : "yes";
  };
  test::expect_of_each({"en", "EN", "en-GB", "de, en", "de,en-US,fr", " en "}, is_drawn, "yes");
  test::expect_of_each({"", "de", "eng", "enx-GB", "de en", "e", ",", "ru-en"}, is_drawn, "no");
}

Box artboard_of(const std::string& attributes, const std::string& content) {
  return import_text(drawing(content, attributes)).document.artboard;
}

TEST(LenientImport, a_picture_without_a_size_is_the_box_of_its_shapes) {
  const std::string rect = "<path d='M10 20h80v60h-80z'/>";
  const Box box{{10, 20}, {90, 80}};
  for (const char* size : {"", "width='100%' height='100%'", "width='0' height='-5'",
                           "width='auto'", "viewBox='0 0 0 0'", "viewBox='nothing'"}) {
    EXPECT_EQ(artboard_of(size, rect), box) << size;
  }
  EXPECT_EQ(artboard_of("width='200'", rect), (Box{{0, 20}, {200, 80}}));
  EXPECT_EQ(artboard_of("height='200' width='50%'", rect), (Box{{10, 0}, {90, 200}}));
  EXPECT_EQ(artboard_of("width='30' height='40'", rect), (Box{{0, 0}, {30, 40}}));
  EXPECT_EQ(artboard_of("", ""), (Box{{0, 0}, {300, 150}}));
}

TEST(LenientImport, the_box_of_the_shapes_holds_strokes_and_what_covers_others) {
  EXPECT_EQ(artboard_of("", "<path d='M10 10h80' stroke='red' stroke-width='20'/>"),
            (Box{{10, 0}, {90, 20}}));
  EXPECT_EQ(artboard_of("", "<g transform='translate(5 6)'><circle cx='50' cy='40' r='30'/></g>"),
            (Box{{25, 16}, {85, 76}}));
  EXPECT_EQ(artboard_of("", "<rect width='400' height='300' fill='#fff'/>" + kDot),
            (Box{{0, 0}, {400, 300}}));
  EXPECT_EQ(artboard_of("", "<rect width='100%' height='100%' fill='#fff'/>" + kDot),
            (Box{{0, 0}, {300, 150}}));
  EXPECT_EQ(artboard_of("", "<rect x='1e7' width='9' height='9'/>" + kDot),
            (Box{{30, 30}, {70, 70}}));
}

}  // namespace
}  // namespace sfumato
