#include "export/pdf/pdf_layer.hpp"

#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "export/facets/curve_bands.hpp"
#include "export/facets/end_bands.hpp"
#include "export/facets/facet_patch.hpp"
#include "export/facets/mesh_bytes.hpp"
#include "export/pdf/pdf_content.hpp"
#include "export/pdf/pdf_paint.hpp"
#include "export/pixel_part.hpp"

namespace sfumato::outputs {
namespace {

using Kind = FacetSource::Kind;
using Resource = PdfContent::Resource;

/// How far the first painting of a mesh is moved, points.
constexpr double kShift = 0.09;
/// The width of the bands along curves, points: more than two pixels of a screen.
constexpr double kBandWidth = 1.75;

/// How far colours continue beyond a layer's last curve, points. A pixel that the curve cuts has
/// its centre there, and a narrow gap keeps the colours of both sides.
constexpr double kBeyondWidth = 1;

/// How exactly points of paths are written, points of the page.
constexpr double kPathStep = 0.002;

/// Returns a power of ten of steps, each kPathStep or less, to a unit.
double steps_per_unit(double points_per_unit) {
  return std::pow(10, std::ceil(std::log10(points_per_unit / kPathStep)));
}

/// Fills the union of closed lines, which all turn alike but around holes, with white.
template <class Lines>
void fill_white(Context& context, const Lines& lines, double steps_per_unit, PdfContent* content) {
  const auto number = [&](double value) {
    const double steps = value * steps_per_unit;
    return pdf_number(std::isfinite(steps) ? std::round(steps) / steps_per_unit : value);
  };
  content->begin("1 g ");
  RarePoll<4096> poll(context);
  for (const auto& line : lines) {
    const char* operation = " m ";
    for (const Vec2& point : line) {
      if (poll.cancelled()) return content->fail(context.cancel_status());
      if (&point != &line.front() && point == *(&point - 1)) continue;
      content->begin(number(point.x) + " " + number(point.y) + operation);
      operation = " l ";
    }
    content->add("h");
  }
  content->add("f");
}

/// Writes one layer.
class PdfLayerWriter {
 public:
  PdfLayerWriter(Context& context, PdfFile* file, const Picture& picture, std::uint32_t index,
                 const PdfLayerOptions& options, ExportNotes* notes)
      : context_(context),
        file_(file),
        picture_(picture),
        layer_(picture.layers[index]),
        index_(index),
        options_(options),
        notes_(notes),
        mesh_box_(decode_box(triangles_box(layer_))),
        box_(mesh_box_.grown_by(band_width())) {}

  PdfRef write();

 private:
  /// A shader where it has weight.
  struct Paint {
    PdfRef image = 0;  ///< 0: nowhere
    Box box;
    Rgb mean;
  };

  bool is_mixed_elsewhere() const;
  bool has_opacity() const { return layer_.opacity.channel_count > 0; }
  /// Returns whether a path is the mask.
  bool is_outlined() const { return !has_opacity() && has_ends(edges_); }
  double pixels_per_unit() const { return options_.points_per_unit * options_.dpi / 72; }
  void paint_facets(const FacetSource& source, PdfContent* content);
  void paint_beyond(const FacetSource& source, PdfContent* content);
  void paint_bands(const FacetSource& source, PdfContent* content);
  void paint_once(const FacetMesh& mesh, PdfContent* content);
  void paint_clipped(const FacetMesh& mesh, const PdfContent& white, PdfContent* content);
  double band_width() const { return kBandWidth / options_.points_per_unit; }
  void paint_field(bool is_opacity, PdfContent* content);
  Paint add_shader(bool is_opacity, std::uint32_t shader);
  void paint_pixels(PdfContent* content);
  void fill_outline(PdfContent* mask);
  Box box_of_weight(const PatchField& field, std::size_t channel) const;

  Context& context_;
  PdfFile* file_;
  const Picture& picture_;
  const PatchLayer& layer_;
  std::uint32_t index_;
  const PdfLayerOptions& options_;
  ExportNotes* notes_;
  CurveEdges edges_;
  Box mesh_box_;
  Box box_;  ///< with the bands around it
};

/// Returns whether colours of shaders are mixed in a space that source-over knows nothing of.
bool PdfLayerWriter::is_mixed_elsewhere() const {
  return picture_.interpolation != InterpolationSpace::srgb && !layer_.color.shader.empty();
}

void PdfLayerWriter::paint_facets(const FacetSource& source, PdfContent* content) {
  const Result<FacetMesh> mesh = make_facets(context_, layer_, picture_.interpolation, source,
                                             options_.max_error, 1 / pixels_per_unit());
  if (!mesh) return file_->fail(mesh.status());
  notes_->triangle_count += mesh->facet_vertex.size() / 3;
  if (reads_color(source)) paint_beyond(source, content);
  paint_mesh(add_mesh(context_, file_, *mesh, mesh_box_), kShift / options_.points_per_unit,
             content);
  paint_bands(source, content);
}

/// Below the mesh its colours, carried on where it ends: the mask cuts them.
void PdfLayerWriter::paint_beyond(const FacetSource& source, PdfContent* content) {
  if (!has_ends(edges_)) return;
  const Result<FacetMesh> band = make_end_band(context_, layer_, picture_.interpolation, source,
                                               edges_, kBeyondWidth / options_.points_per_unit);
  if (!band) return file_->fail(band.status());
  paint_once(*band, content);
}

/// Antialiases the curves: over the mesh one side's colours, a little into the other, and over
/// these the other's, masked along the curve.
void PdfLayerWriter::paint_bands(const FacetSource& source, PdfContent* content) {
  if (!file_->status()) return;
  const Result<CurveBands> bands =
      make_curve_bands(context_, layer_, picture_.interpolation, source, edges_, band_width());
  if (!bands) return file_->fail(bands.status());
  paint_once(bands->under, content);
  if (bands->clip.empty()) return;
  PdfContent white(context_);
  fill_white(context_, bands->clip, steps_per_unit(options_.points_per_unit), &white);
  paint_clipped(bands->over, white, content);
}

/// Where a path is white, by a soft mask: a filled path is antialiased in all programs, a clip path
/// not in Splash and Ghostscript.
void PdfLayerWriter::paint_clipped(const FacetMesh& mesh, const PdfContent& white,
                                   PdfContent* content) {
  const Box box = decode_box(mesh.vertex_position);
  const PdfRef state = add_mask(file_, white.make_mask_form(file_, box));
  PdfContent clipped(context_);
  // Painted twice, like the mesh: the layer below has another colour and would show in uncovered
  // pixels.
  notes_->triangle_count += mesh.facet_vertex.size() / 3;
  paint_mesh(add_mesh(context_, file_, mesh, box), kShift / options_.points_per_unit, &clipped);
  const PdfRef form = mesh.channel_count == 1 ? clipped.make_mask_form(file_, box)
                                              : clipped.make_form(file_, box, true);
  content->add("q " + content->name(Resource::graphics_state, state) + " gs " +
               content->name(Resource::form, form) + " Do Q");
}

void PdfLayerWriter::paint_once(const FacetMesh& mesh, PdfContent* content) {
  notes_->triangle_count += mesh.facet_vertex.size() / 3;
  const PdfRef ref = add_mesh(context_, file_, mesh, decode_box(mesh.vertex_position));
  if (ref != 0) content->add(content->name(Resource::shading, ref) + " sh");
}

/// Returns the triangles where a channel is not 0.
Box PdfLayerWriter::box_of_weight(const PatchField& field, std::size_t channel) const {
  Box box;
  const auto stride = static_cast<std::size_t>(field.channel_count);
  for (std::size_t slot = 0; slot < field.triangle_node.size(); ++slot) {
    if (field.node_value[stride * field.triangle_node[slot] + channel] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k)
      box.extend(layer_.vertex_position[layer_.triangle_vertex[slot / kNodesPerTriangle * 3 + k]]);
  }
  return box;
}

/// A shader's pixels and their mean.
PdfLayerWriter::Paint PdfLayerWriter::add_shader(bool is_opacity, std::uint32_t shader) {
  const PatchField& field = is_opacity ? layer_.opacity : layer_.color;
  Paint paint;
  paint.box = box_of_weight(field, (is_opacity ? 1u : 3u) + shader);
  if (!(paint.box.width() > 0 && paint.box.height() > 0)) return paint;
  // Bands carry weights across curves and beyond them. Without the paint there, opacity would show
  // at its ends, and the mean colour at the ends of an outline.
  if (is_opacity || is_outlined()) paint.box = paint.box.grown_by(band_width());
  const Result<PixelPart> part = shader_pixels(context_, picture_.shaders[field.shader[shader]],
                                               is_opacity, paint.box, pixels_per_unit());
  if (!part) {
    file_->fail(part.status());
    return paint;
  }
  const Result<Rgb> mean = is_opacity ? mean_opacity(context_, *part) : mean_color(context_, *part);
  if (!mean) {
    file_->fail(mean.status());
    return paint;
  }
  paint.mean = *mean;
  paint.image = is_opacity ? add_alpha_image(context_, file_, part->image)
                           : add_image(context_, file_, part->image);
  return paint;
}

/// Colour or opacity: first the curves' own values, then the shaders over them under masks of their
/// shares. The last shader has all of its weight, and each shader leaves the needed share to the
/// shaders below.
void PdfLayerWriter::paint_field(bool is_opacity, PdfContent* content) {
  const PatchField& field = is_opacity ? layer_.opacity : layer_.color;
  std::vector<Paint> paints;
  FacetSource base{is_opacity ? Kind::opacity_base : Kind::color_base, 0, {}};
  for (std::uint32_t s = 0; s < field.shader.size(); ++s) {
    paints.push_back(add_shader(is_opacity, s));
    base.shown.push_back(paints.back().mean);
  }
  paint_facets(base, content);
  for (std::uint32_t s = 0; s < field.shader.size(); ++s) {
    if (paints[s].image == 0) continue;
    PdfContent mask(context_);
    paint_facets({is_opacity ? Kind::opacity_mask : Kind::color_mask, s, {}}, &mask);
    const PdfRef state = add_mask(file_, mask.make_mask_form(file_, box_));
    content->add("q " + content->name(Resource::graphics_state, state) + " gs");
    paint_image(paints[s].image, paints[s].box, content);
    content->add("Q");
  }
}

void PdfLayerWriter::paint_pixels(PdfContent* content) {
  const Result<PixelPart> part =
      layer_pixels(context_, picture_, index_, mesh_box_, pixels_per_unit());
  if (!part) return file_->fail(part.status());
  paint_image(add_image(context_, file_, part->image), mesh_box_, content);
}

/// The mask of a layer without opacity: white as far as it goes.
void PdfLayerWriter::fill_outline(PdfContent* mask) {
  const Result<LayerOutline> outline = outline_of_ends(context_, layer_, edges_, band_width());
  if (!outline) return file_->fail(outline.status());
  fill_white(context_, outline->loop, steps_per_unit(options_.points_per_unit), mask);
}

PdfRef PdfLayerWriter::write() {
  if (layer_.triangle_count() == 0) return 0;
  PdfContent content(context_);
  Result<CurveEdges> edges = find_curve_edges(context_, layer_);
  if (!edges) {
    file_->fail(edges.status());
    return 0;
  }
  edges_ = std::move(*edges);
  if (options_.as_pixels || is_mixed_elsewhere()) {
    paint_pixels(&content);
    return content.make_form(file_, box_, options_.is_group);
  }
  paint_field(false, &content);
  if (!has_opacity() && !is_outlined())
    return content.make_form(file_, box_, options_.is_group || !layer_.color.shader.empty());
  PdfContent mask(context_), masked(context_);
  if (has_opacity()) {
    paint_field(true, &mask);
  } else {
    fill_outline(&mask);
  }
  // The mask is applied to a group: applied to a shading, it would be to each of its triangles.
  const PdfRef colors = content.make_form(file_, box_, true);
  const PdfRef state = add_mask(file_, mask.make_mask_form(file_, box_));
  masked.add(masked.name(Resource::graphics_state, state) + " gs " +
             masked.name(Resource::form, colors) + " Do");
  return masked.make_form(file_, box_, true);
}

}  // namespace

PdfRef add_layer(Context& context, PdfFile* file, const Picture& picture, std::uint32_t layer,
                 const PdfLayerOptions& options, ExportNotes* notes) {
  return PdfLayerWriter(context, file, picture, layer, options, notes).write();
}

}  // namespace sfumato::outputs
