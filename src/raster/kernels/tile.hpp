#pragma once

#include <cstddef>
#include <cstdint>

#include "base/pixel_rect.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/picture/picture.hpp"

/// The data that the parts of the rasterizer pass to one another: plain structures, the same for
/// kernels of every instruction set.
///
/// Frames: image coordinates are pixels, x right, y down; pixel (i, j) is the square from (i, j) to
/// (i + 1, j + 1), its centre at (i + 1/2, j + 1/2).
namespace sfumato::raster {

/// The size of tiles: the image is cut from its upper left corner, for any number of threads.
inline constexpr int kTileWidth = 256;
inline constexpr int kTileHeight = 64;
/// Floats from one row of a tile to the next; leaves room for whole registers past a row's end.
inline constexpr int kTileStride = kTileWidth + 16;
inline constexpr std::size_t kTileFloats = std::size_t{kTileStride} * kTileHeight;

/// A PatchField of a checked picture.
struct FieldView {
  const std::uint32_t* triangle_node = nullptr;
  const float* node_value = nullptr;
  int channel_count = 0;  ///< 0: no such field
  const std::uint32_t* shader = nullptr;
  int shader_count = 0;  ///< their weights are the last channels

  int first_weight() const { return channel_count - shader_count; }
  bool is_opacity() const { return first_weight() == 1; }
};

/// A patch layer placed in the image. The pointers point into a checked PatchLayer.
struct LayerView {
  std::uint32_t index = 0;  ///< in Picture::layers
  const Vec2* vertex_position = nullptr;
  const std::uint32_t* triangle_vertex = nullptr;
  const std::uint8_t* edge_is_curve = nullptr;
  const std::uint8_t* is_bent =
      nullptr;  ///< per triangle, raster/coverage/bends.hpp; null: unknown
  const SoftEdge* soft_edge = nullptr;
  std::size_t soft_edge_count = 0;
  const CurveBow* bow = nullptr;
  std::size_t bow_count = 0;
  FieldView color;
  FieldView opacity;
  const picture::PointFields* exact = nullptr;  ///< PatchLayer::exact_points
  PatchOrder order = PatchOrder::cubic;
  Box frame;  ///< PatchLayer::frame
  Affine image_from_layer;
  bool mirrored = false;  ///< image_from_layer reverses the orientation of triangles
};

/// The pixels of one tile, or of a rectangle in it, while they are painted: code values, one plane
/// per channel, premultiplied by alpha. Row j begins at j kTileStride.
struct Tile {
  int x0 = 0;  ///< pixels of the image
  int y0 = 0;
  int width = 0;  ///< at most kTileWidth
  int height = 0;
  float* color[3] = {};
  float* alpha = nullptr;  ///< null where every pixel is opaque

  PixelRect rect() const { return {x0, y0, x0 + width, y0 + height}; }

  /// Returns the part in `rect`, which must lie inside the tile.
  Tile part(const PixelRect& rect) const {
    const std::ptrdiff_t offset = std::ptrdiff_t{rect.y0 - y0} * kTileStride + (rect.x0 - x0);
    return {rect.x0,
            rect.y0,
            rect.x1 - rect.x0,
            rect.y1 - rect.y0,
            {color[0] + offset, color[1] + offset, color[2] + offset},
            alpha ? alpha + offset : nullptr};
  }
};

/// The triangles of a layer that may touch a tile, in increasing order.
struct TriangleList {
  const std::uint32_t* triangle = nullptr;
  std::size_t count = 0;
};

}  // namespace sfumato::raster
