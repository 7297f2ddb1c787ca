#include "trace/curves/curve_mesh.hpp"

#include <algorithm>
#include <utility>

#include "base/try.hpp"
#include "mesh/mesher.hpp"
#include "sfumato/document/stop_place.hpp"
#include "trace/curves/drawing.hpp"
#include "trace/fit/row_slopes.hpp"

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
  SFUMATO_TRY_ASSIGN(auto&& flat, curves::flatten(context, drawn, flattening));
  SFUMATO_TRY_ASSIGN(auto&& mesher, mesh::Mesher::build(context, flat, meshing));
  SFUMATO_TRY_ASSIGN(auto&& mesh, mesher.visibility_mesh(context));
  out.flat = std::move(flat);
  out.mesh = std::move(mesh);
  out.memory.take(mesher.release_extracted());
  return out;
}

Result<CurveMesh> CurveMesh::build(Context& context, std::span<const TracedCurve> curves, int width,
                                   int height) {
  CurveMesh out;
  const std::vector<Curve> drawn = document_curves(curves, {1, 1}, false);
  SFUMATO_TRY_ASSIGN(auto&& meshed, mesh_curves(context, drawn, width, height));
  SFUMATO_TRY_ASSIGN(out.places_, curves::sample_stop_places(context, meshed.flat, drawn,
                                                             StopAttribute::color, out.memory_));
  out.mesh_ = std::move(meshed.mesh);
  out.memory_.take(std::move(meshed.memory));
  return out;
}

Result<PixelRows> CurveMesh::gather(Context& context, SamplePixels pixels, float negligible) const {
  SFUMATO_TRY_ASSIGN(auto&& rows, gather::gather_rows(context, mesh_, places_, pixels.point,
                                                      {.negligible = negligible}));
  return PixelRows{std::move(pixels), std::move(rows)};
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
                                 std::span<const TracedCurve> curves, std::span<const float> weight,
                                 std::size_t channels) {
  const std::vector<FourFloats> x = values_of(curves);
  const auto& [pixels, rows] = seen;
  return build_rows(
      context, channels * pixels.pixel.size(), static_cast<std::uint32_t>(curves.size()),
      [&](std::size_t row, RowSummer& sum) {
        const std::size_t i = row / channels, channel = row % channels;
        const std::uint32_t first = pixels.point_begin[i], end = pixels.point_begin[i + 1];
        const bool has_weight = channel < 3 && !weight.empty();
        const double share = (has_weight ? double{weight[i]} : 1.0) / (end - first);
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
