#pragma once

#include <initializer_list>
#include <vector>

#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::mesh::test {

/// Adds polylines as from the flattener. Segment indices count all vertices.
inline void add_polyline(curves::FlatCurves& flat, const std::vector<Vec2>& polyline) {
  if (flat.curve_begin.empty()) flat.curve_begin.push_back(0);
  const auto curve = static_cast<std::uint32_t>(flat.curve_begin.size() - 1);
  double arc = 0;
  for (std::size_t i = 0; i < polyline.size(); ++i) {
    if (i > 0) arc += length(polyline[i] - polyline[i - 1]);
    flat.vertex.push_back(polyline[i]);
    flat.parameter.push_back(static_cast<double>(i));
    flat.arc_length.push_back(arc);
    flat.vertex_curve.push_back(curve);
  }
  flat.curve_begin.push_back(static_cast<std::uint32_t>(flat.vertex.size()));
}

inline curves::FlatCurves flat_curves(std::initializer_list<std::vector<Vec2>> polylines) {
  curves::FlatCurves flat;
  flat.curve_begin.push_back(0);
  for (const auto& polyline : polylines) add_polyline(flat, polyline);
  return flat;
}

/// Returns options for a frame of 100 × 100 units, 1 px each.
inline MeshOptions options_100() {
  MeshOptions options;
  options.frame = {{0, 0}, {100, 100}};
  return options;
}

}  // namespace sfumato::mesh::test
