#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "cli/run_command.hpp"
#include "support/places.hpp"

/// Documents that we wrote, saved by other programs.
namespace sfumato::test {
namespace {

constexpr const char* kEditorsDrawing = R"svg(
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

/// Runs `command`, and requires that it saved something.
void save(const std::string& command, const std::string& ours, const std::string& saved) {
  const CommandResult result = run_command({"/bin/sh", "-c", command, "sh", ours, saved});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(read_whole(ours), read_whole(saved)) << "nothing was saved";
}

double number_or_infinity(const std::string& json, const std::string& key) {
  const std::size_t at = json.find("\"" + key + "\":");
  if (at == std::string::npos) return std::numeric_limits<double>::infinity();
  return std::atof(json.c_str() + at + key.size() + 3);
}

/// Expects nearly the same pixels: coordinates are rounded to six digits or fewer, which moves an
/// edge by a few hundredths of a pixel.
void expect_same_picture(const TemporaryFolder& folder, const std::string& ours,
                         const std::string& saved) {
  const std::string picture = folder.path("ours.png"), after = folder.path("saved.png");
  ASSERT_EQ(run_sfumato({"render", ours, "-o", picture}).exit_code, 0);
  const CommandResult rendered = run_sfumato({"render", saved, "-o", after});
  ASSERT_EQ(rendered.exit_code, 0) << rendered.err << read_whole(saved);
  EXPECT_EQ(rendered.err, "");
  const std::string json = run_sfumato({"compare", "--json", picture, after}).out;
  EXPECT_LT(number_or_infinity(json, "rms"), 0.2) << json;
  EXPECT_LT(number_or_infinity(json, "maximum"), 16) << json;
}

/// Writes our document, saves it by `command`, where $1 is its name and $2 the new one, and
/// compares.
void expect_same_picture_after(const std::string& command) {
  const TemporaryFolder folder;
  const std::string ours = folder.path("ours.svg"), saved = folder.path("saved.svg");
  ASSERT_EQ(run_sfumato({"convert", "-", "-o", ours}, kEditorsDrawing).exit_code, 0);
  save(command, ours, saved);
  expect_same_picture(folder, ours, saved);
}

/// The same for our examples, in their hand-written form, beside their textures.
void expect_same_examples_after(const std::string& command) {
  const TemporaryFolder folder;
  const std::string examples = source_path("examples/");
  for (const std::string texture : {"wood.png", "waves.png", "hemp.png"}) {
    folder.add(texture, read_whole(examples + texture));
  }
  for (const std::string name : {"apple", "fish", "textures"}) {
    SCOPED_TRACE(name);
    const std::string ours = folder.add(name + ".svg", read_whole(examples + name + ".svg"));
    const std::string saved = folder.path(name + "-saved.svg");
    save(command, ours, saved);
    expect_same_picture(folder, ours, saved);
  }
}

constexpr const char* kInkscape = "inkscape \"$1\" --export-type=svg --export-filename=\"$2\"";
constexpr const char* kPlainInkscape =
    "inkscape \"$1\" --export-plain-svg --export-filename=\"$2\"";
constexpr const char* kSvgo = "svgo \"$1\" -o \"$2\"";

TEST(Editors, inkscape_keeps_the_picture) {
  if (!is_installed("inkscape")) GTEST_SKIP() << "inkscape is not installed";
  expect_same_picture_after(kInkscape);
}

TEST(Editors, inkscape_keeps_the_picture_in_plain_svg) {
  if (!is_installed("inkscape")) GTEST_SKIP() << "inkscape is not installed";
  expect_same_picture_after(kPlainInkscape);
}

TEST(Editors, svgo_keeps_the_picture) {
  if (!is_installed("svgo")) GTEST_SKIP() << "svgo is not installed";
  expect_same_picture_after(kSvgo);
}

TEST(Editors, inkscape_keeps_our_examples) {
  if (!is_installed("inkscape")) GTEST_SKIP() << "inkscape is not installed";
  expect_same_examples_after(kInkscape);
}

TEST(Editors, inkscape_keeps_our_examples_in_plain_svg) {
  if (!is_installed("inkscape")) GTEST_SKIP() << "inkscape is not installed";
  expect_same_examples_after(kPlainInkscape);
}

TEST(Editors, svgo_keeps_our_examples) {
  if (!is_installed("svgo")) GTEST_SKIP() << "svgo is not installed";
  expect_same_examples_after(kSvgo);
}

}  // namespace
}  // namespace sfumato::test
