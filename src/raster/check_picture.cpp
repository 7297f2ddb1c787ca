#include "raster/check_picture.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/limits.hpp"
#include "document/document.hpp"

namespace sfumato::raster {
namespace {

/// Pixels per unit, and pixels from the image to the artboard's origin. Beyond, squares of pixel
/// coordinates could overflow.
constexpr double kLargestScale = 1e100;

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

bool all_below(const std::vector<std::uint32_t>& indices, std::size_t bound) {
  return std::all_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i < bound; });
}

bool is_position(Vec2 p) {
  return std::fabs(p.x) <= limits::kCoordinate && std::fabs(p.y) <= limits::kCoordinate;
}

bool is_share(float value) {
  return value >= 0 && value <= 1;
}

/// own_channels: those that are no shader's weight.
bool is_whole(const PatchField& field, int own_channels, const Picture& picture,
              const PatchLayer& layer) {
  const std::size_t channels = static_cast<std::size_t>(own_channels) + field.shader.size();
  if (field.channel_count < 0 || static_cast<std::size_t>(field.channel_count) != channels)
    return false;
  return field.triangle_node.size() == std::size_t{10} * layer.triangle_count() &&
         all_below(field.triangle_node, field.node_value.size() / channels) &&
         all_below(field.shader, picture.shaders.size());
}

bool is_whole(const PatchLayer& layer, const Picture& picture) {
  const std::size_t corners = std::size_t{3} * layer.triangle_count();
  return layer.triangle_vertex.size() == corners && layer.edge_is_curve.size() == corners &&
         layer.order <= PatchOrder::cubic && is_whole(layer.color, 3, picture, layer) &&
         (layer.opacity.channel_count == 0 || is_whole(layer.opacity, 1, picture, layer)) &&
         all_below(layer.triangle_vertex, layer.vertex_position.size()) &&
         std::all_of(layer.vertex_position.begin(), layer.vertex_position.end(), is_position);
}

Status check_layer(const Context& context, const PatchLayer& layer, const Picture& picture) {
  const std::size_t shaders = std::max(layer.color.shader.size(), layer.opacity.shader.size());
  if (shaders > context.limits.shaders_per_layer) {
    return limit_error(context.limits, &Limits::shaders_per_layer,
                       "shaders in a layer of the picture");
  }
  if (context.cancelled()) return context.stop_status();
  if (!is_whole(layer, picture)) return bad("a layer of the picture whose tables do not fit");
  return ok_status();
}

bool can_blend(float opacity, BlendMode blend) {
  return is_share(opacity) && blend <= BlendMode::luminosity;
}

/// One item of the stack; `depth` is the number of open groups.
struct ItemCheck {
  const Context& context;
  const Picture& picture;
  std::size_t* depth;

  Status operator()(const PatchInstance& instance) const {
    if (instance.layer >= picture.layers.size())
      return bad("an instance of a layer that is not there");
    if (!is_moderate(instance.artboard_from_layer))
      return bad("an instance placed beyond all numbers");
    if (!can_blend(instance.opacity, instance.blend))
      return bad("an instance with an opacity outside 0 to 1 or an unknown blend mode");
    return ok_status();
  }
  Status operator()(const LocalStroke& stroke) const {
    if (!is_moderate(stroke.artboard_from_stroke)) return bad("a stroke placed beyond all numbers");
    return validate(context, stroke);
  }
  Status operator()(const GroupBegin& group) const {
    if (!can_blend(group.opacity, group.blend))
      return bad("a group with an opacity outside 0 to 1 or an unknown blend mode");
    if (++*depth <= context.limits.group_depth) return ok_status();
    return limit_error(context.limits, &Limits::group_depth, "groups of the picture in each other");
  }
  Status operator()(const GroupEnd&) const {
    if (*depth == 0) return bad("a group of the picture ends that did not begin");
    --*depth;
    return ok_status();
  }
};

}  // namespace

bool is_moderate(const Affine& m) {
  const double entries[] = {m.a, m.b, m.c, m.d, m.e, m.f};
  return std::all_of(std::begin(entries), std::end(entries),
                     [](double entry) { return std::fabs(entry) <= kLargestScale; });
}

Status check_picture(const Context& context, const Picture& picture) {
  if (picture.interpolation > InterpolationSpace::oklab)
    return bad("a picture with an unknown interpolation space");
  if (picture.stack.size() > context.limits.stack_items) {
    return limit_error(context.limits, &Limits::stack_items, "items in the picture's stack");
  }
  if (Status status = validate(context, picture.shaders); !status) return status;
  for (const PatchLayer& layer : picture.layers)
    if (Status status = check_layer(context, layer, picture); !status) return status;
  std::size_t depth = 0;
  for (const PictureItem& item : picture.stack) {
    if (context.cancelled()) return context.stop_status();
    if (Status status = std::visit(ItemCheck{context, picture, &depth}, item); !status) {
      return status;
    }
  }
  return depth == 0 ? ok_status() : bad("a group of the picture that does not end");
}

}  // namespace sfumato::raster
