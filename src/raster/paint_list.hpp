#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "raster/coverage/tile_bins.hpp"
#include "raster/coverage/triangle_blocks.hpp"
#include "raster/paint_plan.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::raster {

/// An item of a plan that the tiles of a window may show.
struct ListedItem {
  const PaintItem* item = nullptr;
  TileRange
      tiles;  ///< the tiles that it may touch; for a group: the tiles that its content may touch
  std::optional<std::uint32_t> bins;       ///< index into the list's bins, if the item has its own
  const TriangleBlocks* blocks = nullptr;  ///< else the blocks of its layer
};

/// The items of a plan, sorted into the rows of a window's tiles. Memory: 40 bytes per item and 4
/// for each row that it touches. In addition, lists of triangles for the instances that touch many
/// tiles; for others (or when these lists have grown large), unless the plan has blocks, 1 byte per
/// triangle of the layer, however often the layer is in the stack.
class PaintList {
 public:
  /// Makes a list. The plan must outlive it, and the grid must be one of its image. Errors: limit,
  /// cancelled.
  static Result<PaintList> create(Context& context, const PaintPlan& plan, const TileGrid& grid);

  double margin_px() const { return plan_->margin_px(); }

  /// Returns the indices of the items that touch a row of tiles, from the bottom of the stack up.
  std::span<const std::uint32_t> row(int tile_row) const;
  const ListedItem& item(std::uint32_t index) const { return items_[index]; }

  /// Returns the triangles of an instance that touch a tile, for any window; `scratch` holds them.
  TriangleList triangles(const ListedItem& listed, std::size_t tile,
                         std::vector<std::uint32_t>* scratch) const;

  const TileGrid& grid() const { return grid_; }
  InterpolationSpace space() const { return plan_->space(); }
  const ShaderSet& shaders() const { return plan_->shaders(); }
  int group_depth() const { return plan_->group_depth(); }
  bool is_plain() const { return plan_->is_plain(); }

 private:
  class Builder;

  const PaintPlan* plan_ = nullptr;
  TileGrid grid_;
  std::vector<TileBins> bins_;
  std::vector<std::optional<TriangleBlocks>> blocks_;  ///< per layer, where the plan has none
  std::vector<ListedItem> items_;
  std::vector<std::size_t> row_first_;  ///< rows + 1 offsets into row_item_
  std::vector<std::uint32_t> row_item_;
  TableMemory memory_{"the picture's stack"};
};

}  // namespace sfumato::raster
