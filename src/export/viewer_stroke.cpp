#include "export/viewer_stroke.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "curves/stroke_segments.hpp"

namespace sfumato::outputs {
namespace {

/// As the rasterizer has them where it looks closest; the viewer does not know how close that will
/// be.
constexpr double kNodesOneSided = 10;
constexpr double kNodesTwoSided = 24;

/// Radii below this part of the viewport's longer side do not ask for more nodes.
constexpr double kSmallestRadius = 1.0 / 8192;

constexpr std::size_t kValues = 26;

bool is_two_sided(const LocalCurve& curve) {
  return !curve.left_color.empty() && !curve.right_color.empty() &&
         !(curve.left_color == curve.right_color);
}

/// In the order of the texels of a segment (docs/gpu.md), without the two that fill the last.
std::array<float, kValues> values_of(const curves::StrokeSegment& s, Vec2 origin) {
  return {static_cast<float>(s.start.x - origin.x),
          static_cast<float>(s.start.y - origin.y),
          s.coefficient[0][0],
          s.coefficient[0][1],
          s.coefficient[1][0],
          s.coefficient[1][1],
          s.coefficient[2][0],
          s.coefficient[2][1],
          s.length_per_speed,
          static_cast<float>(s.node_count),
          s.influence_radius.start,
          s.influence_radius.end,
          s.blur_radius.start,
          s.blur_radius.end,
          s.left.start.r,
          s.left.start.g,
          s.left.start.b,
          s.left.end.r,
          s.left.end.g,
          s.left.end.b,
          s.right.start.r,
          s.right.start.g,
          s.right.start.b,
          s.right.end.r,
          s.right.end.g,
          s.right.end.b};
}

void write_segments(const curves::StrokeSegments& segments, Vec2 origin, ByteWriter& out) {
  std::vector<std::array<float, kValues>> values;
  values.reserve(segments.segment.size());
  for (const curves::StrokeSegment& segment : segments.segment)
    values.push_back(values_of(segment, origin));
  std::vector<std::uint32_t> column(values.size());
  for (std::size_t i = 0; i < kValues; ++i) {
    std::transform(values.begin(), values.end(), column.begin(),
                   [i](const auto& row) { return std::bit_cast<std::uint32_t>(row[i]); });
    out.planes(column, sizeof(float));
  }
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
  ScopedCharge charge;
  if (is_seen) {
    curves::StrokeOptions options;
    options.image_from_stroke = m;
    options.image = viewport;
    options.interpolation = space;
    options.smallest_radius =
        std::max(viewport.width(), viewport.height()) * kSmallestRadius / scale;
    options.nodes_per_radius = is_two_sided(curve) ? kNodesTwoSided : kNodesOneSided;
    Result<curves::StrokeSegments> made = curves::stroke_segments(context, curve, options);
    if (!made) return made.status();
    segments = std::move(*made);
  }
  const std::size_t count = segments.segment.size();
  *segment_count += count;
  if (*segment_count > limits::kViewerStrokeSegments) {
    return make_error(StatusCode::limit, "local curves of more than " +
                                             std::to_string(limits::kViewerStrokeSegments) +
                                             " segments do not fit into the viewer");
  }
  const std::size_t bytes = 3 * count * kValues * sizeof(float);
  if (Status status = charge.add(context, bytes, "a local curve"); !status) return status;
  const Vec2 origin = count > 0 ? segments.segment.front().start : Vec2{};
  for (double value : {m.a, m.b, m.c, m.d, m.e, m.f, origin.x, origin.y}) out.f64(value);
  out.f32(static_cast<float>(curve.alpha));
  out.u8(is_two_sided(curve) ? 1 : 0);
  out.varint(count);
  write_segments(segments, origin, out);
  return ok_status();
}

}  // namespace sfumato::outputs
