#include "export/pixel_run.hpp"

#include <algorithm>
#include <cmath>

#include "base/boxes.hpp"
#include "base/try.hpp"
#include "export/picture_copy.hpp"
#include "export/pixel_part.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::outputs {
namespace {

Box reach(const LocalStroke& stroke) {
  float radius = 0;
  for (const auto& stop : stroke.curve.influence_radius.stops) {
    radius = std::max(radius, stop.value);
  }
  const Box box = box_of_points(stroke.curve.control_points).grown_by(radius);
  return box.empty() ? box : mapped_box(stroke.artboard_from_stroke, box);
}

Box reach(const PatchInstance& instance, const PatchLayer& layer) {
  const Box box = box_of_points(layer.vertex_position);
  return box.empty() ? box : mapped_box(instance.artboard_from_layer, box);
}

/// The items [first, last) alone, and where they can be seen.
class PartPicture {
 public:
  PartPicture(Context& context, const Picture& whole) : context_(context), whole_(whole) {
    part_.interpolation = whole.interpolation;
  }

  Status add(const PictureItem& item) {
    if (const auto* stroke = std::get_if<LocalStroke>(&item)) {
      box_ = united(box_, reach(*stroke));
      Status status = charge_.add(context_, bytes_of(stroke->curve), "items to be painted");
      return status ? memory_.push_back(context_, part_.stack, item) : status;
    }
    return add(std::get<PatchInstance>(item));
  }

  /// Returns the picture, on the box of pixels that its items can touch.
  Picture& on(const Box& box) {
    part_.artboard = part_.viewport = box;
    return part_;
  }

  const Box& box() const { return box_; }

 private:
  Status add(PatchInstance instance) {
    const PatchLayer& layer = whole_.layers[instance.layer];
    const auto known = std::ranges::find(copied_, instance.layer);
    const auto index = static_cast<std::uint32_t>(known - copied_.begin());
    if (known == copied_.end()) {
      SFUMATO_TRY(copy_layer(context_, layer, memory_, &part_.layers));
      if (part_.shaders.empty()) {
        SFUMATO_TRY(copy_shaders(context_, whole_.shaders, memory_, &part_.shaders));
      }
      copied_.push_back(instance.layer);
    }
    box_ = united(box_, reach(instance, layer));
    instance.layer = index;
    instance.blend = BlendMode::normal;
    return memory_.push_back(context_, part_.stack, instance);
  }

  Context& context_;
  const Picture& whole_;
  ScopedCharge charge_;  ///< of local curves
  TableMemory memory_{"items to be painted"};
  Picture part_;
  std::vector<std::uint32_t> copied_;
  Box box_;
};

BlendMode blend_of(const PictureItem& item) {
  const auto* instance = std::get_if<PatchInstance>(&item);
  return instance ? instance->blend : BlendMode::normal;
}

}  // namespace

bool needs_pixels(const Picture& picture, const PictureItem& item) {
  if (std::holds_alternative<LocalStroke>(item)) return true;
  const auto* instance = std::get_if<PatchInstance>(&item);
  if (!instance) return false;
  const PatchLayer& layer = picture.layers[instance->layer];
  return !layer.color.shader.empty() || !layer.opacity.shader.empty();
}

std::size_t pixel_run_end(const Picture& picture, std::size_t first) {
  std::size_t end = first + 1;
  if (run_blend(picture, first) != BlendMode::normal) return end;
  while (end < picture.stack.size() && needs_pixels(picture, picture.stack[end]) &&
         blend_of(picture.stack[end]) == BlendMode::normal) {
    ++end;
  }
  return end;
}

BlendMode run_blend(const Picture& picture, std::size_t first) {
  return blend_of(picture.stack[first]);
}

Result<PixelRun> paint_run(Context& context, const Picture& picture, std::size_t first,
                           std::size_t last, double pixels_per_unit) {
  PartPicture part(context, picture);
  for (std::size_t i = first; i < last; ++i) {
    SFUMATO_TRY(part.add(picture.stack[i]));
  }
  // Strokes thinner than a pixel reach as far as one of a pixel does.
  const Box seen = intersection(part.box().grown_by(2 / pixels_per_unit), picture.viewport);
  PixelRun result;
  if (!(seen.width() > 0 && seen.height() > 0)) return result;
  const Vec2 origin = picture.viewport.min;
  const auto pixel = [&](Vec2 p, auto round) {
    return Vec2{round((p.x - origin.x) * pixels_per_unit),
                round((p.y - origin.y) * pixels_per_unit)};
  };
  const Vec2 begin = pixel(seen.min, [](double x) { return std::floor(x); });
  const Vec2 end = pixel(seen.max, [](double x) { return std::ceil(x); });
  const auto side = [](double pixels) { return static_cast<int>(std::min(pixels, 1e9)); };
  result.width = side(end.x - begin.x);
  result.height = side(end.y - begin.y);
  result.box = {origin + begin * (1 / pixels_per_unit), origin + end * (1 / pixels_per_unit)};
  RasterOptions options;
  options.width = result.width;
  options.height = result.height;
  options.format = PixelFormat::rgba8;
  SFUMATO_TRY_ASSIGN(auto&& image, rasterize(context, part.on(result.box), options));
  ScopedCharge held;
  SFUMATO_TRY(held.add(context, capacity_bytes(image.bytes), "pixels"));
  SFUMATO_TRY(bleed(context, &image));
  SFUMATO_TRY_ASSIGN(result.png, encode_png(context, image));
  SFUMATO_TRY(result.charge.add(context, capacity_bytes(result.png), "pixels as PNG"));
  return result;
}

}  // namespace sfumato::outputs
