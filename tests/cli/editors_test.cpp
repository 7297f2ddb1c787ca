#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/run_command.hpp"

/// Documents that we wrote, as other programs save them.
namespace sfumato::test {
namespace {

constexpr const char* kDrawing = R"svg(
<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="-8 0 256 256"
     sf:version="1">
  <defs>
    <linearGradient id="sky" gradientUnits="userSpaceOnUse" x1="0" y1="0" x2="0" y2="256">
      <stop offset="0" stop-color="#9fd4f5"/><stop offset="1" stop-color="#fdf3d8"/>
    </linearGradient>
    <radialGradient id="glow" gradientUnits="userSpaceOnUse" cx="120" cy="200" r="90">
      <stop offset="0" stop-color="#a52"/><stop offset="1" stop-color="#521"/>
    </radialGradient>
    <g id="fish" sf:diffuse="true">
      <path d="M0 20 C20 0 60 0 80 20 C60 40 20 40 0 20 Z" sf:left-opacity="0"
            sf:right-opacity="1" sf:blur="2"/>
      <path d="M5 20 C25 8 55 8 75 20" sf:left="gold, orange 60%, gold" sf:right="#fff2a8"/>
    </g>
  </defs>
  <rect x="-8" width="256" height="256" fill="#eef"/>
  <g id="ground" sf:diffuse="true" opacity=".9">
    <path d="M-10 150 C80 130 180 170 260 150" sf:left="url(#sky)" sf:right="url(#glow)"
          sf:blur="0, 6 50%, 0"/>
  </g>
  <use href="#fish" transform="translate(40 60)"/>
  <use href="#fish" transform="translate(130 90) rotate(-15) scale(.6)" opacity=".8"/>
  <g opacity=".5" style="mix-blend-mode:multiply">
    <g sf:diffuse="true"><circle cx="60" cy="200" r="20" sf:left="none" sf:right="#36c, #c63"/></g>
    <path d="M16 105 Q60 95 85 100" sf:left="#fff" sf:right="#000" sf:radius="3, 14 50%, 3"/>
  </g>
</svg>)svg";

bool is_installed(const std::string& program) {
  return run_command({"/bin/sh", "-c", "command -v " + program + " >/dev/null"}).exit_code == 0;
}

/// The document as we write it, saved by `command`, in which $1 is its name and $2 the new one.
void expect_same_picture_after(const std::string& command) {
  const TemporaryFolder folder;
  const std::string ours = folder.path("ours.svg"), saved = folder.path("saved.svg");
  const std::string picture = folder.path("ours.png"), after = folder.path("saved.png");
  ASSERT_EQ(run_sfumato({"convert", "-", "-o", ours}, kDrawing).exit_code, 0);
  const CommandResult save = run_command({"/bin/sh", "-c", command, "sh", ours, saved});
  ASSERT_EQ(save.exit_code, 0) << save.err;
  EXPECT_NE(read_whole(ours), read_whole(saved)) << "nothing was saved";
  ASSERT_EQ(run_sfumato({"render", ours, "-o", picture}).exit_code, 0);
  const CommandResult rendered = run_sfumato({"render", saved, "-o", after});
  ASSERT_EQ(rendered.exit_code, 0) << rendered.err << read_whole(saved);
  // Coordinates are rounded to six digits or so.
  const std::string json = run_sfumato({"compare", "--json", picture, after}).out;
  const std::size_t at = json.find("\"rms\":");
  ASSERT_NE(at, std::string::npos) << json;
  EXPECT_LT(std::atof(json.c_str() + at + 6), 0.2) << json;
}

TEST(Editors, inkscape_keeps_the_picture) {
  if (!is_installed("inkscape")) GTEST_SKIP() << "inkscape is not installed";
  expect_same_picture_after("inkscape \"$1\" --export-type=svg --export-filename=\"$2\"");
}

TEST(Editors, inkscape_keeps_the_picture_in_plain_svg) {
  if (!is_installed("inkscape")) GTEST_SKIP() << "inkscape is not installed";
  expect_same_picture_after("inkscape \"$1\" --export-plain-svg --export-filename=\"$2\"");
}

TEST(Editors, svgo_keeps_the_picture) {
  if (!is_installed("svgo")) GTEST_SKIP() << "svgo is not installed";
  expect_same_picture_after("svgo \"$1\" -o \"$2\"");
}

}  // namespace
}  // namespace sfumato::test
