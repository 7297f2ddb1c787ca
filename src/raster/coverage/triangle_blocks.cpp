#include "raster/coverage/triangle_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/try.hpp"

namespace sfumato::raster {
namespace {

struct Corners {
  Vec2 at[3];
};

Corners corners_of(const LayerView& layer, std::uint32_t triangle) {
  Corners corners;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t vertex = layer.triangle_vertex[std::size_t{3} * triangle + k];
    corners.at[k] = layer.image_from_layer(layer.vertex_position[vertex]);
  }
  return corners;
}

Box box_of(const Corners& corners) {
  Box box;
  for (Vec2 p : corners.at) box.extend(p);
  return box;
}

Box box_of(const PixelRect& rect) {
  return {{1.0 * rect.x0, 1.0 * rect.y0}, {1.0 * rect.x1, 1.0 * rect.y1}};
}

/// Returns whether boxes may overlap; also true for NaN.
bool may_overlap(const Box& a, const Box& b) {
  return !(a.min.x > b.max.x || b.min.x > a.max.x || a.min.y > b.max.y || b.min.y > a.max.y);
}

bool is_within(const Box& inner, const Box& outer) {
  return inner.min.x > outer.min.x && inner.max.x < outer.max.x && inner.min.y > outer.min.y &&
         inner.max.y < outer.max.y;
}

/// Returns whether boxes meet in more than their boundary.
bool meet(const Box& a, const Box& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

bool is_far(const Corners& corners) {
  return std::ranges::any_of(
      corners.at, [](Vec2 p) { return std::max(std::fabs(p.x), std::fabs(p.y)) > kExactBelowPx; });
}

/// Returns whether one of a triangle's edges has all of a box on its other side. `turn` is 1, or -1
/// if the layer is mirrored.
bool is_parted(const Corners& corners, double turn, const Box& box) {
  if (is_far(corners)) return false;
  for (int k = 0; k < 3; ++k) {
    const Vec2 a = corners.at[k], along = (corners.at[(k + 1) % 3] - a) * turn;
    // The corner of the box that lies farthest inside.
    const Vec2 inmost{along.y > 0 ? box.min.x : box.max.x, along.x > 0 ? box.max.y : box.min.y};
    if (cross(along, inmost - a) <= 0) return true;
  }
  return false;
}

int floor_within(double x, int low, int high) {
  return static_cast<int>(std::floor(std::clamp<double>(x, low, high)));
}

}  // namespace

Result<TriangleBlocks> make_triangle_blocks(Context& context, const PatchLayer& layer) {
  TriangleBlocks blocks;
  blocks.triangle_count = layer.triangle_count();
  const std::size_t count = (blocks.triangle_count + kTrianglesPerBlock - 1) / kTrianglesPerBlock;
  SFUMATO_TRY(blocks.memory.resize(context, blocks.box, count));
  constexpr std::size_t kGrain = 128;
  SFUMATO_TRY(parallel_for(context, count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t first = std::size_t{3} * kTrianglesPerBlock * i;
      const std::size_t last =
          std::min(first + std::size_t{3} * kTrianglesPerBlock, layer.triangle_vertex.size());
      for (std::size_t corner = first; corner < last; ++corner)
        blocks.box[i].extend(layer.vertex_position[layer.triangle_vertex[corner]]);
    }
  }));
  return blocks;
}

Box mapped_bounds(const Affine& map, const Box& box) {
  const Vec2 center = map(box.center());
  const double half_x = 0.5 * box.width();
  const double half_y = 0.5 * box.height();
  const Vec2 reach{std::fabs(map.a) * half_x + std::fabs(map.c) * half_y,
                   std::fabs(map.b) * half_x + std::fabs(map.d) * half_y};
  // The error that rounding of the sums may cause.
  const double slack = 1e-12 * (std::fabs(center.x) + std::fabs(center.y) + reach.x + reach.y);
  return Box{center - reach, center + reach}.grown_by(slack);
}

void list_triangles(const LayerView& layer, const TriangleBlocks& blocks, const PixelRect& rect,
                    double margin_px, std::vector<std::uint32_t>* triangles) {
  triangles->clear();
  constexpr double kRoundingPx = 1;
  const Box seen = box_of(rect), near = seen.grown_by(margin_px + kRoundingPx);
  for (std::uint32_t i = 0; i < blocks.box.size(); ++i) {
    const Box block = mapped_bounds(layer.image_from_layer, blocks.box[i]);
    if (!may_overlap(block, near)) continue;
    const std::uint32_t first = i * kTrianglesPerBlock;
    const std::uint32_t last = std::min(first + kTrianglesPerBlock, blocks.triangle_count);
    for (std::uint32_t t = first; t < last; ++t)
      if (overlap(box_of(corners_of(layer, t)).grown_by(margin_px), seen)) triangles->push_back(t);
  }
}

void keep_meeting(const LayerView& layer, const PixelRect& rect, double margin_px,
                  std::vector<std::uint32_t>* triangles) {
  const Box seen = box_of(rect), near = seen.grown_by(margin_px);
  const double turn = layer.mirrored ? -1 : 1;
  std::erase_if(*triangles, [&](std::uint32_t t) {
    const Corners corners = corners_of(layer, t);
    const Box box = box_of(corners);
    // The box is grown, as when the lists are made, since rounding is then the same.
    return !meet(box.grown_by(margin_px), seen) ||
           !(is_within(box, near) || !is_parted(corners, turn, near));
  });
}

PixelRect pixels_in(const Box& box, const PixelRect& rect) {
  if (!overlap(box, box_of(rect))) return {};
  const PixelRect pixels{floor_within(box.min.x, rect.x0, rect.x1),
                         floor_within(box.min.y, rect.y0, rect.y1),
                         floor_within(box.max.x, rect.x0 - 1, rect.x1 - 1) + 1,
                         floor_within(box.max.y, rect.y0 - 1, rect.y1 - 1) + 1};
  return pixels.empty() ? PixelRect{} : pixels;
}

}  // namespace sfumato::raster
