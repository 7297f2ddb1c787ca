#pragma once

#include <cstddef>
#include <cstdint>

#include "base/affine.hpp"
#include "base/image.hpp"
#include "base/vec2.hpp"
#include "patches/picture.hpp"

/// What the parts of the rasterizer hand to one another: plain data that kernels of every
/// instruction set read alike.
///
/// Frames: image coordinates are pixels, x right, y down; pixel (i, j) is the square from (i, j) to
/// (i + 1, j + 1), its centre at (i + 1/2, j + 1/2).
namespace sfumato::raster {

/// The image is cut into tiles of this size from its upper left corner, whatever runs them.
inline constexpr int kTileWidth = 256;
inline constexpr int kTileHeight = 64;
/// Floats from one row of a tile to the next: whole registers may be written past a row's end.
inline constexpr int kTileStride = kTileWidth + 16;
inline constexpr std::size_t kTileFloats = std::size_t{kTileStride} * kTileHeight;

/// A patch layer as it lies in the image. The pointers are those of a PatchLayer that was checked.
struct LayerView {
  const Vec2* vertex_position = nullptr;
  const std::uint32_t* triangle_vertex = nullptr;
  const std::uint8_t* edge_is_curve = nullptr;
  const std::uint32_t* triangle_node = nullptr;
  const float* node_value = nullptr;
  int channel_count = 3;
  PatchOrder order = PatchOrder::cubic;
  Affine image_from_layer;
  bool mirrored = false;  ///< image_from_layer turns clockwise triangles round
};

/// The pixels of one tile while they are painted: code values, one plane to a channel. Row j of the
/// tile begins at j kTileStride.
struct Tile {
  int x0 = 0;  ///< pixels of the image
  int y0 = 0;
  int width = 0;  ///< at most kTileWidth
  int height = 0;
  float* color[3] = {};
  float* alpha = nullptr;  ///< 1 where something was painted; null where the format has no alpha
};

/// The triangles of a layer that may touch a tile, in increasing order.
struct TriangleList {
  const std::uint32_t* triangle = nullptr;
  std::size_t count = 0;
};

}  // namespace sfumato::raster
