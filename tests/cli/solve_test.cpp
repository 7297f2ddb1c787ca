// `sfumato solve`, and its files as inputs of the other commands.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

/// Returns a drawing with every feature and its own size.
std::string drawing_of_everything() {
  return R"svg(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1"
     width="96" height="72" viewBox="0 0 64 48" sf:version="1">
  <defs><linearGradient id="g" gradientUnits="userSpaceOnUse" x2="64"><stop stop-color="red"/>
    <stop offset="1" stop-color="gold"/></linearGradient></defs>
  <g style="mix-blend-mode:multiply;opacity:.9">
    <g id="a" sf:diffuse="true"><path d="M-1 20 L65 30" sf:left="url(#g)" sf:right="navy"
      sf:blur="0, 3"/></g>
    <use href="#a" transform="translate(9 3) rotate(20)" opacity=".6"/>
  </g>
  <path d="M8 8 C20 2 40 30 60 40" sf:radius="3, 1" sf:left="white" sf:right="lime"/>
</svg>)svg";
}

std::string solved(const std::vector<std::string>& options = {}) {
  std::vector<std::string> call{"solve", "-", "-o", "-"};
  call.insert(call.end(), options.begin(), options.end());
  const CommandResult result = run_sfumato(call, drawing_of_everything());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

TEST(Solve, every_output_of_a_solved_picture_is_that_of_its_drawing) {
  const TemporaryFolder folder;
  folder.add("a.svg", drawing_of_everything());
  struct Case {
    const char* name;
    std::vector<std::string> solving, drawing;
  };
  const Case cases[] = {{"png", {"--max-error", "0.25"}, {"--depth", "16"}},
                        {"html", {"--detail", "2"}, {}},
                        {"pdf", {"--detail", "2"}, {}},
                        {"eps", {"--detail", "2"}, {"--quiet"}},
                        {"glb", {"--detail", "2"}, {"--quiet"}},
                        {"sfv", {"--detail", "2"}, {}},
                        {"svg", {}, {"--svg", "vector", "--quiet"}}};
  for (const Case& one : cases) {
    std::vector<std::string> solve{"solve", folder.path("a.svg"), "-o", folder.path("s.sfp")};
    solve.insert(solve.end(), one.solving.begin(), one.solving.end());
    ASSERT_EQ(run_sfumato(solve).exit_code, 0);
    std::string made[2];
    for (int i = 0; i < 2; ++i) {
      const std::string out = folder.path(std::string("out.") + one.name);
      std::vector<std::string> call{"render", folder.path(i == 0 ? "a.svg" : "s.sfp"), "-o", out};
      call.insert(call.end(), one.drawing.begin(), one.drawing.end());
      if (std::string(one.name) == "html" || std::string(one.name) == "pdf" ||
          std::string(one.name) == "eps") {
        call.insert(call.end(), {"--title", "the same"});
      }
      const CommandResult result = run_sfumato(call);
      ASSERT_EQ(result.exit_code, 0) << one.name << result.err;
      made[i] = read_whole(out);
    }
    EXPECT_TRUE(made[0] == made[1]) << one.name;
  }
}

TEST(Solve, an_image_of_8_bits_is_nearly_that_of_its_drawing) {
  const TemporaryFolder folder;
  folder.add("a.svg", drawing_of_everything());
  const std::vector<std::string> sources{folder.path("a.svg"), folder.path("s.sfp")};
  ASSERT_EQ(run_sfumato({"solve", sources[0], "-o", sources[1]}).exit_code, 0);
  for (const std::string& source : sources) {
    ASSERT_EQ(run_sfumato({"render", source, "-o", source + ".png", "--no-dither"}).exit_code, 0);
  }
  const CommandResult result =
      run_sfumato({"compare", sources[0] + ".png", sources[1] + ".png", "--json"});
  EXPECT_LE(number_after(result.out, "p99"), 2) << result.out;
  EXPECT_GT(number_after(result.out, "maximum"), 0) << "the drawing is solved for its pixels";
}

TEST(Solve, a_solved_picture_is_told_by_its_bytes) {
  const TemporaryFolder folder;
  const std::string path = folder.add("looks_like.svg", solved());
  const CommandResult from_file = run_sfumato({"render", path, "-o", "-"});
  const CommandResult from_pipe = run_sfumato({"render", "-", "-o", "-"}, solved());
  EXPECT_EQ(from_file.exit_code, 0) << from_file.err;
  EXPECT_EQ(image_of(from_file.out).width, 96);
  EXPECT_TRUE(from_file.out == from_pipe.out);
}

TEST(Solve, parts_and_backgrounds_are_chosen_when_it_is_drawn) {
  const std::string picture = solved();
  const CommandResult part = run_sfumato({"render", "-", "-o", "-", "--viewport", "0,0,16,12",
                                          "--width", "32", "--background", "white", "--quiet"},
                                         picture);
  EXPECT_EQ(part.exit_code, 0) << part.err;
  EXPECT_EQ(image_of(part.out).width, 32);
  EXPECT_EQ(image_of(part.out).height, 24);
}

TEST(Solve, a_picture_drawn_larger_than_it_was_solved_for_is_warned_of) {
  const CommandResult larger = run_sfumato({"render", "-", "-o", "-", "--scale", "6"}, solved());
  EXPECT_EQ(larger.exit_code, 0);
  EXPECT_NE(larger.err.find("solved for 1.5 pixels per user unit, drawn at 6"), std::string::npos)
      << larger.err;
}

TEST(Solve, options_without_effect_are_named) {
  const CommandResult result =
      run_sfumato({"render", "-", "-o", "-", "--rays", "9", "--max-error", "2"}, solved());
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err,
            "<stdin>: error: --rays, --max-error: only for drawings, but this is a solved "
            "picture, `sfumato solve` takes them\n");
  EXPECT_EQ(result.out, "");
  const CommandResult pdf =
      run_sfumato({"render", "-", "-o", "-", "--format", "pdf", "--viewport", "0,0,9,9"}, solved());
  EXPECT_EQ(pdf.exit_code, 1);
  EXPECT_NE(pdf.err.find("--viewport"), std::string::npos) << pdf.err;
}

TEST(Solve, info_says_what_is_in_it) {
  const std::string picture = solved();
  const CommandResult table = run_sfumato({"info", "-"}, picture);
  EXPECT_EQ(table.exit_code, 0) << table.err;
  for (const std::string line :
       {"  format                  solved picture, version 2\n",
        "  viewport                64 x 48\n", "  size                    96 x 72 px\n",
        "  solved for              1.5 pixels per user unit\n",
        "  layers                  1 (2 instances)\n", "  groups                  1\n",
        "  local curves            1\n", "  gradients               1\n"}) {
    EXPECT_NE(table.out.find(line), std::string::npos) << line << table.out;
  }
  const CommandResult json = run_sfumato({"info", "--json", "-"}, picture);
  EXPECT_NE(json.out.find("\"format\":\"solved picture\",\"version\":2,\"bytes\":" +
                          std::to_string(picture.size())),
            std::string::npos)
      << json.out;
}

TEST(Solve, other_commands_say_what_it_is) {
  const TemporaryFolder folder;
  const std::string path = folder.add("a.sfp", solved());
  const std::string as_svg = folder.add("b.svg", solved());
  const std::string out = folder.path("out.svg");
  const std::vector<std::vector<std::string>> calls = {
      {"convert", path, "-o", out},     {"lint", path},
      {"trace", path, "-o", out},       {"compare", path, path},
      {"init", out, "--from", path},    {"solve", path, "-o", folder.path("c.sfp")},
      {"edit", as_svg, "--no-browser"},
  };
  for (const std::vector<std::string>& call : calls) {
    if (call[0] == "edit") continue;  // needs the editor's page
    const CommandResult result = run_sfumato(call);
    EXPECT_EQ(result.exit_code, 1) << call[0];
    EXPECT_NE(result.err.find("this is a solved picture; use "), std::string::npos)
        << call[0] << ": " << result.err;
  }
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST(Solve, damaged_files_are_refused_in_plain_words) {
  const std::string good = solved();
  struct Case {
    std::string bytes;
    const char* words;
  };
  std::string altered = good, later = good, swapped = good;
  altered[good.size() / 2] ^= 4;
  later[7] = 9;
  std::swap(swapped[8], swapped[11]);
  std::swap(swapped[9], swapped[10]);
  const Case cases[] = {
      {good.substr(0, good.size() / 2), " bytes, "},
      {altered, "damaged: the checksum of its bytes is another"},
      {later, "a solved picture of version 9; only version 2 can be read"},
      {swapped, "a solved picture of a machine with the other byte order"},
  };
  for (const Case& one : cases) {
    for (const char* command : {"render", "info"}) {
      std::vector<std::string> call{command, "-"};
      if (call[0] == "render") call.insert(call.end(), {"-o", "-"});
      const CommandResult result = run_sfumato(call, one.bytes);
      EXPECT_EQ(result.exit_code, 1) << one.words;
      EXPECT_NE(result.err.find(one.words), std::string::npos) << result.err;
      EXPECT_EQ(result.err.find("<stdin>: error: "), 0u) << result.err;
      EXPECT_EQ(result.out, "");
    }
  }
}

TEST(Solve, limits_end_it) {
  const CommandResult bytes =
      run_sfumato({"render", "-", "-o", "-", "--limit", "input-bytes=100"}, solved());
  EXPECT_EQ(bytes.exit_code, 3) << bytes.err;
  const CommandResult layers = run_sfumato({"info", "-", "--limit", "layers=0"}, solved());
  EXPECT_EQ(layers.exit_code, 3) << layers.err;
}

TEST(Solve, wrong_calls_are_refused) {
  const TemporaryFolder folder;
  const std::string in = folder.add("a.svg", drawing_of_everything());
  const auto error_of = [&](std::vector<std::string> call) {
    const CommandResult result = run_sfumato(std::move(call));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    return result.err;
  };
  EXPECT_NE(error_of({"solve", in, "-o", folder.path("a.png")}).find("ends in .sfp, or -"),
            std::string::npos);
  EXPECT_NE(error_of({"render", in, "-o", folder.path("a.sfp")}).find("`sfumato solve`"),
            std::string::npos);
  EXPECT_NE(error_of({"solve", in, "-o", folder.path("a.sfp"), "--method", "pixels"})
                .find("makes no solved picture"),
            std::string::npos);
  EXPECT_NE(error_of({"solve", in, "-o", folder.path("a.sfp"), "--scale", "2", "--width", "9"})
                .find("--scale"),
            std::string::npos);
  error_of({"solve", in});
  error_of({"solve", in, "-o", folder.path("a.sfp"), "--quality", "3"});
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(Solve, many_drawings_go_into_a_folder) {
  const TemporaryFolder folder;
  folder.add("a.svg", drawing_of_everything());
  folder.add("b.xml", two_curve_scene());
  const CommandResult result = run_sfumato({"solve", folder.path("a.svg"), folder.path("b.xml"),
                                            "--out-dir", folder.path("out"), "--stats", "-"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_FALSE(read_whole(folder.path("out/a.sfp")).empty());
  EXPECT_FALSE(read_whole(folder.path("out/b.sfp")).empty());
  EXPECT_NE(result.out.find("b.xml\",\"curves\":2"), std::string::npos) << result.out;
}

TEST(Solve, the_file_is_replaced_in_one_step_or_not_at_all) {
  const TemporaryFolder folder;
  const std::string in = folder.add("a.svg", drawing_of_everything());
  const std::string out = folder.add("a.sfp", "as it was");
  EXPECT_EQ(run_sfumato({"solve", in, "-o", out, "--limit", "curves=0"}).exit_code, 3);
  EXPECT_TRUE(read_whole(out) == "as it was");
  EXPECT_EQ(run_sfumato({"solve", in, "-o", "/dev/full"}).exit_code, 2);  // not an .sfp
  EXPECT_EQ(run_sfumato({"solve", in, "-o", out}).exit_code, 0);
  EXPECT_EQ(folder.names().size(), 2u);
}

}  // namespace
}  // namespace sfumato::test
