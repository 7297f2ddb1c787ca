#include <gtest/gtest.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

/// `sfumato render` with outputs that can be enlarged. tests/export checks the content of the
/// files.
namespace sfumato::test {
namespace {

using Names = std::vector<std::string>;

struct Output {
  const char* extension;
  const char* begin;  ///< first bytes of the file
  const char* end;
};

const Output kOutputs[] = {{"html", "<!DOCTYPE html>", "</html>\n"},
                           {"pdf", "%PDF-1.", "%%EOF\n"},
                           {"eps", "%!PS-Adobe-3.0 EPSF-3.0", "%%EOF\n"},
                           {"svg", "<", "</svg>\n"},
                           {"glb", "glTF", ""},
                           {"sfv", "x", ""},
                           {"npz", "PK\x03\x04", ""},
                           {"ply", "ply\n", ""},
                           {"json", "{\"format\":\"sfumato tables\"", "}\n"}};

constexpr const char* kEmptyDrawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" )"
    R"(viewBox="0 0 40 30" sf:version="1"/>)";

TEST(Outputs, the_extension_says_what_is_made) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", two_curve_scene());
  for (const Output& output : kOutputs) {
    const std::string path = folder.path(std::string("a.") + output.extension);
    const CommandResult result = run_sfumato({"render", drawing, "-o", path});
    EXPECT_EQ(result.exit_code, 0) << output.extension << result.err;
    EXPECT_EQ(result.out + result.err, "") << output.extension;
    const std::string file = read_whole(path);
    EXPECT_TRUE(file.starts_with(output.begin)) << output.extension << file.substr(0, 40);
    EXPECT_TRUE(file.ends_with(output.end)) << output.extension;
    const CommandResult piped =
        run_sfumato({"render", drawing, "-o", "-", "--format", output.extension});
    EXPECT_EQ(piped.out, file) << output.extension;
  }
}

TEST(Outputs, are_the_same_for_any_number_of_threads) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", busy_scene(20));
  for (const Output& output : kOutputs) {
    const auto drawn_by = [&](const char* threads) {
      return run_sfumato(
                 {"render", drawing, "-o", "-", "--format", output.extension, "--threads", threads})
          .out;
    };
    const std::string one = drawn_by("1");
    EXPECT_FALSE(one.empty()) << output.extension;
    EXPECT_TRUE(one == drawn_by("3")) << output.extension;
  }
}

TEST(Outputs, of_a_picture_with_nothing_in_it_are_whole) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("empty.svg", kEmptyDrawing);
  for (const Output& output : kOutputs) {
    const CommandResult result =
        run_sfumato({"render", drawing, "-o", "-", "--format", output.extension});
    EXPECT_EQ(result.exit_code, 0) << output.extension << result.err;
    EXPECT_TRUE(result.out.starts_with(output.begin)) << output.extension;
    EXPECT_TRUE(result.out.ends_with(output.end)) << output.extension;
  }
}

TEST(Outputs, where_they_cannot_be_written_is_told_and_nothing_stays) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", two_curve_scene());
  for (const Output& output : kOutputs) {
    const std::string missing = folder.path(std::string("missing/a.") + output.extension);
    const CommandResult result = run_sfumato({"render", drawing, "-o", missing});
    EXPECT_EQ(result.exit_code, 3) << output.extension;
    EXPECT_TRUE(contains(result.err, "cannot be written")) << result.err;
  }
  EXPECT_EQ(folder.names(), Names{"a.xml"});
}

TEST(Outputs, detail_makes_the_mesh_finer) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", busy_scene(20));
  const auto size_at = [&](const char* detail) {
    return run_sfumato({"render", drawing, "-o", "-", "--format", "html", "--detail", detail})
        .out.size();
  };
  EXPECT_LT(size_at("0.5"), size_at("8"));
}

TEST(Outputs, title_is_the_name_of_the_drawing_or_what_was_given) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("Two <curves>.xml", two_curve_scene());
  const auto page = [&](Names options) {
    options.insert(options.begin(), {"render", drawing, "-o", "-", "--format", "html"});
    return run_sfumato(options).out;
  };
  EXPECT_TRUE(contains(page({}), "<title>Two &lt;curves&gt;</title>"));
  EXPECT_TRUE(contains(page({"--title", "A & B"}), "<title>A &amp; B</title>"));
}

TEST(Outputs, pages_have_the_size_that_was_asked_for) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", two_curve_scene());  // 64 × 48
  const auto drawn = [&](const char* format, Names options) {
    options.insert(options.begin(), {"render", drawing, "-o", "-", "--format", format});
    const CommandResult result = run_sfumato(options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  EXPECT_TRUE(contains(drawn("pdf", {}), "/MediaBox [0 0 48 36]"));
  EXPECT_TRUE(contains(drawn("pdf", {"--width", "128"}), "/MediaBox [0 0 96 72]"));
  EXPECT_TRUE(contains(drawn("eps", {"--scale", "2"}), "%%BoundingBox: 0 0 96 72\n"));
  const std::string svg = drawn("svg", {"--scale", "2"});
  EXPECT_TRUE(contains(svg, "width=\"128\" height=\"96\"")) << svg.substr(0, 300);
}

struct BadOutputOption {
  const char* extension;
  Names options;
  const char* expected;
};

TEST(Outputs, options_that_an_output_has_no_place_for_are_named) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", two_curve_scene());
  const BadOutputOption cases[] = {
      {"html", {"--depth", "16"}, "--depth"},
      {"pdf", {"--method", "pixels"}, "images only"},
      {"svg", {"--mesh-overlay"}, "images only"},
      {"glb", {"--dither"}, "images only"},
      {"glb", {"--no-dither"}, "images only"},
      {"html", {"--no-antialias"}, "images only"},
      {"pdf", {"--device", "gpu"}, "images only"},
      {"pdf", {"--width", "10", "--height", "10"}, "only images are stretched"},
      {"pdf", {"--quality", "50"}, "JPEG"},
      {"png", {"--detail", "4"}, "HTML, PDF, EPS, SVG and GLB only"},
      {"webp", {"--dpi", "4"}, "HTML, PDF, EPS, SVG and GLB only"},
      {"png", {"--title", "x"}, "HTML, PDF, EPS, SVG and GLB only"},
      {"npz", {"--detail", "4"}, "HTML, PDF, EPS, SVG and GLB only"},
      {"json", {"--title", "x"}, "HTML, PDF, EPS, SVG and GLB only"},
      {"ply", {"--dpi", "90"}, "HTML, PDF, EPS, SVG and GLB only"},
      {"ply", {"--mesh-overlay"}, "images only"},
      {"pdf", {"--svg", "vector"}, "SVG only"},
      {"svg", {"--force"}, "--svg vector only"},
      {"svg", {"--svg", "flat"}, "one of image|vector"},
      {"pdf", {"--dpi", "0"}, "a number above 0"},
      {"png", {"--device", "gpu", "--method", "pixels"}, "CPU only"},
      {"png", {"--gather", "gpu", "--method", "rays"}, "CPU only"},
  };
  for (const BadOutputOption& bad : cases) {
    Names arguments{"render", drawing, "-o", folder.path(std::string("o.") + bad.extension)};
    arguments.insert(arguments.end(), bad.options.begin(), bad.options.end());
    const CommandResult result = run_sfumato(arguments);
    EXPECT_EQ(result.exit_code, 2) << bad.extension << bad.options[0];
    EXPECT_TRUE(contains(result.err, bad.expected)) << result.err;
  }
  EXPECT_EQ(folder.names(), Names{"a.xml"});
}

TEST(Outputs, what_a_format_cannot_hold_is_a_warning_that_quiet_silences) {
  const TemporaryFolder folder;
  const std::string drawing =
      folder.add("groups.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" )"
                               R"(xmlns:sf="urn:sfumato:1" viewBox="0 0 40 30" )"
                               R"(sf:version="1"><g sf:diffuse="true" )"
                               R"(style="mix-blend-mode: multiply">)"
                               R"(<circle cx="20" cy="15" r="9" sf:left="red" )"
                               R"(sf:right="blue"/></g></svg>)");
  const CommandResult loud = run_sfumato({"render", drawing, "-o", folder.path("a.glb")});
  EXPECT_EQ(loud.exit_code, 0) << loud.err;
  EXPECT_TRUE(contains(loud.err, drawing + ": warning: ")) << loud.err;
  EXPECT_TRUE(contains(loud.err, "blend")) << loud.err;
  const CommandResult quiet =
      run_sfumato({"render", drawing, "-o", folder.path("a.glb"), "--quiet"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.err, "");
}

TEST(Device, a_gpu_draws_or_a_warning_says_that_the_cpu_did) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", two_curve_scene());
  const CommandResult result =
      run_sfumato({"render", drawing, "-o", folder.path("a.png"), "--device", "gpu"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  if (!result.err.empty()) {
    EXPECT_TRUE(contains(result.err, "warning: ")) << result.err;
    EXPECT_TRUE(contains(result.err, "the CPU draws instead")) << result.err;
  }
  const Image image = image_of(read_whole(folder.path("a.png")));
  EXPECT_EQ(image.width, 64);
}

TEST(Device, without_compute_shaders_a_warning_says_so_and_the_cpu_gathers) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", two_curve_scene());
  // Mesa then offers only OpenGL ES 3.0.
  const CommandResult result =
      run_command({"/usr/bin/env", "MESA_GLES_VERSION_OVERRIDE=3.0", sfumato_program(), "render",
                   drawing, "-o", folder.path("gpu.png"), "--method", "pixels", "--gather", "gpu"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  if (result.err.empty()) GTEST_SKIP() << "this driver is not Mesa's";
  EXPECT_TRUE(contains(result.err, "warning: no GPU can be used: ")) << result.err;
  EXPECT_TRUE(contains(result.err, "; the CPU computes the colours instead")) << result.err;
  const CommandResult cpu =
      run_sfumato({"render", drawing, "-o", folder.path("cpu.png"), "--method", "pixels"});
  EXPECT_EQ(cpu.exit_code, 0) << cpu.err;
  EXPECT_EQ(read_whole(folder.path("gpu.png")), read_whole(folder.path("cpu.png")));
}

TEST(Device, a_gpu_gathers_or_a_warning_says_that_the_cpu_did) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("a.xml", two_curve_scene());
  const auto render = [&](const char* method, const char* device) {
    const std::string picture = folder.path("a.png");
    const CommandResult result = run_sfumato({"render", drawing, "-o", picture, "--width", "200",
                                              "--method", method, "--gather", device});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    if (!result.err.empty()) {
      EXPECT_TRUE(contains(result.err, "warning: ")) << result.err;
      EXPECT_TRUE(contains(result.err, "the CPU computes the colours instead")) << result.err;
    }
    return image_of(read_whole(picture));
  };
  for (const char* method : {"exact", "pixels"}) {
    const Image gpu = render(method, "gpu"), cpu = render(method, "cpu");
    ASSERT_EQ(gpu.bytes.size(), cpu.bytes.size());
    for (std::size_t i = 0; i < gpu.bytes.size(); ++i)
      ASSERT_NEAR(gpu.bytes[i], cpu.bytes[i], 1) << method << ' ' << i;
  }
  const CommandResult solved =
      run_sfumato({"solve", drawing, "-o", folder.path("a.sfp"), "--gather", "gpu"});
  EXPECT_EQ(solved.exit_code, 0) << solved.err;
  const CommandResult late =
      run_sfumato({"render", folder.path("a.sfp"), "-o", folder.path("b.png"), "--gather", "gpu"});
  EXPECT_NE(late.exit_code, 0);
  EXPECT_TRUE(contains(late.err, "--gather")) << late.err;
}

}  // namespace
}  // namespace sfumato::test
