#include "trace/curve_mesh.hpp"

#include <algorithm>
#include <utility>

#include "mesh/mesher.hpp"
#include "sfumato/document/stop_place.hpp"
#include "trace/drawing.hpp"
#include "trace/row_slopes.hpp"

namespace sfumato::tracing {
namespace {

/// Chords may be so far from curves, pixels.
constexpr double kFlatness = 0.1;
/// The longer side of an artboard in the mesher's units.
constexpr double kNominalSide = 1024;

using gather::RowSource;
using gather::RowTerm;

}  // namespace

Result<MeshedCurves> mesh_curves(Context& context, std::span<const Curve> drawn, int width,
                                 int height) {
  MeshedCurves out;
  const Box picture{{0, 0}, {static_cast<double>(width), static_cast<double>(height)}};
  mesh::MeshOptions meshing;
  meshing.unit_size = std::min(std::max(picture.width(), picture.height()) / kNominalSide, 1.0);
  meshing.frame = picture.grown_by(2 * meshing.unit_size);
  curves::FlattenOptions flattening;
  flattening.tolerance = kFlatness;
  flattening.reach = meshing.weld_px * meshing.unit_size;
  Result<curves::FlatCurves> flat = curves::flatten(context, drawn, flattening);
  if (!flat) return flat.status();
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, meshing);
  if (!mesher) return mesher.status();
  Result<mesh::TriangleMesh> mesh = mesher->visibility_mesh(context);
  if (!mesh) return mesh.status();
  out.flat = std::move(*flat);
  out.mesh = std::move(*mesh);
  out.memory.take(mesher->release_extracted());
  return out;
}

Result<CurveMesh> CurveMesh::build(Context& context, std::span<const TracedCurve> curves, int width,
                                   int height) {
  CurveMesh out;
  const std::vector<Curve> drawn = document_curves(curves, {1, 1}, false);
  Result<MeshedCurves> meshed = mesh_curves(context, drawn, width, height);
  if (!meshed) return meshed.status();
  Result<curves::SegmentAttributes> places =
      curves::sample_stop_places(context, meshed->flat, drawn, StopAttribute::color, out.memory_);
  if (!places) return places.status();
  out.places_ = std::move(*places);
  out.mesh_ = std::move(meshed->mesh);
  out.memory_.take(std::move(meshed->memory));
  return out;
}

Result<PixelRows> CurveMesh::gather(Context& context, SamplePixels pixels, float negligible) const {
  Result<gather::Rows> rows =
      gather::gather_rows(context, mesh_, places_, pixels.point, {.negligible = negligible});
  if (!rows) return rows.status();
  return PixelRows{std::move(pixels), std::move(*rows)};
}

Result<SparseMatrix> value_rows(Context& context, const PixelRows& seen,
                                std::span<const TracedCurve> curves) {
  std::size_t columns = 0;
  for (const TracedCurve& curve : curves) columns += stop_count(curve);
  const auto& [pixels, rows] = seen;
  return build_rows(
      context, pixels.pixel.size(), static_cast<std::uint32_t>(columns),
      [&](std::size_t i, RowSummer& sum) {
        const std::uint32_t first = pixels.point_begin[i], end = pixels.point_begin[i + 1];
        const double share = 1.0 / (end - first);
        for (std::uint32_t k = rows.begin[first]; k < rows.begin[end]; ++k) {
          const RowTerm& term = rows.term[k];
          const RowSource& source = rows.source[term.source];
          gather::for_each_entry(source, term, curves[source.curve].radius,
                                 [&](std::uint32_t column, double weight) {
                                   sum.add(column, static_cast<float>(share * weight));
                                 });
        }
      });
}

Result<SparseMatrix> radius_rows(Context& context, const PixelRows& seen,
                                 std::span<const TracedCurve> curves,
                                 std::span<const float> weight) {
  const std::vector<FourFloats> x = values_of(curves);
  const auto& [pixels, rows] = seen;
  return build_rows(
      context, 3 * pixels.pixel.size(), static_cast<std::uint32_t>(curves.size()),
      [&](std::size_t row, RowSummer& sum) {
        const std::size_t i = row / 3, channel = row % 3;
        const std::uint32_t first = pixels.point_begin[i], end = pixels.point_begin[i + 1];
        const double share = (weight.empty() ? 1.0 : double{weight[i]}) / (end - first);
        for (std::uint32_t k = rows.begin[first]; k < rows.begin[end]; ++k) {
          const RowTerm& term = rows.term[k];
          const RowSource& source = rows.source[term.source];
          const double radius = curves[source.curve].radius;
          if (!(radius > term.distance) || !source.back.has_value) continue;
          const double jump = double{value_of(source.front, term.moment, x)[channel]} -
                              value_of(source.back, term.moment, x)[channel];
          const double slope = term.lean * share_slope(term.distance, radius);
          sum.add(source.curve, static_cast<float>(share * term.weight * slope * jump));
        }
      });
}

std::vector<FourFloats> values_of(std::span<const TracedCurve> curves) {
  std::vector<FourFloats> x;
  for (const TracedCurve& curve : curves) {
    for (const SideStops& side : curve.side)
      x.insert(x.end(), side.value.begin(), side.value.end());
  }
  return x;
}

}  // namespace sfumato::tracing
