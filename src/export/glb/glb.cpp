#include "sfumato/export/glb/glb.hpp"

#include <algorithm>
#include <cmath>

#include "base/boxes.hpp"
#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "document/rules.hpp"
#include "export/glb/glb_file.hpp"
#include "export/glb/glb_layer.hpp"
#include "export/page.hpp"
#include "export/pixel_run.hpp"
#include "picture/check_picture.hpp"

namespace sfumato {
namespace {

using outputs::GlbFile;
using outputs::GlbMesh;
using outputs::is_positive;

constexpr double kUnitsPerInch = 96;
/// Sides that patches are not cut below, in the largest instance and in sizes of the picture.
constexpr double kSmallestPatchSide = 1.0 / 1024;

Status check(const Context& context, const Picture& picture, const GlbOptions& options) {
  if (!is_positive(options.dpi) || !is_positive(options.size) || !is_positive(options.max_error)) {
    return make_error(StatusCode::bad_input,
                      "dpi, size and error of a GLB must be positive numbers");
  }
  SFUMATO_TRY(outputs::check_viewport(picture.viewport));
  SFUMATO_TRY(rules::check_background(options.background));
  return picture::check_picture(context, picture);
}

/// The mesh of a layer that is shown as triangles.
struct LayerMesh {
  double largest_scale = 0;  ///< of its instances
  bool is_made = false;
  std::uint32_t geometry = 0;
  Vec2 origin;
};

class GlbWriter {
 public:
  GlbWriter(Context& context, const Picture& picture, const GlbOptions& options)
      : context_(context),
        picture_(picture),
        options_(options),
        file_(context),
        side_(std::max(picture.viewport.width(), picture.viewport.height())),
        layers_(picture.layers.size()) {}

  Result<std::vector<std::uint8_t>> write(ExportNotes* notes);

 private:
  void find_scales();
  Status add_background();
  Status add_stack();
  Status add(const PatchInstance& instance);
  Status add_pixels(std::size_t first, std::size_t end);
  Status make_layer(std::uint32_t layer);
  Status add_mesh(std::uint32_t geometry, const GlbFile::Material& material, const Affine& place);
  void tell(ExportNotes* notes) const;
  bool is_drawn(const PatchInstance& instance) const;

  Context& context_;
  const Picture& picture_;
  const GlbOptions& options_;
  GlbFile file_;
  double side_;
  std::vector<LayerMesh> layers_;
  std::vector<double> group_opacity_{1};
  std::size_t depth_ = 0;
  std::uint64_t triangles_ = 0;
  bool has_blends_ = false, has_groups_ = false, has_pixels_ = false;
};

bool GlbWriter::is_drawn(const PatchInstance& instance) const {
  return instance.artboard_from_layer.determinant() != 0 &&
         picture_.layers[instance.layer].triangle_count() > 0;
}

void GlbWriter::find_scales() {
  for (const PictureItem& item : picture_.stack) {
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance) continue;
    const double scale = outputs::instance_scale(instance->artboard_from_layer);
    double& largest = layers_[instance->layer].largest_scale;
    largest = std::max(largest, scale);
  }
}

/// `place` maps to the artboard, y up, its origin at the viewport's centre.
Status GlbWriter::add_mesh(std::uint32_t geometry, const GlbFile::Material& material,
                           const Affine& place) {
  SFUMATO_TRY_ASSIGN(const auto& mesh, file_.add_mesh(geometry, material));
  const double step = outputs::depth_step(side_, picture_.stack.size() + 1);
  return file_.add_node(mesh, place, step * static_cast<double>(depth_++));
}

Status GlbWriter::add_background() {
  const auto& color = options_.background ? options_.background : picture_.background;
  if (!color) return ok_status();
  const Box& viewport = picture_.viewport;
  SFUMATO_TRY_ASSIGN(const auto& geometry, file_.add_geometry(outputs::make_glb_box(
                                               viewport, viewport.center(), *color)));
  triangles_ += 2;
  return add_mesh(geometry, {}, {});
}

Status GlbWriter::make_layer(std::uint32_t layer) {
  LayerMesh& made = layers_[layer];
  if (made.is_made) return ok_status();
  const PatchLayer& source = picture_.layers[layer];
  made.origin = box_of_points(source.vertex_position).center();
  SFUMATO_TRY_ASSIGN(const GlbMesh& mesh,
                     outputs::make_glb_layer(context_, source, picture_.interpolation, made.origin,
                                             options_.max_error / 255,
                                             kSmallestPatchSide * side_ / made.largest_scale));
  SFUMATO_TRY_ASSIGN(const auto& geometry, file_.add_geometry(mesh));
  triangles_ += mesh.index.size() / 3;
  made.geometry = geometry;
  made.is_made = true;
  return ok_status();
}

Status GlbWriter::add(const PatchInstance& instance) {
  if (!is_drawn(instance)) return ok_status();
  SFUMATO_TRY(make_layer(instance.layer));
  has_blends_ |= instance.blend != BlendMode::normal;
  const LayerMesh& layer = layers_[instance.layer];
  GlbFile::Material material;
  material.opacity = instance.opacity * group_opacity_.back();
  material.is_blended =
      material.opacity < 1 || picture_.layers[instance.layer].opacity.channel_count > 0;
  const Affine& map = instance.artboard_from_layer;
  const Vec2 at = map(layer.origin) - picture_.viewport.center();
  return add_mesh(layer.geometry, material, {map.a, -map.b, -map.c, map.d, at.x, -at.y});
}

Status GlbWriter::add_pixels(std::size_t first, std::size_t end) {
  has_pixels_ = true;
  has_blends_ |= outputs::run_blend(picture_, first) != BlendMode::normal;
  SFUMATO_TRY_ASSIGN(const auto& run, outputs::paint_run(context_, picture_, first, end,
                                                         options_.dpi / kUnitsPerInch));
  if (run.box.empty()) return ok_status();
  SFUMATO_TRY_ASSIGN(const auto& image, file_.add_image(run.png));
  const Vec2 origin = picture_.viewport.center();
  SFUMATO_TRY_ASSIGN(const auto& geometry,
                     file_.add_geometry(outputs::make_glb_picture(run.box, origin)));
  triangles_ += 2;
  return add_mesh(geometry, {group_opacity_.back(), true, image}, {});
}

Status GlbWriter::add_stack() {
  const std::vector<PictureItem>& stack = picture_.stack;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (context_.cancelled()) return context_.cancel_status();
    if (outputs::needs_pixels(picture_, stack[i])) {
      const std::size_t end = outputs::pixel_run_end(picture_, i);
      SFUMATO_TRY(add_pixels(i, end));
      i = end - 1;
    } else if (const auto* group = std::get_if<GroupBegin>(&stack[i])) {
      has_groups_ |= group->opacity != 1;
      has_blends_ |= group->blend != BlendMode::normal;
      group_opacity_.push_back(group_opacity_.back() * group->opacity);
    } else if (std::holds_alternative<GroupEnd>(stack[i])) {
      group_opacity_.pop_back();
    } else {
      SFUMATO_TRY(add(std::get<PatchInstance>(stack[i])));
    }
  }
  return ok_status();
}

void GlbWriter::tell(ExportNotes* notes) const {
  if (!notes) return;
  notes->triangle_count += triangles_;
  if (has_blends_) notes->lost.push_back("blend modes other than normal are shown as normal");
  if (has_groups_) {
    notes->lost.push_back(
        "the opacity of a group is given to each item in it instead of the whole");
  }
  if (has_pixels_) {
    notes->lost.push_back(
        "local curves and layers with textures or gradients are stored as textures");
  }
}

Result<std::vector<std::uint8_t>> GlbWriter::write(ExportNotes* notes) {
  find_scales();
  SFUMATO_TRY(add_background());
  SFUMATO_TRY(add_stack());
  tell(notes);
  return file_.finish(options_.size / side_);
}

Result<std::vector<std::uint8_t>> write(Context& context, const Picture& picture,
                                        const GlbOptions& options, ExportNotes* notes) {
  SFUMATO_TRY(check(context, picture, options));
  return GlbWriter(context, picture, options).write(notes);
}

}  // namespace

Result<std::vector<std::uint8_t>> export_glb(Context& context, const Picture& picture,
                                             const GlbOptions& options, ExportNotes* notes) {
  return public_verb(context, [&] { return write(context, picture, options, notes); });
}

}  // namespace sfumato
