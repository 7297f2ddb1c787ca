#include <cstdint>
#include <limits>

#include "document/names.hpp"
#include "options/tables.hpp"

// The tables of the options that limit work and of the options that only the C interface has.

namespace sfumato::options {
namespace {

constexpr std::uint64_t kLargestMemoryMib = std::uint64_t{1} << 24;
constexpr double kLargestSeconds = 1e9;
constexpr std::uint64_t kLargestTriangles = 1'000'000'000;
static_assert(limits::kMemoryBytes >> 20 == 2048 && limits::kSeconds == 60, "the help says so");

constexpr Option<Resources> kResourceOptions[] = {
    {{.key = "max-memory",
      .kind = ValueKind::whole,
      .wholes = {1, kLargestMemoryMib},
      .expected = "a whole number of MiB, at least 1",
      .value_name = "MIB",
      .help = "Stop rather than use more memory [2048]",
      .group = Group::resources,
      .calls = kContext},
     [](Resources& r, const Value& v) {
       r.memory_bytes = static_cast<std::size_t>(v.whole) << 20;
     }},
    {{.key = "max-time",
      .kind = ValueKind::number,
      .numbers = {0, kLargestSeconds},
      .instead = "off",
      .expected = "a number of seconds above 0, or off",
      .value_name = "SECONDS|off",
      .help = "Stop a drawing that takes longer than this [60]",
      .group = Group::resources,
      .calls = kContext},
     [](Resources& r, const Value& v) { r.seconds = v.number; }},
};

constexpr std::string_view kSimdLevels[] = {"sse2", "avx2", "avx512"};

constexpr Option<ContextSettings> kContextOptions[] = {
    {{.key = "simd", .kind = ValueKind::word, .words = kSimdLevels, .calls = kContext},
     [](ContextSettings& s, const Value& v) { s.simd = static_cast<SimdLevel>(v.word); }},
};
static_assert(static_cast<int>(SimdLevel::avx512) == 2, "in the order of the words");

constexpr Option<PictureSettings> kPictureOptions[] = {
    {{.key = "drags", .kind = ValueKind::flag, .calls = kSolve},
     [](PictureSettings& s, const Value&) {
       if (!s.drag_triangles) s.drag_triangles = std::numeric_limits<std::size_t>::max();
     }},
    {{.key = "pixel-grid", .kind = ValueKind::flag, .calls = kSolve},
     [](PictureSettings& s, const Value&) { s.pixel_grid = true; }},
    {{.key = "drag-triangles",
      .kind = ValueKind::whole,
      .wholes = {0, kLargestTriangles},
      .calls = kSolve},
     [](PictureSettings& s, const Value& v) {
       s.drag_triangles = static_cast<std::size_t>(v.whole);
     }},
};

constexpr Option<LintSettings> kLintOptions[] = {
    {{.key = "verbose", .kind = ValueKind::flag, .calls = kLint},
     [](LintSettings& s, const Value&) { s.verbose = true; }},
};

constexpr Option<DocumentSettings> kDocumentOptions[] = {
    {{.key = "artboard",
      .kind = ValueKind::box,
      .expected = "x,y,width,height in user units, width and height above 0, no edge beyond 1e7",
      .calls = kNewDocument},
     [](DocumentSettings& s, const Value& v) { s.artboard = v.box; }},
    {{.key = "interpolation", .kind = ValueKind::word, .words = kSpaceNames, .calls = kNewDocument},
     [](DocumentSettings& s, const Value& v) {
       s.interpolation = static_cast<InterpolationSpace>(v.word);
     }},
    {{.key = "background",
      .kind = ValueKind::color,
      .expected = "an opaque CSS colour such as gold, #rrggbb or rgb(255 165 0), or none",
      .calls = kNewDocument},
     [](DocumentSettings& s, const Value& v) { s.background = v.color; }},
};

}  // namespace

std::span<const Option<Resources>> resource_options() {
  return kResourceOptions;
}

std::span<const Option<ContextSettings>> context_options() {
  return kContextOptions;
}

std::span<const Option<PictureSettings>> picture_options() {
  return kPictureOptions;
}

std::span<const Option<LintSettings>> lint_options() {
  return kLintOptions;
}

std::span<const Option<DocumentSettings>> document_options() {
  return kDocumentOptions;
}

}  // namespace sfumato::options
