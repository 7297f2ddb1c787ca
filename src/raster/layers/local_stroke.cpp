#include "raster/layers/local_stroke.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::raster {
namespace {

/// The number of nodes per local radius: it determines the cost of a pixel, and keeps the error
/// below a quarter of an 8-bit step. Sides that differ need more, and more where they meet sharply.
constexpr double kNodesOneSided = 10;
constexpr double kNodesTwoSided = 16;
constexpr double kNodesSharp = 24;
/// A blur radius below it is sharp, pixels.
constexpr double kSharpBlur = 5;

/// Radius below which a stroke is drawn fainter instead of thinner, pixels.
constexpr double kSmallestRadius = 1;

double nodes_per_radius(const LocalCurve& curve, double scale) {
  if (!curves::is_two_sided(curve)) return kNodesOneSided;
  bool sharp = curve.blur_radius.empty();
  for (const auto& stop : curve.blur_radius.stops) sharp |= stop.value * scale < kSharpBlur;
  return sharp ? kNodesSharp : kNodesTwoSided;
}

StrokeFrame make_frame(const LocalCurve& curve, const Affine& image_from_frame,
                       const Affine& frame_from_image, InterpolationSpace space) {
  const auto set = [](const Affine& m, float(&linear)[2][2]) {
    linear[0][0] = static_cast<float>(m.a);
    linear[0][1] = static_cast<float>(m.c);
    linear[1][0] = static_cast<float>(m.b);
    linear[1][1] = static_cast<float>(m.d);
  };
  StrokeFrame frame;
  set(image_from_frame, frame.image_from_frame);
  set(frame_from_image, frame.frame_from_image);
  frame.reach_per_radius[0] = static_cast<float>(length({image_from_frame.a, image_from_frame.c}));
  frame.reach_per_radius[1] = static_cast<float>(length({image_from_frame.b, image_from_frame.d}));
  frame.smallest_radius = kSmallestRadius;
  frame.alpha = static_cast<float>(curve.alpha);
  frame.two_sided = curves::is_two_sided(curve);
  frame.interpolation = space;
  return frame;
}

int round_down(int value, int step) {
  const int rest = value % step;
  return value - (rest < 0 ? rest + step : rest);
}

}  // namespace

Result<PreparedStroke> prepare_stroke(Context& context, const LocalStroke& stroke,
                                      const Affine& image_from_artboard, InterpolationSpace space,
                                      const Box& image) {
  PreparedStroke prepared;
  const LocalCurve& curve = stroke.curve;
  const Affine image_from_stroke = image_from_artboard * stroke.artboard_from_stroke;
  const double scale = std::sqrt(std::fabs(image_from_stroke.determinant()));
  const bool has_color = !curve.left_color.empty() || !curve.right_color.empty();
  // A map that flattens the plane leaves nothing visible.
  if (!(scale > 0) || !std::isfinite(1 / scale) || !has_color) return prepared;
  curves::StrokeOptions options;
  options.scale = scale;
  options.image_from_stroke = image_from_stroke;
  options.image = image;
  options.interpolation = space;
  options.smallest_radius = kSmallestRadius;
  options.nodes_per_radius = nodes_per_radius(curve, scale);
  SFUMATO_TRY_ASSIGN(auto&& segments, curves::stroke_segments(context, curve, options));
  for (const Box& box : segments.reach) prepared.bounds_px = united(prepared.bounds_px, box);
  prepared.segments = std::move(segments);
  prepared.image_from_frame = image_from_stroke * Affine{1 / scale, 0, 0, 1 / scale, 0, 0};
  prepared.frame =
      make_frame(curve, prepared.image_from_frame, inverse(prepared.image_from_frame), space);
  return prepared;
}

Result<StrokePainter> StrokePainter::create(Context& context, const LocalStroke& stroke,
                                            const Affine& image_from_artboard,
                                            InterpolationSpace space, const Box& image) {
  StrokePainter painter;
  SFUMATO_TRY_ASSIGN(auto&& prepared,
                     prepare_stroke(context, stroke, image_from_artboard, space, image));
  if (prepared.segments.segment.empty()) return painter;
  SFUMATO_TRY_ASSIGN(auto&& tree, StrokeTree::create(context, prepared.segments.reach));
  painter.bounds_ = prepared.bounds_px;
  painter.segments_ = std::move(prepared.segments);
  painter.tree_ = std::move(tree);
  painter.frame_from_image_ = inverse(prepared.image_from_frame);
  painter.frame_ = prepared.frame;
  painter.kernels_ = &stroke_kernels(context.simd);
  return painter;
}

/// Computes the finished sums of a block. Returns false where nothing reaches it.
Result<bool> StrokePainter::add_block(const Context& context, int block_x, int block_y,
                                      StrokeSums& sums) const {
  const Box block{{static_cast<double>(block_x), static_cast<double>(block_y)},
                  {static_cast<double>(block_x + kStrokeBlockWidth),
                   static_cast<double>(block_y + kStrokeBlockHeight)}};
  const Vec2 center = frame_from_image_(block.center());
  bool touched = false;
  RarePoll<64> poll(context);
  SFUMATO_TRY(context.check());
  Status status;
  tree_.find(block, [&](std::span<const std::uint32_t> indices) {
    if (status && poll.cancelled()) status = context.cancel_status();
    if (!status) return;
    if (!touched) sums = {};
    touched = true;
    kernels_->add_segments(frame_, segments_.segment.data(), indices, center, sums);
  });
  if (!status) return status;
  if (touched) kernels_->finish(frame_, sums);
  return touched;
}

Status StrokePainter::paint(const Context& context, int x0, int y0, int width, int height, float* r,
                            float* g, float* b, float* alpha, std::size_t stride) const {
  const Box rectangle{{static_cast<double>(x0), static_cast<double>(y0)},
                      {static_cast<double>(x0) + width, static_cast<double>(y0) + height}};
  if (bounds_.empty() || !overlap(bounds_, rectangle)) return ok_status();
  StrokeSums sums;
  for (int by = round_down(y0, kStrokeBlockHeight); by < y0 + height; by += kStrokeBlockHeight) {
    for (int bx = round_down(x0, kStrokeBlockWidth); bx < x0 + width; bx += kStrokeBlockWidth) {
      SFUMATO_TRY_ASSIGN(const bool is_touched, add_block(context, bx, by, sums));
      if (!is_touched) continue;
      const int left = std::max(x0, bx), right = std::min(x0 + width, bx + kStrokeBlockWidth);
      const int bottom = std::min(y0 + height, by + kStrokeBlockHeight);
      for (int y = std::max(y0, by); y < bottom; ++y) {
        const std::size_t offset =
            static_cast<std::size_t>(y - y0) * stride + static_cast<std::size_t>(left - x0);
        const auto blend = [&](float* plane, const float* color) {
          const float* opacity = &sums.weight[y - by][left - bx];
          for (int i = 0; i < right - left; ++i) {
            plane[i] = plane[i] + (color[i] - plane[i]) * opacity[i];
          }
        };
        blend(r + offset, &sums.color[0][y - by][left - bx]);
        blend(g + offset, &sums.color[1][y - by][left - bx]);
        blend(b + offset, &sums.color[2][y - by][left - bx]);
        const float ones[kStrokeBlockWidth] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
        blend(alpha + offset, ones);
      }
    }
  }
  return ok_status();
}

}  // namespace sfumato::raster
