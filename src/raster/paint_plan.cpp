#include "raster/paint_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "raster/coverage/bends.hpp"
#include "raster/layers/layer_view.hpp"

namespace sfumato::raster {
namespace {

bool is_painted_straight(const Picture& picture, const PatchInstance& instance) {
  const PatchLayer& layer = picture.layers[instance.layer];
  return picture.interpolation == InterpolationSpace::srgb && layer.opacity.channel_count == 0 &&
         layer.color.shader.empty() && instance.opacity == 1 && instance.blend == BlendMode::normal;
}

Box box_of_size(int width, int height) {
  return {{0, 0}, {static_cast<double>(width), static_cast<double>(height)}};
}

}  // namespace

class PaintPlan::Builder {
 public:
  Builder(Context& context, const Picture& picture, const Options& options, PaintPlan* plan)
      : context_(context),
        picture_(picture),
        options_(options),
        image_(box_of_size(options.width, options.height)),
        plan_(*plan) {}

  Status build();

 private:
  void add(const PatchInstance& instance);
  void add(const LocalStroke& stroke);
  void add(const GroupBegin& group);
  void add(const GroupEnd& group);
  Status make_strokes();
  Status place_layers();

  Context& context_;
  const Picture& picture_;
  const Options& options_;
  const Box image_;
  PaintPlan& plan_;
  std::vector<std::uint32_t> open_groups_;
  std::size_t next_stroke_ = 0;
};

void PaintPlan::Builder::add(const PatchInstance& instance) {
  if (instance.opacity == 0 || picture_.layers[instance.layer].triangle_count() == 0) return;
  const LayerPlace& place = plan_.layers_[instance.layer];
  PaintItem item;
  item.layer = view_instance(picture_, instance, options_.image_from_artboard);
  item.layer.is_bent = place.is_bent.data();
  // A map onto a line paints nothing.
  if (!std::isfinite(1 / item.layer.image_from_layer.determinant())) return;
  item.bounds_px =
      mapped_bounds(item.layer.image_from_layer, place.bounds).grown_by(plan_.margin_px_);
  if (!overlap(item.bounds_px, image_)) return;
  item.layer_from_image = inverse(item.layer.image_from_layer);
  item.opacity = instance.opacity;
  item.blend = instance.blend;
  if (!is_painted_straight(picture_, instance)) {
    item.kind = PaintItem::Kind::shaded;
    plan_.is_plain_ = false;
  }
  plan_.items_.push_back(item);
}

void PaintPlan::Builder::add(const LocalStroke&) {
  PaintItem item;
  item.kind = PaintItem::Kind::stroke;
  item.stroke = &*plan_.strokes_[next_stroke_++];
  item.bounds_px = item.stroke->bounds_px();
  if (!overlap(item.bounds_px, image_)) return;
  plan_.is_plain_ = false;
  plan_.items_.push_back(item);
}

void PaintPlan::Builder::add(const GroupBegin& group) {
  PaintItem item;
  item.kind = PaintItem::Kind::group_begin;
  item.opacity = group.opacity;
  item.blend = group.blend;
  open_groups_.push_back(static_cast<std::uint32_t>(plan_.items_.size()));
  plan_.items_.push_back(item);
  plan_.group_depth_ = std::max(plan_.group_depth_, static_cast<int>(open_groups_.size()));
  plan_.is_plain_ = false;
}

void PaintPlan::Builder::add(const GroupEnd&) {
  PaintItem item = plan_.items_[open_groups_.back()];
  item.kind = PaintItem::Kind::group_end;
  open_groups_.pop_back();
  plan_.items_.push_back(item);
}

Status PaintPlan::Builder::make_strokes() {
  TableMemory memory("local curves"), kept_memory("local curves");
  std::vector<const LocalStroke*> strokes;
  for (const PictureItem& item : picture_.stack) {
    const auto* stroke = std::get_if<LocalStroke>(&item);
    SFUMATO_TRY(stroke ? memory.push_back(context_, strokes, stroke) : ok_status());
  }
  std::vector<Status> statuses;
  SFUMATO_TRY(memory.resize(context_, statuses, strokes.size()));
  SFUMATO_TRY(kept_memory.reserve(context_, plan_.strokes_, strokes.size()));
  plan_.strokes_.resize(strokes.size());
  plan_.memory_.take(std::move(kept_memory));
  // The same for all windows of an image, as it decides where strokes are cut into segments.
  const Box image = united(kLargestImage, image_);
  constexpr std::size_t kGrain = 16;
  SFUMATO_TRY(
      parallel_for(context_, strokes.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          Result<StrokePainter> painter = StrokePainter::create(
              context_, *strokes[i], options_.image_from_artboard, plan_.space_, image);
          statuses[i] = painter.status();
          if (painter) plan_.strokes_[i].emplace(std::move(*painter));
        }
      }));
  const auto failed =
      std::find_if(statuses.begin(), statuses.end(), [](const Status& one) { return !one.ok(); });
  return failed == statuses.end() ? ok_status() : *failed;
}

Status PaintPlan::Builder::place_layers() {
  const std::vector<PatchLayer>& layers = picture_.layers;
  SFUMATO_TRY(plan_.memory_.reserve(context_, plan_.layers_, layers.size()));
  plan_.layers_.resize(layers.size());
  TableMemory mark_memory("marks of triangles");
  for (std::size_t i = 0; i < layers.size(); ++i) {
    LayerPlace& place = plan_.layers_[i];
    for (Vec2 p : layers[i].vertex_position) place.bounds.extend(p);
    SFUMATO_TRY_ASSIGN(place.is_bent, bent_triangles(context_, layers[i], mark_memory));
    if (!options_.has_blocks) continue;
    SFUMATO_TRY_ASSIGN(place.blocks, make_triangle_blocks(context_, layers[i]));
  }
  plan_.memory_.take(std::move(mark_memory));
  return ok_status();
}

Status PaintPlan::Builder::build() {
  SFUMATO_TRY(plan_.memory_.reserve(context_, plan_.items_, picture_.stack.size()));
  SFUMATO_TRY_ASSIGN(plan_.shaders_, ShaderSet::create(context_, picture_));
  plan_.space_ = picture_.interpolation;
  SFUMATO_TRY(make_strokes());
  SFUMATO_TRY(place_layers());
  for (const PictureItem& item : picture_.stack) {
    if (context_.cancelled()) return context_.cancel_status();
    std::visit([&](const auto& x) { add(x); }, item);
  }
  return ok_status();
}

Result<PaintPlan> PaintPlan::create(Context& context, const Picture& picture,
                                    const Options& options) {
  PaintPlan plan;
  plan.picture_ = &picture;
  plan.margin_px_ = options.margin_px;
  SFUMATO_TRY(Builder(context, picture, options, &plan).build());
  return plan;
}

}  // namespace sfumato::raster
