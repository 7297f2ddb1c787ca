#include <gtest/gtest.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

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

TEST(Convert, tells_what_the_reader_overlooked) {
  const std::string scene = scene_xml(64, 48, "<banana/>");
  const CommandResult loud = run_sfumato({"convert", "-", "-o", "-"}, scene);
  EXPECT_TRUE(contains(loud.err, "<banana>")) << loud.err;
  EXPECT_EQ(run_sfumato({"convert", "--quiet", "-", "-o", "-"}, scene).err, "");
}

TEST(Convert, fails_as_other_commands_do) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_sfumato({"convert", "-"}).exit_code, 2);
  const CommandResult png = run_sfumato({"convert", "-", "-o", folder.path("out.png")});
  EXPECT_EQ(png.exit_code, 2);
  EXPECT_TRUE(contains(png.err, "expected a file name that ends in .svg, or -")) << png.err;
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
