#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "raster/local_stroke.hpp"
#include "raster/shader_set.hpp"
#include "raster/tile_bins.hpp"
#include "raster/triangle_blocks.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::raster {

/// One item of a picture's stack as it lies in the image.
struct PaintItem {
  enum class Kind : std::uint8_t {
    straight,  ///< an opaque instance in code values: painted directly onto the tile
    shaded,    ///< any other instance: painted separately, then blended
    stroke,
    group_begin,
    group_end
  };

  Kind kind = Kind::straight;
  BlendMode blend = BlendMode::normal;  ///< of a group at its end
  float opacity = 1;
  TileRange tiles;  ///< that it may touch; for a group: that its content may touch
  LayerView layer;
  Affine layer_from_image;
  std::optional<std::uint32_t> bins;       ///< index into the list's bins, if the item has its own
  const TriangleBlocks* blocks = nullptr;  ///< else those of its layer
  const StrokePainter* stroke = nullptr;

  bool is_instance() const { return kind <= Kind::shaded; }
};

/// The stack of a picture, sorted into rows of tiles. Memory: 300 bytes per item and 4 for each row
/// that it touches. In addition, lists of triangles for the instances that touch many tiles; for
/// others (or when these lists have grown large) 1 byte per triangle of the layer, however often
/// the layer is in the stack.
class PaintList {
 public:
  /// The picture was checked and must outlive this. Triangles count as touching a tile when they
  /// come closer than margin_px. Errors: limit, cancelled.
  static Result<PaintList> create(Context& context, const Picture& picture,
                                  const Affine& image_from_artboard, const TileGrid& grid,
                                  double margin_px);

  double margin_px() const { return margin_px_; }

  /// Indices of the items that touch a row of tiles, from the bottom of the stack up.
  std::span<const std::uint32_t> row(int tile_row) const;
  const PaintItem& item(std::uint32_t index) const { return items_[index]; }

  /// The triangles of an instance that touch a tile; `scratch` may hold them.
  TriangleList triangles(const PaintItem& item, std::size_t tile,
                         std::vector<std::uint32_t>* scratch) const;

  const TileGrid& grid() const { return grid_; }
  InterpolationSpace space() const { return space_; }
  const ShaderSet& shaders() const { return shaders_; }
  int group_depth() const { return group_depth_; }  ///< the deepest nesting of groups
  /// Whether everything is painted directly into the image.
  bool is_plain() const { return is_plain_; }

 private:
  struct LayerPlace {
    Box bounds;                         ///< layer frame
    std::vector<std::uint8_t> is_bent;  ///< per triangle, raster/bends.hpp
    std::optional<TriangleBlocks> blocks;
  };
  class Builder;

  TileGrid grid_;
  double margin_px_ = 0;
  InterpolationSpace space_ = InterpolationSpace::srgb;
  ShaderSet shaders_;
  std::vector<LayerPlace> layers_;
  std::vector<TileBins> bins_;
  std::vector<std::optional<StrokePainter>> strokes_;
  std::vector<PaintItem> items_;
  std::vector<std::size_t> row_first_;  ///< rows + 1 offsets into row_item_
  std::vector<std::uint32_t> row_item_;
  int group_depth_ = 0;
  bool is_plain_ = true;
  TableMemory memory_{"the picture's stack"};
};

}  // namespace sfumato::raster
