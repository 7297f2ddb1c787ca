// SVG documents at the command line: the folders of textures, and the messages.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zlib.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

constexpr const char* kHead =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 64 48' "
    "sf:version='1'>\n";

std::string textured_drawing(const std::string& href) {
  return kHead +
         ("<pattern id='p' patternUnits='userSpaceOnUse' width='64' height='64'>\n<image href='" +
          href +
          "' width='64' height='64'/></pattern>\n<g sf:diffuse='true'><circle cx='32' cy='24' "
          "r='9' sf:left='url(#p)' sf:right='red'/></g></svg>\n");
}

std::string texture() {
  return png_of({2, 2, PixelFormat::rgb8, std::vector<std::uint8_t>(12, 99)});
}

/// A folder with art/drawing.svg, and wood.png in the folder, in art, art/sub and art-of-others.
class SvgInput : public testing::Test {
 protected:
  SvgInput() {
    for (const char* name : {"art/sub", "art-of-others", "other"}) {
      std::filesystem::create_directories(folder_.path(name));
    }
    for (const char* name :
         {"wood.png", "art/wood.png", "art/sub/wood.png", "art-of-others/wood.png"}) {
      folder_.add(name, texture());
    }
  }

  CommandResult info_of(const std::string& href, const std::vector<std::string>& allowed = {}) {
    std::vector<std::string> command{"info",
                                     folder_.add("art/drawing.svg", textured_drawing(href))};
    for (const std::string& folder : allowed) {
      command.insert(command.end(), {"--allow-files", folder});
    }
    return run_sfumato(command);
  }

  void expect_read(const std::string& href, const std::vector<std::string>& allowed = {}) {
    const CommandResult result = info_of(href, allowed);
    EXPECT_EQ(result.exit_code, 0) << href << ": " << result.err;
    EXPECT_EQ(result.err, "");
  }

  void expect_refused(const std::string& href, const std::string& reason,
                      const std::vector<std::string>& allowed = {}) {
    const CommandResult result = info_of(href, allowed);
    EXPECT_EQ(result.exit_code, 1) << href;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    EXPECT_NE(result.err.find("drawing.svg:3:1: error: \"" + href + "\""), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
  }

  std::string real(const std::string& name) const {
    return std::filesystem::canonical(folder_.path(name)).string();
  }

  TemporaryFolder folder_;
};

TEST_F(SvgInput, textures_are_read_from_beside_the_document) {
  for (const char* href : {"wood.png", "./wood.png", "sub/wood.png", "sub/../wood.png",
                           "../art/wood.png", "gone/../wood.png", "sub%2Fwood.png"}) {
    expect_read(href);
  }
  expect_read(folder_.path("art/sub/wood.png"));
}

TEST_F(SvgInput, textures_from_elsewhere_need_leave) {
  const std::string outside = ", outside of " + real("art") +
                              "; move the file there, or allow its folder with --allow-files DIR\n";
  for (const std::string& href : {std::string("../wood.png"), std::string("sub/../../wood.png"),
                                  std::string("..%2Fwood.png"), folder_.path("wood.png")}) {
    expect_refused(href, ": leads to " + real("wood.png") + outside);
    expect_read(href, {folder_.path("")});
    expect_read(href, {folder_.path("other"), folder_.path(".")});
    expect_read(href, {"/"});
    expect_refused(href, " and " + real("other") + ";", {folder_.path("other")});
  }
  expect_refused("/etc/passwd", ": leads to /etc/passwd" + outside);
  // A folder whose name begins like another's does not hold the other's files.
  expect_refused("../art-of-others/wood.png", outside);
}

TEST_F(SvgInput, every_command_takes_folders) {
  const std::string input = folder_.add("art/drawing.svg", textured_drawing("../wood.png"));
  const std::vector<std::vector<std::string>> commands{
      {"render", input, "-o", folder_.path("out.png")},
      {"convert", input, "-o", folder_.path("out.svg")},
      {"info", input},
      {"lint", input}};
  for (std::vector<std::string> command : commands) {
    EXPECT_EQ(run_sfumato(command).exit_code, 1) << command[0];
    command.insert(command.end(), {"--allow-files", folder_.path("")});
    EXPECT_EQ(run_sfumato(command).exit_code, 0) << command[0];
  }
}

TEST_F(SvgInput, folders_that_do_not_exist_are_bad_usage) {
  for (const std::string& name : {folder_.path("none"), folder_.path("wood.png"), std::string()}) {
    const CommandResult result = info_of("wood.png", {name});
    EXPECT_EQ(result.exit_code, 2) << name;
    EXPECT_TRUE(result.err.starts_with("sfumato: error: --allow-files: there is no folder \"" +
                                       name + "\"; use a folder that exists\n"))
        << result.err;
  }
}

TEST_F(SvgInput, symbolic_links_do_not_lead_out) {
  namespace fs = std::filesystem;
  fs::create_symlink("../wood.png", folder_.path("art/link.png"));
  fs::create_directory_symlink("..", folder_.path("art/up"));
  fs::create_symlink("sub/wood.png", folder_.path("art/inside.png"));
  fs::create_symlink("loop.png", folder_.path("art/loop.png"));
  for (const char* href : {"link.png", "up/wood.png", "sub/../up/wood.png"}) {
    expect_refused(href, ": leads to " + real("wood.png") + ", outside of " + real("art"));
    expect_read(href, {folder_.path("")});
  }
  expect_read("inside.png");
  expect_read("up/art/wood.png");
  expect_refused("loop.png", "Too many levels of symbolic links");
  // The allowed folder may itself be a link.
  expect_read("../wood.png", {folder_.path("art/up")});
}

TEST_F(SvgInput, a_document_from_stdin_is_in_the_current_folder) {
  const auto info_in = [this](const std::string& folder) {
    return run_command({"/bin/sh", "-c", "cd \"$1\" && exec \"$2\" info -", "sh",
                        folder_.path(folder), sfumato_program()},
                       textured_drawing("../art/wood.png"));
  };
  EXPECT_EQ(info_in("art").exit_code, 0) << info_in("art").err;
  const CommandResult elsewhere = info_in("other");
  EXPECT_EQ(elsewhere.exit_code, 1);
  EXPECT_TRUE(elsewhere.err.starts_with("<stdin>:3:1: error: \"../art/wood.png\": leads to " +
                                        real("art/wood.png") + ", outside of " + real("other")))
      << elsewhere.err;
}

TEST_F(SvgInput, other_places_are_refused) {
  expect_refused("gone.png", "there is no such file");
  expect_refused("sub", "is not a file");
  expect_refused(".", "is not a file", {folder_.path("")});
  expect_refused("wood.png/more.png", "there is no such file");
  expect_refused("a%00b.png", "is not a file name");
  const CommandResult long_name = info_of(std::string(5000, 'a'));
  EXPECT_EQ(long_name.exit_code, 1);
  EXPECT_NE(long_name.err.find("cannot be read: File name too long\n"), std::string::npos);
}

TEST_F(SvgInput, nothing_is_fetched) {
  for (const char* href : {"http://example.org/wood.png", "https://example.org/wood.png",
                           "//example.org/wood.png", "file:wood.png", "FTP:wood.png"}) {
    expect_refused(href, "is not read: nothing is fetched; use a file", {"/"});
  }
}

TEST_F(SvgInput, pipes_and_devices_are_refused) {
  ASSERT_EQ(mkfifo(folder_.path("art/pipe.png").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder_.path("art/zero.png"));
  expect_refused("pipe.png", "is not a file");
  for (const char* href : {"zero.png", "/dev/zero"}) {
    expect_refused(href, "outside of " + real("art"));
    expect_refused(href, "is not a file", {"/dev"});
  }
}

TEST_F(SvgInput, format_is_told_and_render_draws) {
  EXPECT_NE(info_of("wood.png").out.find("SVG"), std::string::npos);
  const std::string picture = folder_.path("a.png");
  const CommandResult result =
      run_sfumato({"render", folder_.path("art/drawing.svg"), "-o", picture});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(image_of(read_whole(picture)).width, 64);
}

TEST_F(SvgInput, render_warns_of_an_ordinary_drawing_and_names_the_import) {
  const CommandResult result =
      run_sfumato({"render", "-", "-o", folder_.path("a.png")},
                  "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 4 4'><rect width='2' "
                  "height='2'/></svg>");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("the picture is empty; it contains no curves of Sfumato"),
            std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("use `sfumato init --from IN.svg OUT.svg`"), std::string::npos)
      << result.err;
}

TEST_F(SvgInput, packed_documents_are_read) {
  const std::string path = folder_.path("art/drawing.svgz");
  const std::string text = textured_drawing("wood.png");
  gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  EXPECT_EQ(run_sfumato({"info", path}).exit_code, 0);
}

TEST_F(SvgInput, misspelt_attribute_is_told_with_its_place) {
  const CommandResult result =
      run_sfumato({"info", "-"}, std::string(kHead) + "<g sf:difuse='true'/></svg>");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err,
            "<stdin>:2:1: error: there is no attribute sf:difuse; did you mean sf:diffuse?\n");
}

}  // namespace
}  // namespace sfumato::test
