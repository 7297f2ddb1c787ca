#include "export/svg/svg_layer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/try.hpp"
#include "export/svg/svg_text.hpp"

namespace sfumato::outputs {
namespace {

/// The layer's longer side in steps of its grid, at least, if no instance is much smaller than
/// others.
constexpr double kGridSteps = 5e4;
/// A step in nominal pixels: at least this many in the smallest instance, because cairo (librsvg,
/// Inkscape) gives up if gradients have units below 2^-15 pixels; but never more in the largest
/// instance.
constexpr double kSmallestStep = 1e-2;
constexpr double kLargestStep = 1.0 / 16;
/// Sides of facets in the largest instance, nominal pixels: patches are not cut any shorter.
/// Opacity has shorter ones: its blurs are the outlines that one sees.
constexpr double kSmallestSide = 3;
constexpr double kSmallestMaskSide = 1.5;
/// How far a facet reaches under its neighbours in the smallest instance, nominal pixels: the
/// farther, the smaller the file can be shown. And beyond the mesh in the largest one.
constexpr double kReachInside = 20;
constexpr double kReachOutside = 3;
/// Facets whose inscribed circle is smaller than this are painted as flat colours before, larger by
/// the margin: nominal pixels in the smallest instance.
constexpr double kSmallRadius = 1;
constexpr double kSmallMargin = 1;

/// Returns the grid on a layer: numbers are whole and short. Pixels are nominal, in the layer's
/// frame.
Affine grid_of(const Box& box, double pixel, double largest_pixel) {
  const double side = std::max(box.width(), box.height());
  if (!(side > 0)) return {};
  const double wished =
      std::max(side / kGridSteps, std::min(kSmallestStep * pixel, kLargestStep * largest_pixel));
  const double step = std::exp2(std::floor(std::log2(wished)));
  const auto rounded = [&](double x) { return std::floor(x / step) * step; };
  return {step, 0, 0, step, rounded(box.min.x), rounded(box.min.y)};
}

/// Writes one layer, after the elements that it refers to.
class SvgLayerWriter {
 public:
  SvgLayerWriter(Context& context, const SvgLayer& layer, SvgIds& ids, OutputBuffer& text)
      : context_(context),
        layer_(layer),
        grid_from_layer_(inverse(layer.layer_from_grid)),
        ids_(ids),
        text_(text) {}

  Status write(const std::string& id);

 private:
  /// Both return the attribute that refers to the written element.
  std::string write_clip(const Silhouette& shape);
  Result<std::string> write_mask();
  Result<SvgMesh> mesh_of(const FacetMesh& facets, const FacetLinks& links, double outside);

  Context& context_;
  const SvgLayer& layer_;
  Affine grid_from_layer_;
  SvgIds& ids_;
  OutputBuffer& text_;
};

Result<SvgMesh> SvgLayerWriter::mesh_of(const FacetMesh& facets, const FacetLinks& links,
                                        double outside) {
  SFUMATO_TRY_ASSIGN(auto&& outlines,
                     underlapped(context_, facets, links, {layer_.reach.inside, outside}));
  SvgMesh mesh;
  mesh.mesh = &facets;
  mesh.outlines = std::move(outlines);
  SFUMATO_TRY_ASSIGN(mesh.small,
                     small_facets(context_, facets, links, layer_.pixel * kSmallRadius,
                                  layer_.pixel * kSmallMargin, outside == 0, mesh.memory));
  mesh.grid_from_layer = grid_from_layer_;
  return mesh;
}

std::string SvgLayerWriter::write_clip(const Silhouette& shape) {
  const std::string id = short_id(ids_.next++);
  text_ += "<clipPath id=\"" + id + "\"><path clip-rule=\"evenodd\" d=\"";
  for (const std::vector<Vec2>& loop : shape.loops) {
    std::vector<Vec2> points;
    for (const Vec2 p : loop) points.push_back(grid_from_layer_(p));
    std::string path;
    append_closed_path(path, points);
    text_ += path;
  }
  text_ += "\"/></clipPath>\n";
  return " clip-path=\"url(#" + id + ")\"";
}

/// The opacity as grey.
Result<std::string> SvgLayerWriter::write_mask() {
  const FacetMesh& facets = layer_.opacity;
  SFUMATO_TRY_ASSIGN(const FacetLinks& links, link_facets(context_, facets));
  SFUMATO_TRY_ASSIGN(auto&& mesh, mesh_of(facets, links, 0));
  SFUMATO_TRY_ASSIGN(const Silhouette& shape, silhouette(context_, facets, links, layer_.frame));
  if (!shape.is_frame && !mesh.small.empty()) mesh.small_clip = write_clip(shape);
  const std::string id = short_id(ids_.next++);
  const Vec2 size = grid_from_layer_(layer_.box.max);
  std::string line =
      "<mask id=\"" + id + "\" maskUnits=\"userSpaceOnUse\" x=\"-1\" y=\"-1\" width=\"";
  append_number(line, size.x + 2, 0);
  line += "\" height=\"";
  append_number(line, size.y + 2, 0);
  text_ += line += "\">\n";
  SFUMATO_TRY(append_channel(context_, mesh, 0, kWhite, ids_, text_));
  text_ += "</mask>\n";
  return " mask=\"url(#" + id + ")\"";
}

Status SvgLayerWriter::write(const std::string& id) {
  SFUMATO_TRY_ASSIGN(const FacetLinks& links, link_facets(context_, layer_.color));
  SFUMATO_TRY_ASSIGN(const Silhouette& shape,
                     silhouette(context_, layer_.color, links, layer_.frame));
  std::string shown;
  if (!layer_.opacity.facet_vertex.empty()) {
    SFUMATO_TRY_ASSIGN(shown, write_mask());
  } else if (!shape.is_frame) {
    shown = write_clip(shape);
  }
  SFUMATO_TRY_ASSIGN(const auto& mesh,
                     mesh_of(layer_.color, links, shape.is_frame ? 0 : layer_.reach.outside));
  text_ += "<g id=\"" + id + "\"" + transform_attribute(layer_.layer_from_grid) + shown +
           " style=\"isolation:isolate\">\n";
  int channel = 0;
  for (const Ink& ink : {kRed, kGreen, kBlue}) {
    text_ += channel == 0 ? "<g>\n" : "<g style=\"mix-blend-mode:screen\">\n";
    SFUMATO_TRY(append_channel(context_, mesh, channel++, ink, ids_, text_));
    text_ += "</g>\n";
  }
  text_ += "</g>\n";
  return text_.status();
}

}  // namespace

Result<SvgLayer> make_svg_layer(Context& context, const PatchLayer& layer, InterpolationSpace space,
                                const SvgScale& scale) {
  const double pixel = scale.pixel / scale.smallest;
  const double largest_pixel = scale.pixel / scale.largest;
  SvgLayer result;
  SFUMATO_TRY_ASSIGN(result.color, make_facets(context, layer, space, {}, scale.max_error,
                                               kSmallestSide * largest_pixel));
  if (layer.opacity.channel_count > 0) {
    const FacetSource source{FacetSource::Kind::opacity, 0};
    SFUMATO_TRY_ASSIGN(result.opacity, make_facets(context, layer, space, source, scale.max_error,
                                                   kSmallestMaskSide * largest_pixel));
  }
  for (const Vec2 p : result.color.vertex_position) result.box.extend(p);
  result.layer_from_grid = grid_of(result.box, pixel, largest_pixel);
  result.frame = layer.frame;
  result.pixel = pixel;
  result.reach = {kReachInside * pixel, kReachOutside * largest_pixel};
  return result;
}

Status append_layer(Context& context, const SvgLayer& layer, const std::string& id, SvgIds& ids,
                    OutputBuffer& text) {
  return SvgLayerWriter(context, layer, ids, text).write(id);
}

}  // namespace sfumato::outputs
