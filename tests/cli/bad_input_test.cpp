// Input that cannot be drawn or written: an exit code, one message, and no half-written file.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

using Names = std::vector<std::string>;

constexpr const char* kOldContent = "what was here before";

struct BadScene {
  const char* name;
  std::string content;
  int exit_code;
  const char* message;  ///< text of the error after "…bad.xml" and before the line's end
};

std::string points(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += point_xml(std::to_string(10 + i), "20");
  return text;
}

std::string scene_with(const std::string& control_points) {
  const char* white = R"(R="255" G="255" B="255")";
  return scene_xml(64, 48, curve_xml(control_points, white, white));
}

std::string million_curves() {
  std::string curves;
  for (int i = 0; i < 1'000'000; ++i) curves += "<curve/>";
  return scene_xml(64, 48, curves);
}

std::vector<BadScene> bad_scenes() {
  const std::string good = two_curve_scene();
  return {
      {"empty", "", 1, ": error: the file is empty"},
      {"not_xml", "P3 2 2 255\n0 0 0\n", 1, ": error: no XML element found"},
      {"truncated", good.substr(0, good.size() / 2), 1, "the XML is cut short"},
      {"other_xml", "<html/>", 1, ":1:1: error: the document is a <html>"},
      {"points_0", scene_with(points(0)), 1, ":4:1: error: the curve has 0 control points"},
      {"points_2", scene_with(points(2)), 1, ":4:1: error: the curve has 2 control points"},
      {"points_5", scene_with(points(5)), 1, ":4:1: error: the curve has 5 control points"},
      {"nan", scene_with(points(3) + point_xml("nan", "1")), 1,
       ":8:1: error: y of <control_point> is \"nan\""},
      {"1e308", scene_with(points(3) + point_xml("1", "1e308")), 1,
       ":8:1: error: x of <control_point> is 1e308"},
      {"no_canvas", scene_xml(0, 48, ""), 1, ":2:1: error: the canvas has no area"},
      {"million_curves", million_curves(), 3, "more than the limit of 200000 curves"},
  };
}

TEST(BadInput, is_refused_and_leaves_everything_as_it_was) {
  for (const BadScene& bad : bad_scenes()) {
    const TemporaryFolder folder;
    const std::string input = folder.add("bad.xml", bad.content);
    const std::string output = folder.add("out.png", kOldContent);
    const CommandResult result =
        run_sfumato({"render", input, "-o", output, "--stats", folder.path("stats.json")});
    EXPECT_EQ(result.exit_code, bad.exit_code) << bad.name;
    EXPECT_TRUE(result.err.starts_with(input + ":")) << bad.name << ": " << result.err;
    EXPECT_TRUE(contains(result.err, bad.message)) << bad.name << ": " << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << bad.name << ": " << result.err;
    EXPECT_EQ(result.out, "") << bad.name;
    EXPECT_EQ(read_whole(output), kOldContent) << bad.name;
    EXPECT_EQ(folder.names(), (Names{"bad.xml", "out.png"})) << bad.name;
    EXPECT_EQ(run_sfumato({"info", input}).exit_code, bad.exit_code) << bad.name;
  }
}

TEST(BadInput, missing_file_is_named) {
  const TemporaryFolder folder;
  const std::string missing = folder.path("missing.xml");
  for (const Names& arguments : {Names{"render", missing, "-o", folder.path("out.png")},
                                 Names{"info", missing}, Names{"compare", missing, missing}}) {
    const CommandResult result = run_sfumato(arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.err, missing + ": error: cannot be read: No such file or directory\n");
  }
  EXPECT_EQ(folder.names(), Names{});
}

TEST(BadInput, message_about_a_missing_file_names_the_one_that_was_meant) {
  const TemporaryFolder folder;
  folder.add("lady_bug.xml", "");
  folder.add("icon.svgz", "");
  const auto hint = [&folder](const std::string& name) {
    const std::string missing = folder.path(name);
    const std::string message = run_sfumato({"info", missing}).err;
    const std::string begin = missing + ": error: cannot be read: No such file or directory";
    EXPECT_TRUE(message.starts_with(begin)) << message;
    return message.substr(std::min(begin.size(), message.size()));
  };
  const std::string drawing = "; did you mean " + folder.path("lady_bug.xml") + "?\n";
  EXPECT_EQ(hint("ladybug.xml"), drawing) << "a small mistake";
  EXPECT_EQ(hint("lady_bug.svg"), drawing) << "another extension";
  EXPECT_EQ(hint("lady_bug"), drawing) << "no extension";
  EXPECT_EQ(hint("icon.svg"), "; did you mean " + folder.path("icon.svgz") + "?\n");
  EXPECT_EQ(hint("portrait.svg"), "\n") << "nothing is similar";
  EXPECT_EQ(hint("nowhere/lady_bug.xml"), "\n") << "there is no such folder";
}

TEST(BadInput, a_folder_is_not_a_file) {
  const TemporaryFolder folder;
  const CommandResult result = run_sfumato({"info", folder.path("")});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(contains(result.err, ": error: cannot be read: ")) << result.err;
}

TEST(BadInput, control_characters_do_not_reach_the_terminal) {
  const CommandResult result = run_sfumato({"info", "no\x1b[31msuch\nfile.xml"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.err.starts_with("no?[31msuch?file.xml: error: ")) << result.err;
}

TEST(BadOutput, missing_folder_fails_before_the_input_is_read) {
  const TemporaryFolder folder;
  const std::string output = folder.path("none/out.png");
  const CommandResult result = run_sfumato({"render", folder.path("missing.xml"), "-o", output});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, output + ": error: cannot be written: the folder " + folder.path("none") +
                            " does not exist; create it first\n");
  const CommandResult stats = run_sfumato(
      {"render", folder.path("missing.xml"), "-o", folder.path("out.png"), "--stats", output});
  EXPECT_EQ(stats.exit_code, 3);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(BadOutput, folders_and_files_in_the_way_are_refused) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  std::filesystem::create_directory(folder.path("folder.png"));
  EXPECT_EQ(run_sfumato({"render", input, "-o", folder.path("folder.png")}).exit_code, 3);
  EXPECT_EQ(run_sfumato({"render", input, "-o", input + "/out.png"}).exit_code, 3);
  EXPECT_EQ(folder.names(), (Names{"folder.png", "scene.xml"}));
  EXPECT_EQ(read_whole(input), two_curve_scene());
}

TEST(BadOutput, file_that_outgrows_the_disk_leaves_the_old_one) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  const std::string output = folder.add("out.png", kOldContent);
  const CommandResult result =
      run_command({"/bin/sh", "-c", "ulimit -f 1; exec \"$@\"", "sh", sfumato_program(), "render",
                   input, "-o", output, "--width", "600"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(result.err.starts_with(output + ": error: cannot be written: ")) << result.err;
  EXPECT_EQ(read_whole(output), kOldContent);
  EXPECT_EQ(folder.names(), (Names{"out.png", "scene.xml"}));
}

TEST(BadOutput, full_device_is_an_error) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  std::filesystem::create_symlink("/dev/full", folder.path("out.png"));
  const CommandResult to_device = run_sfumato({"render", input, "-o", folder.path("out.png")});
  EXPECT_EQ(to_device.exit_code, 3);
  EXPECT_TRUE(contains(to_device.err, "cannot be written")) << to_device.err;
  for (const char* command : {"render \"$2\" -o -", "info \"$2\"", "--help"}) {
    const std::string script = std::string("exec \"$1\" ") + command + " >/dev/full";
    const CommandResult result =
        run_command({"/bin/sh", "-c", script, "sh", sfumato_program(), input});
    EXPECT_EQ(result.exit_code, 3) << command;
    EXPECT_TRUE(contains(result.err, "standard output: error: cannot be written")) << result.err;
  }
}

TEST(Limits, pictures_too_large_are_refused_with_their_size) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  for (const Names& size :
       {Names{"--scale", "1000"}, Names{"--width", "16385"}, Names{"--height", "16384"}}) {
    const CommandResult result =
        run_sfumato({"render", input, "-o", folder.path("out.png"), size[0], size[1]});
    EXPECT_EQ(result.exit_code, 3) << size[0];
    EXPECT_TRUE(contains(result.err, "the limit is 16384 pixels on a side")) << result.err;
  }
  EXPECT_EQ(folder.names(), Names{"scene.xml"});
}

TEST(Limits, memory_limit_is_kept_and_named) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  const CommandResult result = run_sfumato(
      {"render", input, "-o", folder.path("out.png"), "--max-memory", "16", "--width", "8192"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(contains(result.err, "memory limit of 16 MiB")) << result.err;
  EXPECT_EQ(folder.names(), Names{"scene.xml"});
}

TEST(Limits, limits_are_set_by_option_and_named) {
  struct Case {
    const char* option;
    const char* expected;
  };
  const Case cases[] = {
      {"curves=1", "more than the limit of 1 curves; raise the limit with --limit curves=N"},
      {"xml-elements=3",
       "more than the limit of 3 XML elements; raise the limit with --limit xml-elements=N"},
      {"xml-depth=2",
       "more than the limit of 2 elements within each other; --limit "
       "xml-depth=N"},
      {"segments=1", "a larger tolerance makes fewer; raise the limit with --limit segments=N"},
      {"triangles=2",
       "more than the limit of 2 triangles in one layer; raise the limit with --limit triangles=N"},
      {"nodes=3",
       "more than the limit of 3 points to gather at; raise the limit with --limit nodes=N"},
      {"image-side=4", "the limit is 4 pixels on a side; --limit image-side=N"},
      {"input-bytes=99",
       "more than the limit of 99 bytes of input; raise the limit with --limit input-bytes=N"},
  };
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  for (const Case& limit : cases) {
    const CommandResult result =
        run_sfumato({"render", input, "-o", folder.path("out.png"), "--limit", limit.option});
    EXPECT_EQ(result.exit_code, 3) << limit.option;
    EXPECT_TRUE(contains(result.err, limit.expected)) << limit.option << "\n" << result.err;
  }
  EXPECT_EQ(folder.names(), Names{"scene.xml"});
}

TEST(Limits, several_limits_may_be_set_in_every_command) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  const std::vector<std::vector<std::string>> commands = {
      {"render", input, "-o", folder.path("out.png")},
      {"info", input},
      {"convert", input, "-o", "-"},
      {"lint", input}};
  for (std::vector<std::string> command : commands) {
    const std::vector<std::string> given = {"--limit",          "curves=1k",  "--limit",
                                            "input-bytes=1MiB", "--max-time", "off",
                                            "--max-memory",     "512"};
    command.insert(command.end(), given.begin(), given.end());
    EXPECT_EQ(run_sfumato(command).exit_code, 0) << command[0];
    command.insert(command.end(), {"--limit", "curves=0"});
    EXPECT_EQ(run_sfumato(command).exit_code, 3) << command[0];
  }
}

TEST(Limits, time_is_limited_for_each_drawing) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  const std::string second = folder.add("second.xml", two_curve_scene());
  const CommandResult result =
      run_sfumato({"render", input, second, "--out-dir", folder.path("pictures"), "--max-time",
                   "1e-6", "--width", "2048"});
  EXPECT_EQ(result.exit_code, 3);
  const std::string message =
      "the time limit of 1e-6 s is over; raise the limit with --max-time SECONDS";
  EXPECT_TRUE(contains(result.err, "scene.xml: error: " + message)) << result.err;
  EXPECT_TRUE(contains(result.err, "second.xml: error: " + message)) << result.err;
  EXPECT_TRUE(contains(result.err, "2 of 2 drawings failed")) << result.err;
}

TEST(Interrupt, ends_the_work_with_130_and_leaves_nothing) {
  if (!std::filesystem::exists("/proc/self/status")) GTEST_SKIP() << "this system has no /proc";
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", busy_scene(400));
  for (const auto& [signal_number, exit_code] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143)}) {
    RunningCommand command({sfumato_program(), "render", input, "-o", folder.path("out.png"),
                            "--method", "rays", "--rays", "4096", "--tolerance", "0.01"},
                           "");
    command.wait_until_it_catches(signal_number);
    kill(command.id(), signal_number);
    const CommandResult result = command.wait();
    EXPECT_EQ(result.exit_code, exit_code);
    EXPECT_EQ(result.err, "sfumato: interrupted\n");
    EXPECT_EQ(folder.names(), Names{"scene.xml"});
  }
}

class Waiting : public testing::TestWithParam<Names> {};

/// The command reads a FIFO that nobody writes, or writes one that nobody reads.
TEST_P(Waiting, ends_with_the_first_signal_and_with_the_time_limit) {
  const TemporaryFolder folder;
  const std::string fifo = folder.path("fifo.svg");
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  Names arguments = GetParam();
  for (std::string& argument : arguments) {
    if (argument == "FIFO") argument = fifo;
    if (argument == "DRAWING") argument = folder.add("in.xml", two_curve_scene());
    if (argument == "OUT") argument = folder.path("out.png");
  }
  arguments.insert(arguments.begin(), sfumato_program());
  for (const auto& [signal_number, exit_code] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143)}) {
    RunningCommand command(arguments, "");
    command.wait_until_it_catches(signal_number);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    kill(command.id(), signal_number);
    const CommandResult result = command.wait();
    EXPECT_EQ(result.exit_code, exit_code);
    EXPECT_EQ(result.err, "sfumato: interrupted\n");
  }
  arguments.insert(arguments.end(), {"--max-time", "0.3"});
  const CommandResult late = run_command(arguments);
  EXPECT_EQ(late.exit_code, 3);
  EXPECT_NE(late.err.find("time limit of 0.3 s"), std::string::npos) << late.err;
}

INSTANTIATE_TEST_SUITE_P(
    For, Waiting,
    testing::Values(Names{"info", "FIFO"}, Names{"lint", "FIFO"},
                    Names{"convert", "FIFO", "-o", "-"}, Names{"render", "FIFO", "-o", "OUT"},
                    Names{"compare", "FIFO", "FIFO"}, Names{"convert", "DRAWING", "-o", "FIFO"},
                    Names{"render", "DRAWING", "-o", "FIFO"}, Names{"trace", "FIFO", "-o", "-"}),
    [](const auto& instance) { return instance.param[0] + std::to_string(instance.index); });

}  // namespace
}  // namespace sfumato::test
