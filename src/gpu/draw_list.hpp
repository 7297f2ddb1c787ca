#pragma once

#include <optional>
#include <vector>

#include "base/table_memory.hpp"
#include "display/paint_table.hpp"
#include "gpu/layer_tables.hpp"
#include "raster/kernels/local_stroke_kernels.hpp"
#include "raster/kernels/tile.hpp"

namespace sfumato::gpu {

/// One item of a picture's stack, placed in the image.
struct DrawItem {
  enum class Kind : std::uint8_t { instance, stroke, group_begin, group_end };

  Kind kind = Kind::instance;
  BlendMode blend = BlendMode::normal;  ///< at the end of a group
  float opacity = 1;
  PixelRect
      rect;  ///< the pixels that it may touch; for a group: the pixels that its content may touch
  std::uint32_t index = 0;  ///< layer, or stroke
  Affine image_from_layer;
};

/// A local curve: a run of the table of segments.
struct DrawStroke {
  int first_segment = 0;
  int segment_count = 0;
  raster::StrokeFrame frame;
  Affine image_from_segments;  ///< from positions relative to the origin of the table
};

/// Paints on the device.
struct PaintTables {
  display::PaintTable table;  ///< its texels are on the device only
  Table values, texels;
};

/// The input for painting a tile; large data is on the device.
class DrawList {
 public:
  /// Makes a list. The picture was checked and must outlive this. Errors: limit, cancelled. Cost:
  /// O(picture); items outside the image are left out.
  static Result<DrawList> create(Context& context, const Device& device, const Picture& picture,
                                 const Affine& image_from_artboard, const PixelRect& image,
                                 bool with_overlay);

  const Picture& picture() const { return *picture_; }
  const std::vector<DrawItem>& items() const { return items_; }
  int group_depth() const { return group_depth_; }
  /// Returns the tables of a layer that an item shows.
  const LayerTables& layer(std::uint32_t index) const { return *layers_[index]; }
  const DrawStroke& stroke(std::uint32_t index) const { return strokes_[index]; }
  bool has_strokes() const { return !strokes_.empty(); }
  const Table& segments() const { return segments_; }
  const std::optional<PaintTables>& paints() const { return paints_; }

 private:
  class Builder;

  const Picture* picture_ = nullptr;
  std::vector<DrawItem> items_;
  std::vector<std::optional<LayerTables>> layers_;
  std::vector<DrawStroke> strokes_;
  Table segments_;
  std::optional<PaintTables> paints_;
  int group_depth_ = 0;
  TableMemory memory_{"the picture's stack"};
};

}  // namespace sfumato::gpu
