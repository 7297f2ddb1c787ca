#include <gtest/gtest.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

TEST(Convert, writes_the_curves_of_orzan_xml_as_svg) {
  const CommandResult result = run_sfumato({"convert", "-", "-o", "-"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(result.out.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"")) << result.out;
  EXPECT_TRUE(contains(result.out, "viewBox=\"0 0 64 48\""));
  EXPECT_TRUE(contains(result.out, "<g id=\"curves\" sf:diffuse=\"true\""));
  EXPECT_TRUE(contains(result.out, "d=\"M20 10 C34 10 34 38 20 38 6 38 6 10 20 10 Z\""));
  EXPECT_TRUE(contains(result.out, "sf:left=\"#1428c8 @0\"")) << result.out;
  EXPECT_TRUE(contains(result.out, "sf:right=\"#ff8000 @0\"")) << result.out;
  EXPECT_TRUE(result.out.ends_with("</svg>\n"));
}

TEST(Convert, writes_a_file_whole) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  const CommandResult result = run_sfumato({"convert", input, "-o", folder.path("out.SVG")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.SVG", "scene.xml"}));
  const CommandResult piped = run_sfumato({"convert", input, "-o", "-"});
  EXPECT_EQ(read_whole(folder.path("out.SVG")), piped.out);
}

TEST(Convert, packs_what_it_writes_as_svgz) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  const std::string plain = run_sfumato({"convert", input, "-o", "-"}).out;
  for (const char* name : {"out.svgz", "out.SVGZ"}) {
    const CommandResult result = run_sfumato({"convert", input, "-o", folder.path(name)});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string packed = read_whole(folder.path(name));
    EXPECT_TRUE(packed.starts_with("\x1f\x8b"));
    EXPECT_LT(packed.size(), plain.size());
    EXPECT_EQ(run_sfumato({"convert", folder.path(name), "-o", "-"}).out, plain);
  }
  EXPECT_EQ(read_whole(folder.path("out.svgz")), read_whole(folder.path("out.SVGZ")));
}

TEST(Convert, normalises_svg_and_writes_the_same_bytes_again) {
  const char* by_hand =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:d='urn:sfumato:1' viewBox='0 0 64 48' "
      "d:version='1'><g d:diffuse='true'>"
      "<path d='m 1,2 h 30' d:left='gold, red' d:right='rgb(0 128 255)'/></g></svg>";
  const CommandResult once = run_sfumato({"convert", "-", "-o", "-"}, by_hand);
  EXPECT_EQ(once.exit_code, 0) << once.err;
  EXPECT_TRUE(contains(once.out, "sf:left=\"#ffd700, #ff0000\" sf:right=\"#0080ff\"")) << once.out;
  const CommandResult twice = run_sfumato({"convert", "-", "-o", "-"}, once.out);
  EXPECT_EQ(twice.exit_code, 0) << twice.err;
  EXPECT_EQ(twice.out, once.out);
}

/// One drawing, whose XML names are written in several ways.
constexpr const char* kPlainNames = R"(<svg xmlns="http://www.w3.org/2000/svg"
  xmlns:sf="urn:sfumato:1" viewBox="0 0 64 48" sf:version="1">
  <g id="layer" sf:diffuse="true">
    <path id="a" d="M1 2h30" sf:left="gold, red 40%" sf:right="blue" sf:blur="3"/>
    <path id="b" d="M1 9h30" sf:left="lime" sf:opacity="0.5"/></g></svg>)";

constexpr const char* kTwoPrefixesOfOneAddress = R"(<svg xmlns="http://www.w3.org/2000/svg"
  xmlns:p="urn:sfumato:1" xmlns:q="urn:sfumato:1" xmlns:x="urn:x" xmlns:y="urn:x"
  viewBox="0 0 64 48" q:version="1" x:left="1" y:right="2">
  <x:note y:sf="3">text</x:note>
  <g id="layer" p:diffuse="true" x:diffuse="false">
    <path id="a" d="M1 2h30" p:left="gold, red 40%" q:right="blue" p:blur="3" y:blur="9"/>
    <path id="b" d="M1 9h30" q:left="lime" q:opacity="0.5"/><y:path d="M0 0h1"/></g></svg>)";

constexpr const char* kPrefixesThatAreBoundAgain = R"(<svg xmlns="http://www.w3.org/2000/svg"
  xmlns:sf="urn:other" xmlns:d="urn:sfumato:1" viewBox="0 0 64 48" d:version="1" sf:version="7">
  <g id="layer" d:diffuse="true" sf:difuse="no">
    <path id="a" d="M1 2h30" d:left="gold, red 40%" d:right="blue" d:blur="3" sf:left="pink"/>
    <path id="b" xmlns:sf="urn:sfumato:1" xmlns:d="urn:other" d="M1 9h30" sf:left="lime"
      sf:opacity="0.5" d:right="pink"/>
    <d:g xmlns:d="urn:other"><path d="M0 0h1"/></d:g></g></svg>)";

constexpr const char* kForeignDefault = R"(<s:svg xmlns="urn:other"
  xmlns:s="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 48"
  sf:version="1"><g sf:diffuse="true"><path d="M0 0h9" sf:left="pink"/></g>
  <s:g id="layer" sf:diffuse="true"><path d="M0 0h9" sf:left="pink"/>
    <s:path id="a" d="M1 2h30" sf:left="gold, red 40%" sf:right="blue" sf:blur="3"/>
    <path xmlns="http://www.w3.org/2000/svg" id="b" d="M1 9h30" sf:left="lime"
      sf:opacity="0.5"/></s:g></s:svg>)";

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t i = text.find(part); i != text.npos; i = text.find(part, i + 1)) ++found;
  return found;
}

TEST(Convert, keeps_what_is_of_sfumato_among_foreign_namespaces_and_nothing_else) {
  const std::string expected = run_sfumato({"convert", "-", "-o", "-"}, kPlainNames).out;
  ASSERT_EQ(count(expected, "<path"), 2u) << expected;
  // Every used prefix is declared once.
  EXPECT_EQ(count(expected, "xmlns=\"http://www.w3.org/2000/svg\""), 1u);
  EXPECT_EQ(count(expected, "xmlns:"), 1u);
  EXPECT_EQ(count(expected, "xmlns:sf=\"urn:sfumato:1\""), 1u);
  for (const char* drawing :
       {kTwoPrefixesOfOneAddress, kPrefixesThatAreBoundAgain, kForeignDefault}) {
    const CommandResult once = run_sfumato({"convert", "-", "-o", "-"}, drawing);
    EXPECT_EQ(once.exit_code, 0) << drawing << once.err;
    EXPECT_EQ(once.out, expected) << drawing;
    EXPECT_EQ(once.err, "") << drawing;
    const CommandResult twice = run_sfumato({"convert", "-", "-o", "-"}, once.out);
    EXPECT_EQ(twice.exit_code, 0) << twice.err;
    EXPECT_EQ(twice.out, once.out);
  }
}

TEST(Convert, gives_an_svg_that_renders_to_the_same_bytes) {
  const std::string svg = run_sfumato({"convert", "-", "-o", "-"}, two_curve_scene()).out;
  const CommandResult original = run_sfumato({"render", "-", "-o", "-"}, two_curve_scene());
  const CommandResult converted = run_sfumato({"render", "-", "-o", "-"}, svg);
  EXPECT_EQ(converted.exit_code, 0) << converted.err;
  EXPECT_EQ(original.out, converted.out);
}

TEST(Convert, gives_an_svg_of_the_public_lady_bug_that_renders_to_the_same_bytes) {
  const std::string path = shared_path("scenes/lady_bug.xml");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "the public scenes are not here: " << path;
  const CommandResult svg = run_sfumato({"convert", path, "-o", "-"});
  EXPECT_EQ(svg.exit_code, 0) << svg.err;
  const CommandResult original = run_sfumato({"render", path, "-o", "-"});
  const CommandResult converted = run_sfumato({"render", "-", "-o", "-"}, svg.out);
  EXPECT_EQ(converted.exit_code, 0) << converted.err;
  EXPECT_TRUE(original.out == converted.out);
}

TEST(Convert, tells_what_the_reader_overlooked) {
  const std::string scene = scene_xml(64, 48, "<banana/>");
  const CommandResult loud = run_sfumato({"convert", "-", "-o", "-"}, scene);
  EXPECT_TRUE(contains(loud.err, "<banana>")) << loud.err;
  EXPECT_EQ(run_sfumato({"convert", "--quiet", "-", "-o", "-"}, scene).err, "");
}

TEST(Convert, tells_what_is_drawn_nowhere_and_lost) {
  const std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 64 48' "
      "sf:version='1'>\n<g sf:diffuse='true'><path d='M1 2h30' sf:left='url(#used)'/></g>\n"
      "<defs>\n<g id='fish' sf:diffuse='true'/>\n<g id='bird' sf:diffuse='true'/>\n"
      "<linearGradient id='used' gradientUnits='userSpaceOnUse' href='#base' x2='9'/>\n"
      "<linearGradient id='base'><stop/></linearGradient>\n<pattern id='wood'/>\n</defs></svg>";
  const CommandResult result = run_sfumato({"convert", "-", "-o", "-"}, svg);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err,
            "<stdin>:4:1: warning: the layer #fish (and 1 more) is drawn nowhere; it is left out\n"
            "<stdin>:8:1: warning: the paint #wood is drawn nowhere; it is left out\n");
  EXPECT_EQ(run_sfumato({"convert", "-", "-o", "-"}, result.out).err, "");
  const std::string palette =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 64 48' "
      "xmlns:i='http://www.inkscape.org/namespaces/inkscape' sf:version='1'>"
      "<linearGradient id='red' i:swatch='solid'><stop/></linearGradient>"
      "<g sf:diffuse='true'><path d='M1 2h30' sf:left='red'/></g></svg>";
  EXPECT_EQ(run_sfumato({"convert", "-", "-o", "-"}, palette).err, "");
  const CommandResult nameless = run_sfumato(
      {"convert", "-", "-o", "-"},
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 64 48' "
      "sf:version='1'>\n<g sf:diffuse='true'><path d='M1 2h30' sf:left='red'/></g>\n"
      "<defs>\n<g sf:diffuse='true'/></defs></svg>");
  EXPECT_EQ(nameless.err,
            "<stdin>:4:1: warning: the layer without an id is drawn nowhere; it is left out\n");
}

TEST(Convert, fails_as_other_commands_do) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_sfumato({"convert", "-"}).exit_code, 2);
  const CommandResult png = run_sfumato({"convert", "-", "-o", folder.path("out.png")});
  EXPECT_EQ(png.exit_code, 2);
  EXPECT_TRUE(contains(png.err, "use a file name that ends in .svg, .svgz, or -")) << png.err;
  const std::string out = folder.path("out.svg");
  const CommandResult bad = run_sfumato({"convert", "-", "-o", out}, "<curve_set/>");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_TRUE(contains(bad.err, "<stdin>:1:")) << bad.err;
  EXPECT_EQ(run_sfumato({"convert", folder.path("none.xml"), "-o", out}).exit_code, 1);
  const std::string nowhere = folder.path("none/out.svg");
  EXPECT_EQ(run_sfumato({"convert", "-", "-o", nowhere}, two_curve_scene()).exit_code, 3);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace sfumato::test
