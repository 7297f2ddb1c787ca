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

constexpr std::string_view kBlurs[] = {"on", "off", "fixed"};
constexpr std::string_view kStops[] = {"few", "normal", "many"};

constexpr Option<TraceSettings> kTraceOptions[] = {
    {{.key = "points",
      .kind = ValueKind::whole,
      .wholes = {1, limits::kControlPoints},
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.points = static_cast<int>(v.whole); }},
    {{.key = "detail",
      .kind = ValueKind::number,
      .numbers = {0, 1, false},
      .expected = "a number from 0 to 1",
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.detail = v.number; }},
    {{.key = "max-curves",
      .kind = ValueKind::whole,
      .wholes = {1, limits::kCurves},
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.max_curves = static_cast<int>(v.whole); }},
    {{.key = "psnr", .kind = ValueKind::number, .expected = "decibels above 0", .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.psnr_db = *v.number; }},
    {{.key = "smooth",
      .kind = ValueKind::number,
      .numbers = {0, TraceOptions::kMostSmooth, false},
      .expected = "a number of pixels from 0 to 32",
      .calls = kTrace},
     [](TraceSettings& s, const Value& v) { s.trace.smooth_px = *v.number; }},
    {{.key = "stops", .kind = ValueKind::word, .words = kStops, .calls = kTrace},
     [](TraceSettings& s, const Value& v) {
       s.trace.stops = std::array{TraceStops::few, TraceStops::normal, TraceStops::many}[v.word];
     }},
    {{.key = "blur", .kind = ValueKind::word, .words = kBlurs, .calls = kTrace | kFitColors},
     [](TraceSettings& s, const Value& v) {
       s.trace.blur = std::array{TraceBlur::fitted, TraceBlur::sharp, TraceBlur::estimated}[v.word];
     }},
    {{.key = "max-side",
      .kind = ValueKind::whole,
      .wholes = {kLeastSide, limits::kImageSide},
      .calls = kTrace | kFitColors},
     [](TraceSettings& s, const Value& v) { s.trace.max_side = static_cast<int>(v.whole); }},
    {{.key = "seed", .kind = ValueKind::whole, .calls = kTrace | kFitColors},
     [](TraceSettings& s, const Value& v) { s.trace.seed = v.whole; }},
    {{.key = "keep-colors", .kind = ValueKind::flag, .calls = kFitColors},
     [](TraceSettings& s, const Value&) { s.keeps_colors = true; }},
    {{.key = "only", .kind = ValueKind::text, .calls = kFitColors},
     [](TraceSettings& s, const Value& v) { s.only = v.text; }},
    {{.key = "edges-only", .kind = ValueKind::flag, .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.edges_only = true; }},
    {{.key = "no-alpha", .kind = ValueKind::flag, .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.has_opacity = false; }},
    {{.key = "texture", .kind = ValueKind::flag, .calls = kTrace},
     [](TraceSettings& s, const Value&) { s.trace.has_texture = true; }},
};

}  // namespace

int points_of_detail(double detail) {
  return static_cast<int>(std::lround(kFewestPoints * std::pow(kPointsFactor, detail)));
}

std::span<const Option<TraceSettings>> trace_options() {
  return kTraceOptions;
}

}  // namespace sfumato::options
