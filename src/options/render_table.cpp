#include <array>

#include "options/tables.hpp"

// The table of the options for solving, drawing and writing drawings. This is a file of data: each
// option adds an entry.

namespace sfumato::options {
namespace {

constexpr std::uint64_t kLargestCount = 1'000'000'000;
constexpr double kLargestMinAngleDeg = 33;
constexpr double kLargestMaxError = 255;
static_assert(RasterWindow::kLargestSide == 16'777'216, "window says so");

constexpr std::string_view kMethods[] = {"exact", "rays", "pixels"};
constexpr std::string_view kEnds[] = {"soft", "paper"};
constexpr std::string_view kOrders[] = {"linear", "quadratic", "cubic"};
constexpr std::string_view kDepths[] = {"8", "16"};
constexpr std::string_view kSvgModes[] = {"image", "vector"};
constexpr std::string_view kPdfFlattens[] = {"auto", "always", "never"};
constexpr std::string_view kDevices[] = {"cpu", "gpu"};

/// Returns the meaning of a word: kMeanings has one for each word of the option, in their order.
template <auto... kMeanings>
auto meaning(const Value& value) {
  return std::array{kMeanings...}[value.word];
}

constexpr Option<Settings> kRenderOptions[] = {
    {{.key = "viewport",
      .kind = ValueKind::box,
      .expected = "x,y,width,height in user units, width and height above 0, no edge beyond 1e7",
      .value_name = "X,Y,W,H",
      .help = "Draw only this part, in user units [the artboard]",
      .group = Group::place,
      .calls = kSolve | kRaster | kExport | kField | kWeights},
     [](Settings& s, const Value& v) { s.diffuse.viewport = v.box; }},
    {{.key = "width",
      .kind = ValueKind::whole,
      .wholes = {1, kLargestCount},
      .expected = "a whole number of pixels, at least 1",
      .value_name = "PIXELS",
      .help = "Set the width; the height follows [the drawing's]",
      .group = Group::place,
      .calls = kSolve | kRaster | kExport | kField | kWeights},
     [](Settings& s, const Value& v) { s.size.width = static_cast<int>(v.whole); }},
    {{.key = "height",
      .kind = ValueKind::whole,
      .wholes = {1, kLargestCount},
      .expected = "a whole number of pixels, at least 1",
      .value_name = "PIXELS",
      .help = "Set the height; the width follows [the drawing's]",
      .group = Group::place,
      .calls = kSolve | kRaster | kExport | kField | kWeights},
     [](Settings& s, const Value& v) { s.size.height = static_cast<int>(v.whole); }},
    {{.key = "scale",
      .kind = ValueKind::number,
      .expected = "a number above 0",
      .value_name = "NUMBER",
      .help = "Set the size as pixels per user unit instead of @width\nand @height [1, or from the "
              "drawing's width and height]",
      .group = Group::place,
      .calls = kSolve | kRaster | kExport | kField | kWeights},
     [](Settings& s, const Value& v) { s.size.scale = v.number; }},
    {{.key = "method",
      .kind = ValueKind::word,
      .words = kMethods,
      .help = "Choose how to solve: exact (closed form on a mesh), rays\n(random rays on a mesh) "
              "or pixels (closed form at every\npixel, slow) [exact]",
      .group = Group::solution,
      .calls = kSolve},
     [](Settings& s, const Value& v) {
       s.method = meaning<Method::exact, Method::rays, Method::pixels>(v);
       s.diffuse.gather.method =
           s.method == Method::rays ? gather::Method::rays : gather::Method::exact;
     }},
    {{.key = "rays",
      .kind = ValueKind::whole,
      .wholes = {1, limits::kRays},
      .value_name = "N",
      .help = "Shoot N rays at each node with @method=rays [64]",
      .group = Group::solution,
      .calls = kSolve},
     [](Settings& s, const Value& v) {
       s.diffuse.gather.rays_per_node = static_cast<int>(v.whole);
     }},
    {{.key = "seed",
      .kind = ValueKind::whole,
      .expected = "a whole number",
      .value_name = "N",
      .help = "Set the seed of the random rays [0]",
      .group = Group::solution,
      .calls = kSolve},
     [](Settings& s, const Value& v) { s.diffuse.gather.seed = v.whole; }},
    {{.key = "tolerance",
      .kind = ValueKind::number,
      .expected = "a number of user units above 0",
      .value_name = "UNITS",
      .help = "Set the largest distance between a curve and its chords\n[0.04 pixels, at most 0.05 "
              "on an "
              "artboard of 512]",
      .group = Group::solution,
      .calls = kSolve | kField | kWeights},
     [](Settings& s, const Value& v) { s.diffuse.tolerance = v.number; }},
    {{.key = "ends",
      .kind = ValueKind::word,
      .words = kEnds,
      .help = "Choose how colours meet beyond an open curve's end:\nblended (soft), or in a thin "
              "wedge (paper) [soft]",
      .group = Group::solution,
      .calls = kSolve | kField},
     [](Settings& s, const Value& v) {
       s.diffuse.ends = meaning<gather::Ends::soft, gather::Ends::paper>(v);
     }},
    {{.key = "no-blur",
      .kind = ValueKind::flag,
      .help = "Draw every curve sharp",
      .group = Group::solution,
      .calls = kSolve | kField | kWeights},
     [](Settings& s, const Value&) { s.diffuse.ignore_blur = true; }},
    {{.key = "max-error",
      .kind = ValueKind::number,
      .numbers = {0, kLargestMaxError},
      .instead = "off",
      .expected = "a number above 0 and at most 255, or off",
      .value_name = "E|off",
      .help = "Refine the mesh where it is wrong by more than E code\nvalues of 255; off: do not "
              "refine "
              "[1; with 16 bits 0.25]",
      .group = Group::mesh,
      .calls = kSolve | kField | kWeights},
     [](Settings& s, const Value& v) {
       s.diffuse.max_error = v.number.value_or(0);
       s.sets_max_error = true;
     }},
    {{.key = "max-area",
      .kind = ValueKind::fraction,
      .expected = "a fraction above 0 and at most 1, such as 0.04 or 4%",
      .value_name = "FRACTION",
      .help = "Set the largest triangle, as a fraction of the artboard [4%]",
      .group = Group::mesh,
      .calls = kSolve},
     [](Settings& s, const Value& v) { s.diffuse.max_area_fraction = *v.number; }},
    {{.key = "min-angle",
      .kind = ValueKind::number,
      .numbers = {0, kLargestMinAngleDeg, false},
      .expected = "degrees from 0 to 33",
      .value_name = "DEGREES",
      .help = "Set the smallest angle of triangles, where the curves\nallow it [22]",
      .group = Group::mesh,
      .calls = kSolve},
     [](Settings& s, const Value& v) { s.diffuse.min_angle_deg = *v.number; }},
    {{.key = "order",
      .kind = ValueKind::word,
      .words = kOrders,
      .help = "Choose how to interpolate inside a triangle [cubic]",
      .group = Group::mesh,
      .calls = kSolve},
     [](Settings& s, const Value& v) {
       s.diffuse.order = meaning<PatchOrder::linear, PatchOrder::quadratic, PatchOrder::cubic>(v);
     }},
    {{.key = "mesh-overlay",
      .kind = ValueKind::flag,
      .help = "Draw the mesh on top of the picture",
      .group = Group::mesh,
      .calls = kRaster | kExport},
     [](Settings& s, const Value&) { s.raster.mesh_overlay = true; }},
    {{.key = "window",
      .kind = ValueKind::pixels,
      .expected = "x,y,width,height in whole pixels, x and y at least 0, width and height at least "
                  "1, no edge beyond 16777216",
      .value_name = "X,Y,W,H",
      .help = "Render only W x H pixels at (X, Y) of the full image; they\nmatch a full render "
              "[the full image]",
      .group = Group::image,
      .calls = kRaster | kExport},
     [](Settings& s, const Value& v) { s.window = v.pixels; }},
    {{.key = "background",
      .kind = ValueKind::color,
      .expected = "an opaque CSS colour such as gold, #rrggbb or rgb(255 165 0), or none",
      .value_name = "COLOR",
      .help = "Set the colour behind transparent parts; none: ignore the\ndrawing's too [the "
              "drawing's, "
              "or none; JPEG, EPS: white]",
      .group = Group::image,
      .calls = kRaster | kExport | kPayload},
     [](Settings& s, const Value& v) {
       s.raster.background = v.color;
       s.no_background = !v.color;
     }},
    {{.key = "depth",
      .kind = ValueKind::word,
      .words = kDepths,
      .help = "Set the bits per channel; 16: PNG and raw frames only [8]",
      .group = Group::image,
      .calls = kExport},
     [](Settings& s, const Value& v) { s.depth = meaning<8, 16>(v); }},
    {{.key = "dither",
      .kind = ValueKind::flag,
      .help = "Hide colour steps in 8-bit images with blue noise below\none code value [on with "
              "PNG and WebP]",
      .group = Group::image,
      .calls = kRaster | kExport},
     [](Settings& s, const Value&) { s.dither = true; }},
    {{.key = "no-dither",
      .kind = ValueKind::flag,
      .excludes = "dither",
      .help = "Round to the nearest code value [on with JPEG]",
      .group = Group::image,
      .calls = kRaster | kExport},
     [](Settings& s, const Value&) { s.dither = false; }},
    {{.key = "quality",
      .kind = ValueKind::whole,
      .wholes = {1, 100},
      .value_name = "N",
      .help = "Set the quality of JPEG and WebP, 1 to 100 [90]",
      .group = Group::image,
      .calls = kExport | kEncode},
     [](Settings& s, const Value& v) { s.output.quality = static_cast<int>(v.whole); }},
    {{.key = "lossless",
      .kind = ValueKind::flag,
      .help = "Write a WebP that keeps every pixel",
      .group = Group::image,
      .calls = kExport | kEncode},
     [](Settings& s, const Value&) { s.output.lossless = true; }},
    {{.key = "no-antialias",
      .kind = ValueKind::flag,
      .help = "Draw hard edges at curves",
      .group = Group::image,
      .calls = kRaster | kExport},
     [](Settings& s, const Value&) { s.raster.antialias = false; }},
    {{.key = "detail",
      .kind = ValueKind::number,
      .expected = "a number above 0",
      .value_name = "NUMBER",
      .help = "Make the mesh fine enough to enlarge the picture this\nmany times [2; vector SVG 1]",
      .group = Group::vector,
      .calls = kSolve},
     [](Settings& s, const Value& v) { s.output.detail = v.number; }},
    {{.key = "dpi",
      .kind = ValueKind::number,
      .expected = "a number above 0",
      .value_name = "NUMBER",
      .help = "Set the resolution of parts stored as pixels; a user unit\nis 1/96 inch [300; SVG "
              "and GLB 192]",
      .group = Group::vector,
      .calls = kExport},
     [](Settings& s, const Value& v) { s.output.dpi = v.number; }},
    {{.key = "svg",
      .kind = ValueKind::word,
      .words = kSvgModes,
      .help = "Choose the kind of SVG: image (one PNG in it) or vector\n(triangles of gradients) "
              "[image]",
      .group = Group::vector,
      .calls = kExport},
     [](Settings& s, const Value& v) {
       s.output.svg = meaning<SvgMode::image, SvgMode::vector>(v);
     }},
    {{.key = "force",
      .kind = ValueKind::flag,
      .help = "Write a vector SVG even if it is very large",
      .group = Group::vector,
      .calls = kExport},
     [](Settings& s, const Value&) { s.output.force = true; }},
    {{.key = "pdf-flatten",
      .kind = ValueKind::word,
      .words = kPdfFlattens,
      .help = "Store layers of a PDF as pixels; auto: only layers that\nare slow to show in some "
              "programs [auto]",
      .group = Group::vector,
      .calls = kExport},
     [](Settings& s, const Value& v) {
       s.output.pdf_flatten =
           meaning<PdfFlatten::automatic, PdfFlatten::always, PdfFlatten::never>(v);
     }},
    {{.key = "title",
      .kind = ValueKind::text,
      .value_name = "TEXT",
      .help = "Set the title of HTML, PDF and EPS [the drawing's file\nname]",
      .group = Group::vector,
      .calls = kExport},
     [](Settings& s, const Value& v) { s.output.title = v.text; }},
    {{.key = "device",
      .kind = ValueKind::word,
      .words = kDevices,
      .help = "Choose the device that draws pixels; gpu: OpenGL ES, if\navailable [cpu]",
      .group = Group::running},
     [](Settings& s, const Value& v) { s.device = meaning<Device::cpu, Device::gpu>(v); }},
    {{.key = "gather",
      .kind = ValueKind::word,
      .words = kDevices,
      .help = "Choose the device that computes colours; gpu: OpenGL ES\n3.1 compute shaders, if "
              "available "
              "[cpu]",
      .group = Group::running},
     [](Settings& s, const Value& v) { s.gather = meaning<Device::cpu, Device::gpu>(v); }},
    {{.key = "coherent",
      .kind = ValueKind::flag,
      .help =
          "Treat the drawings as frames of a film: each starts from\nthe mesh of the frame before, "
          "to avoid flicker",
      .group = Group::running,
      .calls = kSolve},
     [](Settings& s, const Value&) { s.coherent = true; }},
    {{.key = "threads",
      .kind = ValueKind::whole,
      .wholes = {1, limits::kThreads},
      .value_name = "N",
      .help = "Use N threads; the picture does not depend on N [all cores]",
      .group = Group::running,
      .calls = kContext},
     [](Settings& s, const Value& v) { s.threads = static_cast<int>(v.whole); }},
};

}  // namespace

std::span<const Option<Settings>> render_options() {
  return kRenderOptions;
}

}  // namespace sfumato::options
