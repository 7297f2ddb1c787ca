// Options and a small picture to a drawing: valid, with curves near the picture, the same on every
// instruction set, and the same text after writing, reading and writing.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "fuzz.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/trace/trace.hpp"

using namespace sfumato;

namespace {

constexpr unsigned kMostSide = 48;
/// More control points would only take time.
constexpr int kMostPoints = 160;

/// How far from the picture a control point may lie: a share of its longer side, and extra pixels.
constexpr double kReach = 0.25;
constexpr double kReachPx = 4;

TraceOptions read_options(fuzz::ByteReader& bytes) {
  TraceOptions options;
  options.points = 1 + bytes.byte() * kMostPoints / 256;
  options.max_curves = static_cast<int>(bytes.below(16));
  options.psnr_db = bytes.below(64);
  const unsigned kinds = bytes.byte();
  options.blur = std::array{TraceBlur::fitted, TraceBlur::estimated, TraceBlur::sharp}[kinds % 3];
  options.stops = std::array{TraceStops::few, TraceStops::normal, TraceStops::many}[kinds / 3 % 3];
  const unsigned flags = bytes.byte();
  options.edges_only = (flags & 1) != 0;
  options.has_opacity = (flags & 2) == 0;
  options.has_texture = (flags & 4) != 0;
  if ((flags & 8) != 0) options.smooth_px = bytes.unit() * TraceOptions::kMostSmooth;
  if ((flags & 16) != 0) options.max_side = 1 + static_cast<int>(bytes.below(kMostSide));
  options.seed = bytes.byte();
  return options;
}

/// Fills cells of a few pixels with channels from the remaining bytes, repeated as needed.
Image read_picture(fuzz::ByteReader& bytes) {
  Image image;
  image.width = 1 + static_cast<int>(bytes.below(kMostSide));
  image.height = 1 + static_cast<int>(bytes.below(kMostSide));
  const unsigned kind = bytes.byte();
  image.format = std::array{PixelFormat::rgb8, PixelFormat::rgba8, PixelFormat::rgb16,
                            PixelFormat::rgba16}[kind % 4];
  const int cell = 1 + static_cast<int>(kind / 4 % 16);
  const fuzz::Bytes levels = bytes.rest();
  const int across = (image.width + cell - 1) / cell;
  const int channels = channel_count(image.format);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int first = (y / cell * across + x / cell) * channels;
      for (int c = 0; c < channels; ++c) {
        const auto at = static_cast<std::size_t>(first + c);
        const std::uint8_t level = levels.empty() ? 0 : levels[at % levels.size()];
        image.bytes.insert(image.bytes.end(), bytes_per_channel(image.format), level);
      }
    }
  }
  return image;
}

void check_curves(const Document& drawing, const Image& picture) {
  const double reach = kReach * std::max(picture.width, picture.height) + kReachPx;
  for (const Layer& layer : drawing.layers) {
    for (const Curve& curve : layer.curves) {
      for (const Vec2 p : curve.control_points) {
        fuzz::require(p.x >= -reach && p.x <= picture.width + reach && p.y >= -reach &&
                          p.y <= picture.height + reach,
                      "a curve that is far from the picture");
      }
    }
  }
}

void check_stats(const TraceStats& stats) {
  fuzz::require(!stats.rounds.empty(), "no round");
  for (const TraceState& state : stats.rounds) {
    fuzz::require(!std::isnan(state.psnr_db), "a PSNR that is no number");
    fuzz::require(state.curves > 0, "not even a frame");
  }
  fuzz::require(std::isfinite(stats.noise) && std::isfinite(stats.median_length_px),
                "a measure that is not finite");
  if (stats.textured_psnr_db) {
    fuzz::require(*stats.textured_psnr_db > 44, "a texture that leaves much");
  }
}

std::string traced(SimdLevel level, const Image& picture, const TraceOptions& options) {
  Context context{.budget = Budget(fuzz::kBudgetBytes), .simd = level};
  TraceStats stats;
  const Result<Document> drawing = trace(context, picture, options, &stats);
  fuzz::require_ok(drawing.status(), "no drawing");
  fuzz::require(context.budget.used() == 0, "a trace keeps what it charged");
  fuzz::require_ok(validate(context, *drawing), "an invalid drawing");
  check_curves(*drawing, picture);
  check_stats(stats);
  const Result<std::string> text = write_svg(context, *drawing);
  fuzz::require_ok(text.status(), "a drawing that cannot be written");
  return *text;
}

void check_file(const std::string& text) {
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  const Result<ReadDocument> read = read_document(context, text, "traced.svg");
  fuzz::require_ok(read.status(), "a drawing that cannot be read");
  fuzz::require(read->warnings.empty(), "a drawing that is read with a warning");
  const Result<std::string> again = write_svg(context, read->document);
  fuzz::require(again && *again == text, "a drawing that is another one as a file");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteReader bytes({data, size});
  const TraceOptions options = read_options(bytes);
  const Image picture = read_picture(bytes);
  const std::string text = traced(SimdLevel::sse2, picture, options);
  if (detected_simd_level() > SimdLevel::sse2) {
    fuzz::require(traced(detected_simd_level(), picture, options) == text,
                  "two instruction sets make different drawings");
  }
  check_file(text);
  return 0;
}
