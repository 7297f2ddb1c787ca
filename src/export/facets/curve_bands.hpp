#pragma once

#include <array>
#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/curve_edges.hpp"
#include "export/facets/facets.hpp"

namespace sfumato::outputs {

/// What antialiases the curves of a layer in viewers that antialias paths alone: along each curve,
/// over the mesh, first `under`, which has the colours of one side there and carries them a little
/// into the other; then, within the path of `clip`, `over`: the colours of that other side, which
/// reach beyond the curve. The clip ends at the curve, so that pixels there are a mixture of both.
struct CurveBands {
  FacetMesh under, over;
  std::vector<std::array<Vec2, 4>> clip;  ///< quadrangles, all turning as triangles do
  TableMemory memory{"bands along curves"};
};

/// width  of what `over` paints on its own side, layer frame; less where triangles are lower than
///        twice that. Curves whose sides differ by less than 2/255 have no bands.
///
/// Where just one side of a curve has opacity, `under` carries its colours into the other, which
/// nobody sees, and nothing is clipped: the mask alone is antialiased. Beyond the last triangle,
/// opacities are 0; where the mesh ends, colours are carried on by make_end_band.
/// Errors: limit (memory), cancelled.
Result<CurveBands> make_curve_bands(Context& context, const PatchLayer& layer,
                                    InterpolationSpace space, const FacetSource& source,
                                    const CurveEdges& edges, double width);

}  // namespace sfumato::outputs
