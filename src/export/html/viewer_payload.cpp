#include "export/html/viewer_payload.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "document/rules.hpp"
#include "export/html/viewer_exact.hpp"
#include "export/html/viewer_field.hpp"
#include "export/html/viewer_mesh.hpp"
#include "export/html/viewer_paints.hpp"
#include "export/html/viewer_stroke.hpp"
#include "picture/check_picture.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::string_view kPayloadMagic = "SFUMATO";
constexpr std::uint8_t kVersion = 1;
/// Added to the version where layers have no tables.
constexpr std::uint8_t kWithoutTables = 128;

enum class Tables : std::uint8_t { with, without };

/// Kinds of items of the stack, as the viewer numbers them.
enum class ItemKind : std::uint8_t { instance, stroke, group_begin, group_end };

void write_box(const Box& box, ByteWriter& out) {
  for (double value : {box.min.x, box.min.y, box.max.x, box.max.y}) out.f64(value);
}

void write_blending(float opacity, BlendMode blend, ByteWriter& out) {
  out.f32(opacity);
  out.u8(static_cast<std::uint8_t>(blend));
}

Status check_boxes(const Picture& picture) {
  if (rules::has_area(picture.artboard) && rules::has_area(picture.viewport)) return ok_status();
  return make_error(StatusCode::bad_input, "the picture's artboard or viewport is empty");
}

Status check_size(const Limits& limits, const Picture& picture) {
  std::size_t triangles = 0;
  for (const PatchLayer& layer : picture.layers) triangles += layer.triangle_count();
  if (triangles <= limits.viewer_triangles) return ok_status();
  return make_limit_error(&Limits::viewer_triangles, std::to_string(triangles) +
                                                         " triangles, the viewer takes " +
                                                         std::to_string(limits.viewer_triangles));
}

class PayloadWriter {
 public:
  PayloadWriter(Context& context, const Picture& picture, Tables tables)
      : context_(context), picture_(picture), tables_(tables), out_(context) {}

  Status run(const Rgb& background) {
    out_.raw({reinterpret_cast<const std::uint8_t*>(kPayloadMagic.data()), kPayloadMagic.size()});
    out_.u8(tables_ == Tables::with ? kVersion : kVersion | kWithoutTables);
    write_box(picture_.artboard, out_);
    write_box(picture_.viewport, out_);
    out_.u8(static_cast<std::uint8_t>(picture_.interpolation));
    for (float value : {background.r, background.g, background.b}) out_.f32(value);
    SFUMATO_TRY(write_paints(context_, picture_, out_));
    out_.varint(picture_.layers.size());
    for (const PatchLayer& layer : picture_.layers) {
      SFUMATO_TRY(tables_ == Tables::with ? write_layer(layer) : write_bare(layer));
    }
    out_.varint(picture_.stack.size());
    for (const PictureItem& item : picture_.stack) {
      SFUMATO_TRY(std::visit([this](const auto& x) { return write_item(x); }, item));
    }
    if (tables_ == Tables::with) return write_exact(context_, picture_, out_);
    return out_.status();
  }

  Result<std::vector<std::uint8_t>> finish() { return out_.finish(); }

 private:
  Status write_layer(const PatchLayer& layer) {
    SFUMATO_TRY_ASSIGN(auto&& mesh, order_for_viewer(context_, layer));
    out_.u8(static_cast<std::uint8_t>(layer.order));
    SFUMATO_TRY(write_mesh(context_, layer, mesh, out_));
    write_shaders(layer.color, out_);
    SFUMATO_TRY(
        write_field(context_, layer.color, mesh, viewer_step(picture_.interpolation), out_));
    out_.u8(layer.opacity.channel_count > 0 ? 1 : 0);
    if (layer.opacity.channel_count == 0) return ok_status();
    write_shaders(layer.opacity, out_);
    return write_field(context_, layer.opacity, mesh, viewer_step(InterpolationSpace::srgb), out_);
  }

  Status write_bare(const PatchLayer& layer) {
    out_.u8(static_cast<std::uint8_t>(layer.order));
    write_shaders(layer.color, out_);
    const bool has_opacity = layer.opacity.channel_count > 0;
    out_.u8(has_opacity ? 1 : 0);
    if (has_opacity) write_shaders(layer.opacity, out_);
    return ok_status();
  }

  static void write_shaders(const PatchField& field, ByteWriter& out) {
    out.varint(field.shader.size());
    for (std::uint32_t shader : field.shader) out.varint(shader);
  }

  void write_kind(ItemKind kind) { out_.u8(static_cast<std::uint8_t>(kind)); }

  Status write_item(const PatchInstance& instance) {
    write_kind(ItemKind::instance);
    out_.varint(instance.layer);
    const Affine& m = instance.artboard_from_layer;
    for (double value : {m.a, m.b, m.c, m.d, m.e, m.f}) out_.f64(value);
    write_blending(instance.opacity, instance.blend, out_);
    return ok_status();
  }
  Status write_item(const LocalStroke& stroke) {
    write_kind(ItemKind::stroke);
    return write_stroke(context_, stroke, picture_.interpolation, picture_.viewport,
                        &segment_count_, out_);
  }
  Status write_item(const GroupBegin& group) {
    write_kind(ItemKind::group_begin);
    write_blending(group.opacity, group.blend, out_);
    return ok_status();
  }
  Status write_item(const GroupEnd&) {
    write_kind(ItemKind::group_end);
    return ok_status();
  }

  Context& context_;
  const Picture& picture_;
  const Tables tables_;
  ByteWriter out_;
  std::size_t segment_count_ = 0;
};

Result<std::vector<std::uint8_t>> written(Context& context, const Picture& picture,
                                          const Rgb& background, Tables tables) {
  PayloadWriter writer(context, picture, tables);
  SFUMATO_TRY(writer.run(background));
  return writer.finish();
}

}  // namespace

Rgb viewer_background(const Picture& picture, const std::optional<Rgb>& wanted) {
  return wanted.value_or(picture.background.value_or(Rgb{1, 1, 1}));
}

Result<std::vector<std::uint8_t>> viewer_payload(Context& context, const Picture& picture,
                                                 const Rgb& background) {
  SFUMATO_TRY(picture::check_picture(context, picture));
  SFUMATO_TRY(check_boxes(picture));
  SFUMATO_TRY(check_size(context.limits, picture));
  return written(context, picture, background, Tables::with);
}

Result<std::vector<std::uint8_t>> viewer_stack(Context& context, const Picture& picture,
                                               const Rgb& background) {
  SFUMATO_TRY(check_boxes(picture));
  return written(context, picture, background, Tables::without);
}

}  // namespace sfumato::outputs
