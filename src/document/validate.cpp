#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/limit_error.hpp"
#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "document/curve_change.hpp"
#include "document/rules.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {
namespace {

using rules::inside;
using rules::is_color;
using rules::is_coordinate;
using rules::is_share;
using rules::is_usable;

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

Status at_most(const Context& context, std::size_t count, std::size_t Limits::*limit,
               const char* what) {
  if (count <= context.limits.*limit) return ok_status();
  return make_limit_error(limit, std::to_string(count) + " " + what + "; the limit is " +
                                     limit_text(context.limits, limit, what));
}

bool is_length(float value) {
  return value >= 0 && is_coordinate(value);
}

/// Sums over the whole document that have limits.
struct Totals {
  std::size_t curves = 0;
  std::size_t control_points = 0;
  std::size_t stops = 0;
};

Status check_totals(const Context& context, const Totals& totals) {
  SFUMATO_TRY(at_most(context, totals.curves, &Limits::curves, "curves"));
  SFUMATO_TRY(at_most(context, totals.control_points, &Limits::control_points, "control points"));
  return at_most(context, totals.stops, &Limits::stops, "stops");
}

Status check_control_points(const std::vector<Vec2>& points) {
  if (points.size() < 4 || points.size() % 3 != 1) {
    return bad(std::to_string(points.size()) + " control points; use 3n+1 (4, 7, 10, …)");
  }
  const auto bad_point = std::ranges::find_if_not(points, [](Vec2 p) { return is_coordinate(p); });
  if (bad_point == points.end()) return ok_status();
  return bad("control point " + std::to_string(bad_point - points.begin()) +
             " is not finite or beyond the largest coordinate");
}

/// Checks that offsets are in range and never fall, and that is_value accepts the values.
template <class Value, class IsValue>
Status check_stops(const Context& context, const StopList<Value>& list, std::size_t piece_count,
                   IsValue is_value) {
  if (Status status = at_most(context, list.stops.size(), &Limits::stops_per_list, "stops");
      !status) {
    return status;
  }
  if (list.space > StopSpace::parameter) return bad("stops in an unknown space");
  const double end = list.space == StopSpace::parameter ? static_cast<double>(piece_count) : 1;
  double last = 0;
  for (std::size_t i = 0; i < list.stops.size(); ++i) {
    const Stop<Value>& stop = list.stops[i];
    if (!(stop.offset >= 0 && stop.offset <= end)) {
      return bad("stop " + std::to_string(i) + " lies outside the curve");
    }
    if (stop.offset < last) return bad("stop " + std::to_string(i) + " falls back");
    if (!is_value(stop.value))
      return bad("stop " + std::to_string(i) + " has a value out of range");
    last = stop.offset;
  }
  return ok_status();
}

template <class Value, class IsValue>
Status check_shader(const Context& context, const SideShader<Value>& shader,
                    std::size_t piece_count, std::size_t shader_count, IsValue is_value) {
  if (shader.kind > ShaderKind::image_domain) return bad("an unknown kind of shader");
  const bool has_stops = !shader.stops.empty();
  if (has_stops != (shader.kind == ShaderKind::curve_domain)) {
    return bad(has_stops ? "stops on a side that takes none" : "no stops");
  }
  if (shader.kind == ShaderKind::image_domain && shader.shader >= shader_count) {
    return bad("there is no shader " + std::to_string(shader.shader));
  }
  return check_stops(context, shader.stops, piece_count, is_value);
}

Status check_side(const Context& context, const Side& side, std::size_t piece_count,
                  std::size_t shader_count) {
  SFUMATO_TRY(
      inside("colour", check_shader(context, side.color, piece_count, shader_count, is_color)));
  SFUMATO_TRY(
      inside("opacity", check_shader(context, side.opacity, piece_count, shader_count, is_share)));
  return inside("blur radius", check_stops(context, side.blur_radius, piece_count, is_length));
}

Status check_curve(const Context& context, const Curve& curve, std::size_t shader_count) {
  SFUMATO_TRY(check_control_points(curve.control_points));
  SFUMATO_TRY(
      inside("left side", check_side(context, curve.left, curve.piece_count(), shader_count)));
  SFUMATO_TRY(
      inside("right side", check_side(context, curve.right, curve.piece_count(), shader_count)));
  if (!(curve.weight > 0 && curve.weight <= limits::kCoordinate)) {
    SFUMATO_TRY(bad("the weight is not above 0 and finite"));
  }
  return ok_status();
}

void note_shader(ShaderKind kind, std::uint32_t shader, std::size_t most,
                 std::vector<std::uint32_t>& used) {
  if (kind == ShaderKind::image_domain && std::ranges::find(used, shader) == used.end() &&
      used.size() <= most) {
    used.push_back(shader);
  }
}

/// Adds the shaders of a curve that `used` does not contain yet, while it has at most `most`.
void note_shaders(const Curve& curve, std::size_t most, std::vector<std::uint32_t>& used) {
  for (const Side* side : {&curve.left, &curve.right}) {
    note_shader(side->color.kind, side->color.shader, most, used);
    note_shader(side->opacity.kind, side->opacity.shader, most, used);
  }
}

std::size_t stop_count(const Side& side) {
  return side.color.stops.stops.size() + side.opacity.stops.stops.size() +
         side.blur_radius.stops.size();
}

Status check_curve_of(const Context& context, const Document& document, const Layer& layer,
                      std::size_t curve) {
  Status status = check_curve(context, layer.curves[curve], document.shaders.size());
  return status ? status : inside("curve " + std::to_string(curve), std::move(status));
}

Status check_curves(const Context& context, const Document& document, const Layer& layer) {
  for (std::size_t i = 0; i < layer.curves.size(); ++i) {
    if (context.cancelled()) return context.cancel_status();
    SFUMATO_TRY(check_curve_of(context, document, layer, i));
  }
  return ok_status();
}

/// Adds to the totals, and counts the shaders.
Status check_sums(const Context& context, const Layer& layer, Totals& totals) {
  std::vector<std::uint32_t> used_shaders;
  totals.curves += layer.curves.size();
  for (const Curve& curve : layer.curves) {
    if (context.cancelled()) return context.cancel_status();
    totals.control_points += curve.control_points.size();
    totals.stops += stop_count(curve.left) + stop_count(curve.right);
    note_shaders(curve, context.limits.shaders_per_layer, used_shaders);
  }
  return at_most(context, used_shaders.size(), &Limits::shaders_per_layer, "shaders");
}

/// Returns `status` of a layer with its place.
Status in_layer(const Context& context, const Document& document, std::size_t layer,
                Status status) {
  if (status) return status;
  if (context.cancelled()) return context.cancel_status();
  return inside("layer " + std::to_string(layer) + " \"" + document.layers[layer].id + "\"",
                std::move(status));
}

Status check_layers(const Context& context, const Document& document, Totals& totals) {
  Status status = at_most(context, document.layers.size(), &Limits::layers, "layers");
  for (std::size_t i = 0; status && i < document.layers.size(); ++i) {
    status = check_curves(context, document, document.layers[i]);
    if (status) status = check_sums(context, document.layers[i], totals);
    status = in_layer(context, document, i, std::move(status));
  }
  return status;
}

Status check_stroke(const Context& context, const LocalStroke& stroke) {
  const LocalCurve& curve = stroke.curve;
  const std::size_t pieces =
      curve.control_points.empty() ? 0 : (curve.control_points.size() - 1) / 3;
  SFUMATO_TRY(check_control_points(curve.control_points));
  SFUMATO_TRY(inside("left colour", check_stops(context, curve.left_color, pieces, is_color)));
  SFUMATO_TRY(inside("right colour", check_stops(context, curve.right_color, pieces, is_color)));
  SFUMATO_TRY(inside("blur radius", check_stops(context, curve.blur_radius, pieces, is_length)));
  SFUMATO_TRY(
      inside("influence radius", check_stops(context, curve.influence_radius, pieces, is_length)));
  const auto is_wide = [](const Stop<float>& stop) { return stop.value > 0; };
  if (std::ranges::none_of(curve.influence_radius.stops, is_wide)) {
    return bad("the influence radius is nowhere above 0");
  }
  if (!(curve.alpha >= 0 && curve.alpha <= limits::kCoordinate)) return bad("alpha is below 0");
  if (!is_usable(stroke.artboard_from_stroke)) return bad("the transform cannot be inverted");
  return ok_status();
}

void add(const LocalCurve& curve, Totals& totals) {
  totals.curves += 1;
  totals.control_points += curve.control_points.size();
  totals.stops += curve.left_color.stops.size() + curve.right_color.stops.size() +
                  curve.blur_radius.stops.size() + curve.influence_radius.stops.size();
}

void add_strokes(const Document& document, Totals& totals) {
  for (const StackItem& item : document.stack) {
    if (const auto* stroke = std::get_if<LocalStroke>(&item)) add(stroke->curve, totals);
  }
}

bool is_shape(const LinearGradient& shape) {
  return is_coordinate(shape.start) && is_coordinate(shape.end);
}

bool is_shape(const RadialGradient& shape) {
  return is_coordinate(shape.center) && is_coordinate(shape.focus) && is_coordinate(shape.radius) &&
         shape.radius > 0 && is_coordinate(shape.focal_radius) && shape.focal_radius >= 0;
}

Status check_paint(const Context& context, const GradientFill& fill) {
  if (!std::visit([](const auto& shape) { return is_shape(shape); }, fill.shape)) {
    return bad("the gradient's shape is out of range");
  }
  if (!is_usable(fill.layer_from_gradient)) return bad("the transform cannot be inverted");
  if (fill.spread > SpreadMethod::repeat) return bad("an unknown spread method");
  if (fill.stops.empty()) return bad("the gradient has no stops");
  if (Status status = at_most(context, fill.stops.size(), &Limits::stops_per_list, "stops");
      !status) {
    return status;
  }
  double last = 0;
  for (const GradientStop& stop : fill.stops) {
    if (!is_share(stop.offset) || stop.offset < last) return bad("a stop's offset is out of order");
    if (!is_color(stop.color) || !is_share(stop.alpha))
      return bad("a stop's colour is out of range");
    last = stop.offset;
  }
  return ok_status();
}

Status check_paint(const Context& context, const Texture& texture) {
  if (texture.width < 1 || texture.height < 1) return bad("the texture has no pixels");
  if (static_cast<std::size_t>(std::max(texture.width, texture.height)) >
      context.limits.image_side) {
    return limit_error(context.limits, &Limits::image_side, "pixels on a side of the texture");
  }
  const std::size_t texels = static_cast<std::size_t>(texture.width) * texture.height;
  if (texture.rgba.size() != 4 * texels) return bad("the texture's size and bytes disagree");
  if (!is_usable(texture.layer_from_texture)) return bad("the transform cannot be inverted");
  const bool has_period = texture.period.x > 0 && texture.period.y > 0;
  if (!is_coordinate(texture.period) || (!has_period && !(texture.period == Vec2{}))) {
    return bad("the texture's period is not above 0");
  }
  return ok_status();
}

Status check_textures(const Context& context, const std::vector<Shader>& shaders) {
  std::size_t textures = 0, texels = 0;
  for (const Shader& shader : shaders) {
    const auto* texture = std::get_if<Texture>(&shader.paint);
    if (!texture) continue;
    ++textures;
    texels += texture->rgba.size() / 4;
  }
  Status status = at_most(context, textures, &Limits::textures, "textures");
  return status ? at_most(context, texels, &Limits::texels, "texels") : status;
}

Status check_shaders(const Context& context, const std::vector<Shader>& shaders) {
  SFUMATO_TRY(check_textures(context, shaders));
  for (std::size_t i = 0; i < shaders.size(); ++i) {
    Status status = std::visit([&](const auto& paint) { return check_paint(context, paint); },
                               shaders[i].paint);
    if (!status) {
      return inside("shader " + std::to_string(i) + " \"" + shaders[i].id + "\"",
                    std::move(status));
    }
  }
  return ok_status();
}

Status check_document(const Context& context, const Document& document) {
  if (!rules::has_area(document.artboard)) {
    return bad("the artboard has no area or is out of range");
  }
  if (document.size_px &&
      !(document.size_px->x > 0 && document.size_px->y > 0 && is_finite(*document.size_px))) {
    return bad("the picture's size is not above 0");
  }
  SFUMATO_TRY(rules::check_interpolation(document.interpolation));
  SFUMATO_TRY(rules::check_background(document.background));
  Totals totals;
  SFUMATO_TRY(check_shaders(context, document.shaders));
  SFUMATO_TRY(check_layers(context, document, totals));
  SFUMATO_TRY(rules::check_stack(context, document.stack, document.layers.size()));
  add_strokes(document, totals);
  return check_totals(context, totals);
}

bool uses_same_shader(const Side& a, const Side& b) {
  const auto is_same = [](const auto& old, const auto& now) {
    return now.kind != ShaderKind::image_domain ||
           (old.kind == ShaderKind::image_domain && old.shader == now.shader);
  };
  return is_same(a.color, b.color) && is_same(a.opacity, b.opacity);
}

}  // namespace

bool adds_to_sums(const Curve& old, const Curve& curve) {
  return curve.control_points.size() > old.control_points.size() ||
         stop_count(curve.left) + stop_count(curve.right) >
             stop_count(old.left) + stop_count(old.right) ||
         !uses_same_shader(old.left, curve.left) || !uses_same_shader(old.right, curve.right);
}

Status validate_curve(const Context& context, const Document& document, std::uint32_t layer,
                      std::uint32_t curve) {
  Status status = check_curve_of(context, document, document.layers[layer], curve);
  return status ? context.check() : in_layer(context, document, layer, std::move(status));
}

Status validate_sums(const Context& context, const Document& document) {
  Totals totals;
  for (std::size_t i = 0; i < document.layers.size(); ++i) {
    SFUMATO_TRY(in_layer(context, document, i, check_sums(context, document.layers[i], totals)));
  }
  add_strokes(document, totals);
  return check_totals(context, totals);
}

Status validate(const Context& context, const std::vector<Shader>& shaders) {
  return public_verb(context, [&] { return check_shaders(context, shaders); });
}

Status validate(const Context& context, const LocalStroke& stroke) {
  return public_verb(context, [&] { return check_stroke(context, stroke); });
}

Status validate(const Context& context, const Document& document) {
  return public_verb(context, [&] { return check_document(context, document); });
}

}  // namespace sfumato
