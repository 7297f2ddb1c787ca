#pragma once

#include <array>
#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/curve_edges.hpp"
#include "export/facets/facets.hpp"

namespace sfumato::outputs {

/// Bands that antialias the curves of a layer in viewers that antialias only paths. Along each
/// curve, over the mesh, `under` is painted first: it has the colours of one side and extends them
/// slightly into the other. Then `over` is painted, clipped to the path `clip`: the colours of the
/// other side, which extend beyond the curve. The clip ends at the curve, so that pixels there are
/// a mixture of both.
struct CurveBands {
  FacetMesh under, over;
  std::vector<std::array<Vec2, 4>> clip;  ///< quadrangles, oriented like triangles
  TableMemory memory{"bands along curves"};
};

/// width  of the part of `over` on its own side, layer frame; less where triangles are lower than
///        twice that. Curves whose sides differ by less than 2/255 have no bands.
///
/// If only one side of a curve has opacity, `under` extends its colours into the other side, which
/// is invisible, and nothing is clipped: only the mask is antialiased. Beyond the last triangle
/// opacities are 0; where the mesh ends, make_end_band extends the colours.
/// Errors: limit (memory), cancelled.
Result<CurveBands> make_curve_bands(Context& context, const PatchLayer& layer,
                                    InterpolationSpace space, const FacetSource& source,
                                    const CurveEdges& edges, double width);

}  // namespace sfumato::outputs
