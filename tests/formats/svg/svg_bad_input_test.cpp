// Invalid documents: one clear message with its place.
#include <gtest/gtest.h>

#include "formats/image_files.hpp"
#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

struct BadInput {
  const char* name;
  std::string text;
  const char* message;  ///< text after "a.svg:"
};

class BadSvg : public testing::TestWithParam<BadInput> {};

TEST_P(BadSvg, is_refused_with_place_and_reason) {
  MemoryLoader loader;
  loader.files["wood.png"] = png_file(4, 2);
  loader.files["short.png"] = png_file(40, 20);
  loader.files["short.png"].resize(loader.files["short.png"].size() / 2);
  loader.files["short.jpg"] = jpeg_file(64, 64, 3, {1, 2, 3, 0});
  loader.files["short.jpg"].resize(loader.files["short.jpg"].size() - 20);
  loader.files["text.png"] = {'h', 'i'};
  const Status status = status_of(GetParam().text, &loader);
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(to_string(status), std::string("a.svg:") + GetParam().message);
}

std::string with(const std::string& attributes) {
  return svg_layer("<path d='M0 0 h9' " + attributes + "/>");
}

std::string path(const std::string& data) {
  return svg_layer("<path d='" + data + "'/>");
}

std::string painted_curve(const std::string& paint) {
  return svg_layer("<path d='M0 0 h9' sf:left='url(#p)'/>\n" + paint);
}

std::string textured(const std::string& href, const std::string& rest = "") {
  return painted_curve(
      "<pattern id='p' patternUnits='userSpaceOnUse' width='4' height='2'><image href='" + href +
      "'/>" + rest + "</pattern>");
}

const BadInput kStructure[] = {
    {"not_svg", "<html/>", "1:1: the document is a <html>; use <svg>"},
    {"attribute_twice", svg("<g id='a' class='b' id='c'/>"),
     "2:1: not well-formed XML: the attribute \"id\" is given twice"},
    {"namespace_twice", svg("<g xmlns:a='x' xmlns:a='x'/>"),
     "2:1: not well-formed XML: the attribute \"xmlns:a\" is given twice"},
    {"attribute_by_two_prefixes",
     svg("<g xmlns:a='urn:sfumato:1' a:diffuse='true' sf:diffuse='true'/>"),
     "2:1: the attribute \"sf:diffuse\" is given twice, by two prefixes of urn:sfumato:1"},
    {"not_xml", "hello", " no XML element found; use an SVG or Orzan XML file"},
    {"no_size", "<svg/>", "1:1: <svg> has no size; add viewBox, or width and height"},
    {"size_in_percent", "<svg width='100%' height='50'/>",
     "1:1: width of <svg> is \"100%\", a share of nothing known; add a viewBox"},
    {"no_area", "<svg width='0' height='50'/>",
     "1:1: <svg> has no area; use width and height above 0"},
    {"short_view_box", "<svg viewBox='0 0 9'/>",
     "1:1: viewBox of <svg>: ends too early: expected a number"},
    {"flat_view_box", "<svg viewBox='0 0 9 0'/>",
     "1:1: viewBox of <svg>: the box has no area; use x, y, width and height with a width and "
     "height above 0"},
    {"far_view_box", "<svg viewBox='1e7 0 1 1'/>",
     "1:1: viewBox of <svg> reaches farther than 10000000 from the origin; keep coordinates within "
     "that"},
    {"version", "<svg xmlns:s='urn:sfumato:1' viewBox='0 0 9 9' s:version='2'/>",
     "1:1: sf:version is \"2\"; use 1, the version that is read here"},
    {"namespace_version", "<svg xmlns:sf='urn:sfumato:2' viewBox='0 0 9 9'/>",
     "1:1: the namespace \"urn:sfumato:2\" is not known; use \"urn:sfumato:1\", the format "
     "that this version reads"},
    {"undeclared_prefix", "<svg viewBox='0 0 9 9'>\n<g sf:diffuse='true'/></svg>",
     "2:1: the prefix sf is not declared; add xmlns:sf=\"urn:sfumato:1\" on <svg>"},
    {"element_of_ours", svg("<sf:layer/>"),
     "2:1: the element <sf:layer> means nothing; the namespace urn:sfumato:1 has attributes only"},
    {"interpolation", svg("", "sf:interpolation='hsv'"),
     "1:1: sf:interpolation is \"hsv\"; use srgb, linear or oklab"},
    {"background", svg("", "sf:background='#fff8'"),
     "1:1: sf:background is \"#fff8\"; use an opaque colour, or none"},
    {"diffuse", svg("<g sf:diffuse='yes'/>"),
     "2:1: sf:diffuse of <g> is \"yes\"; use true or false"},
    {"layer_in_layer", svg_layer("<g id='x' sf:diffuse='true'/>"),
     "3:1: the layer #x is inside another layer; put layers side by side"},
    {"local_curve_in_layer", with("sf:left='red' sf:radius='3'"),
     "3:1: <path> with sf:radius is a local curve and stands in a layer; move it before or after "
     "the layer"},
    {"curve_in_no_layer", svg("<path d='M0 0 h9' sf:left='red'/>"),
     "2:1: <path> has attributes of a diffusion curve but stands in no layer; put it in <g "
     "sf:diffuse=\"true\">, or with sf:radius to be a local curve"},
    {"opacity", svg("<g opacity='half'/>"),
     "2:1: opacity of <g> is \"half\"; use a number from 0 to 1 or a percentage"},
};

const BadInput kAttributes[] = {
    {"misspelt", with("sf:lefft='red'"),
     "3:1: there is no attribute sf:lefft; did you mean sf:left?"},
    {"misspelt_opacity", with("sf:left_opacity='1'"),
     "3:1: there is no attribute sf:left_opacity; did you mean sf:left-opacity?"},
    {"unknown", with("sf:zzzzzzzz='1'"),
     "3:1: there is no attribute sf:zzzzzzzz; docs/format.md lists the attributes"},
    {"unknown_in_defs", svg("<defs><path sf:rigth='red'/></defs>"),
     "2:7: there is no attribute sf:rigth; did you mean sf:right?"},
    {"colour_on_group", svg("<g sf:left='red'/>"),
     "2:1: sf:left on <g> means nothing; it belongs on a shape: path, line, polyline, polygon, "
     "circle, ellipse, rect"},
    {"diffuse_on_path", with("sf:diffuse='true'"),
     "3:1: sf:diffuse on <path> means nothing; it belongs on a <g>"},
    {"reference_on_path", with("sf:reference='true'"),
     "3:1: sf:reference on <path> means nothing; it belongs on an <image>"},
    {"repeats_on_path", with("sf:repeats='true'"),
     "3:1: sf:repeats on <path> means nothing; it belongs on a <pattern>"},
    {"version_on_group", svg("<g sf:version='1'/>"),
     "2:1: sf:version on <g> means nothing; it belongs on the outermost <svg>"},
    {"alpha_without_radius", with("sf:alpha='1'"),
     "3:1: sf:alpha on <path> means nothing; it belongs on a shape with sf:radius, a local curve"},
    {"opacity_of_local_curve", svg("<path d='M0 0 h9' sf:radius='3' sf:left-opacity='1'/>"),
     "2:1: sf:left-opacity on <path> means nothing; it belongs on a shape in a layer, one without "
     "sf:radius"},
    {"empty_list", with("sf:left=' '"),
     "3:1: sf:left of <path>: is empty; use a list of "
     "stops"},
    {"missing_stop", with("sf:left='red,,blue'"),
     "3:1: sf:left of <path>: a stop is missing beside a comma"},
    {"comma_at_end", with("sf:left='red,'"),
     "3:1: sf:left of <path>: a stop is missing beside a comma"},
    {"colour", with("sf:left='reed'"),
     "3:1: sf:left of <path>: \"reed\" is not a colour; use a CSS name, #rgb, #rrggbb, rgb(), "
     "hsl(), hwb(), lab(), lch(), oklab(), oklch() or color(); did you mean red?"},
    {"transparent_colour", with("sf:left='red, #0f08'"),
     "3:1: sf:left of <path>: the colour \"#0f08\" is not opaque; use an opaque colour, and "
     "sf:left-opacity, sf:right-opacity or sf:opacity for the opacity"},
    {"current_colour", with("sf:left='currentColor'"),
     "3:1: sf:left of <path>: currentColor depends on where it stands; use the colour itself"},
    {"none_in_list", with("sf:left='none, red'"),
     "3:1: sf:left of <path>: \"none\" is not a stop; use it alone, without other stops and "
     "offsets"},
    {"opacity_of_percent", with("sf:left='red' sf:opacity='50%'"),
     "3:1: sf:opacity of <path>: \"50%\" is not a valid opacity; use a number from 0 to 1; did you "
     "mean 0.5?"},
    {"opacity_of_percent_in_list", with("sf:left='red' sf:left-opacity='1, 12.5% 30%'"),
     "3:1: sf:left-opacity of <path>: \"12.5%\" is not a valid opacity; use a number from 0 to 1; "
     "did "
     "you mean 0.125?"},
    {"opacity_beyond", with("sf:left='red' sf:opacity='101%'"),
     "3:1: sf:opacity of <path>: \"101%\" is not a valid opacity; use a number from 0 to 1"},
    {"offset", with("sf:left='red 5'"),
     "3:1: sf:left of <path>: the offset \"5\" is none; use 0% to 100% of the length, or @ "
     "and a segment like @2.5; did you mean 5%?"},
    {"offset_nan", with("sf:left='red @nan'"),
     "3:1: sf:left of <path>: the offset \"@nan\" is none; use 0% to 100% of the length, or "
     "@ and a segment like @2.5"},
    {"offset_beyond", with("sf:left='red 101%'"),
     "3:1: sf:left of <path>: the offset \"101%\" is none; use 0% to 100% of the length, or "
     "@ and a segment like @2.5"},
    {"two_offsets", with("sf:left='red 1% 2%'"),
     "3:1: sf:left of <path>: \"2%\" follows the offset \"1%\"; use a comma"},
    {"opacity_above_1", with("sf:left-opacity='0, 2'"),
     "3:1: sf:left-opacity of <path>: \"2\" is not a valid opacity; use a number from 0 to 1"},
    {"negative_blur", with("sf:blur='-1'"),
     "3:1: sf:blur of <path>: \"-1\" is not a valid blur radius; use a number from 0 to 10000000"},
    {"nan_blur", with("sf:blur='nan'"),
     "3:1: sf:blur of <path>: \"nan\" is not a valid blur radius; use a number from 0 to 10000000"},
    {"weight", with("sf:weight='0'"), "3:1: sf:weight of <path> is \"0\"; use a number above 0"},
    {"radius", svg("<path d='M0 0 h9' sf:left='red' sf:radius='0, 0'/>"),
     "2:1: sf:radius of <path> is nowhere above 0"},
    {"negative_radius", svg("<path d='M0 0 h9' sf:left='red' sf:radius='-2'/>"),
     "2:1: sf:radius of <path>: \"-2\" is not a valid radius of influence; use a number from 0 to "
     "10000000"},
    {"alpha_in_percent", svg("<path d='M0 0 h9' sf:left='red' sf:radius='2' sf:alpha='80%'/>"),
     "2:1: sf:alpha of <path> is \"80%\"; use 0 or more; did you mean 0.8?"},
    {"alpha", svg("<path d='M0 0 h9' sf:left='red' sf:radius='2' sf:alpha='-1'/>"),
     "2:1: sf:alpha of <path> is \"-1\"; use 0 or more"},
    {"local_curve_without_colour", svg("<path d='M0 0 h9' sf:radius='2'/>"),
     "2:1: the local curve has no colour; add sf:left, sf:right or both"},
    {"paint_on_local_curve", svg("<path d='M0 0 h9' sf:left='url(#a)' sf:radius='2'/>"),
     "2:1: sf:left of <path> is \"url(#a)\"; a local curve takes a list of colours only"},
};

const BadInput kGeometry[] = {
    {"path_garbage", path("M0 0 x"),
     "3:1: d of <path>: at character 6, before \"x\": expected a path command, one of "
     "MmLlHhVvCcSsQqTtAaZz"},
    {"path_without_move", path("L0 0"),
     "3:1: d of <path>: at character 1, before \"L0 0\": expected M or m"},
    {"path_short", path("M0 0 C1 2 3 4 5"), "3:1: d of <path>: ends too early: expected a number"},
    {"path_nan", path("M0 0 Lnan 1"),
     "3:1: d of <path>: at character 7, before \"nan 1\": expected a number"},
    {"path_infinite", path("M0 0 L1e999 1"),
     "3:1: d of <path>: at character 7, before \"1e999 1\": expected a number of at most 10000000 "
     "in magnitude"},
    {"path_flag", path("M0 0 A1 1 0 2 0 3 3"),
     "3:1: d of <path>: at character 13, before \"2 0 3 3\": expected a flag, 0 or 1"},
    {"path_number_after_close", path("M0 0 h1 z 5"),
     "3:1: d of <path>: at character 11, before \"5\": expected a path command, one of "
     "MmLlHhVvCcSsQqTtAaZz"},
    {"odd_points", svg_layer("<polyline points='1 2 3'/>"),
     "3:1: points of <polyline>: ends too early: expected a number"},
    {"negative_radius", svg_layer("<circle r='-1'/>"),
     "3:1: r of <circle> is negative; use 0 or more"},
    {"negative_size", svg_layer("<rect width='-1' height='2'/>"),
     "3:1: the size of <rect> is negative; use 0 or more"},
    {"unit", svg_layer("<circle r='1ell'/>"),
     "3:1: r of <circle>: \"1ell\" has an unknown unit; use px, em, % or another unit of CSS"},
    {"transform", svg_layer("<path transform='rotat(3)' d=''/>"),
     "3:1: transform of <path>: at character 1, before \"rotat(3)\": expected matrix, translate, "
     "scale, rotate, skewX or skewY; did you mean rotate?"},
    {"transform_arguments", svg_layer("<path transform='matrix(1 2)' d=''/>"),
     "3:1: transform of <path>: at character 1, before \"matrix(1 2)\": expected another number of "
     "arguments than 2"},
    {"transform_huge", svg_layer("<g transform='scale(1e7)'><g transform='scale(1e7)'/></g>"),
     "3:27: the transforms around <g> together are too large or too small; use entries of "
     "usual size"},
    {"far_away", svg_layer("<path transform='translate(1e7)' d='M0 0 h9'/>"),
     "3:1: <path> reaches farther than 10000000 from the origin; keep coordinates within that"},
};

const BadInput kReferences[] = {
    {"use_of_nothing", svg("<use/>"), "2:1: <use> has no href"},
    {"use_unknown", svg("<use href='#fisch'/>"),
     "2:1: <use> refers to #fisch, but no element has that id"},
    {"use_of_file", svg("<use href='a.svg#b'/>"),
     "2:1: href of <use> is \"a.svg#b\"; use # and the id of an element of this document"},
    {"use_cycle", svg("<g id='a'><use href='#b'/></g>\n<g id='b'><use href='#a'/></g>"),
     "2:11: the <use> goes round in a circle: #b → #a → #b"},
    {"use_of_itself", svg("<use id='a' href='#a'/>"),
     "2:1: the <use> goes round in a circle: #a → #a"},
    {"use_of_root", svg("<use href='#r'/>", "id='r'"), "2:1: the <use> goes round in a circle: #r"},
    {"paint_unknown", painted_curve(""), "3:1: <path> refers to #p, but no element has that id"},
    {"paint_of_path", painted_curve("<path id='p' d='M0 0 h9'/>"),
     "3:1: <path> is painted by #p, which is a <path>; use a linearGradient, a "
     "radialGradient, or a pattern with one <image>"},
    {"paint_of_file", with("sf:left='url(a.svg)'"),
     "3:1: sf:left of <path> is \"url(a.svg)\"; use url(#id)"},
    {"paint_cycle",
     painted_curve("<linearGradient id='p' href='#q'/><linearGradient id='q' href='#p'/>"),
     "4:1: the hrefs of paints go round in a circle: #p → #q → #p"},
    {"no_stops", painted_curve("<linearGradient id='p' gradientUnits='userSpaceOnUse'/>"),
     "4:1: the gradient has no stops; add at least one"},
    {"flat_box", painted_curve("<linearGradient id='p'><stop/></linearGradient>"),
     "3:1: the bounding box of <path> has no area for <linearGradient> #p of objectBoundingBox "
     "units; use userSpaceOnUse"},
    {"stop_offset",
     painted_curve("<linearGradient id='p' gradientUnits='userSpaceOnUse'><stop offset='x'/>"
                   "</linearGradient>"),
     "4:55: offset of <stop> is \"x\"; use a number from 0 to 1 or a percentage"},
    {"stop_colour",
     painted_curve("<linearGradient id='p' gradientUnits='userSpaceOnUse'><stop stop-color='x'/>"
                   "</linearGradient>"),
     "4:55: stop-color of <stop>: \"x\" is not a colour; use a CSS name, #rgb, #rrggbb, rgb(), "
     "hsl(), hwb(), lab(), lch(), oklab(), oklch() or color()"},
    {"spread",
     painted_curve("<linearGradient id='p' gradientUnits='userSpaceOnUse' "
                   "spreadMethod='x'><stop/></linearGradient>"),
     "4:1: spreadMethod is \"x\"; use pad, reflect or repeat"},
    {"units", painted_curve("<linearGradient id='p' gradientUnits='x'><stop/></linearGradient>"),
     "4:1: gradientUnits is \"x\"; use userSpaceOnUse or objectBoundingBox"},
    {"singular_gradient",
     painted_curve("<linearGradient id='p' gradientUnits='userSpaceOnUse' "
                   "gradientTransform='scale(0)'><stop/></linearGradient>"),
     "4:1: gradientTransform of <linearGradient> cannot be inverted; use a transform that can"},
    {"pattern_of_path", painted_curve("<pattern id='p'><path/></pattern>"),
     "4:1: the pattern holds something else; use exactly one <image>"},
    {"pattern_of_two", textured("wood.png", "<image/>"),
     "4:1: the pattern holds something else; use exactly one <image>"},
    {"pattern_without_size",
     painted_curve("<pattern id='p' patternUnits='userSpaceOnUse'>"
                   "<image href='wood.png'/></pattern>"),
     "4:1: the pattern's tile has no area; use width and height above 0"},
    {"image_turned",
     painted_curve("<pattern id='p' patternUnits='userSpaceOnUse' width='4' height='2'>"
                   "<image href='wood.png' transform='rotate(9)'/></pattern>"),
     "4:68: the <image> is turned or mirrored within its tile; use patternTransform on the "
     "pattern to do that"},
    {"image_of_no_size",
     painted_curve("<pattern id='p' patternUnits='userSpaceOnUse' width='4' "
                   "height='2'><image href='wood.png' width='1e-7'/></pattern>"),
     "4:1: the pattern's tile is too large or too small for its <image>; use sizes of one "
     "kind"},
    {"image_outside",
     painted_curve("<pattern id='p' patternUnits='userSpaceOnUse' width='4' height='2'>"
                   "<image href='wood.png' x='-1'/></pattern>"),
     "4:68: the <image> begins outside of its tile; use its upper left corner at the tile's"},
    {"file_missing", textured("gone.png"), "4:68: \"gone.png\": there is no such file"},
    {"file_remote", textured("https://example.org/a.png"),
     "4:68: \"https://example.org/a.png\" is not read: nothing is fetched; use a file beside "
     "the document, or a data: URI"},
    {"file_local_url", textured("file:///etc/passwd"),
     "4:68: \"file:///etc/passwd\" is not read: nothing is fetched; use a file beside the "
     "document, or a data: URI"},
    {"file_of_text", textured("text.png"),
     "4:68: \"text.png\": the image is neither a PNG nor a JPEG"},
    {"png_cut_short", textured("short.png"),
     "4:68: \"short.png\": the PNG image is damaged: end of stream"},
    {"jpeg_cut_short", textured("short.jpg"),
     "4:68: \"short.jpg\": the JPEG image is damaged: Premature end of JPEG file"},
    {"data_without_comma", textured("data:image/png;base64"),
     "4:68: href of <image>: the data: URI has no comma before its data"},
    {"data_damaged", textured("data:image/png;base64,AA*A"),
     "4:68: href of <image>: the base64 is damaged at its character 3"},
    {"data_short", textured("data:image/png;base64,AAAAA"),
     "4:68: href of <image>: the base64 is cut short"},
    {"data_of_text", textured("data:,hello"),
     "4:68: the data: URI: the image is neither a PNG nor a JPEG"},
};

std::string name_of(const testing::TestParamInfo<BadInput>& input) {
  return input.param.name;
}

INSTANTIATE_TEST_SUITE_P(Structure, BadSvg, testing::ValuesIn(kStructure), name_of);
INSTANTIATE_TEST_SUITE_P(Attributes, BadSvg, testing::ValuesIn(kAttributes), name_of);
INSTANTIATE_TEST_SUITE_P(Geometry, BadSvg, testing::ValuesIn(kGeometry), name_of);
INSTANTIATE_TEST_SUITE_P(References, BadSvg, testing::ValuesIn(kReferences), name_of);

TEST(SvgWithoutLoader, file_is_refused) {
  EXPECT_EQ(to_string(status_of(textured("wood.png"))),
            "a.svg:4:68: \"wood.png\" cannot be read; use a data: URI");
}

}  // namespace
}  // namespace sfumato::test
