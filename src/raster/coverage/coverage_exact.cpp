#include <algorithm>
#include <tuple>

#include "base/try.hpp"
#include "raster/coverage/coverage_parts.hpp"
#include "raster/coverage/edge_search.hpp"
#include "raster/coverage/placed_parts.hpp"
#include "raster/layers/exact_shader.hpp"

/// MixedPixels for a layer with exact fields: the parts are collected, then read all at once.
namespace sfumato::raster {
namespace {

/// A point on an edge is moved by this fraction towards the barycentre of the triangle whose colour
/// it gives.
constexpr double kNudge = 4e-3;

/// The number of parts of a pixel that are searched for a triangle. A pixel may have thousands.
constexpr int kMostCompared = 16;

/// Narrows the triangle's range of pixels to the columns that the triangle touches in one row of
/// the tile.
PixelRange columns_in_row(const Placed& placed, int row, const Tile& tile) {
  PixelRange range = placed.range;
  const double top = tile.y0 + row, bottom = top + 1;
  double left = placed.box.max.x, right = placed.box.min.x;
  for (int k = 0; k < 3; ++k) {
    const Vec2 from = placed.corner[k], to = placed.corner[(k + 1) % 3];
    const double height = to.y - from.y;
    if (height == 0) continue;  // its ends belong to the other edges, too
    const double a = std::clamp((top - from.y) / height, 0.0, 1.0);
    const double b = std::clamp((bottom - from.y) / height, 0.0, 1.0);
    if (std::max(from.y, to.y) < top || std::min(from.y, to.y) > bottom) continue;
    for (const double u : {a, b}) {
      const double x = lerp(from, to, u).x;
      left = std::min(left, x);
      right = std::max(right, x);
    }
  }
  // A pixel more on each side, for rounding.
  range.begin = std::max(range.begin, clamped_floor(left - tile.x0 - 1, 0, tile.width - 1));
  range.end = std::min(range.end, clamped_floor(right - tile.x0 + 1, 0, tile.width - 1) + 1);
  return range;
}

/// Returns whether a point of the image lies in a triangle.
bool contains(const LayerView& layer, std::uint32_t triangle, Vec2 p) {
  Vec2 corner[3];
  for (std::uint32_t k = 0; k < 3; ++k)
    corner[k] = layer.image_from_layer(corner_in_layer(layer, 3 * triangle + k)) - p;
  const double turn = layer.mirrored ? -1 : 1;
  return turn * cross(corner[0], corner[1]) > 0 && turn * cross(corner[1], corner[2]) > 0 &&
         turn * cross(corner[2], corner[0]) > 0;
}

/// Returns a point of the image on the side of a slot's triangle.
Vec2 beside(const LayerView& layer, std::uint32_t slot, Vec2 foot) {
  const std::uint32_t first = slot / 3 * 3;
  Vec2 barycentre;
  for (std::uint32_t k = 0; k < 3; ++k)
    barycentre = barycentre + layer.image_from_layer(corner_in_layer(layer, first + k)) / 3;
  return lerp(foot, barycentre, kNudge);
}

}  // namespace

Status MixedPixels::collect(Context& context, const LayerView& layer, const TriangleList& triangles,
                            const Tile& tile, ExactPoints* points) {
  parts_.clear();
  exact_edges_.clear();
  last_part_.assign(sum_.size(), kNoPart);
  if (sum_.empty()) return ok_status();
  Status status;
  for_each_placed(layer, triangles, tile, [&](std::uint32_t t, std::size_t place) {
    if (!status) return;
    collect_parts(layer, t, place, tile);
    status = settle(context, *points);
  });
  SFUMATO_TRY(status);
  for_each_marked(tile, [&](int column, int row, std::uint32_t index) {
    const int x = tile.x0 + column, y = tile.y0 + row;
    join_parts(layer, index, x, y);
    for (std::uint32_t i = last_part_[index]; i != kNoPart; i = parts_[i].before) {
      if (parts_[i].whole != i) continue;
      const ExactPart& part = parts_[i];
      const Coverage& read = part.is_inside ? part.all : parts_[part.nearest].own;
      parts_[i].point = points->add(Vec2{1.0 * x, 1.0 * y} + read.centroid, x, y);
    }
  });
  return collect_edges(context, layer, triangles, tile, points);
}

Status MixedPixels::settle(const Context& context, ExactPoints& points) {
  SFUMATO_TRY(points.settle(context));
  return memory_.settle(context, capacity_bytes(parts_, last_part_, part_edges_, exact_edges_),
                        charged_);
}

void MixedPixels::collect_parts(const LayerView& layer, std::uint32_t triangle, std::size_t place,
                                const Tile& tile) {
  const Placed placed(placed_, place);
  const PixelRange& range = placed.range;
  if (!holds_any(marks_.mask(), range)) return;
  const TriangleParts parts(placed, layer.mirrored, 1, &cells_);
  const bool is_wide = range.end - range.begin > 4 && range.end_row - range.first_row > 4;
  for (int row = range.first_row; row < range.end_row; ++row) {
    const PixelRange columns = is_wide ? columns_in_row(placed, row, tile) : range;
    if (columns.begin >= columns.end) continue;
    marks_.for_each(row, columns.begin, columns.end, [&](int column, std::uint32_t index) {
      const int x = tile.x0 + column, y = tile.y0 + row;
      const Coverage part = parts.in(x, y);
      if (!(part.area > 0)) return;
      const auto own = static_cast<std::uint32_t>(parts_.size());
      parts_.push_back({part, part, index, kNoPart, triangle, last_part_[index], own, own, true});
      last_part_[index] = own;
    });
  }
}

/// Returns the part that a part, after all joins, belongs to.
std::uint32_t MixedPixels::whole_of(std::uint32_t part) {
  while (parts_[part].whole != part)
    part = parts_[part].whole = parts_[parts_[part].whole].whole;  // halves the way for later calls
  return part;
}

/// Joins the parts of a pixel, (x, y) of the image, that no curve separates.
void MixedPixels::join_parts(const LayerView& layer, std::uint32_t sum, int x, int y) {
  part_edges_.clear();
  for (std::uint32_t i = last_part_[sum]; i != kNoPart; i = parts_[i].before) {
    const std::uint32_t first = 3 * parts_[i].triangle;
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (layer.edge_is_curve[first + k]) continue;
      const auto [from, to] =
          std::minmax(layer.triangle_vertex[first + k], layer.triangle_vertex[first + (k + 1) % 3]);
      part_edges_.push_back({std::uint64_t{from} << 32 | to, i});
    }
  }
  std::ranges::sort(part_edges_, {}, [](const PartEdge& e) { return std::tie(e.ends, e.part); });
  for (std::size_t i = 1; i < part_edges_.size(); ++i) {
    const PartEdge &one = part_edges_[i - 1], &other = part_edges_[i];
    if (one.ends != other.ends) continue;
    const auto end = [&](std::uint64_t vertex) {
      return layer.image_from_layer(layer.vertex_position[vertex]) - Vec2{1.0 * x, 1.0 * y};
    };
    join(whole_of(one.part), whole_of(other.part), end(one.ends >> 32), end(one.ends & 0xffffffff));
  }
  for (std::uint32_t i = last_part_[sum]; i != kNoPart; i = parts_[i].before) {
    const ExactPart& part = parts_[i];
    ExactPart& whole = parts_[whole_of(i)];
    if (whole.is_inside) continue;
    const Vec2 centroid = whole.all.centroid;
    whole.is_inside = contains(layer, part.triangle, Vec2{1.0 * x, 1.0 * y} + centroid);
    const auto distance = [&](const ExactPart& p) {
      return length_squared(p.own.centroid - centroid);
    };
    if (distance(part) < distance(parts_[whole.nearest])) whole.nearest = i;
  }
}

/// Joins two parts if the line between their centroids crosses their common edge. The centroid of
/// the joined parts is then seldom beyond a curve.
void MixedPixels::join(std::uint32_t one, std::uint32_t other, Vec2 from, Vec2 to) {
  if (one == other) return;
  ExactPart &whole = parts_[one], &added = parts_[other];
  const Vec2 along = added.all.centroid - whole.all.centroid;
  const Vec2 start = whole.all.centroid;
  if (!(cross(along, from - start) * cross(along, to - start) < 0)) return;
  added.whole = one;
  whole.is_inside = false;  // join_parts() finds out
  const double area = whole.all.area + added.all.area;
  whole.all = {area, lerp(start, added.all.centroid, added.all.area / area)};
}

/// Returns the point that gives the colour of a triangle in a pixel.
std::uint32_t MixedPixels::point_beside(const LayerView& layer, std::uint32_t slot, Vec2 foot,
                                        const EdgePixel& pixel, ExactPoints* points) {
  int left = kMostCompared;
  for (std::uint32_t i = last_part_[pixel.sum]; i != kNoPart && left > 0;
       i = parts_[i].before, --left)
    if (parts_[i].triangle == slot / 3) return parts_[whole_of(i)].point;
  return points->add(beside(layer, slot, foot), pixel.x, pixel.y);
}

template <class Edge, class PartIn>
void MixedPixels::collect_edge(const LayerView& layer, const Edge& edge, const PaintedEdge& painted,
                               const Box& box, const Tile& tile, const PartIn& part_in,
                               ExactPoints* points) {
  for_each_edge_pixel(box, tile, part_in, [&](const EdgePixel& pixel) {
    ExactEdge exact{pixel, &edge, {kNoPart, kNoPart}};
    const Vec2 foot = lerp(painted.end[0], painted.end[1], double{pixel.part.along});
    const std::uint32_t slot[2] = {edge.back, edge.front};
    for (int side = 0; side < 2; ++side) {
      if (slot[side] == SoftEdge::kNone) continue;
      exact.point[side] = point_beside(layer, slot[side], foot, pixel, points);
    }
    exact_edges_.push_back(exact);
  });
}

Status MixedPixels::collect_edges(Context& context, const LayerView& layer,
                                  const TriangleList& triangles, const Tile& tile,
                                  ExactPoints* points) {
  if (layer.soft_edge_count + layer.bow_count == 0) return ok_status();
  EdgeSearch<SoftEdge> soft_edges = soft_edges_of(layer);
  EdgeSearch<CurveBow> bows = bows_of(layer);
  const BowSight is_visible(layer);
  for (std::size_t i = 0; i < triangles.count; ++i) {
    for (const CurveBow& bow : bows.of(triangles.triangle[i])) {
      if (!is_visible(bow)) continue;
      const BowShape shape = bow_shape(layer, bow);
      collect_edge(
          layer, bow, shape.edge, box_of(shape.corners()), tile,
          [&](int x, int y) { return bow_part(shape, x, y); }, points);
    }
    for (const SoftEdge& edge : soft_edges.of(triangles.triangle[i])) {
      const SoftStrip strip = soft_strip(layer, edge);
      collect_edge(
          layer, edge, strip.edge, box_of(outline(strip)), tile,
          [&](int x, int y) { return strip_part(strip, x, y); }, points);
    }
    SFUMATO_TRY(settle(context, *points));
  }
  return ok_status();
}

/// Reads the colours on both sides of an edge.
void MixedPixels::read_sides(const ExactShader& shader, ExactEdge* edge) {
  EdgePixel& pixel = edge->pixel;
  const Vec2 center{pixel.x + 0.5, pixel.y + 0.5};
  for (int side = 0; side < 2; ++side)
    if (edge->point[side] != kNoPart) pixel.side[side] = shader.value(edge->point[side], center);
  for (int side = 0; side < 2; ++side)
    if (edge->point[side] == kNoPart) pixel.side[side] = without_alpha(pixel.side[1 - side]);
}

void MixedPixels::paint(const ExactShader& shader, const Tile& tile, bool is_straight) {
  for_each_marked(tile, [&](int x, int row, std::uint32_t index) {
    const Vec2 center{tile.x0 + x + 0.5, tile.y0 + row + 0.5};
    for (std::uint32_t i = last_part_[index]; i != kNoPart; i = parts_[i].before)
      if (parts_[i].whole == i)
        sum_[index].add(parts_[i].all, shader.shown(shader.value(parts_[i].point, center)));
  });
  for (ExactEdge& edge : exact_edges_) {
    read_sides(shader, &edge);
    Sum& sum = sum_[edge.pixel.sum];
    if (const auto* bow = std::get_if<const CurveBow*>(&edge.edge)) {
      change_by_bow(shader, **bow, edge.pixel, sum);
    } else {
      change_by_blur(shader, *std::get<const SoftEdge*>(edge.edge), edge.pixel, sum);
    }
  }
  write(shader.layer(), tile, is_straight);
}

}  // namespace sfumato::raster
