#include <gtest/gtest.h>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

constexpr const char* kWhite = R"(R="255" G="255" B="255")";

std::string curve_through(std::initializer_list<const char*> coordinates) {
  std::string points;
  for (auto x = coordinates.begin(); x != coordinates.end(); x += 2) points += point_xml(*x, x[1]);
  return curve_xml(points, kWhite, kWhite);
}

/// Returns a sound curve, and two more in one place.
std::string doubled_scene() {
  const std::string sound = curve_through({"10", "10", "20", "30", "30", "10", "40", "20"});
  const std::string doubled = curve_through({"5", "40", "20", "44", "40", "36", "60", "40"});
  return scene_xml(64, 48, sound + doubled + doubled);
}

constexpr const char* kMessage =
    "it lies exactly on curve 1 and both have colour, so the later one hides the earlier; delete "
    "one";

TEST(Lint, says_that_there_are_no_hints) {
  const CommandResult result = run_sfumato({"lint", "--strict", "-"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "<stdin>: no hints\n");
}

TEST(Lint, lists_hints_with_their_place_and_kind) {
  const CommandResult result = run_sfumato({"lint", "-"}, doubled_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, std::string("<stdin>: hint: layer 0 \"curves\", curve 2: ") + kMessage +
                            " [duplicate]\n<stdin>: 1 hint\n");
  EXPECT_EQ(run_sfumato({"lint", "--strict", "-"}, doubled_scene()).exit_code, 1);
}

TEST(Lint, prints_json) {
  const CommandResult result = run_sfumato({"lint", "--json", "-"}, doubled_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, std::string(R"({"file":"<stdin>","hints":[{"kind":"duplicate",)") +
                            R"("severity":"hint","layer":0,"layer_id":"curves","curve":2,)" +
                            R"("curve_id":"","message":")" + kMessage + R"("}],"hint_count":1})" +
                            '\n');
}

TEST(Lint, names_points_in_json) {
  const CommandResult result = run_sfumato({"lint", "--json", "-"},
                                           R"(<svg xmlns="http://www.w3.org/2000/svg"
    xmlns:sf="urn:sfumato:1" viewBox="0 0 100 100" sf:version="1"><g sf:diffuse="true">
    <circle cx="50" cy="50" r="30" sf:left="gold" sf:right="red, lime"/></g></svg>)");
  EXPECT_NE(result.out.find(R"("side":"right","at":[80,50],"message":)"), std::string::npos)
      << result.out;
}

TEST(Lint, tells_notes_only_where_they_are_asked_for) {
  const CommandResult result =
      run_sfumato({"lint", "--strict", "--verbose", "-"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out,
            "<stdin>: note: layer 0 \"curves\", curve 0: it is closed and clockwise: its inside is "
            "on the right [closed-loop]\n<stdin>: no hints\n");
}

TEST(Lint, takes_many_files) {
  const TemporaryFolder folder;
  const std::string sound = folder.add("sound.xml", two_curve_scene());
  const std::string doubled = folder.add("doubled.xml", doubled_scene());
  const std::string missing = folder.path("missing.xml");
  const CommandResult result = run_sfumato({"lint", sound, missing, doubled});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, sound + ": no hints\n" + doubled + ": hint: layer 0 \"curves\", curve 2: " +
                            kMessage + " [duplicate]\n" + doubled + ": 1 hint\n");
  EXPECT_NE(result.err.find("missing.xml: error: "), std::string::npos) << result.err;
}

TEST(Lint, fails_on_what_cannot_be_read) {
  EXPECT_EQ(run_sfumato({"lint"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"lint", "-"}, "<curve_set/>").exit_code, 1);
}

}  // namespace
}  // namespace sfumato::test
