#include "raster/paint_list.hpp"

#include <algorithm>
#include <utility>

#include "base/try.hpp"

namespace sfumato::raster {
namespace {

/// Instances on more tiles get separate lists, as long as all of these lists together have no more
/// triangles than the largest layer may have.
constexpr std::size_t kTilesWithoutBins = 4;
constexpr std::size_t kBinnedTriangles = limits::kTriangles;

TileRange united(const TileRange& a, const TileRange& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace

class PaintList::Builder {
 public:
  Builder(Context& context, PaintList* list)
      : context_(context), plan_(*list->plan_), list_(*list) {}

  Status build();

 private:
  Status add(const PaintItem& item);
  Status add_instance(const PaintItem& item, const TileRange& tiles);
  void open_group(const PaintItem& item);
  void close_group(const PaintItem& item);
  Result<const TriangleBlocks*> blocks_of(std::uint32_t layer);
  Status place_triangles(ListedItem* listed);
  void touch(const TileRange& tiles);
  Status sort_into_rows();

  Context& context_;
  const PaintPlan& plan_;
  PaintList& list_;
  std::vector<std::uint32_t> open_groups_;
  std::size_t binned_triangles_ = 0;
};

/// Marks tiles. A group includes the items in it.
void PaintList::Builder::touch(const TileRange& tiles) {
  if (open_groups_.empty()) return;
  TileRange& group = list_.items_[open_groups_.back()].tiles;
  group = united(group, tiles);
}

Result<const TriangleBlocks*> PaintList::Builder::blocks_of(std::uint32_t layer) {
  if (const TriangleBlocks* blocks = plan_.blocks(layer)) return blocks;
  std::optional<TriangleBlocks>& own = list_.blocks_[layer];
  if (!own) {
    SFUMATO_TRY_ASSIGN(own, make_triangle_blocks(context_, plan_.picture().layers[layer]));
  }
  return &*own;
}

Status PaintList::Builder::place_triangles(ListedItem* listed) {
  const LayerView& layer = listed->item->layer;
  const std::uint32_t triangle_count = plan_.picture().layers[layer.index].triangle_count();
  if (listed->tiles.count() > kTilesWithoutBins && triangle_count >= list_.grid_.tile_count() &&
      binned_triangles_ + triangle_count <= kBinnedTriangles) {
    SFUMATO_TRY_ASSIGN(auto&& bins, bin_triangles(context_, layer, triangle_count, list_.grid_,
                                                  plan_.margin_px()));
    binned_triangles_ += triangle_count;
    listed->bins = static_cast<std::uint32_t>(list_.bins_.size());
    list_.bins_.push_back(std::move(bins));
    return ok_status();
  }
  SFUMATO_TRY_ASSIGN(const TriangleBlocks* blocks, blocks_of(layer.index));
  listed->blocks = blocks;
  return ok_status();
}

Status PaintList::Builder::add_instance(const PaintItem& item, const TileRange& tiles) {
  ListedItem listed{&item, tiles, {}, nullptr};
  if (item.is_instance()) {
    SFUMATO_TRY(place_triangles(&listed));
  }
  touch(tiles);
  list_.items_.push_back(listed);
  return ok_status();
}

void PaintList::Builder::open_group(const PaintItem& item) {
  open_groups_.push_back(static_cast<std::uint32_t>(list_.items_.size()));
  list_.items_.push_back({&item, {}, {}, nullptr});
}

void PaintList::Builder::close_group(const PaintItem& item) {
  const TileRange tiles = list_.items_[open_groups_.back()].tiles;
  open_groups_.pop_back();
  touch(tiles);
  list_.items_.push_back({&item, tiles, {}, nullptr});
}

Status PaintList::Builder::add(const PaintItem& item) {
  if (item.kind == PaintItem::Kind::group_begin) {
    open_group(item);
  } else if (item.kind == PaintItem::Kind::group_end) {
    close_group(item);
  } else {
    const TileRange tiles = tiles_of(item.bounds_px, list_.grid_);
    if (!tiles.empty()) return add_instance(item, tiles);
  }
  return ok_status();
}

/// Does a counting sort, so that each row's list is in the order of the stack.
Status PaintList::Builder::sort_into_rows() {
  TableMemory memory("lists of instances"), next_memory("lists of instances");
  std::vector<std::size_t>& first = list_.row_first_;
  std::vector<std::size_t> next;
  SFUMATO_TRY(memory.resize(context_, first, static_cast<std::size_t>(list_.grid_.rows()) + 1));
  for (const ListedItem& item : list_.items_)
    for (int y = item.tiles.y0; y < item.tiles.y1; ++y) ++first[static_cast<std::size_t>(y) + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  SFUMATO_TRY(memory.resize(context_, list_.row_item_, first.back()));
  SFUMATO_TRY(next_memory.append(context_, first, next));
  for (std::uint32_t i = 0; i < list_.items_.size(); ++i) {
    const TileRange& tiles = list_.items_[i].tiles;
    for (int y = tiles.y0; y < tiles.y1; ++y)
      list_.row_item_[next[static_cast<std::size_t>(y)]++] = i;
  }
  list_.memory_.take(std::move(memory));
  return ok_status();
}

Status PaintList::Builder::build() {
  const std::size_t layer_count = plan_.picture().layers.size();
  SFUMATO_TRY(list_.memory_.reserve(context_, list_.items_, plan_.items().size()));
  SFUMATO_TRY(list_.memory_.reserve(context_, list_.blocks_, layer_count));
  list_.blocks_.resize(layer_count);
  for (const PaintItem& item : plan_.items()) {
    if (context_.cancelled()) return context_.cancel_status();
    SFUMATO_TRY(add(item));
  }
  return sort_into_rows();
}

Result<PaintList> PaintList::create(Context& context, const PaintPlan& plan, const TileGrid& grid) {
  PaintList list;
  list.plan_ = &plan;
  list.grid_ = grid;
  SFUMATO_TRY(Builder(context, &list).build());
  return list;
}

std::span<const std::uint32_t> PaintList::row(int tile_row) const {
  const std::size_t first = row_first_[static_cast<std::size_t>(tile_row)];
  const std::size_t last = row_first_[static_cast<std::size_t>(tile_row) + 1];
  return {row_item_.data() + first, last - first};
}

TriangleList PaintList::triangles(const ListedItem& listed, std::size_t tile,
                                  std::vector<std::uint32_t>* scratch) const {
  const PixelRect rect = tile_rect(grid_, tile);
  const LayerView& layer = listed.item->layer;
  if (listed.bins) {
    const TriangleList binned = bins_[*listed.bins].of(tile);
    scratch->assign(binned.triangle, binned.triangle + binned.count);
  } else {
    list_triangles(layer, *listed.blocks, rect, margin_px(), scratch);
  }
  keep_meeting(layer, rect, margin_px(), scratch);
  return {scratch->data(), scratch->size()};
}

}  // namespace sfumato::raster
