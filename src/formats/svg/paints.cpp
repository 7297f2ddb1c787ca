#include "formats/svg/paints.hpp"

#include <string>
#include <utility>

#include "formats/svg/gradient.hpp"
#include "formats/svg/paint_attributes.hpp"
#include "formats/svg/pattern.hpp"

namespace sfumato::svg {
namespace {

Paints::Key key_of(const void* paint, const Affine& map, Vec2 period) {
  return {paint, map.a, map.b, map.c, map.d, map.e, map.f, period.x, period.y};
}

}  // namespace

Result<std::uint32_t> Paints::shader(const PaintedShape& shape, std::string_view id) {
  const Result<Element> paint = input_.element_of(shape.element, id);
  if (!paint) return paint.status();
  note_use(*paint);
  const std::string_view name = paint->name();
  if (name == "linearGradient" || name == "radialGradient") return gradient(shape, *paint);
  if (name == "pattern") return pattern(shape, *paint);
  return input_.error(shape.element, tag(shape.element) + " is painted by #" +
                                         std::string(id).substr(0, 64) + ", which is a " +
                                         tag(*paint) + "; expected a linearGradient, a " +
                                         "radialGradient, or a pattern with one <image>");
}

/// The paint and those that it inherits from.
void Paints::note_use(Element paint) {
  while (used_.insert(paint.internal_object()).second) {
    if (!input_.attribute(paint, "href")) return;
    const Result<Element> parent = input_.referred(paint);
    if (!parent) return;
    paint = *parent;
  }
}

Result<std::uint32_t> Paints::gradient(const PaintedShape& shape, Element paint) {
  const Result<PaintAttributes> attributes = PaintAttributes::read(input_, paint);
  if (!attributes) return attributes.status();
  const Result<GradientFrame> frame = read_gradient_frame(input_, *attributes, shape);
  if (!frame) return frame.status();
  const Key key = key_of(paint.internal_object(), frame->layer_from_gradient, {});
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  Result<GradientFill> fill =
      read_gradient(input_, totals_, *attributes, *frame, viewport_, last_stops_);
  if (!fill) return fill.status();
  return add(key, paint, {{}, std::move(*fill)});
}

Result<std::uint32_t> Paints::pattern(const PaintedShape& shape, Element paint) {
  const Result<PaintAttributes> attributes = PaintAttributes::read(input_, paint);
  if (!attributes) return attributes.status();
  const Result<PatternPlace> place = read_pattern(input_, files_, *attributes, shape, viewport_);
  if (!place) return place.status();
  const Key key = key_of(place->file, place->layer_from_texture, place->period);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const codecs::RgbaImage& image = place->file->image;
  Texture texture{image.width, image.height,  {}, place->layer_from_texture,
                  true,        place->period, {}};
  const Context& context = input_.context();
  DocumentMemory& memory = input_.memory();
  Status status = totals_.count_texture(paint, image.rgba.size() / 4);
  if (!status) return status;
  status = memory.textures.append(context, image.rgba, texture.rgba);
  if (status) status = memory.texture_files.append(context, place->file->file, texture.file);
  if (!status) return input_.placed(paint, std::move(status));
  return add(key, paint, {{}, std::move(texture)});
}

Result<std::uint32_t> Paints::add(const Key& key, Element paint, Shader shader) {
  shader.id = paint.attribute("id").value();
  const auto index = static_cast<std::uint32_t>(shaders_.size());
  Status status = input_.push_back(paint, input_.memory().shaders, shaders_, std::move(shader));
  if (!status) return status;
  known_.emplace(key, index);
  return index;
}

}  // namespace sfumato::svg
