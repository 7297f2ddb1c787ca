// `sfumato tiles`: bad usage and input, killed shards, and a full disk.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

using Names = std::vector<std::string>;

std::string solved_in(const TemporaryFolder& folder) {
  const std::string path = folder.path("scene.sfp");
  const CommandResult result =
      run_sfumato({"solve", "-", "-o", path, "--scale", "8"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return path;
}

std::map<std::string, std::string> content_of(const std::string& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    if (entry.is_regular_file()) content[name] = read_whole(entry.path().string());
  }
  return content;
}

TEST(Tiles, a_folder_gets_a_description_and_tiles) {
  const TemporaryFolder folder;
  const std::string picture = solved_in(folder);
  const CommandResult result =
      run_sfumato({"tiles", picture, "-o", folder.path("deep"), "--stats", "-"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(contains(result.out, "{\"width\":512,\"height\":384,\"levels\":10,\"tiles\":"))
      << result.out;
  const auto content = content_of(folder.path("deep"));
  const std::string description = content.at("scene.dzi");
  EXPECT_TRUE(contains(description, "Format=\"png\" Overlap=\"0\" TileSize=\"256\""))
      << description;
  EXPECT_TRUE(contains(description, "<Size Width=\"512\" Height=\"384\"/>")) << description;
  EXPECT_EQ(content.count("scene_files/9/1_1.png"), 1u);
  EXPECT_EQ(content.count("scene_files/0/0_0.png"), 1u);
  // A level is a picture of that size.
  ASSERT_EQ(
      run_sfumato({"render", picture, "-o", folder.path("a.png"), "--width", "256"}).exit_code, 0);
  EXPECT_TRUE(content.at("scene_files/8/0_0.png") == read_whole(folder.path("a.png")));
}

TEST(Tiles, formats_and_sizes_are_those_of_render) {
  const TemporaryFolder folder;
  const std::string picture = solved_in(folder);
  for (const char* format : {"webp", "jpg", "png"}) {
    const std::string out = folder.path(std::string(format) + ".dzi");
    Names call{"tiles",   picture, "-o",           out,   "--format", format,
               "--width", "200",   "--background", "gold"};
    if (std::string(format) != "png") call.insert(call.end(), {"--quality", "70"});
    ASSERT_EQ(run_sfumato(call).exit_code, 0) << format;
    const std::string rendered = folder.path(std::string("a.") + format);
    Names render{"render", picture, "-o", rendered, "--width", "200", "--background", "gold"};
    if (std::string(format) != "png") render.insert(render.end(), {"--quality", "70"});
    ASSERT_EQ(run_sfumato(render).exit_code, 0) << format;
    EXPECT_TRUE(read_whole(folder.path(std::string(format) + "_files/8/0_0." + format)) ==
                read_whole(rendered))
        << format;
  }
}

TEST(Tiles, more_than_was_solved_for_is_told) {
  const TemporaryFolder folder;
  const std::string picture = solved_in(folder);
  const CommandResult result =
      run_sfumato({"tiles", picture, "-o", folder.path("deep"), "--scale", "16"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(contains(result.err, "solved for 8 pixels per user unit, drawn at 16")) << result.err;
}

struct BadTilesUsage {
  Names options;
  const char* expected;
};

TEST(Tiles, bad_usage_is_named) {
  const TemporaryFolder folder;
  const std::string picture = solved_in(folder);
  const BadTilesUsage cases[] = {
      {{"-o", "deep", "--shard", "16/16"}, "I/N, with I from 0 to N - 1"},
      {{"-o", "deep", "--shard", "3"}, "I/N"},
      {{"-o", "deep", "--shard", "-1/4"}, "I/N"},
      {{"-o", "deep", "--shard", "0/0"}, "I/N"},
      {{"-o", "deep", "--tile", "8"}, "from 16 to 4096"},
      {{"-o", "deep", "--tile", "16", "--overlap", "16"}, "less than the side of a tile"},
      {{"-o", "deep", "--format", "tiff"}, "png|webp|jpg"},
      {{"-o", "deep", "--quality", "50"}, "JPEG"},
      {{"-o", "deep", "--scale", "2", "--width", "9"}, "--width and --height"},
      {{"-o", "deep", "--format", "jpg", "--background", "none"}, "no alpha"},
      {{"-o", "-"}, "use a folder, NAME.dzi or NAME.tif"},
      {{"-o", "a.tif", "--shard", "0/2"}, "one file"},
      {{"-o", "a.tif", "--overlap", "1"}, "Deep Zoom only"},
      {{"-o", "a.tif", "--format", "png"}, "Deep Zoom only"},
      {{"-o", "a.tif", "--tile", "100"}, "multiple of 16"},
      {{}, "--output"},
  };
  for (const BadTilesUsage& bad : cases) {
    Names call{"tiles", picture};
    call.insert(call.end(), bad.options.begin(), bad.options.end());
    const CommandResult result = run_sfumato(call);
    EXPECT_EQ(result.exit_code, 2) << bad.expected;
    EXPECT_TRUE(contains(result.err, bad.expected)) << bad.expected << "\n" << result.err;
  }
  EXPECT_EQ(folder.names(), Names{"scene.sfp"});
}

TEST(Tiles, bad_input_and_limits_are_told) {
  const TemporaryFolder folder;
  const std::string picture = solved_in(folder);
  const std::string out = folder.path("deep");
  const CommandResult drawing =
      run_sfumato({"tiles", folder.add("a.xml", two_curve_scene()), "-o", out});
  EXPECT_EQ(drawing.exit_code, 1);
  EXPECT_TRUE(contains(drawing.err, "use a solved picture, which `sfumato solve` makes"))
      << drawing.err;
  const std::string cut = folder.add("cut.sfp", read_whole(picture).substr(0, 3000));
  EXPECT_EQ(run_sfumato({"tiles", cut, "-o", out}).exit_code, 1);
  const CommandResult large = run_sfumato({"tiles", picture, "-o", out, "--width", "99999999"});
  EXPECT_EQ(large.exit_code, 3) << large.err;
  const CommandResult little = run_sfumato({"tiles", picture, "-o", out, "--max-memory", "1"});
  EXPECT_EQ(little.exit_code, 3) << little.err;
  const CommandResult file = run_sfumato({"tiles", picture, "-o", folder.path("a.xml/deep")});
  EXPECT_EQ(file.exit_code, 3) << file.err;
}

TEST(Tiles, a_full_disk_is_told_and_a_second_call_goes_on) {
  const TemporaryFolder folder;
  const std::string picture = solved_in(folder);
  const std::string out = folder.path("deep");
  Names call{"/bin/sh", "-c", "ulimit -f 8; exec \"$@\"", "sh", sfumato_program(), "tiles", picture,
             "-o",      out};
  const CommandResult full = run_command(call);
  EXPECT_EQ(full.exit_code, 3) << full.err;
  EXPECT_TRUE(contains(full.err, "cannot be written")) << full.err;
  for (const auto& [name, bytes] : content_of(out)) EXPECT_FALSE(contains(name, ".tmp")) << name;
  call.back() = folder.path("a.tif");
  EXPECT_EQ(run_command(call).exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.tif")));
  EXPECT_EQ(run_sfumato({"tiles", picture, "-o", out}).exit_code, 0);
  EXPECT_EQ(run_sfumato({"tiles", picture, "-o", folder.path("clean/scene.dzi")}).exit_code, 0);
  EXPECT_TRUE(content_of(out) == content_of(folder.path("clean")));
}

TEST(Tiles, of_two_pictures_that_begin_at_once_are_not_mixed) {
  const TemporaryFolder folder;
  const std::string first = solved_in(folder), second = folder.path("other.sfp");
  ASSERT_EQ(run_sfumato({"solve", "-", "-o", second, "--scale", "4"}, two_curve_scene()).exit_code,
            0);
  for (int turn = 0; turn < 8; ++turn) {
    const std::string out = folder.path("deep" + std::to_string(turn) + ".dzi");
    const auto call = [&](const std::string& picture) {
      return Names{sfumato_program(), "tiles", picture,     "-o", out,      "--width", "64",
                   "--tile",          "16",    "--threads", "1",  "--quiet"};
    };
    RunningCommand one(call(first), {}), other(call(second), {});
    const CommandResult results[] = {one.wait(), other.wait()};
    EXPECT_EQ(results[0].exit_code + results[1].exit_code, 3) << results[0].err << results[1].err;
    EXPECT_TRUE(contains(results[0].err + results[1].err, "tiles of another picture"));
  }
}

TEST(Tiles, shards_that_are_killed_or_meet_leave_what_one_call_makes) {
  const TemporaryFolder folder;
  const std::string picture = solved_in(folder);
  const Names large{"--width", "6000", "--threads", "2"};
  const auto call = [&](const std::string& out, const std::string& shard) {
    Names names{sfumato_program(), "tiles",   picture, "-o",
                folder.path(out),  "--shard", shard,   "--quiet"};
    names.insert(names.end(), large.begin(), large.end());
    return names;
  };
  ASSERT_EQ(run_command(call("clean", "0/1")).exit_code, 0);
  for (int turn = 0; turn < 6; ++turn) {
    RunningCommand running(call("deep", "0/2"), {});
    ::usleep(static_cast<useconds_t>(20'000 + 60'000 * turn));
    ::kill(running.id(), SIGKILL);
    running.wait();
  }
  RunningCommand first(call("deep", "0/2"), {}), same(call("deep", "0/2"), {}),
      other(call("deep", "1/2"), {});
  for (RunningCommand* running : {&first, &same, &other}) {
    const CommandResult result = running->wait();
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  EXPECT_TRUE(content_of(folder.path("deep")) == content_of(folder.path("clean")));
}

}  // namespace
}  // namespace sfumato::test
