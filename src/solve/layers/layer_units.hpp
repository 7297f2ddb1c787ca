#pragma once

#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// Returns the box clamped to the range of coordinates.
Box within_coordinates(const Box& box);

/// Lengths and areas of the artboard, converted to a layer's frame.
class LayerUnits {
 public:
  /// Keeps references to sight and options.
  LayerUnits(const Box& artboard, const LayerSight& sight, const DiffuseOptions& options);

  double pixel() const { return 1 / (options_.pixels_per_unit * sight_.scale); }

  /// Returns the smallest blur radius that a mesh shows.
  double smallest_radius() const;

  SmallestEdges smallest_edges() const;

  curves::FlattenOptions flatten_options() const;
  mesh::MeshOptions mesh_options() const;

  /// Returns the frame of the mesh with as much room around it: curves that move may reach that
  /// far.
  Box roomy_frame() const;

 private:
  const LayerSight& sight_;
  const DiffuseOptions& options_;
  double artboard_side_;
  double whole_area_;
};

}  // namespace sfumato::solve
