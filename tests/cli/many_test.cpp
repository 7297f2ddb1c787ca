#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

using Names = std::vector<std::string>;

TEST(ManyDrawings, each_becomes_the_picture_that_it_becomes_alone) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.xml", two_curve_scene());
  const std::string b = folder.add("b.old.xml", two_curve_scene());
  const std::string alone = folder.path("alone.png"), out = folder.path("new/pictures");
  ASSERT_EQ(run_sfumato({"render", a, "-o", alone}).exit_code, 0);
  const CommandResult result = run_sfumato({"render", a, b, "--out-dir", out});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_EQ(names_in(out), (Names{"a.png", "b.old.png"}));
  EXPECT_EQ(read_whole(out + "/a.png"), read_whole(alone));
  EXPECT_EQ(read_whole(out + "/b.old.png"), read_whole(alone));
}

TEST(ManyDrawings, a_bad_one_stops_no_other_and_shows_in_the_exit_code) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.xml", two_curve_scene());
  const std::string bad = folder.add("bad.xml", "<curve_set");
  const std::string z = folder.add("z.xml", two_curve_scene());
  const std::string missing = folder.path("missing.svg"), out = folder.path("out");
  const CommandResult result = run_sfumato({"render", a, bad, missing, z, "--out-dir", out});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(contains(result.err, bad + ":1:")) << result.err;
  EXPECT_TRUE(contains(result.err, missing + ": error: ")) << result.err;
  EXPECT_TRUE(contains(result.err, "sfumato: 2 of 4 drawings failed\n")) << result.err;
  EXPECT_EQ(names_in(out), (Names{"a.png", "z.png"}));
}

TEST(ManyDrawings, the_first_failure_gives_the_exit_code) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.xml", two_curve_scene());
  const std::string bad = folder.add("bad.xml", "<curve_set");
  const std::string out = folder.path("out");
  std::filesystem::create_directories(out + "/a.png");  // a file cannot replace it
  EXPECT_EQ(run_sfumato({"render", a, bad, "--out-dir", out}).exit_code, 3);
  EXPECT_EQ(run_sfumato({"render", bad, a, "--out-dir", out}).exit_code, 1);
}

TEST(ManyDrawings, format_says_what_is_written) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.xml", two_curve_scene());
  const std::string out = folder.path("out");
  for (const char* format : {"jpg", "webp", "PNG"}) {
    EXPECT_EQ(run_sfumato({"render", a, "--out-dir", out, "--format", format}).exit_code, 0);
  }
  EXPECT_EQ(names_in(out), (Names{"a.PNG", "a.jpg", "a.webp"}));
  EXPECT_TRUE(read_whole(out + "/a.PNG").starts_with("\x89PNG"));
  EXPECT_TRUE(read_whole(out + "/a.jpg").starts_with("\xff\xd8\xff"));
  EXPECT_TRUE(read_whole(out + "/a.webp").starts_with("RIFF"));
}

TEST(ManyDrawings, stats_are_one_line_for_each_that_was_drawn) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.xml", two_curve_scene());
  const std::string bad = folder.add("bad.xml", "<curve_set");
  const std::string stats = folder.path("stats.json");
  const CommandResult result =
      run_sfumato({"render", a, bad, a, "--out-dir", folder.path("out"), "--stats", stats});
  EXPECT_EQ(result.exit_code, 2) << "one drawing twice";
  ASSERT_EQ(run_sfumato({"render", a, bad, folder.add("c.xml", two_curve_scene()), "--out-dir",
                         folder.path("out"), "--stats", stats})
                .exit_code,
            1);
  const std::string text = read_whole(stats);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_TRUE(text.starts_with("{\"input\":\"" + a + "\",\"curves\":")) << text;
}

TEST(ManyDrawings, no_picture_replaces_a_drawing_or_another_picture) {
  const TemporaryFolder folder;
  const std::string drawing = two_curve_scene();
  // A drawing may have any name; its content decides.
  const std::string odd = folder.add("odd.png", drawing);
  std::filesystem::create_directories(folder.path("b"));
  const std::string same = folder.add("b/odd.xml", drawing);
  const CommandResult replaced = run_sfumato({"render", odd, "-o", odd});
  EXPECT_EQ(replaced.exit_code, 2);
  EXPECT_TRUE(contains(replaced.err, "would replace the drawing")) << replaced.err;
  std::filesystem::create_hard_link(odd, folder.path("link.png"));
  EXPECT_EQ(run_sfumato({"render", odd, "-o", folder.path("link.png")}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"render", same, odd, "--out-dir", folder.path("")}).exit_code, 2);
  const CommandResult both = run_sfumato({"render", odd, same, "--out-dir", folder.path("o")});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_TRUE(contains(both.err, "would both become")) << both.err;
  EXPECT_EQ(read_whole(odd), drawing);
  EXPECT_FALSE(std::filesystem::exists(folder.path("o")));
}

TEST(ManyDrawings, need_a_folder_and_names) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.xml", two_curve_scene());
  const std::string b = folder.add("b.xml", two_curve_scene());
  const CommandResult no_folder = run_sfumato({"render", a, b, "-o", folder.path("x.png")});
  EXPECT_EQ(no_folder.exit_code, 2);
  EXPECT_TRUE(contains(no_folder.err, "--out-dir")) << no_folder.err;
  EXPECT_EQ(run_sfumato({"render", "-", "--out-dir", folder.path("o")}, a).exit_code, 2);
  EXPECT_EQ(run_sfumato({"render", a}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"render", a, "-o", folder.path("x.png"), "--out-dir", "o"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"render", a, "-o", folder.path("x.png"), "--format", "png"}).exit_code, 2);
  const CommandResult no_place = run_sfumato({"render", a, "--out-dir", a + "/o"});
  EXPECT_EQ(no_place.exit_code, 3);
  EXPECT_TRUE(contains(no_place.err, "cannot be made")) << no_place.err;
  const CommandResult no_folder_but_a_file = run_sfumato({"render", a, "--out-dir", b});
  EXPECT_EQ(no_folder_but_a_file.exit_code, 3);
  EXPECT_TRUE(contains(no_folder_but_a_file.err, "Not a directory")) << no_folder_but_a_file.err;
  EXPECT_EQ(folder.names(), (Names{"a.xml", "b.xml"}));
}

struct BadImageOption {
  const char* output;
  std::vector<std::string> options;
  const char* expected;
};

TEST(ImageFormats, options_that_a_format_has_no_place_for_are_named) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.xml", two_curve_scene());
  const BadImageOption cases[] = {
      {"o.jpg", {"--depth", "16"}, "PNG only"},
      {"o.webp", {"--depth", "16"}, "PNG only"},
      {"o.jpeg", {"--background", "none"}, "JPEG has no alpha"},
      {"o.png", {"--quality", "80"}, "JPEG and lossy WebP only"},
      {"o.webp", {"--lossless", "--quality", "80"}, "JPEG and lossy WebP only"},
      {"o.jpg", {"--lossless"}, "WebP only"},
      {"o.jpg", {"--quality", "0"}, "a whole number from 1 to 100"},
  };
  for (const BadImageOption& bad : cases) {
    std::vector<std::string> arguments{"render", a, "-o", folder.path(bad.output)};
    arguments.insert(arguments.end(), bad.options.begin(), bad.options.end());
    const CommandResult result = run_sfumato(arguments);
    EXPECT_EQ(result.exit_code, 2) << bad.output;
    EXPECT_TRUE(contains(result.err, bad.expected)) << result.err;
  }
  EXPECT_EQ(folder.names(), Names{"a.xml"});
}

TEST(ImageFormats, quality_and_lossless_change_the_file) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.xml", two_curve_scene());
  const auto size_of = [&](const std::string& name, std::vector<std::string> options) {
    options.insert(options.begin(), {"render", a, "--scale", "8", "-o", folder.path(name)});
    EXPECT_EQ(run_sfumato(options).exit_code, 0);
    return read_whole(folder.path(name)).size();
  };
  EXPECT_LT(size_of("low.jpg", {"--quality", "20"}), size_of("high.jpg", {"--quality", "100"}));
  EXPECT_LT(size_of("low.webp", {"--quality", "20"}), size_of("high.webp", {"--quality", "100"}));
  EXPECT_GT(size_of("a.webp", {"--lossless", "--background", "none"}), 0u);
}

}  // namespace
}  // namespace sfumato::test
