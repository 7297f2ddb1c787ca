#include <gtest/gtest.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

TEST(Info, prints_a_table) {
  const CommandResult result = run_sfumato({"info", "-"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "<stdin>\n"
            "  format                  Orzan XML\n"
            "  artboard                64 x 48\n"
            "  layers                  1\n"
            "  curves                  2 (1 open, 1 closed)\n"
            "  Bezier pieces           4\n"
            "  control points          14\n"
            "  colour stops            4\n"
            "  curves with blur        0\n"
            "  leaving the artboard    0\n"
            "  warnings                0\n");
}

TEST(Info, prints_json) {
  const CommandResult result = run_sfumato({"info", "--json", "-"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            R"({"file":"<stdin>","format":"Orzan XML",)"
            R"("artboard":{"x":0,"y":0,"width":64,"height":48},"layers":1,"curves":2,)"
            R"("open_curves":1,"closed_curves":1,"bezier_pieces":4,"control_points":14,)"
            R"("color_stops":4,"blurred_curves":0,"leaving_curves":0,"warnings":0})"
            "\n");
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
  const std::string path = SFUMATO_SHARED_DIR "/scenes/lady_bug.xml";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "the public scenes are not here: " << path;
  const CommandResult result = run_sfumato({"info", "--json", path});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find(R"("artboard":{"x":0,"y":0,"width":512,"height":512})"),
            std::string::npos);
  EXPECT_NE(result.out.find(R"("curves":71,)"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace sfumato::test
