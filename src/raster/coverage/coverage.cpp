#include "raster/coverage/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "raster/coverage/coverage_parts.hpp"
#include "raster/coverage/edge_search.hpp"
#include "raster/coverage/placed_parts.hpp"
#include "raster/coverage/split_triangle.hpp"

namespace sfumato::raster {
namespace {

struct PixelCorners {
  PixelPoint at[3];
};

PixelCorners pixel_corners_of(const LayerView& layer, std::uint32_t triangle) {
  PixelCorners corners;
  for (int k = 0; k < 3; ++k) corners.at[k] = corner_position(layer, triangle, k);
  return corners;
}

/// Shades directly into a tile: opaque, in code values.
class OpaqueShader {
 public:
  explicit OpaqueShader(const LayerView& layer) : layer_(layer) {}

  const LayerView& layer() const { return layer_; }
  void begin_triangle(std::uint32_t triangle, const TriangleFrame& frame) {
    patch_ = patch_polynomial(ColorChannels(layer_), layer_.order, triangle, frame);
  }
  bool has_centers() const { return layer_.order == PatchOrder::cubic; }
  Color4 at_center(std::uint32_t triangle) const {
    const std::size_t slot = node_slot(triangle, kCenterNode);
    return ColorChannels(layer_).at(slot) + color4(0, 0, 0, 1);
  }
  Color4 at(const PatchPoint& p, Vec2) const { return patch_color(patch_, p) + color4(0, 0, 0, 1); }
  Color4 value(const PatchPoint& p, Vec2 center) const { return at(p, center); }
  Color4 shown(const Color4& value) const { return value; }

 private:
  const LayerView& layer_;
  PatchPolynomial patch_;
};

/// Finds the pixels whose whole square lies in a layer's frame.
class FrameInImage {
 public:
  explicit FrameInImage(const LayerView& layer)
      : frame_(layer.frame), layer_from_image_(inverse(layer.image_from_layer)) {}

  bool holds(int x, int y) const {
    const Affine& m = layer_from_image_;
    const Vec2 center = m({x + 0.5, y + 0.5});
    const Vec2 reach{0.5 * (std::fabs(m.a) + std::fabs(m.c)),
                     0.5 * (std::fabs(m.b) + std::fabs(m.d))};
    return center.x - reach.x >= frame_.min.x && center.x + reach.x <= frame_.max.x &&
           center.y - reach.y >= frame_.min.y && center.y + reach.y <= frame_.max.y;
  }

 private:
  Box frame_;
  Affine layer_from_image_;
};

/// Returns the offset of a pixel in the tile's planes.
std::size_t offset(int x, int row) {
  return static_cast<std::size_t>(row) * kTileStride + static_cast<std::size_t>(x);
}

/// Triangles with no longer edge than this, pixels, may have colours that bend within a pixel:
/// triangles of a blur, which are as fine as its radius.
constexpr double kSmallTrianglePx = 3;

/// Triangles with no longer edge than this, pixels, are not split by a pixel's quarters.
constexpr double kWholeTrianglePx = 0.6;

/// Smaller areas are rounding errors.
constexpr double kLeastPart = 1e-13;

/// The pixels that a box meets: the given one, it and the next one in its row or in its column, or
/// others, such as for a box beside a tile.
enum class PixelSpan { one, row, column, other };

PixelSpan pixel_span(const Box& box, int x, int y) {
  const bool begins = box.min.x >= x && box.min.x < x + 1 && box.min.y >= y && box.min.y < y + 1;
  if (!(begins && box.max.x <= x + 2 && box.max.y <= y + 2)) return PixelSpan::other;
  const bool in_column = box.max.x <= x + 1, in_row = box.max.y <= y + 1;
  if (in_row) return in_column ? PixelSpan::one : PixelSpan::row;
  return in_column ? PixelSpan::column : PixelSpan::other;
}

double longest_edge_squared(const Vec2 (&corner)[3]) {
  double longest = 0;
  for (int k = 0; k < 3; ++k)
    longest = std::max(longest, length_squared(corner[(k + 1) % 3] - corner[k]));
  return longest;
}

bool may_be_small(const LayerView& layer, std::uint32_t triangle) {
  return layer.is_bent && layer.is_bent[triangle];
}

bool is_small(const LayerView& layer, std::uint32_t triangle, const Vec2 (&corner)[3]) {
  return may_be_small(layer, triangle) &&
         longest_edge_squared(corner) <= kSmallTrianglePx * kSmallTrianglePx;
}

bool is_read_in_quarters(const LayerView& layer, std::uint32_t triangle, const Vec2 (&corner)[3]) {
  if (!may_be_small(layer, triangle)) return false;
  const double longest = longest_edge_squared(corner);
  return longest <= kSmallTrianglePx * kSmallTrianglePx &&
         longest > kWholeTrianglePx * kWholeTrianglePx;
}

}  // namespace

void MixedPixels::mark(const LayerView& layer, const TriangleList& triangles, const Tile& tile) {
  marks_.clear();
  EdgeSearch<SoftEdge> soft_edges = soft_edges_of(layer);
  EdgeSearch<CurveBow> bows = bows_of(layer);
  const BowSight is_visible(layer);
  for_each_placed(layer, triangles, tile, [&](std::uint32_t t, std::size_t place) {
    mark_triangle(layer, t, place, tile);
    for (const SoftEdge& edge : soft_edges.of(t))
      marks_.mark_convex(outline(soft_strip(layer, edge)), tile);
    for (const CurveBow& bow : bows.of(t))
      if (is_visible(bow)) marks_.mark_convex(bow_shape(layer, bow).corners(), tile);
  });
  sum_.assign(marks_.number(), Sum{});
}

void MixedPixels::mark_triangle(const LayerView& layer, std::uint32_t triangle, std::size_t place,
                                const Tile& tile) {
  const std::uint8_t* is_curve = layer.edge_is_curve + std::size_t{3} * triangle;
  if (!may_be_small(layer, triangle) && !(is_curve[0] | is_curve[1] | is_curve[2])) return;
  const Placed placed(placed_, place);
  // Where triangles are smaller than pixels, earlier ones have already marked these pixels.
  if (holds_all(marks_.mask(), placed.range)) return;
  const auto& corner = placed.corner;
  if (is_small(layer, triangle, corner)) marks_.mark_convex(corner, tile);
  for (int k = 0; k < 3; ++k)
    if (is_curve[k]) marks_.mark_edge(corner[k], corner[(k + 1) % 3], tile);
}

void MixedPixels::Sum::add(const Coverage& part, const Color4& color) {
  const float part_area = static_cast<float>(part.area);
  const float part_moment[2] = {part_area * static_cast<float>(part.centroid.x),
                                part_area * static_cast<float>(part.centroid.y)};
  add(part_area, part_moment, color);
}

/// The area is negative where a part is taken away.
void MixedPixels::Sum::add(float part_area, const float (&part_moment)[2], const Color4& color) {
  if (area == 0) color.store(first);
  const Color4 difference = color - Color4::load(first);
  (Color4::load(rest) + Color4(part_area) * difference).store(rest);
  area += part_area;
  moment[0] += part_moment[0];
  moment[1] += part_moment[1];
}

/// Adds a triangle that lies in the pixel at the range's beginning.
template <class Shader>
void MixedPixels::add_whole_triangle(const Shader& shader, std::uint32_t triangle,
                                     const Vec2 (&corner)[3], const PixelRange& range,
                                     const Tile& tile) {
  const bool mirrored = shader.layer().mirrored;
  const Coverage part =
      whole_coverage(corner[0], corner[mirrored ? 2 : 1], corner[mirrored ? 1 : 2],
                     tile.x0 + range.begin, tile.y0 + range.first_row);
  if (!(part.area > 0)) return;
  const auto add = [&](int, std::uint32_t index) {
    sum_[index].add(part, shader.at_center(triangle));
  };
  marks_.for_each(range.first_row, range.begin, range.begin + 1, add);
}

/// Adds a triangle that lies in the pixel at the range's beginning and the next in its row (axis 0)
/// or column (axis 1), which may be beside the tile.
template <class Shader>
void MixedPixels::add_split_triangle(Shader* shader, std::uint32_t triangle,
                                     const Vec2 (&corner)[3], int axis, const PixelRange& range,
                                     const Tile& tile) {
  const Vec2 along[2] = {corner[1] - corner[0], corner[2] - corner[0]};
  const double area =
      0.5 * (shader->layer().mirrored ? cross(along[1], along[0]) : cross(along[0], along[1]));
  if (!(area > 0)) return;
  bool has_begun = false;
  const auto add = [&](const SplitPart& split, int column, int row) {
    const double part_area = split.share * area;
    if (!(part_area > kLeastPart)) return;
    marks_.for_each(row, column, column + 1, [&](int, std::uint32_t index) {
      if (!has_begun) shader->begin_triangle(triangle, kBarycentricFrame);
      has_begun = true;
      const Vec2 pixel{1.0 * tile.x0 + column, 1.0 * tile.y0 + row};
      const Vec2 centroid = corner[0] + along[0] * split.u + along[1] * split.v;
      const PatchPoint at{static_cast<float>(clamp_unit(split.u)),
                          static_cast<float>(clamp_unit(split.v))};
      sum_[index].add({part_area, centroid - pixel}, shader->at(at, pixel + Vec2{0.5, 0.5}));
    });
  };
  const int column = range.begin, row = range.first_row;
  const double border = axis == 0 ? tile.x0 + column + 1 : tile.y0 + row + 1;
  const auto distance = [&](Vec2 p) { return (axis == 0 ? p.x : p.y) - border; };
  const SplitTriangle split =
      split_triangle({distance(corner[0]), distance(corner[1]), distance(corner[2])});
  add(split.below, column, row);
  if (axis == 0 && column + 1 < range.end) add(split.above, column + 1, row);
  if (axis == 1 && row + 1 < range.end_row) add(split.above, column, row + 1);
}

template <class Shader>
void MixedPixels::add_triangle(Shader* shader, std::uint32_t triangle, std::size_t place,
                               const Tile& tile) {
  const Placed placed(placed_, place);
  const PixelRange& range = placed.range;
  if (!holds_any(marks_.mask(), range)) return;
  const auto& corner = placed.corner;
  const bool in_quarters = is_read_in_quarters(shader->layer(), triangle, corner);
  if (!in_quarters && shader->has_centers()) {
    const int x = tile.x0 + range.begin, y = tile.y0 + range.first_row;
    const PixelSpan span = pixel_span(placed.box, x, y);
    if (span == PixelSpan::one) return add_whole_triangle(*shader, triangle, corner, range, tile);
    if (span != PixelSpan::other)
      return add_split_triangle(shader, triangle, corner, span == PixelSpan::row ? 0 : 1, range,
                                tile);
  }
  const bool mirrored = shader->layer().mirrored;
  const TriangleParts parts(placed, mirrored, in_quarters ? 2 : 1, &cells_);
  const TriangleFrame frame = triangle_frame(
      {{corner[0].x, corner[0].y}, {corner[1].x, corner[1].y}, {corner[2].x, corner[2].y}},
      mirrored);
  bool has_begun = false;
  const auto add = [&](const Coverage& part, int x, int y, std::uint32_t index) {
    if (!(part.area > 0)) return;
    if (!has_begun) shader->begin_triangle(triangle, frame);
    has_begun = true;
    const Vec2 p{x + part.centroid.x, y + part.centroid.y};
    // Shaders are already filtered over the pixel's square: they are evaluated at its centre.
    sum_[index].add(part, shader->at(patch_point(frame, p.x, p.y), {x + 0.5, y + 0.5}));
  };
  for (int row = range.first_row; row < range.end_row; ++row) {
    marks_.for_each(row, range.begin, range.end, [&](int column, std::uint32_t index) {
      const int x = tile.x0 + column, y = tile.y0 + row;
      if (!in_quarters) return add(parts.in(x, y), x, y, index);
      for (int quarter = 0; quarter < 4; ++quarter)
        add(parts.in_quarter(x, y, quarter), x, y, index);
    });
  }
}

/// Reads the colours that a triangle at the edge shows in the collected pixels. Without a triangle
/// the other side's colour is absent.
template <class Shader>
void MixedPixels::read_side(Shader* shader, const PaintedEdge& painted, std::uint32_t slot,
                            int side) {
  if (slot == SoftEdge::kNone) {
    for (EdgePixel& pixel : edge_pixel_) pixel.side[side] = without_alpha(pixel.side[1 - side]);
    return;
  }
  const PixelCorners corners = pixel_corners_of(shader->layer(), slot / 3);
  const TriangleFrame frame = triangle_frame(corners.at, shader->layer().mirrored);
  shader->begin_triangle(slot / 3, frame);
  for (EdgePixel& pixel : edge_pixel_) {
    const Vec2 p = lerp(painted.end[0], painted.end[1], double{pixel.part.along});
    pixel.side[side] = shader->value(patch_point(frame, p.x, p.y), {pixel.x + 0.5, pixel.y + 0.5});
  }
}

/// Reads both sides, first the one that has a triangle.
template <class Shader, class Edge>
void MixedPixels::read_sides(Shader* shader, const Edge& edge, const PaintedEdge& painted) {
  const bool front_first = edge.front != SoftEdge::kNone;
  read_side(shader, painted, front_first ? edge.front : edge.back, front_first ? 1 : 0);
  read_side(shader, painted, front_first ? edge.back : edge.front, front_first ? 0 : 1);
}

/// Adds the change by an edge.
///
/// box       contains the pixels that change
/// part_in   part_in(x, y) returns the part of a pixel that changes
/// change    change(pixel, sum) changes the sum of a pixel by the colours of both sides
template <class Shader, class Edge, class PartIn, class Change>
void MixedPixels::add_edge(Shader* shader, const Edge& edge, const PaintedEdge& painted,
                           const Box& box, const Tile& tile, const PartIn& part_in,
                           const Change& change) {
  const auto add_collected = [&] {
    if (edge_pixel_.empty()) return;
    read_sides(shader, edge, painted);
    for (const EdgePixel& pixel : edge_pixel_) change(pixel, sum_[pixel.sum]);
    edge_pixel_.clear();
  };
  for_each_edge_pixel(box, tile, part_in, [&](const EdgePixel& pixel) {
    edge_pixel_.push_back(pixel);
    if (edge_pixel_.size() == kMostEdgePixels) add_collected();
  });
  add_collected();
}

template <class Shader>
void MixedPixels::add_blur(Shader* shader, const SoftEdge& edge, const Tile& tile) {
  const SoftStrip strip = soft_strip(shader->layer(), edge);
  const auto part_in = [&](int x, int y) { return strip_part(strip, x, y); };
  const auto change = [&](const EdgePixel& pixel, Sum& sum) {
    change_by_blur(*shader, edge, pixel, sum);
  };
  add_edge(shader, edge, strip.edge, box_of(outline(strip)), tile, part_in, change);
}

template <class Shader>
void MixedPixels::add_bow(Shader* shader, const CurveBow& bow, const Tile& tile) {
  const BowShape shape = bow_shape(shader->layer(), bow);
  const auto part_in = [&](int x, int y) { return bow_part(shape, x, y); };
  const auto change = [&](const EdgePixel& pixel, Sum& sum) {
    change_by_bow(*shader, bow, pixel, sum);
  };
  add_edge(shader, bow, shape.edge, box_of(shape.corners()), tile, part_in, change);
}

template <class Shader>
void MixedPixels::add_edges(Shader* shader, const TriangleList& triangles, const Tile& tile) {
  const LayerView& layer = shader->layer();
  if (layer.soft_edge_count + layer.bow_count == 0) return;
  EdgeSearch<SoftEdge> soft_edges = soft_edges_of(layer);
  EdgeSearch<CurveBow> bows = bows_of(layer);
  const BowSight is_visible(layer);
  for (std::size_t i = 0; i < triangles.count; ++i) {
    for (const CurveBow& bow : bows.of(triangles.triangle[i]))
      if (is_visible(bow)) add_bow(shader, bow, tile);
    for (const SoftEdge& edge : soft_edges.of(triangles.triangle[i])) add_blur(shader, edge, tile);
  }
}

/// is_straight: writes onto the pixels below, not separately.
void MixedPixels::write(const LayerView& layer, const Tile& tile, bool is_straight) {
  // Where half of a pixel's square is covered, the centre rule decides.
  constexpr float kLeastArea = 0.5f + 1e-6f;
  // Where bows leave less than this of a part, its colour is lost in rounding.
  const float least_colored = layer.bow_count > 0 ? 1e-5f : 0.0f;
  // A larger area is all of a pixel, apart from the rounding of the sum.
  constexpr float kWholeArea = 1 - 1e-5f;
  const FrameInImage frame(layer);
  const bool is_opaque = layer.opacity.channel_count == 0;
  for_each_marked(tile, [&](int x, int row, std::uint32_t index) {
    const Sum& sum = sum_[index];
    float share = sum.area > kWholeArea ? 1 : std::max(sum.area, 0.0f);
    if (share < 1 && is_opaque && !frame.holds(tile.x0 + x, tile.y0 + row)) {
      if (share < kLeastArea) return;
      share = 1;
    }
    const std::size_t at = offset(x, row);
    float* const target[4] = {tile.color[0] + at, tile.color[1] + at, tile.color[2] + at,
                              tile.alpha ? tile.alpha + at : nullptr};
    PixelPart part{share, {sum.moment[0], sum.moment[1]}, {}};
    for (int c = 0; c < 4; ++c)
      part.color[c] = sum.area > least_colored ? sum.first[c] + sum.rest[c] / sum.area : 0;
    float out[4];
    std::copy_n(part.color, 4, out);
    if (share < 1) {
      // Values out of range are clamped later where the part stands alone.
      for (float& channel : part.color) channel = std::clamp(channel, 0.0f, 1.0f);
      for (int c = 0; c < 4; ++c) out[c] = share * part.color[c];
      if (is_straight) abutting_.paint(tile.x0 + x, tile.y0 + row, part, sum.below, out);
    }
    if (is_straight) {
      for (int c = 0; c < 4 && target[c]; ++c) *target[c] = out[c] + sum.edges[c];
    } else {
      for (int c = 0; c < 4; ++c) *target[c] = std::clamp(out[c] + sum.edges[c], 0.0f, 1.0f);
    }
  });
}

template <class Shader>
void MixedPixels::add_triangles(Shader* shader, const TriangleList& triangles, const Tile& tile) {
  if (sum_.empty()) return;
  for_each_placed(shader->layer(), triangles, tile, [&](std::uint32_t t, std::size_t place) {
    add_triangle(shader, t, place, tile);
  });
  add_edges(shader, triangles, tile);
}

void MixedPixels::keep_below(const Tile& tile) {
  for_each_marked(tile, [&](int x, int row, std::uint32_t index) {
    const std::size_t at = offset(x, row);
    for (int c = 0; c < 3; ++c) sum_[index].below[c] = tile.color[c][at];
    sum_[index].below[3] = tile.alpha ? tile.alpha[at] : 1;
  });
}

void MixedPixels::paint(const LayerView& layer, const TriangleList& triangles, const Tile& tile) {
  OpaqueShader shader(layer);
  add_triangles(&shader, triangles, tile);
  write(layer, tile, true);
}

void MixedPixels::paint(PointShader* shader, const TriangleList& triangles, const Tile& tile) {
  add_triangles(shader, triangles, tile);
  write(shader->layer(), tile, false);
}

}  // namespace sfumato::raster
