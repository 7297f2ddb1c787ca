#include "export/html/viewer_stroke.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "base/limit_error.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "curves/stroke_segments.hpp"

namespace sfumato::outputs {
namespace {

/// The viewer puts more nodes into the segments, as many as it needs where it looks; segments that
/// are longer than this makes them would be cut by the stops along the curve anyway.
constexpr double kNodesPerRadius = 4;

/// Radii below this part of the viewport's longer side do not ask for more nodes.
constexpr double kSmallestRadius = 1.0 / 8192;

/// Bits of attributes and of coefficients that are left out, of the 23 behind the binary point:
/// one part in 2¹⁴ and in 2¹⁹ may be lost.
constexpr int kAttributeBits = 10;
constexpr int kCoefficientBits = 5;

/// To the nearest number whose last `bits` bits are 0.
float rounded(float value, int bits) {
  const std::uint32_t half = 1u << (bits - 1), code = std::bit_cast<std::uint32_t>(value);
  return std::bit_cast<float>((code + half) & ~((half << 1) - 1));
}

/// The stored data of a segment: its start, its direction, and its attributes at its start and its
/// end.
struct StoredSegment {
  std::array<float, 2> start;
  std::array<float, 6> coefficient;
  std::array<std::array<float, 8>, 2> attribute;
  std::uint32_t node_count;
};

StoredSegment stored(const curves::StrokeSegment& s, Vec2 origin) {
  StoredSegment result;
  result.start = {static_cast<float>(s.start.x - origin.x),
                  static_cast<float>(s.start.y - origin.y)};
  for (std::size_t i = 0; i < 6; ++i)
    result.coefficient[i] = rounded(s.coefficient[i / 2][i % 2], kCoefficientBits);
  result.attribute[0] = {s.influence_radius.start, s.blur_radius.start, s.left.start.r,
                         s.left.start.g,           s.left.start.b,      s.right.start.r,
                         s.right.start.g,          s.right.start.b};
  result.attribute[1] = {s.influence_radius.end, s.blur_radius.end, s.left.end.r,  s.left.end.g,
                         s.left.end.b,           s.right.end.r,     s.right.end.g, s.right.end.b};
  for (auto& end : result.attribute)
    for (float& value : end) value = rounded(value, kAttributeBits);
  result.node_count = static_cast<std::uint32_t>(s.node_count);
  return result;
}

std::uint32_t difference(float value, float guess) {
  return std::bit_cast<std::uint32_t>(value) ^ std::bit_cast<std::uint32_t>(guess);
}

/// Columns of numbers, each as planes. A segment is predicted to start at the end of the segment
/// before; its start is stored as the differing bits.
Status write_segments(const Context& context, const curves::StrokeSegments& segments, Vec2 origin,
                      ByteWriter& out) {
  const std::size_t count = segments.segment.size();
  TableMemory memory("a local curve");
  std::vector<StoredSegment> rows;
  std::vector<std::uint32_t> column;
  SFUMATO_TRY(memory.reserve(context, rows, count));
  SFUMATO_TRY(memory.resize(context, column, count));
  for (const curves::StrokeSegment& segment : segments.segment)
    rows.push_back(stored(segment, origin));
  const auto write = [&](int bytes, const auto& value) {
    for (std::size_t i = 0; i < count; ++i) column[i] = value(i);
    out.planes(column, bytes);
  };
  write(1, [&](std::size_t i) { return rows[i].node_count; });
  for (std::size_t c = 0; c < 6; ++c)
    write(4, [&](std::size_t i) { return difference(rows[i].coefficient[c], 0); });
  for (std::size_t axis = 0; axis < 2; ++axis) {
    write(4, [&](std::size_t i) {
      double guess = 0;
      if (i > 0) {
        guess = rows[i - 1].start[axis];
        for (std::size_t c = axis; c < 6; c += 2) guess += rows[i - 1].coefficient[c];
      }
      return difference(rows[i].start[axis], static_cast<float>(guess));
    });
  }
  for (std::size_t a = 0; a < 8; ++a) {
    write(4, [&](std::size_t i) {
      return difference(rows[i].attribute[0][a], i > 0 ? rows[i - 1].attribute[1][a] : 0);
    });
    write(4, [&](std::size_t i) {
      return difference(rows[i].attribute[1][a], rows[i].attribute[0][a]);
    });
  }
  return out.status();
}

}  // namespace

Status write_stroke(Context& context, const LocalStroke& stroke, InterpolationSpace space,
                    const Box& viewport, std::size_t* segment_count, ByteWriter& out) {
  const LocalCurve& curve = stroke.curve;
  const Affine& m = stroke.artboard_from_stroke;
  const double scale = std::sqrt(std::fabs(m.determinant()));
  const bool is_seen = scale > 0 && std::isfinite(1 / scale) &&
                       (!curve.left_color.empty() || !curve.right_color.empty());
  curves::StrokeSegments segments;
  if (is_seen) {
    curves::StrokeOptions options;
    options.image_from_stroke = m;
    options.image = viewport;
    options.interpolation = space;
    options.smallest_radius =
        std::max(viewport.width(), viewport.height()) * kSmallestRadius / scale;
    options.nodes_per_radius = kNodesPerRadius;
    SFUMATO_TRY_ASSIGN(segments, curves::stroke_segments(context, curve, options));
  }
  const std::size_t count = segments.segment.size();
  *segment_count += count;
  if (*segment_count > context.limits.viewer_stroke_segments) {
    return limit_error(context.limits, &Limits::viewer_stroke_segments,
                       "segments of local curves in the viewer");
  }
  const Vec2 origin = count > 0 ? segments.segment.front().start : Vec2{};
  for (double value : {m.a, m.b, m.c, m.d, m.e, m.f, origin.x, origin.y}) out.f64(value);
  out.f32(static_cast<float>(curve.alpha));
  out.u8(curves::is_two_sided(curve) ? 1 : 0);
  out.varint(count);
  return write_segments(context, segments, origin, out);
}

}  // namespace sfumato::outputs
