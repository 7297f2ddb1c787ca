#pragma once

#include <span>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "gather/rows/rows.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/image/sample_pixels.hpp"

namespace sfumato::tracing {

/// Pixels with the rows of the points in them.
struct PixelRows {
  SamplePixels pixels;
  gather::Rows rows;
};

/// A drawing's curves in a mesh.
struct MeshedCurves {
  curves::FlatCurves flat;
  mesh::TriangleMesh mesh;
  TableMemory memory{"the mesh of a trace"};
};

/// width, height   of the picture, pixels
/// Errors          limit, cancelled
Result<MeshedCurves> mesh_curves(Context& context, std::span<const Curve> drawn, int width,
                                 int height);

/// Curves as the gather sees them. Only their shapes and the places of their stops count.
class CurveMesh {
 public:
  /// width, height   of the picture, pixels
  /// Errors          limit, cancelled
  static Result<CurveMesh> build(Context& context, std::span<const TracedCurve> curves, int width,
                                 int height);

  /// negligible   as in gather::RowOptions
  /// Errors       limit, cancelled
  Result<PixelRows> gather(Context& context, SamplePixels pixels, float negligible) const;

 private:
  CurveMesh() = default;

  mesh::TriangleMesh mesh_;
  curves::SegmentAttributes places_;
  TableMemory memory_{"the mesh of a trace"};
};

/// Returns the values of pixels as sums of the values of stops, in the order of curves, sides and
/// stops: a row for each pixel. Uses the radii of the curves. Errors: limit (memory), cancelled.
Result<SparseMatrix> value_rows(Context& context, const PixelRows& seen,
                                std::span<const TracedCurve> curves);

/// How pixels change with the radii of curves: three rows for each pixel, one a channel, or four
/// with opacity, and a column for each curve. Errors: limit (memory), cancelled.
/// weight     per pixel, by which its rows of colour are multiplied; empty: 1
/// channels   3 or 4
Result<SparseMatrix> radius_rows(Context& context, const PixelRows& seen,
                                 std::span<const TracedCurve> curves, std::span<const float> weight,
                                 std::size_t channels);

/// Returns the values of all stops, in their order.
std::vector<FourFloats> values_of(std::span<const TracedCurve> curves);

}  // namespace sfumato::tracing
