#include "raster/triangle_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace sfumato::raster {
namespace {

Box triangle_box(const LayerView& layer, std::uint32_t triangle) {
  Box box;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t vertex = layer.triangle_vertex[std::size_t{3} * triangle + k];
    box.extend(layer.image_from_layer(layer.vertex_position[vertex]));
  }
  return box;
}

Box box_of(const PixelRect& rect) {
  return {{1.0 * rect.x0, 1.0 * rect.y0}, {1.0 * rect.x1, 1.0 * rect.y1}};
}

/// True also where a number is none.
bool may_overlap(const Box& a, const Box& b) {
  return !(a.min.x > b.max.x || b.min.x > a.max.x || a.min.y > b.max.y || b.min.y > a.max.y);
}

int clamped_floor(double x, int low, int high) {
  return static_cast<int>(std::floor(std::clamp<double>(x, low, high)));
}

}  // namespace

Result<TriangleBlocks> make_triangle_blocks(Context& context, const PatchLayer& layer) {
  TriangleBlocks blocks;
  blocks.triangle_count = layer.triangle_count();
  const std::size_t count = (blocks.triangle_count + kTrianglesPerBlock - 1) / kTrianglesPerBlock;
  Status status = blocks.memory.resize(context, blocks.box, count);
  if (!status) return status;
  constexpr std::size_t kGrain = 128;
  status = parallel_for(context, count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t first = std::size_t{3} * kTrianglesPerBlock * i;
      const std::size_t last =
          std::min(first + std::size_t{3} * kTrianglesPerBlock, layer.triangle_vertex.size());
      for (std::size_t corner = first; corner < last; ++corner)
        blocks.box[i].extend(layer.vertex_position[layer.triangle_vertex[corner]]);
    }
  });
  if (!status) return status;
  return blocks;
}

Box mapped_bounds(const Affine& map, const Box& box) {
  const Vec2 center = map(box.center());
  const double half_x = 0.5 * box.width();
  const double half_y = 0.5 * box.height();
  const Vec2 reach{std::fabs(map.a) * half_x + std::fabs(map.c) * half_y,
                   std::fabs(map.b) * half_x + std::fabs(map.d) * half_y};
  // What rounding of the sums may take off.
  const double slack = 1e-12 * (std::fabs(center.x) + std::fabs(center.y) + reach.x + reach.y);
  return Box{center - reach, center + reach}.grown_by(slack);
}

void list_triangles(const LayerView& layer, const TriangleBlocks& blocks, const PixelRect& rect,
                    double margin_px, std::vector<std::uint32_t>* triangles) {
  triangles->clear();
  const Box seen = box_of(rect).grown_by(margin_px);
  for (std::uint32_t i = 0; i < blocks.box.size(); ++i) {
    const Box block = mapped_bounds(layer.image_from_layer, blocks.box[i]);
    if (!may_overlap(block, seen)) continue;
    const std::uint32_t first = i * kTrianglesPerBlock;
    const std::uint32_t last = std::min(first + kTrianglesPerBlock, blocks.triangle_count);
    for (std::uint32_t t = first; t < last; ++t)
      if (overlap(triangle_box(layer, t), seen)) triangles->push_back(t);
  }
}

PixelRect pixels_in(const Box& box, const PixelRect& rect) {
  if (!overlap(box, box_of(rect))) return {};
  const PixelRect pixels{clamped_floor(box.min.x, rect.x0, rect.x1),
                         clamped_floor(box.min.y, rect.y0, rect.y1),
                         clamped_floor(box.max.x, rect.x0 - 1, rect.x1 - 1) + 1,
                         clamped_floor(box.max.y, rect.y0 - 1, rect.y1 - 1) + 1};
  return pixels.empty() ? PixelRect{} : pixels;
}

}  // namespace sfumato::raster
