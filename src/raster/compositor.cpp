#include "raster/compositor.hpp"

#include "base/try.hpp"

namespace sfumato::raster {

Compositor::Compositor(Context& context, const PaintList& list, const SpanKernels& kernels,
                       bool antialias)
    : context_(context),
      list_(list),
      kernels_(kernels),
      antialias_(antialias),
      mixed_(kernels),
      exact_(kernels, antialias),
      groups_(static_cast<std::size_t>(list.group_depth())) {
  if (!list.is_plain()) layer_painter_.emplace(kernels, antialias);
}

std::size_t Compositor::bytes(const PaintList& list) {
  if (list.is_plain()) return MixedPixels::kMostBytes;
  return MixedPixels::kMostBytes + LayerPainter::kBytes + kTileFloats * sizeof(float) +
         static_cast<std::size_t>(list.group_depth()) * TilePlanes::kBytes;
}

Tile Compositor::target(const PixelRect& rect) {
  Level& level = levels_.back();
  const PixelRect old = level.painted;
  const PixelRect all = united(old, rect);
  const auto clear_part = [&](const PixelRect& part) {
    if (!part.empty()) clear(level.tile.part(part));
  };
  if (old.empty()) {
    clear_part(all);
  } else {
    clear_part({all.x0, all.y0, all.x1, old.y0});
    clear_part({all.x0, old.y1, all.x1, all.y1});
    clear_part({all.x0, old.y0, old.x0, old.y1});
    clear_part({old.x1, old.y0, all.x1, old.y1});
  }
  level.painted = all;
  return level.tile.part(rect);
}

/// Returns the pixels of the tile that an instance may paint.
PixelRect Compositor::pixels_of(const PaintItem& item, const TriangleList& triangles) const {
  const PixelRect whole = levels_.back().tile.rect();
  const PixelRect rect = pixels_in(kernels_.box_of_triangles(item.layer, triangles), whole);
  if (rect.empty() || item.layer.soft_edge_count + item.layer.bow_count == 0) return rect;
  // Blurs and bows extend into transparent parts, where a layer has no triangles.
  return intersection(grown(rect, list_.margin_px()), whole);
}

Status Compositor::paint_straight(const PaintItem& item, const TriangleList& triangles) {
  const PixelRect rect = pixels_of(item, triangles);
  if (rect.empty()) return ok_status();
  const Tile tile = target(rect);
  if (item.layer.exact) {
    return exact_.paint_straight(context_, item.layer, item.layer_from_image, triangles, tile,
                                 &mixed_);
  }
  if (antialias_) {
    mixed_.mark(item.layer, triangles, tile);
    mixed_.keep_below(tile);
  }
  kernels_.draw_triangles(item.layer, triangles, tile, nullptr);
  if (antialias_) mixed_.paint(item.layer, triangles, tile);
  return ok_status();
}

Status Compositor::paint_shaded(const PaintItem& item, const TriangleList& triangles) {
  const PixelRect rect = pixels_of(item, triangles);
  if (rect.empty()) return ok_status();
  const ShadingInput input{list_.space(), &list_.shaders(), item.layer_from_image};
  SFUMATO_TRY_ASSIGN(const Tile& source,
                     layer_painter_->paint(context_, item.layer, input, triangles, rect, &exact_));
  kernels_.blend(source, item.opacity, item.blend, target(rect));
  return ok_status();
}

Status Compositor::paint_stroke(const StrokePainter& stroke) {
  const PixelRect whole = levels_.back().tile.rect();
  const PixelRect rect = pixels_in(stroke.bounds_px(), whole);
  if (rect.empty()) return ok_status();
  const Tile tile = target(rect);
  // Painting over opaque pixels leaves the ones of this plane unchanged.
  if (!tile.alpha) opaque_.resize(kTileFloats, 1);
  return stroke.paint(context_, tile.x0, tile.y0, tile.width, tile.height, tile.color[0],
                      tile.color[1], tile.color[2], tile.alpha ? tile.alpha : opaque_.data(),
                      kTileStride);
}

void Compositor::close_group(const PaintItem& item) {
  const Level group = levels_.back();
  levels_.pop_back();
  if (group.painted.empty()) return;
  kernels_.blend(group.tile.part(group.painted), item.opacity, item.blend, target(group.painted));
}

Status Compositor::paint_item(const ListedItem& listed, std::size_t tile_index) {
  const PaintItem& item = *listed.item;
  switch (item.kind) {
    case PaintItem::Kind::straight:
      return paint_straight(item, list_.triangles(listed, tile_index, &triangles_));
    case PaintItem::Kind::shaded:
      return paint_shaded(item, list_.triangles(listed, tile_index, &triangles_));
    case PaintItem::Kind::stroke:
      return paint_stroke(*item.stroke);
    case PaintItem::Kind::group_begin:
      levels_.push_back({groups_[levels_.size() - 1].tile(levels_.front().tile.rect()), {}});
      break;
    case PaintItem::Kind::group_end:
      close_group(item);
      break;
  }
  return ok_status();
}

Status Compositor::paint(std::size_t tile_index, const Tile& root) {
  levels_.assign(1, {root, root.rect()});
  mixed_.start_tile();
  const int columns = list_.grid().columns();
  const int column = static_cast<int>(tile_index % static_cast<std::size_t>(columns));
  const int row = static_cast<int>(tile_index / static_cast<std::size_t>(columns));
  for (std::uint32_t index : list_.row(row)) {
    if (context_.cancelled()) return context_.cancel_status();
    const ListedItem& listed = list_.item(index);
    if (column < listed.tiles.x0 || column >= listed.tiles.x1) continue;
    SFUMATO_TRY(paint_item(listed, tile_index));
  }
  return ok_status();
}

}  // namespace sfumato::raster
