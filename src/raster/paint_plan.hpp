#pragma once

#include <optional>
#include <vector>

#include "base/table_memory.hpp"
#include "raster/coverage/tile_bins.hpp"
#include "raster/coverage/triangle_blocks.hpp"
#include "raster/layers/local_stroke.hpp"
#include "raster/shaders/shader_set.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::raster {

/// One item of a picture's stack, placed in the image.
struct PaintItem {
  enum class Kind : std::uint8_t {
    straight,  ///< an opaque instance in code values: painted directly onto the tile
    shaded,    ///< any other instance: painted separately, then blended
    stroke,
    group_begin,
    group_end
  };

  Kind kind = Kind::straight;
  BlendMode blend = BlendMode::normal;  ///< at the end of a group
  float opacity = 1;
  Box bounds_px;  ///< the box that it may paint; empty for a group
  LayerView layer;
  Affine layer_from_image;
  const StrokePainter* stroke = nullptr;

  bool is_instance() const { return kind <= Kind::shaded; }
};

/// Prepared data for painting a picture, for all windows of one image. Memory: 300 bytes per item,
/// 1 byte per triangle, and 1 more for the blocks.
class PaintPlan {
 public:
  struct Options {
    Affine image_from_artboard;
    int width = 0;  ///< width of the whole image, pixels
    int height = 0;
    /// Triangles count as touching a tile when they come closer than this.
    double margin_px = 0;
    bool has_blocks = false;  ///< whether blocks() has the blocks of every layer
  };

  /// Makes a plan. The picture was checked and must outlive it. Errors: limit, cancelled.
  static Result<PaintPlan> create(Context& context, const Picture& picture, const Options& options);

  const Picture& picture() const { return *picture_; }
  double margin_px() const { return margin_px_; }
  /// Returns the visible items, from the bottom of the stack up; groups also where they show
  /// nothing.
  const std::vector<PaintItem>& items() const { return items_; }
  /// Returns the blocks of a layer; null: not made.
  const TriangleBlocks* blocks(std::uint32_t layer) const {
    return layers_[layer].blocks ? &*layers_[layer].blocks : nullptr;
  }
  InterpolationSpace space() const { return space_; }
  const ShaderSet& shaders() const { return shaders_; }
  int group_depth() const { return group_depth_; }  ///< Returns the deepest nesting of groups.
  /// Returns whether everything is painted directly into the image.
  bool is_plain() const { return is_plain_; }

 private:
  struct LayerPlace {
    Box bounds;                         ///< layer frame
    std::vector<std::uint8_t> is_bent;  ///< per triangle, raster/coverage/bends.hpp
    std::optional<TriangleBlocks> blocks;
  };
  class Builder;

  const Picture* picture_ = nullptr;
  double margin_px_ = 0;
  InterpolationSpace space_ = InterpolationSpace::srgb;
  ShaderSet shaders_;
  std::vector<LayerPlace> layers_;
  std::vector<std::optional<StrokePainter>> strokes_;
  std::vector<PaintItem> items_;
  int group_depth_ = 0;
  bool is_plain_ = true;
  TableMemory memory_{"the picture's stack"};
};

}  // namespace sfumato::raster
