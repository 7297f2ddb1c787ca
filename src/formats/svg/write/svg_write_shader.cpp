#include "formats/svg/write/svg_write_shader.hpp"

#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "codecs/data_uri_write.hpp"

namespace sfumato::svg {
namespace {

void add_frame(Attributes& attributes, const char* name, const Affine& layer_from_paint) {
  if (!(layer_from_paint == Affine{})) attributes.add(name, transform_text(layer_from_paint));
}

void add_shape(Attributes& attributes, const LinearGradient& shape) {
  attributes.add("x1", number_text(shape.start.x)).add("y1", number_text(shape.start.y));
  attributes.add("x2", number_text(shape.end.x)).add("y2", number_text(shape.end.y));
}

void add_shape(Attributes& attributes, const RadialGradient& shape) {
  attributes.add("cx", number_text(shape.center.x)).add("cy", number_text(shape.center.y));
  attributes.add("r", number_text(shape.radius));
  if (shape.focus != shape.center) {
    attributes.add("fx", number_text(shape.focus.x)).add("fy", number_text(shape.focus.y));
  }
  if (shape.focal_radius > 0) attributes.add("fr", number_text(shape.focal_radius));
}

void write_stops(ElementWriter& writer, const std::vector<GradientStop>& stops) {
  for (const GradientStop& stop : stops) {
    Attributes attributes;
    attributes.add("offset", number_text(stop.offset)).add("stop-color", color_text(stop.color));
    if (stop.alpha != 1) attributes.add("stop-opacity", number_text(stop.alpha));
    writer.leaf("stop", attributes);
  }
}

void write_gradient(ElementWriter& writer, const GradientFill& fill, const std::string& id) {
  const bool is_linear = std::holds_alternative<LinearGradient>(fill.shape);
  const char* name = is_linear ? "linearGradient" : "radialGradient";
  Attributes attributes;
  attributes.add("id", id).add("gradientUnits", "userSpaceOnUse");
  std::visit([&attributes](const auto& shape) { add_shape(attributes, shape); }, fill.shape);
  if (fill.spread == SpreadMethod::reflect) attributes.add("spreadMethod", "reflect");
  if (fill.spread == SpreadMethod::repeat) attributes.add("spreadMethod", "repeat");
  add_frame(attributes, "gradientTransform", fill.layer_from_gradient);
  writer.open(name, attributes);
  write_stops(writer, fill.stops);
  writer.close(name);
}

Status write_texture(Context& context, ElementWriter& writer, const Texture& texture,
                     const std::string& id) {
  Attributes image;
  SFUMATO_TRY_ASSIGN(auto&& uri, codecs::data_uri(context, texture, image.memory()));
  SFUMATO_TRY(check_length(context, writer.text().size() + uri.size()));
  const bool has_period = texture.repeats && texture.period.x > 0;
  const Vec2 period =
      has_period ? texture.period
                 : Vec2{static_cast<double>(texture.width), static_cast<double>(texture.height)};
  Attributes pattern;
  pattern.add("id", id).add("patternUnits", "userSpaceOnUse");
  pattern.add("width", number_text(period.x)).add("height", number_text(period.y));
  add_frame(pattern, "patternTransform", texture.layer_from_texture);
  if (!texture.repeats) pattern.add("sf:repeats", "false");
  writer.open("pattern", pattern);
  image.add("width", std::to_string(texture.width)).add("height", std::to_string(texture.height));
  writer.leaf("image", image.add("xlink:href", std::move(uri)));
  writer.close("pattern");
  return ok_status();
}

}  // namespace

Status write_shader(Context& context, ElementWriter& writer, const Shader& shader,
                    const std::string& id) {
  if (const auto* texture = std::get_if<Texture>(&shader.paint)) {
    return write_texture(context, writer, *texture, id);
  }
  write_gradient(writer, std::get<GradientFill>(shader.paint), id);
  return ok_status();
}

std::string_view kind_of(const Shader& shader) {
  return std::holds_alternative<Texture>(shader.paint) ? "texture" : "gradient";
}

}  // namespace sfumato::svg
