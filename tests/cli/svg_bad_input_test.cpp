// Wrong or hostile SVG at the command line: the documented exit code, one line with the place,
// after a short time, with little memory, and no half-written file.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "formats/image_files.hpp"
#include "support/places.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::test {
namespace {

constexpr std::size_t kMillion = 1'000'000;
/// The allowed processor time is a multiple of the time for an example in the same run, so that a
/// slow machine lengthens both; and at least the constant below.
constexpr double kMostReferences = 14;
constexpr double kLittleSeconds = 0.25;
constexpr std::size_t kMostBytes = std::size_t{256} << 20;

/// Debug builds and sanitizers take more time and memory.
#if defined(NDEBUG) && !SFUMATO_HAS_SANITIZER
constexpr bool kIsMeasured = true;
#else
constexpr bool kIsMeasured = false;
#endif

/// Returns a text whose line 1 is the <svg>; the content begins on line 2.
std::string svg_of_lines(const std::string& content) {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 100 50' "
         "sf:version='1'>\n" +
         content + "\n</svg>\n";
}

/// Returns a layer whose only curve, on line 2, has these attributes; then more content.
std::string layer_of_curve(const std::string& attributes, const std::string& more = "") {
  return svg_of_lines("<g sf:diffuse='true'><path d='M9 9h80' " + attributes + "/></g>\n" + more);
}

/// Returns a curve with a gradient on line 3.
std::string gradient(const std::string& attributes, const std::string& stops) {
  return layer_of_curve("sf:left='url(#p)'",
                        "<linearGradient id='p' gradientUnits='userSpaceOnUse' " + attributes +
                            ">" + stops + "</linearGradient>");
}

/// Returns a curve with a texture on line 4.
std::string textured(const std::string& href) {
  return layer_of_curve(
      "sf:left='url(#p)'",
      "<pattern id='p' patternUnits='userSpaceOnUse' width='4' height='4'>\n<image href='" + href +
          "' width='4' height='4'/></pattern>");
}

const std::string kLayer = "<g sf:diffuse='true'><path d='M9 9h80' sf:left='red'/></g>";

/// Returns 10⁹ times `first` through nine groups of ten <use> each, on line 2.
std::string laughs(const std::string& first) {
  std::string groups = "<g id='g0'>" + first + "</g>";
  for (int i = 1; i <= 9; ++i) {
    groups += "<g id='g" + std::to_string(i) + "'>" +
              repeated("<use href='#g" + std::to_string(i - 1) + "'/>", 10) + "</g>";
  }
  return "<defs>" + groups + "</defs>";
}

void set_word(std::string& bytes, std::size_t at, std::size_t value, int byte_count) {
  for (int i = byte_count - 1; i >= 0; --i, value >>= 8) {
    bytes[at + static_cast<std::size_t>(i)] = static_cast<char>(value);
  }
}

/// Returns a PNG of 1 kB whose header claims that size.
std::string lying_png(std::size_t width, std::size_t height) {
  std::string png = text_of(png_file(15, 15));
  set_word(png, 16, width, 4);
  set_word(png, 20, height, 4);
  return png;
}

/// The same as a JPEG.
std::string lying_jpeg(std::size_t width, std::size_t height) {
  std::string jpeg = text_of(jpeg_file(16, 16, 3, {9, 99, 199, 0}));
  const std::size_t frame = jpeg.find("\xFF\xC0");
  set_word(jpeg, frame + 5, height, 2);
  set_word(jpeg, frame + 7, width, 2);
  return jpeg;
}

std::string damaged_png() {
  std::string png = text_of(png_file(15, 15));
  png[60] = static_cast<char>(png[60] ^ 0x5A);
  return png;
}

struct BadDrawing {
  const char* name;
  std::string (*content)();
  int exit_code;
  const char* message;  ///< text after "bad.svg:", to the end of the line
  std::string (*texture)() = nullptr;
};

void PrintTo(const BadDrawing& bad, std::ostream* out) {
  *out << bad.name;
}

std::string name_of_bad_drawing(const testing::TestParamInfo<BadDrawing>& bad) {
  return bad.param.name;
}

class SvgBadInput : public testing::TestWithParam<BadDrawing> {
 protected:
  /// Writes bad.svg and the files that it refers to. This process stays small, because the
  /// commands' memory peak begins at its own.
  SvgBadInput() : input_(folder_.add("bad.svg", GetParam().content())) {
    if (GetParam().texture) folder_.add("texture", GetParam().texture());
  }

  /// Returns the time of a drawing by the mesh of all outputs: that for antialiased pixels takes a
  /// third of it.
  double reference_seconds() {
    return run_sfumato({"render", source_path("examples/sunset.svg"), "--no-antialias", "-o",
                        folder_.path("reference.png")})
        .cpu_seconds;
  }

  void expect_cheap(const CommandResult& result) {
    if (!kIsMeasured) return;
    if (result.cpu_seconds > kLittleSeconds) {
      EXPECT_LT(result.cpu_seconds, kMostReferences * reference_seconds());
    }
    EXPECT_LT(result.peak_bytes, kMostBytes);
  }

  TemporaryFolder folder_;
  std::string input_;
};

TEST_P(SvgBadInput, ends_soon_with_its_exit_code_and_one_line) {
  const BadDrawing& bad = GetParam();
  const std::string output = folder_.add("out.png", "as it was");
  const CommandResult result = run_sfumato({"render", input_, "-o", output});
  EXPECT_EQ(result.exit_code, bad.exit_code);
  EXPECT_EQ(result.err, bad.exit_code == 0 ? "" : input_ + ":" + bad.message + "\n");
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(read_whole(output) == "as it was", bad.exit_code != 0);
  expect_cheap(result);
  const CommandResult info = run_sfumato({"info", input_});
  EXPECT_EQ(info.exit_code, bad.exit_code);
  expect_cheap(info);
}

const BadDrawing kReferences[] = {
    {"undefined_url", [] { return layer_of_curve("sf:left='url(#p)'"); }, 1,
     "2:22: error: <path> refers to #p, but no element has that id"},
    {"undefined_use", [] { return svg_of_lines("<use href='#p'/>"); }, 1,
     "2:1: error: <use> refers to #p, but no element has that id"},
    {"cyclic_use",
     [] { return svg_of_lines("<g id='a'><use href='#b'/></g>\n<g id='b'><use href='#a'/></g>"); },
     1, "2:11: error: the <use> goes round in a circle: #b → #a → #b"},
    {"use_of_its_own_group", [] { return svg_of_lines("<g id='a'><use href='#a'/></g>"); }, 1,
     "2:11: error: the <use> goes round in a circle: #a → #a"},
    {"undefined_href_of_a_gradient", [] { return gradient("href='#q'", ""); }, 1,
     "3:1: error: <linearGradient> refers to #q, but no element has that id"},
    {"cyclic_gradient", [] { return gradient("href='#p'", ""); }, 1,
     "3:1: error: the hrefs of paints go round in a circle: #p → #p"},
    {"cyclic_pattern",
     [] {
       return layer_of_curve("sf:left='url(#p)'",
                             "<pattern id='p' href='#q'/><pattern id='q' href='#p'/>");
     },
     1, "3:1: error: the hrefs of paints go round in a circle: #p → #q → #p"},
    {"long_chain_of_gradients",
     [] {
       std::string chain;
       for (int i = 0; i < 100'000; ++i) {
         chain += "<linearGradient id='p" + std::to_string(i) + "' href='#p" +
                  std::to_string(i + 1) + "'/>";
       }
       return layer_of_curve("sf:left='url(#p0)'", chain);
     },
     3,
     "3:1: error: more than the limit of 256 paints that inherit from each other"
     "; --limit xml-depth=N goes up to 256"},
};

// svg_input_test.cpp has files that are missing or lie elsewhere.
const BadDrawing kTextures[] = {
    {"lying_png", [] { return textured("texture"); }, 3,
     "4:1: error: \"texture\": an image of 60000 × 60000 pixels; the limit is 16384 pixels on a "
     "side; --limit image-side=N goes up to 16384; use a smaller image",
     [] { return lying_png(60'000, 60'000); }},
    {"lying_png_within_the_limits", [] { return textured("texture"); }, 1,
     "4:1: error: \"texture\": the PNG image is damaged: too few bytes for 8000 × 8000 pixels",
     [] { return lying_png(8'000, 8'000); }},
    {"lying_jpeg", [] { return textured("texture"); }, 3,
     "4:1: error: \"texture\": an image of 60000 × 60000 pixels; the limit is 16384 pixels on a "
     "side; --limit image-side=N goes up to 16384; use a smaller image",
     [] { return lying_jpeg(60'000, 60'000); }},
    {"lying_jpeg_within_the_limits", [] { return textured("texture"); }, 1,
     "4:1: error: \"texture\": the JPEG image is damaged: too few bytes for 8000 × 8000 pixels",
     [] { return lying_jpeg(8'000, 8'000); }},
    {"lying_data_uri",
     [] {
       const std::string png = lying_png(16'000, 16'000);
       return textured("data:image/png;base64," + base64_of({png.begin(), png.end()}));
     },
     3,
     "4:1: error: the data: URI: an image of 16000 × 16000 pixels; the limit is 64000000 "
     "texels; raise the limit with --limit texels=N"},
    {"huge_file", [] { return textured("texture"); }, 3,
     "4:1: error: \"texture\": more than the limit of 67108864 bytes in the file"
     "; raise the limit with --limit image-file-bytes=N",
     [] { return text_of(png_file(4, 4)) + std::string(std::size_t{64} << 20, '\0'); }},
    {"corrupt", [] { return textured("texture"); }, 1,
     "4:1: error: \"texture\": the PNG image is damaged: IDAT stream error", damaged_png},
    {"cut_short", [] { return textured("texture"); }, 1,
     "4:1: error: \"texture\": the PNG image is damaged: end of stream",
     [] { return text_of(png_file(15, 15)).substr(0, 500); }},
    {"empty_file", [] { return textured("texture"); }, 1,
     "4:1: error: \"texture\": the image is neither a PNG nor a JPEG, but an empty file",
     [] { return std::string(); }},
    {"text", [] { return textured("texture"); }, 1,
     "4:1: error: \"texture\": the image is neither a PNG nor a JPEG",
     [] { return std::string("hello\n"); }},
};

const BadDrawing kStopLists[] = {
    {"empty", [] { return layer_of_curve("sf:left=''"); }, 1,
     "2:22: error: sf:left of <path>: is empty; use a list of stops"},
    {"of_commas", [] { return layer_of_curve("sf:blur=',,'"); }, 1,
     "2:22: error: sf:blur of <path>: a stop is missing beside a comma"},
    {"empty_gradient", [] { return gradient("", ""); }, 1,
     "3:1: error: the gradient has no stops; add at least one"},
    {"out_of_order", [] { return layer_of_curve("sf:left='red 90%, lime 20%, blue 50%'"); }, 0, ""},
    {"out_of_order_in_a_gradient",
     [] { return gradient("", "<stop offset='.9'/><stop offset='.2' stop-color='red'/>"); }, 0, ""},
    {"nan_offset", [] { return layer_of_curve("sf:left='red nan%'"); }, 1,
     "2:22: error: sf:left of <path>: the offset \"nan%\" is none; use 0% to 100% of the "
     "length, or @ and a segment like @2.5"},
    {"nan_value", [] { return layer_of_curve("sf:left='red' sf:opacity='1, nan'"); }, 1,
     "2:22: error: sf:opacity of <path>: \"nan\" is not a valid opacity; use a number from 0 to 1"},
    {"nan_in_a_gradient", [] { return gradient("", "<stop offset='nan'/>"); }, 1,
     "3:56: error: offset of <stop> is \"nan\"; use a number from 0 to 1 or a percentage"},
    {"million_colours",
     [] { return layer_of_curve("sf:left='red" + repeated(",blue", kMillion) + "'"); }, 3,
     "2:22: error: sf:left of <path>: more than the limit of 10000 stops in one list"
     "; raise the limit with --limit stops-per-list=N"},
    {"million_opacities",
     [] {
       return layer_of_curve("sf:left='red' sf:right-opacity='1" + repeated(",0", kMillion) + "'");
     },
     3,
     "2:22: error: sf:right-opacity of <path>: more than the limit of 10000 stops in one list"
     "; raise the limit with --limit stops-per-list=N"},
    {"million_radii",
     [] {
       return svg_of_lines("<path d='M9 9h80' sf:left='red' sf:radius='1" +
                           repeated(",2", kMillion) + "'/>");
     },
     3,
     "2:1: error: sf:radius of <path>: more than the limit of 10000 stops in one list"
     "; raise the limit with --limit stops-per-list=N"},
    {"million_in_a_gradient", [] { return gradient("", repeated("<stop/>", kMillion)); }, 3,
     "3:70056: error: more than the limit of 10000 stops in one gradient"
     "; raise the limit with --limit stops-per-list=N"},
};

const BadDrawing kBombs[] = {
    {"laughs_of_entities",
     [] {
       std::string entities = "<!ENTITY a0 'ha'>";
       for (int i = 1; i <= 9; ++i) {
         entities += "<!ENTITY a" + std::to_string(i) + " '" +
                     repeated("&a" + std::to_string(i - 1) + ";", 10) + "'>";
       }
       return "<!DOCTYPE svg [" + entities + "]>" + svg_of_lines("<g id='&a9;'>&a9;</g>" + kLayer);
     },
     3,
     "2:8: error: more than the limit of 1048576 bytes of entities; raise the limit with --limit "
     "entity-bytes=N"},
    {"uses_of_layers",
     [] { return svg_of_lines(laughs(repeated(kLayer, 10)) + "<use href='#g9'/>"); }, 3,
     "2:18: error: more than the limit of 200000 layers, local curves and groups after every use "
     "was followed"
     "; raise the limit with --limit stack-items=N"},
    {"uses_of_nothing", [] { return svg_of_lines(laughs("") + "<use href='#g9'/>"); }, 3,
     "2:7: error: more than the limit of 400000 elements read through <use>"
     "; raise the limit with --limit used-elements=N"},
    {"uses_of_curves",
     [] {
       return svg_of_lines(laughs(repeated("<path d='M9 9h9' sf:left='red'/>", 10)) +
                           "<g sf:diffuse='true'><use href='#g9'/></g>");
     },
     3,
     "2:18: error: more than the limit of 200000 curves"
     "; raise the limit with --limit curves=N"},
    {"uses_of_stops",
     [] {
       return svg_of_lines(
           laughs("<path d='M9 9h9' sf:left='red" + repeated(",lime", 9'999) + "'/>") +
           "<g sf:diffuse='true'><use href='#g9'/></g>");
     },
     3,
     "2:18: error: more than the limit of 16777216 bytes read again through <use> or for paints"
     "; raise the limit with --limit used-bytes=N"},
    {"nested_groups",
     [] { return svg_of_lines(repeated("<g>", kMillion) + repeated("</g>", kMillion)); }, 3,
     "2:766: error: more than the limit of 256 elements within each other"
     "; --limit xml-depth=N goes up to 256"},
};

const BadDrawing kValues[] = {
    {"garbage_in_a_path",
     [] { return svg_of_lines("<g sf:diffuse='true'><path d='M0 0 L9 9 @#%'/></g>"); }, 1,
     "2:22: error: d of <path>: at character 11, before \"@#%\": expected a path command, one of "
     "MmLlHhVvCcSsQqTtAaZz"},
    {"bytes_in_a_path",
     [] { return svg_of_lines("<g sf:diffuse='true'><path d='M0 0 \x01\x02'/></g>"); }, 1,
     "2:22: error: d of <path>: at character 6, before \"??\": expected a path command, one of "
     "MmLlHhVvCcSsQqTtAaZz"},
    {"megabyte_of_garbage",
     [] {
       return svg_of_lines("<g sf:diffuse='true'><path d='" + repeated("x", kMillion) + "'/></g>");
     },
     1, "2:22: error: d of <path>: at character 1, before \"xxxxxxxxxxxx\": expected M or m"},
    {"negative_radius_of_a_circle",
     [] { return svg_of_lines("<g sf:diffuse='true'><circle r='-1'/></g>"); }, 1,
     "2:22: error: r of <circle> is negative; use 0 or more"},
    {"negative_radius_of_a_corner",
     [] { return svg_of_lines("<g sf:diffuse='true'><rect width='3' height='3' rx='-1'/></g>"); },
     1, "2:22: error: rx of <rect> is negative; use 0 or more"},
    {"negative_radius_of_blur", [] { return layer_of_curve("sf:left='red' sf:blur='3, -1'"); }, 1,
     "2:22: error: sf:blur of <path>: \"-1\" is not a valid blur radius; use a number from 0 to "
     "10000000"},
    {"negative_radius_of_influence",
     [] { return svg_of_lines("<path d='M9 9h80' sf:left='red' sf:radius='-1'/>"); }, 1,
     "2:1: error: sf:radius of <path>: \"-1\" is not a valid radius of influence; use a number "
     "from 0 "
     "to 10000000"},
    {"negative_radius_of_a_gradient",
     [] {
       return layer_of_curve("sf:left='url(#p)'",
                             "<radialGradient id='p' gradientUnits='userSpaceOnUse' r='-1'><stop/>"
                             "</radialGradient>");
     },
     1, "3:1: error: r is negative; use 0 or more"},
    {"alpha_in_hex", [] { return layer_of_curve("sf:left='#ff000080'"); }, 1,
     "2:22: error: sf:left of <path>: the colour \"#ff000080\" is not opaque; use an opaque "
     "colour, and sf:left-opacity, sf:right-opacity or sf:opacity for the opacity"},
    {"alpha_in_rgba", [] { return layer_of_curve("sf:right='lime, rgba(255,0,0,.5)'"); }, 1,
     "2:22: error: sf:right of <path>: the colour \"rgba(255,0,0,.5)\" is not opaque; use an "
     "opaque colour, and sf:left-opacity, sf:right-opacity or sf:opacity for the opacity"},
    {"alpha_of_transparent", [] { return layer_of_curve("sf:left='transparent'"); }, 1,
     "2:22: error: sf:left of <path>: the colour \"transparent\" is not opaque; use an opaque "
     "colour, and sf:left-opacity, sf:right-opacity or sf:opacity for the opacity"},
    {"alpha_of_1", [] { return layer_of_curve("sf:left='#ff0000ff'"); }, 0, ""},
};

INSTANTIATE_TEST_SUITE_P(References, SvgBadInput, testing::ValuesIn(kReferences),
                         name_of_bad_drawing);
INSTANTIATE_TEST_SUITE_P(Textures, SvgBadInput, testing::ValuesIn(kTextures), name_of_bad_drawing);
INSTANTIATE_TEST_SUITE_P(StopLists, SvgBadInput, testing::ValuesIn(kStopLists),
                         name_of_bad_drawing);
INSTANTIATE_TEST_SUITE_P(Bombs, SvgBadInput, testing::ValuesIn(kBombs), name_of_bad_drawing);
INSTANTIATE_TEST_SUITE_P(Values, SvgBadInput, testing::ValuesIn(kValues), name_of_bad_drawing);

}  // namespace
}  // namespace sfumato::test
