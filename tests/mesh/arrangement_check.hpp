#pragma once

#include <string>

#include "curves/flatten.hpp"
#include "mesh/triangle_mesh.hpp"

namespace sfumato::mesh::test {

/// How well the constraints of a visibility mesh represent their source segments.
struct ArrangementFacts {
  double input_to_mesh = 0;  ///< largest distance of a point of a segment to one of its pieces
  double mesh_to_input = 0;  ///< largest distance of a constraint's ends to its segments
  double vertex_gap = 0;     ///< smallest distance of two vertices
  std::string broken;        ///< the first segment whose pieces do not cover it in order, or ""
};

/// weld: segments vanish if their ends are within this distance; user units.
ArrangementFacts check_arrangement(const TriangleMesh& mesh, const curves::FlatCurves& flat,
                                   double weld);

}  // namespace sfumato::mesh::test
