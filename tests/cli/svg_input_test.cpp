// SVG documents at the command line: where textures are read from, and what is told.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zlib.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

constexpr const char* kHead =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 64 48' "
    "sf:version='1'>\n";

std::string drawing(const std::string& href) {
  return kHead +
         ("<pattern id='p' patternUnits='userSpaceOnUse' width='64' height='64'>\n<image href='" +
          href +
          "' width='64' height='64'/></pattern>\n<g sf:diffuse='true'><circle cx='32' cy='24' "
          "r='9' sf:left='url(#p)' sf:right='red'/></g></svg>\n");
}

std::string texture() {
  return png_of({2, 2, PixelFormat::rgb8, std::vector<std::uint8_t>(12, 99)});
}

/// A folder with art/drawing.svg, art/wood.png, art/sub/wood.png and wood.png.
class SvgInput : public testing::Test {
 protected:
  SvgInput() {
    std::filesystem::create_directories(folder_.path("art/sub"));
    for (const char* name : {"wood.png", "art/wood.png", "art/sub/wood.png"}) {
      folder_.add(name, texture());
    }
  }

  CommandResult info_of(const std::string& href) {
    return run_sfumato({"info", folder_.add("art/drawing.svg", drawing(href))});
  }

  void expect_refused(const std::string& href, const std::string& reason) {
    const CommandResult result = info_of(href);
    EXPECT_EQ(result.exit_code, 1) << href;
    EXPECT_NE(result.err.find("drawing.svg:3:1: error: \"" + href + "\""), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
  }

  TemporaryFolder folder_;
};

TEST_F(SvgInput, textures_are_read_from_beside_the_document) {
  for (const char* href : {"wood.png", "./wood.png", "sub/wood.png", "../wood.png"}) {
    const CommandResult result = info_of(href);
    EXPECT_EQ(result.exit_code, 0) << href << ": " << result.err;
    EXPECT_EQ(result.err, "");
  }
}

TEST_F(SvgInput, other_places_are_refused) {
  expect_refused("gone.png", "there is no such file");
  expect_refused("sub", "is not a file");
  expect_refused(folder_.path("wood.png"), "is an absolute path");
  expect_refused("http://example.org/wood.png", "nothing is fetched");
  expect_refused("//example.org/wood.png", "nothing is fetched");
}

TEST_F(SvgInput, pipes_and_devices_are_refused) {
  ASSERT_EQ(mkfifo(folder_.path("art/pipe.png").c_str(), 0600), 0);
  expect_refused("pipe.png", "is not a file");
}

TEST_F(SvgInput, format_is_told_and_render_draws) {
  EXPECT_NE(info_of("wood.png").out.find("SVG"), std::string::npos);
  const std::string picture = folder_.path("a.png");
  const CommandResult result =
      run_sfumato({"render", folder_.path("art/drawing.svg"), "-o", picture});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(image_of(read_whole(picture)).width, 64);
}

TEST_F(SvgInput, packed_documents_are_read) {
  const std::string path = folder_.path("art/drawing.svgz");
  const std::string text = drawing("wood.png");
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
