#pragma once

#include <optional>
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
  Box bounds_px;  ///< of what it may paint; empty for a group
  LayerView layer;
  Affine layer_from_image;
  const StrokePainter* stroke = nullptr;

  bool is_instance() const { return kind <= Kind::shaded; }
};

/// What the painting of a picture needs besides the picture, for all windows of one image.
/// Memory: 300 bytes per item, 1 byte per triangle, and 1 more for the blocks.
class PaintPlan {
 public:
  struct Options {
    Affine image_from_artboard;
    int width = 0;  ///< of the whole image, pixels
    int height = 0;
    /// Triangles count as touching a tile when they come closer than this.
    double margin_px = 0;
    bool has_blocks = false;  ///< whether blocks() has those of every layer
  };

  /// The picture was checked and must outlive this. Errors: limit, cancelled.
  static Result<PaintPlan> create(Context& context, const Picture& picture, const Options& options);

  const Picture& picture() const { return *picture_; }
  double margin_px() const { return margin_px_; }
  /// What the image shows, from the bottom of the stack up; groups also where they show nothing.
  const std::vector<PaintItem>& items() const { return items_; }
  /// Of a layer; null: not made.
  const TriangleBlocks* blocks(std::uint32_t layer) const {
    return layers_[layer].blocks ? &*layers_[layer].blocks : nullptr;
  }
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
