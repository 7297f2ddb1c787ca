#pragma once

#include <string>

#include "curves/flatten.hpp"
#include "mesh/triangle_mesh.hpp"

namespace sfumato::mesh::test {

/// How well the constraints of a visibility mesh stand for the segments they came from.
struct ArrangementFacts {
  double input_to_mesh = 0;  ///< largest distance of a point of a segment to a piece of it
  double mesh_to_input = 0;  ///< largest distance of a constraint's ends to its segments
  double vertex_gap = 0;     ///< smallest distance of two vertices
  std::string broken;        ///< the first segment whose pieces do not cover it in order, or ""
};

/// weld: segments that vanish are those whose ends lie within it; user units.
ArrangementFacts check_arrangement(const TriangleMesh& mesh, const curves::FlatCurves& flat,
                                   double weld);

}  // namespace sfumato::mesh::test
