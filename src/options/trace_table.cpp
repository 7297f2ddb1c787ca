#include <array>
#include <cmath>
#include <cstdint>

#include "options/tables.hpp"

// The table of options by which pictures are traced. A file of data: it grows by an entry an
// option.

namespace sfumato::options {
namespace {

constexpr double kFewestPoints = 250;
constexpr double kPointsFactor = 64;
constexpr std::uint64_t kLeastSide = 16;

static_assert(TraceOptions::kMostSmooth == 32, "smooth says so");
static_assert(kLeastSide == 16 && limits::kImageSide == 16'384, "max-side says so");

constexpr std::string_view kBlurs[] = {"on", "off", "fixed"};
constexpr std::string_view kStops[] = {"few", "normal", "many"};

constexpr Option<TraceSettings> kTraceOptions[] = {
    {{.key = "points",
      .kind = ValueKind::whole,
      .wholes = {1, limits::kControlPoints},
      .value_name = "N",
      .help = "Control points at most [2,000 for 640 × 480 pixels]",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.points = static_cast<int>(v.whole); }},
    {{.key = "detail",
      .kind = ValueKind::number,
      .numbers = {0, 1, false},
      .expected = "a number from 0 to 1",
      .value_name = "NUMBER",
      .excludes = "points",
      .help = "Instead: 0 for 250 control points, 1 for 16,000",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.detail = v.number; }},
    {{.key = "max-curves",
      .kind = ValueKind::whole,
      .wholes = {1, limits::kCurves},
      .value_name = "N",
      .help = "Curves at most [as many as there are points for]",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.max_curves = static_cast<int>(v.whole); }},
    {{.key = "psnr",
      .kind = ValueKind::number,
      .expected = "decibels above 0",
      .value_name = "DB",
      .help = "End as soon as the drawing is as near as this",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.psnr_db = *v.number; }},
    {{.key = "smooth",
      .kind = ValueKind::number,
      .numbers = {0, TraceOptions::kMostSmooth, false},
      .expected = "a number of pixels from 0 to 32",
      .value_name = "PIXELS",
      .help = "What is finer is texture, which no curve follows [0]",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.smooth_px = *v.number; }},
    {{.key = "stops",
      .kind = ValueKind::word,
      .words = kStops,
      .help = "How many colours are kept along curves [normal]",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) {
       s.trace.stops = std::array{TraceStops::few, TraceStops::normal, TraceStops::many}[v.word];
     }},
    {{.key = "edges-only",
      .kind = ValueKind::flag,
      .help = "A draft: only edges of the picture",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.edges_only = true; }},
    {{.key = "no-alpha",
      .kind = ValueKind::flag,
      .help = "Transparent pictures as on white; else they become\ndrawings with opacity",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.has_opacity = false; }},
    {{.key = "texture",
      .kind = ValueKind::flag,
      .help = "What the curves miss becomes a texture, which is as\nlarge as a PNG of the picture",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.has_texture = true; }},
    {{.key = "blur",
      .kind = ValueKind::word,
      .words = kBlurs,
      .help = "Blur of curves: fitted together with the colours, none,\n"
              "or from the picture alone [on]",
      .group = Group::drawing,
      .calls = kTrace | kFitColors},
     [](TraceSettings& s, const Value& v) {
       s.trace.blur = std::array{TraceBlur::fitted, TraceBlur::sharp, TraceBlur::estimated}[v.word];
     }},
    {{.key = "max-side",
      .kind = ValueKind::whole,
      .wholes = {kLeastSide, limits::kImageSide},
      .expected = "a whole number of pixels from 16 to 16384",
      .value_name = "PIXELS",
      .help = "A larger picture is looked at in this size [1024]",
      .group = Group::drawing,
      .calls = kTrace | kFitColors},
     [](TraceSettings& s, const Value& v) { s.trace.max_side = static_cast<int>(v.whole); }},
    {{.key = "seed",
      .kind = ValueKind::whole,
      .expected = "a whole number",
      .value_name = "N",
      .help = "Of the choice of pixels that colours are fitted to [0]",
      .group = Group::drawing,
      .calls = kTrace | kFitColors},
     [](TraceSettings& s, const Value& v) { s.trace.seed = v.whole; }},
    {{.key = "only",
      .kind = ValueKind::text,
      .value_name = "CURVES",
      .help = "These curves alone take colours, others stay as they\n"
              "are: LAYER:CURVE, and so on, with commas between,\n"
              "numbers from 0 [all]",
      .group = Group::drawing,
      .calls = kFitColors},
     [](TraceSettings& s, const Value& v) { s.only = v.text; }},
    {{.key = "keep-colors",
      .kind = ValueKind::flag,
      .help = "Colours stay, blur alone is fitted",
      .group = Group::drawing,
      .calls = kFitColors},
     [](TraceSettings& s, const Value&) { s.keeps_colors = true; }},
};

}  // namespace

int points_of_detail(double detail) {
  return static_cast<int>(std::lround(kFewestPoints * std::pow(kPointsFactor, detail)));
}

ColorFit color_fit_of(const TraceSettings& settings) {
  return {.blur = settings.trace.blur,
          .max_side = settings.trace.max_side,
          .seed = settings.trace.seed,
          .keeps_colors = settings.keeps_colors};
}

std::span<const Option<TraceSettings>> trace_options() {
  return kTraceOptions;
}

}  // namespace sfumato::options
