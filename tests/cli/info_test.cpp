#include <gtest/gtest.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

/// Every command gives the same message for a file of the wrong kind.
TEST(OtherFiles, are_called_what_they_are) {
  const TemporaryFolder folder;
  const std::string jpeg = folder.add("a.jpg", "\xff\xd8\xff\xe0 <svg>");
  const auto error = [](std::vector<std::string> arguments) {
    const CommandResult result = run_sfumato(std::move(arguments));
    EXPECT_EQ(result.exit_code, 1);
    return result.err;
  };
  const std::string is_jpeg = jpeg + ": error: is a JPEG picture; use ";
  for (const char* command : {"info", "lint"}) {
    EXPECT_EQ(error({command, jpeg}),
              is_jpeg + "a drawing (SVG or Orzan XML), or trace the picture to make one\n");
  }
  EXPECT_TRUE(error({"render", jpeg, "-o", folder.path("o.png")}).starts_with(is_jpeg));
  EXPECT_TRUE(error({"init", folder.path("n.svg"), "--from", jpeg}).starts_with(is_jpeg));
  EXPECT_TRUE(error({"compare", jpeg, jpeg}).starts_with(is_jpeg + "a PNG"));
  EXPECT_TRUE(error({"tiles", jpeg, "-o", folder.path("t")}).starts_with(is_jpeg + "a solved"));
  const std::string gif = folder.add("a.gif", "GIF89a");
  EXPECT_TRUE(error({"trace", gif, "-o", folder.path("o.svg")})
                  .starts_with(gif + ": error: is a GIF picture; use a PNG"));
}

TEST(Info, prints_a_table) {
  const CommandResult result = run_sfumato({"info", "-"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "<stdin>\n"
            "  format                  Orzan XML\n"
            "  artboard                64 x 48\n"
            "  size                    64 x 48 px\n"
            "  background              none\n"
            "  interpolation           srgb\n"
            "  layers                  1 (1 instance)\n"
            "  groups                  0\n"
            "  curves                  2 (1 open, 1 closed)\n"
            "    of colour             2\n"
            "    of opacity            0\n"
            "    of both               0\n"
            "    barriers              0\n"
            "    of nothing            0\n"
            "    with blur             0\n"
            "    with a weight         0\n"
            "    leaving the artboard  0\n"
            "  local curves            0\n"
            "  Bezier pieces           4\n"
            "  control points          14\n"
            "  colour stops            4\n"
            "  opacity stops           0\n"
            "  gradients               0 (0 linear, 0 radial)\n"
            "  textures                0\n"
            "  warnings                0\n");
}

TEST(Info, prints_json) {
  const CommandResult result = run_sfumato({"info", "--json", "-"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            R"({"file":"<stdin>","format":"Orzan XML",)"
            R"("artboard":{"x":0,"y":0,"width":64,"height":48},"size_px":{"width":64,"height":48},)"
            R"("background":"none","interpolation":"srgb","layers":1,"instances":1,"groups":0,)"
            R"("curves":2,)"
            R"("open_curves":1,"closed_curves":1,"color_curves":2,"opacity_curves":0,)"
            R"("both_curves":0,"barrier_curves":0,"bare_curves":0,"blurred_curves":0,)"
            R"("weighted_curves":0,"leaving_curves":0,"local_curves":0,"bezier_pieces":4,)"
            R"("control_points":14,"color_stops":4,"opacity_stops":0,"linear_gradients":0,)"
            R"("radial_gradients":0,"textures":[],"warnings":0})"
            "\n");
}

TEST(Info, shows_what_an_svg_document_has) {
  const char* svg =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 64 48'"
      " sf:version='1' sf:interpolation='oklab'><defs>"
      "<linearGradient id='g'><stop/></linearGradient>"
      "<pattern id='t' patternUnits='userSpaceOnUse' width='1' height='1'><image href='"
      "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAAAXNSR0IArs4c6QAAAA1J"
      "REFUeAFiYGRi/g8AAAD//wiKEDUAAAAGSURBVAMAARQBBuWJk9MAAAAASUVORK5CYII='/></pattern></defs>"
      "<rect width='64' height='48' fill='#102030'/>"
      "<g opacity='.5'><g id='a' sf:diffuse='true'>"
      "<path d='M1 1h9v9z' sf:left='url(#g)' sf:right='url(#t)' sf:opacity='1' sf:blur='2'/>"
      "<path d='M20 1h9' sf:left='none' sf:weight='2'/><path d='M20 9h9' sf:left-opacity='0'/>"
      "</g><use href='#a' x='60'/></g>"
      "<path d='M1 30h9' sf:left='red' sf:radius='3'/></svg>";
  const CommandResult result = run_sfumato({"info", "-"}, svg);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* row :
       {"format                  SVG", "background              #102030",
        "interpolation           oklab", "layers                  1 (2 instances)",
        "groups                  1", "curves                  3 (2 open, 1 closed)",
        "  of both               1", "  of opacity            1", "  barriers              1",
        "  with blur             1", "  with a weight         1", "local curves            1",
        "gradients               1 (1 linear, 0 radial)", "textures                1 (1 x 1)"}) {
    EXPECT_NE(result.out.find(row), std::string::npos) << row << '\n' << result.out;
  }
}

TEST(Info, tells_warnings_on_stderr_and_counts_them) {
  const char* white = R"(R="255" G="255" B="255")";
  const std::string points =
      point_xml("1", "2") + point_xml("3", "4") + point_xml("5", "6") + point_xml("7", "8");
  const std::string scene =
      scene_xml(64, 48, curve_xml(points, white, white) + "<banana/>\n<cherry/>\n");
  const CommandResult loud = run_sfumato({"info", "--json", "-"}, scene);
  EXPECT_NE(loud.out.find("\"warnings\":2}"), std::string::npos) << loud.out;
  EXPECT_NE(loud.err.find("<banana>"), std::string::npos) << loud.err;
  EXPECT_EQ(run_sfumato({"info", "--quiet", "-"}, scene).err, "");
}

TEST(Info, counts_the_public_lady_bug) {
  const std::string path = shared_path("scenes/lady_bug.xml");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "the public scenes are not here: " << path;
  const CommandResult result = run_sfumato({"info", "--json", path});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find(R"("artboard":{"x":0,"y":0,"width":512,"height":512})"),
            std::string::npos);
  EXPECT_NE(result.out.find(R"("curves":71,)"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace sfumato::test
