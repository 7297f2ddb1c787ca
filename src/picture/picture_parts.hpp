#pragma once

#include <concepts>
#include <initializer_list>
#include <optional>
#include <type_traits>
#include <variant>

#include "sfumato/picture/picture.hpp"
#include "sfumato/picture/picture_file.hpp"

/// The parts of a picture file in the order of the file (docs/picture-file.md), defined once for an
/// Archive that writes, counts or reads.
///
///   archive.number(x)       a number or an enum
///   archive.flag(x)         a bool
///   archive.table(v)        a vector of numbers
///   archive.text(s)         a string
///   archive.resize(v)       the length of a vector whose items follow one by one
///   archive.alternative(v)  the number of a variant's alternative
///   archive.ok()            whether to continue
///
/// The parts are const for an archive that writes.
namespace sfumato::picture {

template <class T, class Part>
concept Is = std::same_as<std::remove_const_t<T>, Part>;

/// A type that the archive passes as its bytes in memory.
template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class Archive>
void pass(Archive& archive, Number auto& number) {
  archive.number(number);
}

/// Passes parts one after another.
template <class Archive>
void pass_all(Archive& archive, auto&... part) {
  (pass(archive, part), ...);
}

template <class Archive>
void pass(Archive& archive, Is<Vec2> auto& v) {
  pass_all(archive, v.x, v.y);
}

template <class Archive>
void pass(Archive& archive, Is<Box> auto& box) {
  pass_all(archive, box.min, box.max);
}

template <class Archive>
void pass(Archive& archive, Is<Rgb> auto& color) {
  pass_all(archive, color.r, color.g, color.b);
}

template <class Archive>
void pass(Archive& archive, Is<Affine> auto& map) {
  for (auto* entry : {&map.a, &map.b, &map.c, &map.d, &map.e, &map.f}) pass(archive, *entry);
}

/// Passes items one by one, because they have padding in memory or their own tables.
template <class Archive, class Items>
void pass_items(Archive& archive, Items& items) {
  if (!archive.resize(items)) return;
  for (auto& item : items) {
    pass(archive, item);
    if (!archive.ok()) return;
  }
}

template <class Archive, class Value>
void pass_stop(Archive& archive, Value& stop) {
  pass_all(archive, stop.offset, stop.value);
}
template <class Archive>
void pass(Archive& archive, Is<Stop<Rgb>> auto& stop) {
  pass_stop(archive, stop);
}
template <class Archive>
void pass(Archive& archive, Is<Stop<float>> auto& stop) {
  pass_stop(archive, stop);
}

template <class Archive, class List>
requires Is<List, ColorStops> || Is<List, ScalarStops>
void pass(Archive& archive, List& list) {
  pass(archive, list.space);
  pass_items(archive, list.stops);
}

template <class Archive>
void pass(Archive& archive, Is<GradientStop> auto& stop) {
  pass_all(archive, stop.offset, stop.color, stop.alpha);
}

template <class Archive>
void pass(Archive& archive, Is<LinearGradient> auto& gradient) {
  pass_all(archive, gradient.start, gradient.end);
}

template <class Archive>
void pass(Archive& archive, Is<RadialGradient> auto& gradient) {
  pass_all(archive, gradient.center, gradient.focus, gradient.radius, gradient.focal_radius);
}

template <class Archive, class Variant>
void pass_variant(Archive& archive, Variant& variant) {
  if (!archive.alternative(variant)) return;
  std::visit([&archive](auto& part) { pass(archive, part); }, variant);
}

template <class Archive>
void pass(Archive& archive, Is<GradientFill> auto& fill) {
  pass_variant(archive, fill.shape);
  pass_all(archive, fill.spread, fill.layer_from_gradient);
  pass_items(archive, fill.stops);
}

template <class Archive>
void pass(Archive& archive, Is<Texture> auto& texture) {
  pass_all(archive, texture.width, texture.height);
  archive.table(texture.rgba);
  pass(archive, texture.layer_from_texture);
  archive.flag(texture.repeats);
  pass(archive, texture.period);
  archive.table(texture.file);
}

template <class Archive>
void pass(Archive& archive, Is<Shader> auto& shader) {
  archive.text(shader.id);
  pass_variant(archive, shader.paint);
}

template <class Archive>
void pass(Archive& archive, Is<PatchField> auto& field) {
  pass(archive, field.channel_count);
  archive.table(field.triangle_node);
  archive.table(field.node_value);
  archive.table(field.shader);
}

template <class Archive>
void pass(Archive& archive, Is<SoftEdge> auto& edge) {
  pass_all(archive, edge.front, edge.back, edge.reach[0], edge.reach[1], edge.contrast);
}

template <class Archive>
void pass(Archive& archive, Is<PatchLayer> auto& layer) {
  pass_all(archive, layer.frame, layer.order);
  archive.table(layer.vertex_position);
  archive.table(layer.triangle_vertex);
  archive.table(layer.edge_is_curve);
  pass_items(archive, layer.soft_edge);
  pass_all(archive, layer.color, layer.opacity);
}

template <class Archive>
void pass(Archive& archive, Is<PatchInstance> auto& instance) {
  pass_all(archive, instance.layer, instance.artboard_from_layer, instance.opacity, instance.blend);
}

template <class Archive>
void pass(Archive& archive, Is<LocalStroke> auto& stroke) {
  auto& curve = stroke.curve;
  archive.text(curve.id);
  archive.table(curve.control_points);
  pass_all(archive, curve.left_color, curve.right_color, curve.blur_radius, curve.influence_radius,
           curve.alpha, stroke.artboard_from_stroke);
}

template <class Archive>
void pass(Archive& archive, Is<GroupBegin> auto& group) {
  pass_all(archive, group.opacity, group.blend);
}

template <class Archive>
void pass(Archive&, Is<GroupEnd> auto&) {}

template <class Archive>
void pass(Archive& archive, Is<PictureItem> auto& item) {
  pass_variant(archive, item);
}

template <class Archive>
void pass(Archive& archive, Is<PictureOrigin> auto& origin) {
  pass_all(archive, origin.own_scale, origin.pixels_per_unit, origin.max_error);
}

template <class Archive>
void pass_background(Archive& archive, Is<std::optional<Rgb>> auto& background) {
  bool is_there = background.has_value();
  archive.flag(is_there);
  if (!is_there || !archive.ok()) return;
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(background)>>) {
    background.emplace();
  }
  pass(archive, *background);
}

template <class Archive>
void pass(Archive& archive, Is<Picture> auto& picture) {
  pass_all(archive, picture.artboard, picture.viewport, picture.interpolation);
  pass_background(archive, picture.background);
  pass_items(archive, picture.shaders);
  pass_items(archive, picture.layers);
  pass_items(archive, picture.stack);
}

}  // namespace sfumato::picture
