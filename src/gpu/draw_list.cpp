#include "gpu/draw_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/try.hpp"
#include "raster/coverage/triangle_blocks.hpp"
#include "raster/layers/local_stroke.hpp"
#include "raster/layers/overlay.hpp"

namespace sfumato::gpu {
namespace {

constexpr std::size_t kSegmentTexels = 7;

/// Appends a segment (docs/gpu.md, "stroke").
void append_segment(const curves::StrokeSegment& s, Vec2 origin, std::vector<float>* values) {
  const Vec2 start = s.start - origin;
  const auto& c = s.coefficient;
  const auto put = [values](auto... number) {
    (values->push_back(static_cast<float>(number)), ...);
  };
  put(start.x, start.y, c[0][0], c[0][1], c[1][0], c[1][1], c[2][0], c[2][1]);
  put(s.length_per_speed, s.node_count, s.influence_radius.start, s.influence_radius.end);
  put(s.blur_radius.start, s.blur_radius.end);
  for (const auto* side : {&s.left, &s.right}) {
    put(side->start.r, side->start.g, side->start.b, side->end.r, side->end.g, side->end.b);
  }
  put(0, 0);
}

bool has_shaders(const PatchLayer& layer) {
  return !layer.color.shader.empty() || !layer.opacity.shader.empty();
}

}  // namespace

class DrawList::Builder {
 public:
  Builder(Context& context, const Device& device, const Affine& image_from_artboard,
          const PixelRect& image, bool with_overlay, DrawList* list)
      : context_(context),
        device_(device),
        image_from_artboard_(image_from_artboard),
        image_(image),
        with_overlay_(with_overlay),
        list_(*list) {}

  Status build();

 private:
  Status add(const PatchInstance& instance);
  Status add(const LocalStroke& stroke);
  Status add(const GroupBegin& group);
  Status add(const GroupEnd&);
  void add_item(const DrawItem& item);
  Status upload(const DrawItem& item);
  Status upload_segments();
  Status upload_paints();

  Context& context_;
  const Device& device_;
  const Affine& image_from_artboard_;
  const PixelRect image_;
  const bool with_overlay_;
  DrawList& list_;
  std::vector<Box> bounds_;  ///< of the layers
  std::vector<std::uint32_t> open_groups_;
  TableMemory memory_{"the picture's stack"};
  std::vector<float> segment_values_;
  TableMemory segment_memory_{"local curves"};
  bool needs_paints_ = false;
};

/// Adds an item. A group includes the items in it.
void DrawList::Builder::add_item(const DrawItem& item) {
  if (!open_groups_.empty()) {
    PixelRect& group = list_.items_[open_groups_.back()].rect;
    group = united(group, item.rect);
  }
  list_.items_.push_back(item);
}

Status DrawList::Builder::add(const PatchInstance& instance) {
  const PatchLayer& layer = list_.picture_->layers[instance.layer];
  if (instance.opacity == 0 || layer.triangle_count() == 0) return ok_status();
  DrawItem item;
  item.blend = instance.blend;
  item.opacity = instance.opacity;
  item.index = instance.layer;
  item.image_from_layer = image_from_artboard_ * instance.artboard_from_layer;
  // A map onto a line paints nothing.
  if (!std::isfinite(1 / item.image_from_layer.determinant())) return ok_status();
  const double margin_px = with_overlay_ ? raster::kOverlayReachPx + 1 : 1;
  const Box bounds = raster::mapped_bounds(item.image_from_layer, bounds_[instance.layer]);
  item.rect = raster::pixels_in(bounds.grown_by(margin_px), image_);
  if (item.rect.empty()) return ok_status();
  add_item(item);
  return upload(item);
}

Status DrawList::Builder::upload(const DrawItem& item) {
  std::optional<LayerTables>& tables = list_.layers_[item.index];
  if (tables) return ok_status();
  const PatchLayer& layer = list_.picture_->layers[item.index];
  needs_paints_ |= has_shaders(layer);
  const Vec2 middle{0.5 * (item.rect.x0 + item.rect.x1), 0.5 * (item.rect.y0 + item.rect.y1)};
  Result<LayerTables> made =
      upload_layer(context_, device_, layer, inverse(item.image_from_layer)(middle), with_overlay_);
  if (made) tables.emplace(std::move(*made));
  return made.status();
}

Status DrawList::Builder::add(const LocalStroke& stroke) {
  SFUMATO_TRY_ASSIGN(const raster::PreparedStroke& prepared,
                     raster::prepare_stroke(context_, stroke, image_from_artboard_,
                                            list_.picture_->interpolation));
  const std::vector<curves::StrokeSegment>& segments = prepared.segments.segment;
  DrawItem item;
  item.kind = DrawItem::Kind::stroke;
  item.index = static_cast<std::uint32_t>(list_.strokes_.size());
  item.rect = raster::pixels_in(prepared.bounds_px, image_);
  if (segments.empty() || item.rect.empty()) return ok_status();
  SFUMATO_TRY(
      segment_memory_.make_room(context_, segment_values_, segments.size() * 4 * kSegmentTexels));
  const Vec2 middle{0.5 * (item.rect.x0 + item.rect.x1), 0.5 * (item.rect.y0 + item.rect.y1)};
  const Vec2 origin = inverse(prepared.image_from_frame)(middle);
  DrawStroke placed;
  placed.first_segment = static_cast<int>(segment_values_.size() / (4 * kSegmentTexels));
  placed.segment_count = static_cast<int>(segments.size());
  placed.frame = prepared.frame;
  placed.image_from_segments = prepared.image_from_frame * Affine{1, 0, 0, 1, origin.x, origin.y};
  for (const curves::StrokeSegment& segment : segments)
    append_segment(segment, origin, &segment_values_);
  list_.strokes_.push_back(placed);
  add_item(item);
  return ok_status();
}

Status DrawList::Builder::add(const GroupBegin& group) {
  DrawItem item;
  item.kind = DrawItem::Kind::group_begin;
  item.blend = group.blend;
  item.opacity = group.opacity;
  open_groups_.push_back(static_cast<std::uint32_t>(list_.items_.size()));
  list_.items_.push_back(item);
  list_.group_depth_ = std::max(list_.group_depth_, static_cast<int>(open_groups_.size()));
  return ok_status();
}

Status DrawList::Builder::add(const GroupEnd&) {
  DrawItem item = list_.items_[open_groups_.back()];
  item.kind = DrawItem::Kind::group_end;
  open_groups_.pop_back();
  add_item(item);
  return ok_status();
}

Status DrawList::Builder::upload_segments() {
  const std::size_t texels = segment_values_.size() / 4;
  SFUMATO_TRY_ASSIGN(list_.segments_,
                     Table::create(context_, device_, kColorTable, texels, "local curves"));
  list_.segments_.upload(0, texels, segment_values_.data());
  return ok_status();
}

Status DrawList::Builder::upload_paints() {
  SFUMATO_TRY_ASSIGN(auto&& made, display::make_paint_table(context_, *list_.picture_,
                                                            display::PaintTexels::kept));
  const std::size_t value_count = made.values.size() / 4, texel_count = made.texel_count;
  SFUMATO_TRY_ASSIGN(auto&& values,
                     Table::create(context_, device_, kColorTable, value_count, "gradients"));
  values.upload(0, value_count, made.values.data());
  SFUMATO_TRY_ASSIGN(auto&& texels,
                     Table::create(context_, device_, kTexelTable, texel_count, "textures"));
  texels.upload(0, texel_count, made.texels.data());
  made.memory.free(made.texels);
  list_.paints_.emplace(PaintTables{std::move(made), std::move(values), std::move(texels)});
  return ok_status();
}

Status DrawList::Builder::build() {
  const Picture& picture = *list_.picture_;
  TableMemory& memory = list_.memory_;
  SFUMATO_TRY(memory.reserve(context_, list_.items_, picture.stack.size()));
  SFUMATO_TRY(memory.reserve(context_, list_.strokes_, picture.stack.size()));
  SFUMATO_TRY(memory.reserve(context_, list_.layers_, picture.layers.size()));
  SFUMATO_TRY(memory_.resize(context_, bounds_, picture.layers.size()));
  list_.layers_.resize(picture.layers.size());
  for (std::size_t i = 0; i < bounds_.size(); ++i)
    for (Vec2 p : picture.layers[i].vertex_position) bounds_[i].extend(p);
  for (const PictureItem& item : picture.stack) {
    if (context_.cancelled()) return context_.cancel_status();
    SFUMATO_TRY(std::visit([&](const auto& x) { return add(x); }, item));
  }
  if (list_.has_strokes()) SFUMATO_TRY(upload_segments());
  if (needs_paints_) SFUMATO_TRY(upload_paints());
  return ok_status();
}

Result<DrawList> DrawList::create(Context& context, const Device& device, const Picture& picture,
                                  const Affine& image_from_artboard, const PixelRect& image,
                                  bool with_overlay) {
  DrawList list;
  list.picture_ = &picture;
  SFUMATO_TRY(Builder(context, device, image_from_artboard, image, with_overlay, &list).build());
  return list;
}

}  // namespace sfumato::gpu
