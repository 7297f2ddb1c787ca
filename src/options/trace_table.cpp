#include <array>
#include <cmath>
#include <cstdint>

#include "options/tables.hpp"

// The table of the options for tracing pictures. This is a file of data: each option adds an entry.

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
      .help = "Use at most N control points [2,000 for 640 × 480 pixels]",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.points = static_cast<int>(v.whole); }},
    {{.key = "detail",
      .kind = ValueKind::number,
      .numbers = {0, 1, false},
      .expected = "a number from 0 to 1",
      .value_name = "NUMBER",
      .excludes = "points",
      .help = "Set the detail instead of @points: 0 allows 250 control\npoints, 1 allows 16,000",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.detail = v.number; }},
    {{.key = "max-curves",
      .kind = ValueKind::whole,
      .wholes = {1, limits::kCurves},
      .value_name = "N",
      .help = "Make at most N curves [as many as the points allow]",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.max_curves = static_cast<int>(v.whole); }},
    {{.key = "psnr",
      .kind = ValueKind::number,
      .expected = "decibels above 0",
      .value_name = "DB",
      .help = "Stop when the drawing matches the picture this closely",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.psnr_db = *v.number; }},
    {{.key = "smooth",
      .kind = ValueKind::number,
      .numbers = {0, TraceOptions::kMostSmooth, false},
      .expected = "a number of pixels from 0 to 32",
      .value_name = "PIXELS",
      .help = "Ignore details finer than this; no curve follows them [0]",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.smooth_px = *v.number; }},
    {{.key = "stops",
      .kind = ValueKind::word,
      .words = kStops,
      .help = "Choose how many colours to keep along curves [normal]",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) {
       s.trace.stops = std::array{TraceStops::few, TraceStops::normal, TraceStops::many}[v.word];
     }},
    {{.key = "edges-only",
      .kind = ValueKind::flag,
      .help = "Make a draft from the edges of the picture alone",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.edges_only = true; }},
    {{.key = "no-alpha",
      .kind = ValueKind::flag,
      .help = "Put transparent pictures on white instead of making\ndrawings with opacity",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.has_opacity = false; }},
    {{.key = "texture",
      .kind = ValueKind::flag,
      .help = "Store what the curves miss in a texture, about as large\nas a PNG of the picture",
      .group = Group::drawing,
      .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.has_texture = true; }},
    {{.key = "blur",
      .kind = ValueKind::word,
      .words = kBlurs,
      .help = "Choose the blur of curves: fitted with the colours (on),\n"
              "none (off), or estimated from the picture (fixed) [on]",
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
      .help = "Shrink larger pictures to this size for tracing [1024]",
      .group = Group::drawing,
      .calls = kTrace | kFitColors},
     [](TraceSettings& s, const Value& v) { s.trace.max_side = static_cast<int>(v.whole); }},
    {{.key = "seed",
      .kind = ValueKind::whole,
      .expected = "a whole number",
      .value_name = "N",
      .help = "Set the seed that chooses the pixels for fitting colours [0]",
      .group = Group::drawing,
      .calls = kTrace | kFitColors},
     [](TraceSettings& s, const Value& v) { s.trace.seed = v.whole; }},
    {{.key = "only",
      .kind = ValueKind::text,
      .value_name = "CURVES",
      .help = "Recolour only these curves: LAYER:CURVE pairs with commas\n"
              "between, such as 0:4,0:7, counted from 0 [all]",
      .group = Group::drawing,
      .calls = kFitColors},
     [](TraceSettings& s, const Value& v) { s.only = v.text; }},
    {{.key = "keep-colors",
      .kind = ValueKind::flag,
      .help = "Keep the colours and fit only the blur",
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
