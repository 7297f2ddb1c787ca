#include "gpu/painter.hpp"

#include <string>
#include <utility>

#include "base/try.hpp"
#include "raster/layers/overlay.hpp"

namespace sfumato::gpu {
namespace {

constexpr int kSegmentInstances = 16;

constexpr GLuint kPaintViewBinding = 0;
constexpr std::size_t kMostPaints = 2 * limits::kShadersPerLayer;

constexpr unsigned kWithOpacity = 1;
constexpr unsigned kWithPaints = 2;
constexpr unsigned kCenters = 0;
constexpr unsigned kWithAreas = 4;
constexpr unsigned kWithStrips = 8;

unsigned variant_of(const PatchLayer& layer) {
  const bool has_paints = !layer.color.shader.empty() || !layer.opacity.shader.empty();
  return (layer.opacity.channel_count > 0 ? kWithOpacity : 0) | (has_paints ? kWithPaints : 0);
}

/// Maps pixels to normalised device coordinates.
Affine clip_from_pixels(double width, double height) {
  return {2 / width, 0, 0, 2 / height, -1, -1};
}

Affine moved_by(Vec2 p) {
  return {1, 0, 0, 1, p.x, p.y};
}

}  // namespace

Painter::Painter(Context& context, const Device& device, const DrawList& list,
                 const PaintSettings& settings)
    : context_(context),
      device_(device),
      list_(list),
      settings_(settings),
      vertex_array_(make_vertex_array()),
      paint_views_(make_buffer()) {
  glBindVertexArray(vertex_array_.name());
  glEnable(GL_SCISSOR_TEST);
  glBindBuffer(GL_UNIFORM_BUFFER, paint_views_.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, kPaintViewBinding, paint_views_.name());
}

Result<Painter> Painter::create(Context& context, const Device& device, const DrawList& list,
                                const PaintSettings& settings) {
  Painter painter(context, device, list, settings);
  SFUMATO_TRY(painter.make_programs());
  SFUMATO_TRY(painter.make_targets());
  return painter;
}

Status Painter::make_patch_programs() {
  for (const DrawItem& item : list_.items()) {
    if (item.kind != DrawItem::Kind::instance) continue;
    const unsigned variant = variant_of(list_.picture().layers[item.index]);
    for (unsigned kind : {kCenters, kWithAreas, kWithStrips}) {
      std::optional<Program>& slot = programs_.patch[variant | kind];
      if (slot || (kind && !settings_.antialias)) continue;
      std::vector<std::string_view> defines;
      if (variant & kWithOpacity) defines.push_back("WITH_OPACITY");
      if (variant & kWithPaints) defines.push_back("WITH_PAINTS");
      if (kind == kWithAreas) defines.push_back("WITH_AREAS");
      if (kind == kWithStrips) defines.push_back("WITH_STRIPS");
      SFUMATO_TRY_ASSIGN(auto&& program, Program::create("patch.vert", "patch.frag", defines));
      slot.emplace(std::move(program));
    }
  }
  return ok_status();
}

Status Painter::make_programs() {
  Status status = make_patch_programs();
  const auto make = [&](Program* slot, std::string_view vertex, std::string_view fragment,
                        const std::vector<std::string_view>& defines) {
    if (!status) return;
    Result<Program> program = Program::create(vertex, fragment, defines);
    if (program) *slot = std::move(*program);
    status = program.status();
  };
  make(&programs_.mark_edges, "edges.vert", "edges.frag", {});
  make(&programs_.mark_small, "patch.vert", "patch.frag", {"WITH_AREAS", "WITH_MARKS"});
  make(&programs_.mark_strips, "patch.vert", "patch.frag", {"WITH_STRIPS", "WITH_MARKS"});
  make(&programs_.stroke, "stroke.vert", "stroke.frag", {});
  make(&programs_.stroke_resolve, "screen.vert", "stroke_resolve.frag", {});
  make(&programs_.over, "screen.vert", "composite.frag", {"WITHOUT_BACKDROP"});
  make(&programs_.over_with_edges, "screen.vert", "composite.frag",
       {"WITHOUT_BACKDROP", "WITH_EDGES"});
  make(&programs_.blend, "screen.vert", "composite.frag", {});
  make(&programs_.blend_with_edges, "screen.vert", "composite.frag", {"WITH_EDGES"});
  make(&programs_.overlay, "overlay.vert", "overlay.frag", {});
  make(&programs_.present, "screen.vert", "present.frag", {});
  return status;
}

Status Painter::make_targets() {
  const GLenum format = settings_.single_precision ? GL_RGBA32F : GL_RGBA16F;
  const std::size_t bytes = settings_.single_precision ? 16 : 8;
  Status status;
  const auto make = [&](Target* target, GLenum of, std::size_t pixel_bytes,
                        bool with_stencil = false) {
    if (!status) return;
    Result<Target> made = Target::create(context_, device_, of, pixel_bytes, settings_.tile_width,
                                         settings_.tile_height, with_stencil);
    if (made) *target = std::move(*made);
    status = made.status();
  };
  levels_.resize(static_cast<std::size_t>(list_.group_depth()) + 1);
  for (Target& level : levels_) make(&level, format, bytes);
  make(&layer_, format, bytes);
  make(&spare_, format, bytes);
  make(&ink_, GL_RG8, 2);
  make(&result_, GL_RGBA32F, 16);
  make(&sums_, format, bytes, true);
  return status;
}

Affine Painter::tile_from_image() const {
  return moved_by({-static_cast<double>(tile_.x0), -static_cast<double>(tile_.y0)});
}

PixelRect Painter::in_tile(const PixelRect& rect) const {
  const PixelRect part = intersection(rect, tile_);
  return {part.x0 - tile_.x0, part.y0 - tile_.y0, part.x1 - tile_.x0, part.y1 - tile_.y0};
}

bool Painter::is_opaque(const DrawItem& item) const {
  return list_.picture().layers[item.index].opacity.channel_count == 0;
}

/// Maps pixels of the tile to [0, 1]² of the frame of the item's layer.
Affine Painter::frame_from_tile(const DrawItem& item) const {
  const Box& frame = list_.picture().layers[item.index].frame;
  const Affine unit_from_layer{1 / frame.width(),
                               0,
                               0,
                               1 / frame.height(),
                               -frame.min.x / frame.width(),
                               -frame.min.y / frame.height()};
  return unit_from_layer * inverse(tile_from_image() * item.image_from_layer);
}

/// Binds two vec4 for each paint of the layer, colours first (docs/gpu.md, PaintViews).
void Painter::bind_paints(const Program& program, const DrawItem& item) const {
  const PatchLayer& layer = list_.picture().layers[item.index];
  const PaintTables& paints = *list_.paints();
  const Affine layer_from_pixels = inverse(tile_from_image() * item.image_from_layer);
  std::array<float, 8 * kMostPaints> views{};
  std::size_t at = 0;
  for (const PatchField* field : {&layer.color, &layer.opacity}) {
    for (std::uint32_t shader : field->shader) {
      const Affine m = paints.table.paint_from_layer[shader] * layer_from_pixels;
      for (double x : {m.a, m.c, m.e, 1.0 * paints.table.first_value[shader], m.b, m.d, m.f, 0.0})
        views[at++] = static_cast<float>(x);
    }
  }
  glBufferData(GL_UNIFORM_BUFFER, sizeof(views), views.data(), GL_DYNAMIC_DRAW);
  glUniformBlockBinding(program.name(), glGetUniformBlockIndex(program.name(), "PaintViews"),
                        kPaintViewBinding);
  const LayerTables& tables = list_.layer(item.index);
  const auto weight_of = [](const FieldTables& field) {
    return field.weight ? field.weight->name() : 0;
  };
  program.bind("color_weight", 6, weight_of(tables.color));
  program.bind("opacity_weight", 7, tables.opacity ? weight_of(*tables.opacity) : 0);
  program.bind("paint_table", 8, paints.values.name());
  program.bind("paint_texels", 9, paints.texels.name());
  program.set("paint_count", static_cast<int>(layer.color.shader.size()),
              static_cast<int>(layer.opacity.shader.size()));
  program.set("paint_step", 1.0f);
}

void Painter::bind_layer(const Program& program, const DrawItem& item) const {
  const LayerTables& tables = list_.layer(item.index);
  program.bind("triangle_vertex", 0, tables.triangle_vertex.name());
  program.bind("vertex_position", 1, tables.vertex_position.name());
  program.set("pixel_from_layer",
              tile_from_image() * item.image_from_layer * moved_by(tables.origin));
  program.set("target_size", static_cast<double>(settings_.tile_width),
              static_cast<double>(settings_.tile_height));
}

/// Draws all triangles, or the strips of all soft edges, onto the current target.
void Painter::draw_patches(const DrawItem& item, unsigned kind) const {
  const PatchLayer& layer = list_.picture().layers[item.index];
  const LayerTables& tables = list_.layer(item.index);
  const unsigned variant = variant_of(layer) | kind;
  const Program& program = *programs_.patch[variant];
  program.use();
  bind_layer(program, item);
  if (kind == kWithStrips) bind_strips(program, item);
  if (kind == kWithAreas) program.bind("is_bent", 12, tables.is_bent.name());
  program.bind("triangle_node", 2, tables.color.node.name());
  program.bind("node_color", 3, tables.color.value.name());
  if (tables.opacity) {
    program.bind("triangle_opacity_node", 4, tables.opacity->node.name());
    program.bind("node_opacity", 5, tables.opacity->value.name());
  }
  program.set("clip_from_layer", clip_from_pixels(settings_.tile_width, settings_.tile_height) *
                                     tile_from_image() * item.image_from_layer *
                                     moved_by(tables.origin));
  program.set("first_triangle", 0);
  program.set("patch_order", static_cast<int>(layer.order) + 1);
  program.set("interpolation", static_cast<int>(list_.picture().interpolation));
  program.set("opacity", 1.0f);
  if (variant & kWithPaints) bind_paints(program, item);
  const std::uint32_t vertices = kind == kWithStrips  ? 6 * tables.soft_edge_count
                                 : kind == kWithAreas ? 6 * layer.triangle_count()
                                                      : 3 * layer.triangle_count();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices));
}

void Painter::bind_strips(const Program& program, const DrawItem& item) const {
  const LayerTables& tables = list_.layer(item.index);
  program.bind("soft_edge", 10, tables.soft_edge->name());
  program.bind("soft_reach", 11, tables.soft_reach->name());
  program.set("turn", item.image_from_layer.determinant() < 0 ? -1.0f : 1.0f);
}

/// Sets the pixels to 0 that edges, strips and small triangles touch, where the stencil is written.
void Painter::mark_pixels(const DrawItem& item) const {
  const LayerTables& tables = list_.layer(item.index);
  programs_.mark_edges.use();
  bind_layer(programs_.mark_edges, item);
  programs_.mark_edges.bind("edge_slot", 2, tables.edge_slot.name());
  glDrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(tables.curve_edge_count));
  programs_.mark_small.use();
  bind_layer(programs_.mark_small, item);
  programs_.mark_small.set("first_triangle", 0);
  programs_.mark_small.bind("is_bent", 12, tables.is_bent.name());
  const std::uint32_t triangles = list_.picture().layers[item.index].triangle_count();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * triangles));
  if (tables.soft_edge_count == 0) return;
  programs_.mark_strips.use();
  bind_layer(programs_.mark_strips, item);
  bind_strips(programs_.mark_strips, item);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * tables.soft_edge_count));
}

/// Marks the pixels that the layer's curves cut, and sums up their content there; alpha is negative
/// elsewhere.
void Painter::paint_edges(const DrawItem& item, const PixelRect& rect) const {
  sums_.begin(rect);
  sums_.clear(0, 0, 0, -1);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 1);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  mark_pixels(item);
  glStencilFunc(GL_EQUAL, 1, 1);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  draw_patches(item, kWithAreas);
  if (list_.layer(item.index).soft_edge_count > 0) draw_patches(item, kWithStrips);
  glDisable(GL_BLEND);
  glDisable(GL_STENCIL_TEST);
}

void Painter::paint_instance(const DrawItem& item, const PixelRect& rect) {
  glDisable(GL_BLEND);
  if (settings_.antialias) paint_edges(item, rect);
  layer_.begin(rect);
  layer_.clear();
  draw_patches(item, kCenters);
  composite(layer_.texture(), settings_.antialias, item, rect);
}

/// Composites onto the present level. is_layer: the source is layer_, with edges.
void Painter::composite(GLuint source, bool is_layer, const DrawItem& item, const PixelRect& rect) {
  const Target& level = levels_[level_];
  const bool is_normal = item.blend == BlendMode::normal;
  const Program& program = is_normal ? (is_layer ? programs_.over_with_edges : programs_.over)
                                     : (is_layer ? programs_.blend_with_edges : programs_.blend);
  program.use();
  program.bind("source", 0, source);
  program.set("opacity", item.opacity);
  if (is_layer) {
    program.bind("edges", 1, sums_.texture());
    program.set("is_opaque", is_opaque(item) ? 1 : 0);
    program.set("frame_from_pixel", frame_from_tile(item));
  }
  if (is_normal) {
    level.begin(rect);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return;
  }
  program.bind("backdrop", 2, level.texture());
  program.set("blend_mode", static_cast<int>(item.blend));
  glDisable(GL_BLEND);
  spare_.begin(rect);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  spare_.copy_to(level, rect);
}

void Painter::paint_stroke(const DrawItem& item, const PixelRect& rect) const {
  const DrawStroke& stroke = list_.stroke(item.index);
  const Affine pixel_from_frame = tile_from_image() * stroke.image_from_segments;
  sums_.begin(rect);
  sums_.clear();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  const Program& program = programs_.stroke;
  program.use();
  program.bind("stroke_segment", 0, list_.segments().name());
  program.set("first_segment", stroke.first_segment);
  program.set("pixel_from_frame", pixel_from_frame);
  program.set_linear("frame_from_pixel", inverse(pixel_from_frame));
  program.set("target_size", static_cast<double>(settings_.tile_width),
              static_cast<double>(settings_.tile_height));
  program.set("smallest_radius", stroke.frame.smallest_radius);
  program.set("two_sided", stroke.frame.two_sided ? 1 : 0);
  glDrawArraysInstanced(GL_TRIANGLES, 0, 6, kSegmentInstances * stroke.segment_count);
  levels_[level_].begin(rect);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  programs_.stroke_resolve.use();
  programs_.stroke_resolve.bind("sums", 0, sums_.texture());
  programs_.stroke_resolve.set("interpolation", static_cast<int>(stroke.frame.interpolation));
  programs_.stroke_resolve.set("alpha", stroke.frame.alpha);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Painter::paint_item(const DrawItem& item) {
  const PixelRect rect = in_tile(item.rect);
  if (rect.empty()) return;
  switch (item.kind) {
    case DrawItem::Kind::instance:
      return paint_instance(item, rect);
    case DrawItem::Kind::stroke:
      return paint_stroke(item, rect);
    case DrawItem::Kind::group_begin:
      levels_[++level_].begin(rect);
      return levels_[level_].clear();
    case DrawItem::Kind::group_end:
      --level_;
      return composite(levels_[level_ + 1].texture(), false, item, rect);
  }
}

void Painter::paint_overlay() const {
  const PixelRect whole{0, 0, settings_.tile_width, settings_.tile_height};
  ink_.begin(whole);
  ink_.clear();
  if (!settings_.overlay) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBlendEquation(GL_MAX);
  const Program& program = programs_.overlay;
  program.use();
  program.set("line_scale", 1.0f);
  program.set("first_triangle", 0);
  for (const DrawItem& item : list_.items()) {
    if (item.kind != DrawItem::Kind::instance || in_tile(item.rect).empty()) continue;
    const LayerTables& tables = list_.layer(item.index);
    bind_layer(program, item);
    program.bind("edge_is_curve", 2, tables.edge_is_curve->name());
    const std::uint32_t triangles = list_.picture().layers[item.index].triangle_count();
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(18 * triangles));
  }
  glBlendEquation(GL_FUNC_ADD);
}

void Painter::read(float* rgba) const {
  const int width = tile_.x1 - tile_.x0, height = tile_.y1 - tile_.y0;
  glDisable(GL_BLEND);
  result_.begin({0, 0, width, height});
  programs_.present.use();
  programs_.present.bind("picture", 0, levels_.front().texture());
  programs_.present.bind("ink", 1, ink_.texture());
  programs_.present.set("turned", 0);
  programs_.present.set("premultiplied", 0);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, rgba);
}

Status Painter::paint(const PixelRect& tile, float* rgba) {
  tile_ = tile;
  level_ = 0;
  const raster::Backdrop& back = settings_.backdrop;
  levels_.front().begin({0, 0, settings_.tile_width, settings_.tile_height});
  levels_.front().clear(back.alpha * back.color.r, back.alpha * back.color.g,
                        back.alpha * back.color.b, back.alpha);
  for (const DrawItem& item : list_.items()) {
    if (context_.cancelled()) return context_.cancel_status();
    paint_item(item);
  }
  paint_overlay();
  read(rgba);
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return ok_status();
  if (error == GL_OUT_OF_MEMORY)
    return make_error(StatusCode::out_of_memory, "out of memory on the GPU");
  return make_error(StatusCode::internal, "OpenGL reports error " + std::to_string(error));
}

}  // namespace sfumato::gpu
