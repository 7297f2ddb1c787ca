#include "base/lanes.hpp"
#include "curves/front_share.hpp"
#include "raster/kernels/color_space_kernel.hpp"
#include "raster/kernels/local_stroke_kernels.hpp"

/// Eq. 12–16 at the pixels of a block, by the midpoint rule over the nodes of the stroke's
/// segments. Compiled for every instruction set.
namespace sfumato::raster::inline SFUMATO_ISA {

/// The nodes of one segment, relative to the block's centre, frame of the segments.
struct StrokeNodes {
  float x[curves::kStrokeNodes], y[curves::kStrokeNodes];
  float inverse_radius_squared[curves::kStrokeNodes];                      ///< Q⁻²
  float weight[curves::kStrokeNodes];                                      ///< ds / Q; 0: no node
  float tangent_x[curves::kStrokeNodes], tangent_y[curves::kStrokeNodes];  ///< unit
  float blur_squared[curves::kStrokeNodes];                            ///< R² widened by the pixel
  float turn[curves::kStrokeNodes];                                    ///< see `beta`
  float base[3][curves::kStrokeNodes];                                 ///< the right side's colour
  float difference[3][curves::kStrokeNodes];                           ///< left minus right
  float image_x[curves::kStrokeNodes], image_y[curves::kStrokeNodes];  ///< pixels from the centre
  float reach_x[curves::kStrokeNodes], reach_y[curves::kStrokeNodes];  ///< pixels
};

/// A node and the pixels of the block that it reaches: rows and columns from `first` to `last`.
struct NodeReach {
  int node, first_row, last_row, first_column, last_column;
};

/// The positions of the pixels of a block, from its centre, frame of the segments.
struct StrokePixels {
  float x[kStrokeBlockHeight][kStrokeBlockWidth], y[kStrokeBlockHeight][kStrokeBlockWidth];
};

// A blur of variance v, for any cause, is represented by one of radius sqrt(5 v), since
// smoothstep's derivative over ±R has variance R²/5. A pixel's square adds extent² / 12, its extent
// across the curve. The stretch that a node represents adds (half its range of r⊥)² / 3; without
// this a hard side would switch node by node.
inline constexpr float kPixelVariance = 5.0f / 12;
inline constexpr float kRangeVariance = 5.0f / 3;

template <class F>
SFUMATO_INLINE F between(const F& u, float start, float end) {
  return F(start) + u * F(end - start);
}

template <class F>
SFUMATO_INLINE void make_colors(const curves::StrokeSegment& s, const F& u, int k,
                                StrokeNodes& nodes) {
  const float right[3][2] = {{s.right.start.r, s.right.end.r},
                             {s.right.start.g, s.right.end.g},
                             {s.right.start.b, s.right.end.b}};
  const float left[3][2] = {{s.left.start.r, s.left.end.r},
                            {s.left.start.g, s.left.end.g},
                            {s.left.start.b, s.left.end.b}};
  for (int c = 0; c < 3; ++c) {
    const F base = between(u, right[c][0], right[c][1]);
    base.store(nodes.base[c] + k);
    (between(u, left[c][0], left[c][1]) - base).store(nodes.difference[c] + k);
  }
}

/// Computes nodes k, k + 1, …, as many as F has lanes.
template <class F>
SFUMATO_INLINE void make_nodes(const StrokeFrame& frame, const curves::StrokeSegment& s,
                               Vec2 center, int k, StrokeNodes& nodes) {
  float steps[curves::kStrokeNodes];
  for (int i = 0; i < curves::kStrokeNodes; ++i) steps[i] = static_cast<float>(i) + 0.5f;
  const F step = F::load(steps + k), count(static_cast<float>(s.node_count));
  const F u = step / count;
  F position[2], speed[2], bend[2];
  const float start[2] = {static_cast<float>(s.start.x - center.x),
                          static_cast<float>(s.start.y - center.y)};
  for (int axis = 0; axis < 2; ++axis) {
    const F c1(s.coefficient[0][axis]), c2(s.coefficient[1][axis]), c3(s.coefficient[2][axis]);
    position[axis] = F(start[axis]) + u * (c1 + u * (c2 + u * c3));
    speed[axis] = c1 + u * (F(2) * c2 + F(3) * u * c3);
    bend[axis] = F(2) * c2 + F(6) * u * c3;
  }
  const F squared = max(speed[0] * speed[0] + speed[1] * speed[1], F(1e-30f));
  const F length = sqrt(squared), inverse_length = F(1) / length;
  const F tangent_x = speed[0] * inverse_length, tangent_y = speed[1] * inverse_length;
  const F influence = between(u, s.influence_radius.start, s.influence_radius.end);
  const F radius = max(influence, F(frame.smallest_radius));
  const F inverse_squared = F(1) / (radius * radius);
  const F arc = length * F(s.length_per_speed);
  // A stroke thinner than a pixel is drawn one pixel wide and correspondingly fainter.
  const F weight = arc * influence * inverse_squared;
  const auto& m = frame.image_from_frame;
  const auto& j = frame.frame_from_image;
  position[0].store(nodes.x + k);
  position[1].store(nodes.y + k);
  inverse_squared.store(nodes.inverse_radius_squared + k);
  zero_unless(step < count, weight).store(nodes.weight + k);
  (F(m[0][0]) * position[0] + F(m[0][1]) * position[1]).store(nodes.image_x + k);
  (F(m[1][0]) * position[0] + F(m[1][1]) * position[1]).store(nodes.image_y + k);
  (radius * F(frame.reach_per_radius[0])).store(nodes.reach_x + k);
  (radius * F(frame.reach_per_radius[1])).store(nodes.reach_y + k);
  make_colors(s, u, k, nodes);
  if (!frame.two_sided) return;
  tangent_x.store(nodes.tangent_x + k);
  tangent_y.store(nodes.tangent_y + k);
  // The normal's components along the pixel's edges.
  const F edge_x = tangent_y * F(j[0][0]) - tangent_x * F(j[1][0]);
  const F edge_y = tangent_y * F(j[0][1]) - tangent_x * F(j[1][1]);
  const F blur = between(u, s.blur_radius.start, s.blur_radius.end);
  (blur * blur + F(kPixelVariance) * (edge_x * edge_x + edge_y * edge_y))
      .store(nodes.blur_squared + k);
  const F angle = (speed[0] * bend[1] - speed[1] * bend[0]) / (squared * count);
  (F(kRangeVariance / 4) * angle * angle).store(nodes.turn + k);
}

/// Finds the pixels of a row or column of a block within reach: from middle - reach to middle +
/// reach, pixels from the block's centre. Returns false where there are none.
SFUMATO_INLINE bool reached_pixels(float middle, float reach, int count, int* first, int* last) {
  // The margin allows for rounding of the reach.
  constexpr float kMargin = 0.01f;
  // Pixels count at their centres.
  const float center = 0.5f * static_cast<float>(count) - 0.5f;
  const float low = middle - reach + (center - kMargin);
  const float high = middle + reach + (center + kMargin);
  if (!(low < static_cast<float>(count) && high > 0)) return false;
  *first = low > 0 ? static_cast<int>(low) + 1 : 0;
  *last = high < static_cast<float>(count - 1) ? static_cast<int>(high) : count - 1;
  return *first <= *last;
}

/// Lists the nodes that reach the block, in order, and returns their number.
inline int reaching_nodes(const StrokeNodes& nodes, int count, NodeReach* reaching) {
  int found = 0;
  for (int k = 0; k < count; ++k) {
    if (!(nodes.weight[k] > 0)) continue;
    NodeReach& reach = reaching[found];
    reach.node = k;
    found += reached_pixels(nodes.image_y[k], nodes.reach_y[k], kStrokeBlockHeight,
                            &reach.first_row, &reach.last_row) &&
             reached_pixels(nodes.image_x[k], nodes.reach_x[k], kStrokeBlockWidth,
                            &reach.first_column, &reach.last_column);
  }
  return found;
}

template <class F>
SFUMATO_INLINE void make_pixels(const StrokeFrame& frame, StrokePixels& pixels) {
  const auto& j = frame.frame_from_image;
  for (int row = 0; row < kStrokeBlockHeight; ++row) {
    const float down = static_cast<float>(row) + 0.5f - 0.5f * kStrokeBlockHeight;
    for (int x = 0; x < kStrokeBlockWidth; x += F::kCount) {
      float columns[F::kCount];
      for (int i = 0; i < F::kCount; ++i) {
        columns[i] = static_cast<float>(x + i) + 0.5f - 0.5f * kStrokeBlockWidth;
      }
      const F right = F::load(columns);
      (F(j[0][0]) * right + F(j[0][1] * down)).store(pixels.x[row] + x);
      (F(j[1][0]) * right + F(j[1][1] * down)).store(pixels.y[row] + x);
    }
  }
}

/// Returns beta of eq. 16, the left side's share, at (dx, dy) from node k. Over the length that the
/// node represents, r⊥ changes by the node's turn times the distance along the tangent.
template <class F>
SFUMATO_INLINE F beta(const StrokeNodes& nodes, int k, const F& dx, const F& dy) {
  const F tx(nodes.tangent_x[k]), ty(nodes.tangent_y[k]);
  const F across = ty * dx - tx * dy, along = tx * dx + ty * dy;
  const F variance = F(nodes.blur_squared[k]) + F(nodes.turn[k]) * (along * along);
  const F u = F(0.5f) + F(0.5f) * across * reciprocal_sqrt(variance);
  const F inside = min(max(u, F(0)), F(1));
  return curves::smoothstep(inside);
}

/// Adds a node to the rows that it reaches, in the columns from x on.
template <class F, bool kTwoSided>
SFUMATO_INLINE void add_columns(const StrokeNodes& nodes, const NodeReach& reach, int x,
                                const StrokePixels& pixels, StrokeSums& sums) {
  const int k = reach.node;
  const F node_x(nodes.x[k]), node_y(nodes.y[k]), weight(nodes.weight[k]);
  const F inverse_radius_squared(nodes.inverse_radius_squared[k]);
  const F base[3] = {F(nodes.base[0][k]), F(nodes.base[1][k]), F(nodes.base[2][k])};
  const F difference[3] = {F(nodes.difference[0][k]), F(nodes.difference[1][k]),
                           F(nodes.difference[2][k])};
  for (int row = reach.first_row; row <= reach.last_row; ++row) {
    const F dx = F::load(pixels.x[row] + x) - node_x, dy = F::load(pixels.y[row] + x) - node_y;
    const F q = min((dx * dx + dy * dy) * inverse_radius_squared, F(1));
    const F w = (F(1) - q * (F(3) - F(2) * sqrt(q))) * weight;
    (F::load(sums.weight[row] + x) + w).store(sums.weight[row] + x);
    const F left = kTwoSided ? w * beta(nodes, k, dx, dy) : F(0);
    for (int c = 0; c < 3; ++c) {
      F color = F::load(sums.color[c][row] + x) + w * base[c];
      if (kTwoSided) color = color + left * difference[c];
      color.store(sums.color[c][row] + x);
    }
  }
}

/// Adds a node to the pixels that it reaches, and to some beside them, where its weight is 0.
template <class F, bool kTwoSided>
SFUMATO_INLINE void add_node(const StrokeNodes& nodes, const NodeReach& reach,
                             const StrokePixels& pixels, StrokeSums& sums) {
  const int columns = reach.last_column - reach.first_column + 1;
  const int covered = (columns + F::kCount - 1) / F::kCount * F::kCount;
  const int most = kStrokeBlockWidth - covered;
  const int first = reach.first_column < most ? reach.first_column : most;
  for (int x = first; x < first + covered; x += F::kCount)
    add_columns<F, kTwoSided>(nodes, reach, x, pixels, sums);
}

/// Adds segments, with W lanes to a register.
template <int W>
void add_stroke_segments(const StrokeFrame& frame, const curves::StrokeSegment* segments,
                         std::span<const std::uint32_t> indices, Vec2 center, StrokeSums& sums) {
  using F = Lanes<W>;
  StrokePixels pixels;
  make_pixels<F>(frame, pixels);
  StrokeNodes nodes;
  NodeReach reaching[curves::kStrokeNodes];
  for (std::uint32_t index : indices) {
    const curves::StrokeSegment& segment = segments[index];
    for (int k = 0; k < segment.node_count; k += W) make_nodes<F>(frame, segment, center, k, nodes);
    const int count = reaching_nodes(nodes, segment.node_count, reaching);
    for (int i = 0; i < count; ++i) {
      if (frame.two_sided)
        add_node<F, true>(nodes, reaching[i], pixels, sums);
      else
        add_node<F, false>(nodes, reaching[i], pixels, sums);
    }
  }
}

template <int W>
void finish_stroke(const StrokeFrame& frame, StrokeSums& sums) {
  using F = Lanes<W>;
  for (int row = 0; row < kStrokeBlockHeight; ++row) {
    for (int x = 0; x < kStrokeBlockWidth; x += W) {
      const F total = F::load(sums.weight[row] + x);
      const F share = F(1) / max(total, F(1e-30f));
      Rgb3<W> color{F::load(sums.color[0][row] + x) * share,
                    F::load(sums.color[1][row] + x) * share,
                    F::load(sums.color[2][row] + x) * share};
      color = clamped_srgb(frame.interpolation, color);
      color.r.store(sums.color[0][row] + x);
      color.g.store(sums.color[1][row] + x);
      color.b.store(sums.color[2][row] + x);
      min(total * F(frame.alpha), F(1)).store(sums.weight[row] + x);
    }
  }
}

}  // namespace sfumato::raster::inline SFUMATO_ISA

namespace sfumato::raster {

const StrokeKernels& stroke_kernels(LaneCount<SFUMATO_ISA_LANES>) {
  static constexpr StrokeKernels kKernels{add_stroke_segments<SFUMATO_ISA_LANES>,
                                          finish_stroke<SFUMATO_ISA_LANES>};
  return kKernels;
}

}  // namespace sfumato::raster
