#include "picture/check_picture.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "document/rules.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::picture {
namespace {

/// The largest pixels per unit, and pixels from the image to the artboard's origin. Beyond, squares
/// of pixel coordinates could overflow.
constexpr double kLargestScale = 1e100;

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

/// Compares only the largest, without an early exit, so that several are compared at once.
bool all_below(const std::vector<std::uint32_t>& indices, std::size_t bound) {
  std::uint32_t largest = 0;
  for (const std::uint32_t index : indices) largest = std::max(largest, index);
  return indices.empty() || largest < bound;
}

/// own_channels: the number of channels that are not a shader's weight.
bool is_whole(const PatchField& field, int own_channels, const Picture& picture,
              const PatchLayer& layer) {
  const std::size_t channels = static_cast<std::size_t>(own_channels) + field.shader.size();
  if (field.channel_count < 0 || static_cast<std::size_t>(field.channel_count) != channels)
    return false;
  if (layer.exact_points) {
    return field.triangle_node.empty() && field.node_value.empty() &&
           all_below(field.shader, picture.shaders.size());
  }
  return field.triangle_node.size() == std::size_t{kNodesPerTriangle} * layer.triangle_count() &&
         field.node_value.size() % channels == 0 &&
         all_below(field.triangle_node, field.node_value.size() / channels) &&
         all_below(field.shader, picture.shaders.size());
}

bool is_absent(const PatchField& field) {
  return field.channel_count == 0 && field.shader.empty();
}

bool is_whole(const SoftEdge& edge) {
  return rules::is_coordinate(edge.reach[0]) && rules::is_coordinate(edge.reach[1]) &&
         edge.contrast >= 0 && edge.contrast <= 2;
}

bool is_whole(const CurveBow& bow) {
  return std::ranges::all_of(bow.height, [](float h) { return rules::is_coordinate({h, 0}); });
}

/// Returns whether SoftEdges or CurveBows lie on half-edges of the layer, in their order.
template <class Edge>
bool are_edges(const std::vector<Edge>& edges, std::size_t corners) {
  const auto is_side = [&](std::uint32_t slot) {
    return slot == SoftEdge::kNone || slot < corners;
  };
  const auto is_edge = [&](const Edge& edge) {
    return is_side(edge.front) && is_side(edge.back) &&
           !(edge.front == SoftEdge::kNone && edge.back == SoftEdge::kNone) && is_whole(edge);
  };
  return std::ranges::all_of(edges, is_edge) &&
         std::ranges::is_sorted(edges, {}, painting_triangle<Edge>);
}

bool are_coordinates(const std::vector<Vec2>& positions) {
  return std::ranges::all_of(positions, [](Vec2 p) { return rules::is_coordinate(p); });
}

bool is_whole(const ExactField& field, int channels, const ExactLayer& layer) {
  const auto sides = static_cast<std::size_t>(std::ranges::count(field.edge, RayEdge::side));
  const auto is_kind = [](RayEdge edge) { return edge <= RayEdge::side; };
  const auto has_weight = [](const ExactSide& side) {
    return std::isfinite(side.weight) && side.weight > 0;
  };
  const auto is_placed = [](const ExactEnd& end) { return rules::is_coordinate(end.position); };
  return field.channel_count == channels && field.side.size() == sides &&
         field.edge.size() == layer.triangle_vertex.size() &&
         std::ranges::all_of(field.edge, is_kind) && std::ranges::all_of(field.side, has_weight) &&
         std::ranges::all_of(field.end, is_placed);
}

/// Returns whether positions lie around the coordinates. The triangulation for rays extends beyond
/// the outermost coordinates by a fraction of its size.
bool are_around_coordinates(const std::vector<Vec2>& positions) {
  return std::ranges::all_of(positions, [](Vec2 p) { return rules::is_coordinate(p / 2); });
}

/// Returns whether the layer has all of its exact fields, or none.
bool is_exact(const PatchLayer& layer) {
  const ExactLayer& exact = layer.exact;
  if (exact.field.empty()) return true;
  const std::size_t fields = is_absent(layer.opacity) ? 1 : 2;
  return exact.triangle_vertex.size() % 3 == 0 &&
         all_below(exact.triangle_vertex, exact.vertex_position.size()) &&
         are_around_coordinates(exact.vertex_position) && exact.field.size() == fields &&
         is_whole(exact.field[0], 3, exact) && (fields == 1 || is_whole(exact.field[1], 1, exact));
}

bool is_whole(const PatchLayer& layer, const Picture& picture) {
  const std::size_t corners = std::size_t{3} * layer.triangle_count();
  return layer.triangle_vertex.size() == corners && layer.edge_is_curve.size() == corners &&
         are_edges(layer.soft_edge, corners) && are_edges(layer.bow, corners) &&
         layer.order <= PatchOrder::cubic && is_whole(layer.color, 3, picture, layer) &&
         (is_absent(layer.opacity) || is_whole(layer.opacity, 1, picture, layer)) &&
         all_below(layer.triangle_vertex, layer.vertex_position.size()) &&
         are_coordinates(layer.vertex_position) && is_exact(layer);
}

Status check_layer(const Context& context, const PatchLayer& layer, const Picture& picture) {
  const std::size_t shaders = std::max(layer.color.shader.size(), layer.opacity.shader.size());
  if (shaders > context.limits.shaders_per_layer) {
    return limit_error(context.limits, &Limits::shaders_per_layer,
                       "shaders in a layer of the picture");
  }
  if (context.cancelled()) return context.cancel_status();
  if (!is_whole(layer, picture)) return bad("a layer of the picture whose tables do not fit");
  return ok_status();
}

}  // namespace

bool is_moderate(const Affine& m) {
  const double entries[] = {m.a, m.b, m.c, m.d, m.e, m.f};
  return std::all_of(std::begin(entries), std::end(entries),
                     [](double entry) { return std::fabs(entry) <= kLargestScale; });
}

bool can_be_drawn(const Box& viewport) {
  const double x_scale = kLargestImageSide / viewport.width();
  const double y_scale = kLargestImageSide / viewport.height();
  return is_moderate(
      {x_scale, 0, 0, y_scale, -viewport.min.x * x_scale, -viewport.min.y * y_scale});
}

Status check_picture(const Context& context, const Picture& picture, PictureUse use) {
  if (use == PictureUse::any && picture.for_pixel_grid) {
    return bad(
        "the picture was solved for a pixel grid and can only be rasterized; solve without "
        "pixel_grid");
  }
  SFUMATO_TRY(rules::check_interpolation(picture.interpolation));
  SFUMATO_TRY(rules::check_background(picture.background));
  SFUMATO_TRY(validate(context, picture.shaders));
  for (const PatchLayer& layer : picture.layers) SFUMATO_TRY(check_layer(context, layer, picture));
  return rules::check_stack(context, picture.stack, picture.layers.size());
}

}  // namespace sfumato::picture
