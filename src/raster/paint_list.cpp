#include "raster/paint_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "raster/bends.hpp"
#include "raster/layer_view.hpp"

namespace sfumato::raster {
namespace {

/// Instances on more tiles get lists of their own, as long as these lists are of no more triangles
/// in all than the largest layer may have.
constexpr std::size_t kTilesWithoutBins = 4;
constexpr std::size_t kBinnedTriangles = limits::kTriangles;

bool is_painted_straight(const Picture& picture, const PatchInstance& instance) {
  const PatchLayer& layer = picture.layers[instance.layer];
  return picture.interpolation == InterpolationSpace::srgb && layer.opacity.channel_count == 0 &&
         layer.color.shader.empty() && instance.opacity == 1 && instance.blend == BlendMode::normal;
}

TileRange united(const TileRange& a, const TileRange& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace

class PaintList::Builder {
 public:
  Builder(Context& context, const Picture& picture, const Affine& image_from_artboard,
          PaintList* list)
      : context_(context),
        picture_(picture),
        image_from_artboard_(image_from_artboard),
        list_(*list) {}

  Status build();

 private:
  Status add(const PatchInstance& instance);
  Status add(const LocalStroke& stroke);
  Status add(const GroupBegin& group);
  Status add(const GroupEnd&);
  Status make_strokes();
  Status place_layers();
  Status place_triangles(std::uint32_t layer, PaintItem* item);
  void touch(const TileRange& tiles);
  Status sort_into_rows();

  Context& context_;
  const Picture& picture_;
  const Affine& image_from_artboard_;
  PaintList& list_;
  std::vector<std::uint32_t> open_groups_;
  std::size_t binned_triangles_ = 0;
  std::size_t next_stroke_ = 0;
};

/// What stands in a group counts for it.
void PaintList::Builder::touch(const TileRange& tiles) {
  if (open_groups_.empty()) return;
  TileRange& group = list_.items_[open_groups_.back()].tiles;
  group = united(group, tiles);
}

Status PaintList::Builder::place_triangles(std::uint32_t layer, PaintItem* item) {
  const std::uint32_t triangle_count = picture_.layers[layer].triangle_count();
  if (item->tiles.count() > kTilesWithoutBins && triangle_count >= list_.grid_.tile_count() &&
      binned_triangles_ + triangle_count <= kBinnedTriangles) {
    Result<TileBins> bins =
        bin_triangles(context_, item->layer, triangle_count, list_.grid_, list_.margin_px_);
    if (!bins) return bins.status();
    binned_triangles_ += triangle_count;
    item->bins = static_cast<std::uint32_t>(list_.bins_.size());
    list_.bins_.push_back(std::move(*bins));
    return ok_status();
  }
  std::optional<TriangleBlocks>& blocks = list_.layers_[layer].blocks;
  if (!blocks) {
    Result<TriangleBlocks> made = make_triangle_blocks(context_, picture_.layers[layer]);
    if (!made) return made.status();
    blocks = std::move(*made);
  }
  item->blocks = &*blocks;
  return ok_status();
}

Status PaintList::Builder::add(const PatchInstance& instance) {
  if (instance.opacity == 0 || picture_.layers[instance.layer].triangle_count() == 0)
    return ok_status();
  PaintItem item;
  item.layer = view_instance(picture_, instance, image_from_artboard_);
  item.layer.is_bent = list_.layers_[instance.layer].is_bent.data();
  // A map onto a line paints nothing.
  if (!std::isfinite(1 / item.layer.image_from_layer.determinant())) return ok_status();
  const Box bounds =
      mapped_bounds(item.layer.image_from_layer, list_.layers_[instance.layer].bounds);
  item.tiles = tiles_of(bounds.grown_by(list_.margin_px_), list_.grid_);
  if (item.tiles.empty()) return ok_status();
  item.layer_from_image = inverse(item.layer.image_from_layer);
  item.opacity = instance.opacity;
  item.blend = instance.blend;
  if (!is_painted_straight(picture_, instance)) {
    item.kind = PaintItem::Kind::shaded;
    list_.is_plain_ = false;
  }
  if (Status status = place_triangles(instance.layer, &item); !status) return status;
  touch(item.tiles);
  list_.items_.push_back(std::move(item));
  return ok_status();
}

Status PaintList::Builder::make_strokes() {
  TableMemory memory("local curves"), kept_memory("local curves");
  std::vector<const LocalStroke*> strokes;
  for (const PictureItem& item : picture_.stack) {
    const auto* stroke = std::get_if<LocalStroke>(&item);
    Status status = stroke ? memory.push_back(context_, strokes, stroke) : ok_status();
    if (!status) return status;
  }
  std::vector<Status> statuses;
  Status status = memory.resize(context_, statuses, strokes.size());
  if (status) status = kept_memory.reserve(context_, list_.strokes_, strokes.size());
  if (!status) return status;
  list_.strokes_.resize(strokes.size());
  list_.memory_.take(std::move(kept_memory));
  constexpr std::size_t kGrain = 16;
  status = parallel_for(context_, strokes.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Result<StrokePainter> painter =
          StrokePainter::create(context_, *strokes[i], image_from_artboard_, list_.space_);
      statuses[i] = painter.status();
      if (painter) list_.strokes_[i].emplace(std::move(*painter));
    }
  });
  if (!status) return status;
  const auto failed =
      std::find_if(statuses.begin(), statuses.end(), [](const Status& one) { return !one.ok(); });
  return failed == statuses.end() ? ok_status() : *failed;
}

Status PaintList::Builder::add(const LocalStroke&) {
  PaintItem item;
  item.kind = PaintItem::Kind::stroke;
  item.stroke = &*list_.strokes_[next_stroke_++];
  item.tiles = tiles_of(item.stroke->bounds_px(), list_.grid_);
  if (item.tiles.empty()) return ok_status();
  list_.is_plain_ = false;
  touch(item.tiles);
  list_.items_.push_back(std::move(item));
  return ok_status();
}

Status PaintList::Builder::add(const GroupBegin& group) {
  PaintItem item;
  item.kind = PaintItem::Kind::group_begin;
  item.opacity = group.opacity;
  item.blend = group.blend;
  open_groups_.push_back(static_cast<std::uint32_t>(list_.items_.size()));
  list_.items_.push_back(std::move(item));
  list_.group_depth_ = std::max(list_.group_depth_, static_cast<int>(open_groups_.size()));
  list_.is_plain_ = false;
  return ok_status();
}

Status PaintList::Builder::add(const GroupEnd&) {
  PaintItem item = list_.items_[open_groups_.back()];
  item.kind = PaintItem::Kind::group_end;
  open_groups_.pop_back();
  touch(item.tiles);
  list_.items_.push_back(std::move(item));
  return ok_status();
}

/// A counting sort, so that each row's list is in the order of the stack.
Status PaintList::Builder::sort_into_rows() {
  TableMemory memory("lists of instances"), next_memory("lists of instances");
  std::vector<std::size_t>& first = list_.row_first_;
  std::vector<std::size_t> next;
  Status status = memory.resize(context_, first, static_cast<std::size_t>(list_.grid_.rows()) + 1);
  if (!status) return status;
  for (const PaintItem& item : list_.items_)
    for (int y = item.tiles.y0; y < item.tiles.y1; ++y) ++first[static_cast<std::size_t>(y) + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  status = memory.resize(context_, list_.row_item_, first.back());
  if (status) status = next_memory.append(context_, first, next);
  if (!status) return status;
  for (std::uint32_t i = 0; i < list_.items_.size(); ++i) {
    const TileRange& tiles = list_.items_[i].tiles;
    for (int y = tiles.y0; y < tiles.y1; ++y)
      list_.row_item_[next[static_cast<std::size_t>(y)]++] = i;
  }
  list_.memory_.take(std::move(memory));
  return ok_status();
}

Status PaintList::Builder::place_layers() {
  const std::vector<PatchLayer>& layers = picture_.layers;
  Status status = list_.memory_.reserve(context_, list_.layers_, layers.size());
  if (!status) return status;
  list_.layers_.resize(layers.size());
  TableMemory mark_memory("marks of triangles");
  for (std::size_t i = 0; i < layers.size(); ++i) {
    for (Vec2 p : layers[i].vertex_position) list_.layers_[i].bounds.extend(p);
    Result<std::vector<std::uint8_t>> bent = bent_triangles(context_, layers[i], mark_memory);
    if (!bent) return bent.status();
    list_.layers_[i].is_bent = std::move(*bent);
  }
  list_.memory_.take(std::move(mark_memory));
  return ok_status();
}

Status PaintList::Builder::build() {
  Status status = list_.memory_.reserve(context_, list_.items_, picture_.stack.size());
  if (!status) return status;
  Result<ShaderSet> shaders = ShaderSet::create(context_, picture_);
  if (!shaders) return shaders.status();
  list_.shaders_ = std::move(*shaders);
  list_.space_ = picture_.interpolation;
  if (status = make_strokes(); !status) return status;
  if (status = place_layers(); !status) return status;
  for (const PictureItem& item : picture_.stack) {
    if (context_.cancelled()) return context_.cancel_status();
    status = std::visit([&](const auto& x) { return add(x); }, item);
    if (!status) return status;
  }
  return sort_into_rows();
}

Result<PaintList> PaintList::create(Context& context, const Picture& picture,
                                    const Affine& image_from_artboard, const TileGrid& grid,
                                    double margin_px) {
  PaintList list;
  list.grid_ = grid;
  list.margin_px_ = margin_px;
  Status status = Builder(context, picture, image_from_artboard, &list).build();
  if (!status) return status;
  return list;
}

std::span<const std::uint32_t> PaintList::row(int tile_row) const {
  const std::size_t first = row_first_[static_cast<std::size_t>(tile_row)];
  const std::size_t last = row_first_[static_cast<std::size_t>(tile_row) + 1];
  return {row_item_.data() + first, last - first};
}

TriangleList PaintList::triangles(const PaintItem& item, std::size_t tile,
                                  std::vector<std::uint32_t>* scratch) const {
  if (item.bins) return bins_[*item.bins].of(tile);
  list_triangles(item.layer, *item.blocks, tile_rect(grid_, tile), margin_px_, scratch);
  return {scratch->data(), scratch->size()};
}

}  // namespace sfumato::raster
