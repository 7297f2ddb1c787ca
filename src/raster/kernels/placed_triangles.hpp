#pragma once

#include "base/lane_register.hpp"
#include "raster/kernels/tile.hpp"

/// The places of a layer's triangles in the image, processed a register at a time. Compiled for
/// every instruction set.
namespace sfumato::raster {

/// Corners, bounding boxes, and the pixels of a tile, from its corner, that these boxes meet; for a
/// box beside the tile the nearest pixels.
struct PlacedTriangles {
  static constexpr std::size_t kMost = 64;

  double x[3][kMost], y[3][kMost];  ///< pixels of the image
  double left[kMost], right[kMost], top[kMost], bottom[kMost];
  std::int32_t begin[kMost], end[kMost], first_row[kMost], end_row[kMost];
};

inline namespace SFUMATO_ISA {

#if defined(__AVX512F__)
inline constexpr std::size_t kPlacedAtOnce = 8;
#elif defined(__AVX2__)
inline constexpr std::size_t kPlacedAtOnce = 4;
#else
inline constexpr std::size_t kPlacedAtOnce = 2;
#endif
typedef double PlacedDoubles __attribute__((vector_size(8 * kPlacedAtOnce)));
typedef std::int32_t PlacedInts __attribute__((vector_size(4 * kPlacedAtOnce)));

SFUMATO_INLINE PlacedDoubles least(const PlacedDoubles& a, const PlacedDoubles& b) {
  return a < b ? a : b;
}

SFUMATO_INLINE PlacedDoubles greatest(const PlacedDoubles& a, const PlacedDoubles& b) {
  return a > b ? a : b;
}

/// Returns floor(x), at least 0 and at most `last`.
SFUMATO_INLINE PlacedInts clamped_floors(const PlacedDoubles& x, double last) {
  const PlacedDoubles low{}, high = low + last;
  return __builtin_convertvector(least(greatest(x, low), high), PlacedInts);
}

template <class Lanes, class Item>
SFUMATO_INLINE void store_placed(const Lanes& lanes, Item* target) {
  __builtin_memcpy(target, &lanes, sizeof(lanes));
}

/// Some triangles; where a list ends earlier, its last one fills the other lanes.
struct PlacedLanes {
  PlacedDoubles x[3], y[3], left, right, top, bottom;
};

/// Places triangles. The corners equal the results of corner_position() to the bit.
SFUMATO_INLINE PlacedLanes place_lanes(const LayerView& layer, const std::uint32_t* triangle,
                                       std::size_t count) {
  double from_x[3][kPlacedAtOnce], from_y[3][kPlacedAtOnce];
  for (std::size_t i = 0; i < kPlacedAtOnce; ++i) {
    const std::uint32_t* vertex =
        layer.triangle_vertex + std::size_t{3} * triangle[i < count ? i : count - 1];
    for (int k = 0; k < 3; ++k) {
      const Vec2& p = layer.vertex_position[vertex[k]];
      from_x[k][i] = p.x;
      from_y[k][i] = p.y;
    }
  }
  const Affine& m = layer.image_from_layer;
  PlacedLanes lanes;
  for (int k = 0; k < 3; ++k) {
    PlacedDoubles x, y;
    __builtin_memcpy(&x, from_x[k], sizeof(x));
    __builtin_memcpy(&y, from_y[k], sizeof(y));
    lanes.x[k] = m.a * x + m.c * y + m.e;
    lanes.y[k] = m.b * x + m.d * y + m.f;
  }
  lanes.left = least(lanes.x[0], least(lanes.x[1], lanes.x[2]));
  lanes.right = greatest(lanes.x[0], greatest(lanes.x[1], lanes.x[2]));
  lanes.top = least(lanes.y[0], least(lanes.y[1], lanes.y[2]));
  lanes.bottom = greatest(lanes.y[0], greatest(lanes.y[1], lanes.y[2]));
  return lanes;
}

/// Places `count` triangles, from 1 to kMost.
inline void place_triangles(const LayerView& layer, const std::uint32_t* triangle,
                            std::size_t count, const Tile& tile, PlacedTriangles* placed) {
  const double last_x = tile.width - 1, last_y = tile.height - 1;
  for (std::size_t i = 0; i < count; i += kPlacedAtOnce) {
    const PlacedLanes lanes = place_lanes(layer, triangle + i, count - i);
    for (int k = 0; k < 3; ++k) {
      store_placed(lanes.x[k], placed->x[k] + i);
      store_placed(lanes.y[k], placed->y[k] + i);
    }
    store_placed(lanes.left, placed->left + i);
    store_placed(lanes.right, placed->right + i);
    store_placed(lanes.top, placed->top + i);
    store_placed(lanes.bottom, placed->bottom + i);
    store_placed(clamped_floors(lanes.left - tile.x0, last_x), placed->begin + i);
    store_placed(clamped_floors(lanes.right - tile.x0, last_x) + 1, placed->end + i);
    store_placed(clamped_floors(lanes.top - tile.y0, last_y), placed->first_row + i);
    store_placed(clamped_floors(lanes.bottom - tile.y0, last_y) + 1, placed->end_row + i);
  }
}

/// Returns the smallest box that contains all triangles of a list.
inline Box box_of_triangles(const LayerView& layer, const TriangleList& triangles) {
  const PlacedDoubles far = PlacedDoubles{} + __builtin_huge_val();
  PlacedDoubles left = far, top = far, right = -far, bottom = -far;
  for (std::size_t i = 0; i < triangles.count; i += kPlacedAtOnce) {
    const PlacedLanes lanes = place_lanes(layer, triangles.triangle + i, triangles.count - i);
    left = least(left, lanes.left);
    right = greatest(right, lanes.right);
    top = least(top, lanes.top);
    bottom = greatest(bottom, lanes.bottom);
  }
  Box box;
  for (std::size_t i = 0; i < kPlacedAtOnce; ++i) {
    box.min = {box.min.x < left[i] ? box.min.x : left[i], box.min.y < top[i] ? box.min.y : top[i]};
    box.max = {box.max.x > right[i] ? box.max.x : right[i],
               box.max.y > bottom[i] ? box.max.y : bottom[i]};
  }
  return box;
}

}  // namespace SFUMATO_ISA
}  // namespace sfumato::raster
