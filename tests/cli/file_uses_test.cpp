// A call never writes a file that it also reads, or the same file twice, whatever names the file
// has.
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

constexpr const char* kTextured = R"svg(
<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 8 8"><defs>
  <pattern id="t" width="1" height="1"><image href="tile.png" width="1" height="1"/></pattern>
</defs><g sf:diffuse="true"><path d="M0 0L8 8" sf:left="url(#t)"/></g></svg>)svg";

class FileUses : public testing::Test {
 protected:
  /// Expects bad usage that names `option`, and no change.
  void expect_refused(Names arguments, const std::string& option) {
    const CommandResult result = run_sfumato(std::move(arguments));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_NE(result.err.find(option + ": "), std::string::npos) << result.err;
    expect_unchanged();
  }
  void expect_unchanged() {
    EXPECT_EQ(read_whole(drawing_), two_curve_scene());
    EXPECT_EQ(read_whole(other_), two_curve_scene());
  }
  std::string path(const std::string& name) const { return folder_.path(name); }
  std::string link(const std::string& target, const std::string& name) const {
    fs::create_symlink(target, path(name));
    return path(name);
  }

  const TemporaryFolder folder_;
  const std::string drawing_ = folder_.add("in.xml", two_curve_scene());
  const std::string other_ = folder_.add("other.svg", two_curve_scene());
};

TEST_F(FileUses, stats_never_replace_a_drawing) {
  fs::create_directory(path("sub"));
  fs::create_hard_link(drawing_, path("hard"));
  for (const std::string& stats : {drawing_, path("sub/../in.xml"), path("./in.xml"), path("hard"),
                                   link(drawing_, "soft"), link("soft", "soft_to_soft")}) {
    expect_refused({"render", drawing_, "-o", path("a.png"), "--stats", stats}, "--stats");
    EXPECT_FALSE(fs::exists(path("a.png")));
  }
  expect_refused({"render", drawing_, other_, "--out-dir", path("o"), "--stats", other_},
                 "--stats");
}

TEST_F(FileUses, stats_never_replace_the_picture) {
  fs::create_directory(path("sub"));
  const std::string picture = path("a.png");
  // None of these files exists yet.
  for (const std::string& stats :
       {picture, path("./a.png"), path("sub/../a.png"), path("sub//../a.png"),
        link("a.png", "soft"), link(path("sub/../soft"), "longer")}) {
    expect_refused({"render", drawing_, "-o", picture, "--stats", stats}, "--stats");
    EXPECT_FALSE(fs::exists(picture));
  }
  ASSERT_EQ(run_sfumato({"render", drawing_, "-o", picture}).exit_code, 0);
  const std::string before = read_whole(picture);
  expect_refused({"render", drawing_, "-o", picture, "--stats", path("soft")}, "--stats");
  expect_refused(
      {"render", drawing_, "--out-dir", path("n/e/w"), "--stats", path("n/e/../e/w/in.png")},
      "--stats");
  EXPECT_EQ(read_whole(picture), before);
  EXPECT_FALSE(fs::exists(path("n")));
}

TEST_F(FileUses, stats_beside_the_picture_are_written) {
  const std::string stats = link("figures.json", "soft.json");
  ASSERT_EQ(run_sfumato({"render", drawing_, "-o", path("a.png"), "--stats", stats}).exit_code, 0);
  EXPECT_TRUE(read_whole(path("figures.json")).starts_with("{\"curves\":"));
  EXPECT_EQ(
      run_sfumato({"render", drawing_, "-o", path("a.png"), "--stats", "/dev/null"}).exit_code, 0);
}

TEST_F(FileUses, two_pictures_never_become_one_file) {
  fs::create_directory(path("o"));
  fs::create_symlink("other.png", path("o/in.png"));
  expect_refused({"render", drawing_, other_, "--out-dir", path("o")}, "--out-dir");
  EXPECT_FALSE(fs::exists(path("o/other.png")));
  fs::remove(path("o/in.png"));
  fs::create_symlink(drawing_, path("o/in.png"));
  expect_refused({"render", drawing_, other_, "--out-dir", path("o")}, "--out-dir");
}

TEST_F(FileUses, convert_and_compare_never_replace_what_they_read) {
  const std::string soft = link("other.svg", "soft.svg");
  expect_refused({"convert", other_, "-o", other_}, "--output");
  expect_refused({"convert", other_, "-o", soft}, "--output");
  ASSERT_EQ(run_sfumato({"render", drawing_, "-o", path("a.png")}).exit_code, 0);
  const std::string before = read_whole(path("a.png"));
  ASSERT_EQ(run_sfumato({"render", other_, "-o", path("b.png")}).exit_code, 0);
  for (const Names& inputs :
       {Names{path("a.png"), path("b.png")}, Names{path("b.png"), path("a.png")}}) {
    expect_refused({"compare", inputs[0], inputs[1], "-o", path("./a.png")}, "--output");
  }
  EXPECT_EQ(read_whole(path("a.png")), before);
}

TEST_F(FileUses, standard_streams_are_files_too) {
  const std::string script =
      "exec \"$0\" render - -o '" + path("other.png") + "' <'" + link("in.xml", "other.png") + "'";
  const CommandResult read = run_command({"/bin/sh", "-c", script, sfumato_program()});
  EXPECT_EQ(read.exit_code, 2) << read.err;
  const std::string written = "exec \"$0\" render '" + drawing_ + "' -o - --stats '" + path("out") +
                              "' >'" + path("out") + "'";
  const CommandResult stats = run_command({"/bin/sh", "-c", written, sfumato_program()});
  EXPECT_EQ(stats.exit_code, 2) << stats.err;
  expect_unchanged();
}

TEST_F(FileUses, no_output_replaces_a_texture) {
  ASSERT_EQ(run_sfumato({"render", drawing_, "-o", path("tile.png"), "--width", "8"}).exit_code, 0);
  const std::string tile = read_whole(path("tile.png"));
  const std::string textured = folder_.add("textured.svg", kTextured);
  ASSERT_EQ(run_sfumato({"render", textured, "-o", path("a.png")}).exit_code, 0);
  fs::create_hard_link(path("tile.png"), path("hard.png"));
  for (const std::string& output :
       {path("tile.png"), path("hard.png"), link("tile.png", "soft.png")}) {
    const CommandResult result = run_sfumato({"render", textured, "-o", output});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("would replace this file"), std::string::npos) << result.err;
    EXPECT_EQ(run_sfumato({"render", textured, "-o", path("b.png"), "--stats", output}).exit_code,
              1);
  }
  EXPECT_TRUE(read_whole(path("tile.png")) == tile);
}

TEST_F(FileUses, no_picture_replaces_a_texture_of_another_drawing) {
  ASSERT_EQ(run_sfumato({"render", drawing_, "-o", path("tile.png"), "--width", "8"}).exit_code, 0);
  const std::string tile = read_whole(path("tile.png"));
  const std::string textured = folder_.add("textured.svg", kTextured);
  const std::string tile_drawing = folder_.add("tile.svg", two_curve_scene());
  // In either order, and even if a drawing in between is invalid.
  const std::string bad = folder_.add("bad.svg", "<svg");
  const Names in_some_order[] = {{tile_drawing, bad, textured}, {textured, bad, tile_drawing}};
  for (const Names& drawings : in_some_order) {
    Names call{"render", "--out-dir", folder_.path("")};
    call.insert(call.end(), drawings.begin(), drawings.end());
    const CommandResult result = run_sfumato(call);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("--out-dir: the picture "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("tile.png\" would replace the texture \"tile.png\" of \"" + textured),
              std::string::npos)
        << result.err;
    EXPECT_TRUE(read_whole(path("tile.png")) == tile);
    EXPECT_FALSE(fs::exists(path("textured.png")));
  }
  expect_refused({"render", drawing_, textured, "--out-dir", path("o"), "--stats",
                  link("tile.png", "soft.json")},
                 "--stats");
  EXPECT_FALSE(fs::exists(path("o")));
  EXPECT_TRUE(read_whole(path("tile.png")) == tile);
}

TEST_F(FileUses, no_picture_becomes_a_texture_that_is_not_there_yet) {
  const std::string textured = folder_.add("textured.svg", kTextured);
  const std::string tile_drawing = folder_.add("tile.svg", two_curve_scene());
  expect_refused({"render", tile_drawing, textured, "--out-dir", folder_.path("")}, "--out-dir");
  EXPECT_FALSE(fs::exists(path("tile.png")));
}

TEST_F(FileUses, pictures_in_another_folder_leave_textures_alone) {
  ASSERT_EQ(run_sfumato({"render", drawing_, "-o", path("tile.png"), "--width", "8"}).exit_code, 0);
  const std::string textured = folder_.add("textured.svg", kTextured);
  const std::string tile_drawing = folder_.add("tile.svg", two_curve_scene());
  const CommandResult result =
      run_sfumato({"render", tile_drawing, textured, "--out-dir", path("o")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::exists(path("o/tile.png")) && fs::exists(path("o/textured.png")));
}

}  // namespace
}  // namespace sfumato::test
