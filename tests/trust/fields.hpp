#pragma once

#include <tuple>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/lint/hint.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/picture/picture_file.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

/// The fields of every public struct that a caller fills in. A new field of a struct must be added
/// here: without it the number of names is wrong, and this does not compile.
namespace sfumato::test {

inline auto fields(Vec2& v) {
  auto& [x, y] = v;
  return std::tie(x, y);
}
inline auto fields(Rgb& v) {
  auto& [r, g, b] = v;
  return std::tie(r, g, b);
}
inline auto fields(Box& v) {
  auto& [min, max] = v;
  return std::tie(min, max);
}
inline auto fields(Affine& v) {
  auto& [a, b, c, d, e, f] = v;
  return std::tie(a, b, c, d, e, f);
}
template <class Value>
auto fields(Stop<Value>& v) {
  auto& [offset, value] = v;
  return std::tie(offset, value);
}
template <class Value>
auto fields(StopList<Value>& v) {
  auto& [space, stops] = v;
  return std::tie(space, stops);
}
template <class Value>
auto fields(SideShader<Value>& v) {
  auto& [kind, stops, shader] = v;
  return std::tie(kind, stops, shader);
}
inline auto fields(Side& v) {
  auto& [color, opacity, blur_radius] = v;
  return std::tie(color, opacity, blur_radius);
}
inline auto fields(Curve& v) {
  auto& [id, control_points, left, right, weight] = v;
  return std::tie(id, control_points, left, right, weight);
}
inline auto fields(LocalCurve& v) {
  auto& [id, control_points, left_color, right_color, blur_radius, influence_radius, alpha] = v;
  return std::tie(id, control_points, left_color, right_color, blur_radius, influence_radius,
                  alpha);
}
inline auto fields(GradientStop& v) {
  auto& [offset, color, alpha] = v;
  return std::tie(offset, color, alpha);
}
inline auto fields(LinearGradient& v) {
  auto& [start, end] = v;
  return std::tie(start, end);
}
inline auto fields(RadialGradient& v) {
  auto& [center, focus, radius, focal_radius] = v;
  return std::tie(center, focus, radius, focal_radius);
}
inline auto fields(GradientFill& v) {
  auto& [shape, spread, layer_from_gradient, stops] = v;
  return std::tie(shape, spread, layer_from_gradient, stops);
}
inline auto fields(Texture& v) {
  auto& [width, height, rgba, layer_from_texture, repeats, period, file] = v;
  return std::tie(width, height, rgba, layer_from_texture, repeats, period, file);
}
inline auto fields(Shader& v) {
  auto& [id, paint] = v;
  return std::tie(id, paint);
}
inline auto fields(Layer& v) {
  auto& [id, curves] = v;
  return std::tie(id, curves);
}
inline auto fields(LayerInstance& v) {
  auto& [layer, artboard_from_layer, opacity, blend] = v;
  return std::tie(layer, artboard_from_layer, opacity, blend);
}
inline auto fields(LocalStroke& v) {
  auto& [curve, artboard_from_stroke] = v;
  return std::tie(curve, artboard_from_stroke);
}
inline auto fields(GroupBegin& v) {
  auto& [opacity, blend] = v;
  return std::tie(opacity, blend);
}
inline auto fields(GroupEnd&) {
  return std::tuple<>();
}
inline auto fields(Document& v) {
  auto& [artboard, size_px, interpolation, background, shaders, layers, stack] = v;
  return std::tie(artboard, size_px, interpolation, background, shaders, layers, stack);
}
inline auto fields(PatchField& v) {
  auto& [channel_count, triangle_node, node_value, shader] = v;
  return std::tie(channel_count, triangle_node, node_value, shader);
}
inline auto fields(SoftEdge& v) {
  auto& [front, back, reach, contrast] = v;
  return std::tie(front, back, reach[0], reach[1], contrast);
}
inline auto fields(CurveBow& v) {
  auto& [front, back, height] = v;
  return std::tie(front, back, height[0], height[1], height[2]);
}
inline auto fields(ExactSide& v) {
  auto& [from, to, weight, blur_from, blur_to] = v;
  return std::tie(from[0], from[1], from[2], from[3], to[0], to[1], to[2], to[3], weight, blur_from,
                  blur_to);
}
inline auto fields(ExactEnd& v) {
  auto& [position, direction, bend, reach, weight, blur_positive, blur_negative, positive,
         negative] = v;
  return std::tie(position, direction, bend, reach, weight, blur_positive, blur_negative,
                  positive[0], positive[1], positive[2], positive[3], negative[0], negative[1],
                  negative[2], negative[3]);
}
inline auto fields(ExactField& v) {
  auto& [channel_count, edge, side, end] = v;
  return std::tie(channel_count, edge, side, end);
}
inline auto fields(ExactLayer& v) {
  auto& [tolerance, vertex_position, triangle_vertex, field] = v;
  return std::tie(tolerance, vertex_position, triangle_vertex, field);
}
inline auto fields(PatchLayer& v) {
  auto& [frame, order, vertex_position, triangle_vertex, edge_is_curve, soft_edge, bow, color,
         opacity, exact, exact_points] = v;
  static_cast<void>(exact_points);  // the solver's own
  return std::tie(frame, order, vertex_position, triangle_vertex, edge_is_curve, soft_edge, bow,
                  color, opacity, exact);
}
inline auto fields(PatchInstance& v) {
  auto& [layer, artboard_from_layer, opacity, blend] = v;
  return std::tie(layer, artboard_from_layer, opacity, blend);
}
inline auto fields(Picture& v) {
  auto& [artboard, viewport, interpolation, background, for_pixel_grid, shaders, layers, stack] = v;
  return std::tie(artboard, viewport, interpolation, background, for_pixel_grid, shaders, layers,
                  stack);
}
inline auto fields(PictureOrigin& v) {
  auto& [own_scale, pixels_per_unit, max_error] = v;
  return std::tie(own_scale, pixels_per_unit, max_error);
}
inline auto fields(gather::GatherOptions& v) {
  auto& [method, rays_per_node, seed] = v;
  return std::tie(method, rays_per_node, seed);
}
inline auto fields(DiffuseOptions& v) {
  auto& [viewport, pixels_per_unit, tolerance, min_angle_deg, max_area_fraction, max_error, order,
         gather, ends, ignore_blur, pixel_grid, exact_pixels, exact_fields] = v;
  return std::tie(viewport, pixels_per_unit, tolerance, min_angle_deg, max_area_fraction, max_error,
                  order, gather, ends, ignore_blur, pixel_grid, exact_pixels, exact_fields);
}
inline auto fields(RasterWindow& v) {
  auto& [x, y, of_width, of_height] = v;
  return std::tie(x, y, of_width, of_height);
}
inline auto fields(RasterOptions& v) {
  auto& [width, height, viewport, format, background, dither, antialias, mesh_overlay, window] = v;
  return std::tie(width, height, viewport, format, background, dither, antialias, mesh_overlay,
                  window);
}
inline auto fields(PdfOptions& v) {
  auto& [page_width_pt, dpi, max_error, title, flatten] = v;
  return std::tie(page_width_pt, dpi, max_error, title, flatten);
}
inline auto fields(EpsOptions& v) {
  auto& [page_width_pt, dpi, max_error, title] = v;
  return std::tie(page_width_pt, dpi, max_error, title);
}
inline auto fields(SvgOptions& v) {
  auto& [mode, scale, dpi, background, max_error, force] = v;
  return std::tie(mode, scale, dpi, background, max_error, force);
}
inline auto fields(GlbOptions& v) {
  auto& [max_error, dpi, size, background] = v;
  return std::tie(max_error, dpi, size, background);
}
inline auto fields(HtmlOptions& v) {
  auto& [title, background, fallback, fallback_type] = v;
  return std::tie(title, background, fallback, fallback_type);
}
inline auto fields(WebpOptions& v) {
  auto& [lossless, quality] = v;
  return std::tie(lossless, quality);
}
inline auto fields(Image& v) {
  auto& [width, height, format, bytes] = v;
  return std::tie(width, height, format, bytes);
}
inline auto fields(Hint& v) {
  auto& [kind, layer, curve, side, stack_item, shader, at, message] = v;
  return std::tie(kind, layer, curve, side, stack_item, shader, at, message);
}
inline auto fields(SourcePlace& v) {
  auto& [file, line, column] = v;
  return std::tie(file, line, column);
}
inline auto fields(Status& v) {
  auto& [code, message, where, limit] = v;
  static_cast<void>(limit);  // a name, any text
  return std::tie(code, message, where);
}
inline auto fields(Deadline& v) {
  auto& [at, seconds] = v;  // any time is valid
  static_cast<void>(at);
  return std::tie(seconds);
}
inline auto fields(Context& v) {
  auto& [executor, progress, budget, limits, cancel, deadline, simd, point_source, poll_watch,
         outer] = v;
  // The caller owns pointers. Limits, budget and the objects behind pointers have their own tests.
  static_cast<void>(executor), static_cast<void>(progress), static_cast<void>(budget);
  static_cast<void>(limits), static_cast<void>(cancel), static_cast<void>(poll_watch);
  static_cast<void>(outer), static_cast<void>(point_source);
  return std::tie(deadline, simd);
}

}  // namespace sfumato::test
