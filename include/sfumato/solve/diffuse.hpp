#pragma once

#include <cstdint>
#include <optional>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/gather/options.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// Options of diffuse(). Lengths are in user units of the artboard.
struct DiffuseOptions {
  /// The part of the artboard frame that is solved; default: the artboard. It may reach beyond it.
  std::optional<Box> viewport{};
  /// Resolution of the largest intended output, in pixels to a user unit. It bounds refinement:
  /// triangles whose edges are all shorter than a pixel are not made smaller.
  double pixels_per_unit = 1;
  /// Flattening tolerance: how far chords may be from their curve. Default: 0.05/512 of the
  /// artboard's longer side, inside the viewport at most 0.04 pixels; where max_error is 0, 0.1/512
  /// and 0.2 pixels.
  std::optional<double> tolerance{};
  /// Smallest angle of triangles in degrees, 0 to 33. Curves that meet at smaller angles keep them.
  double min_angle_deg = 22;
  /// Largest area of a triangle, as a fraction above 0 and at most 1. It is a fraction of the
  /// larger of two areas: the box around artboard and viewport, and the visible part of the layer.
  double max_area_fraction = 0.04;
  /// Largest tolerated difference of a patch from the exact solution, in code values of 255, as
  /// found at probe points. 0: the paper's mesh, refined at blurred curves only.
  double max_error = 1;
  PatchOrder order = PatchOrder::cubic;  ///< the interpolation of patches
  /// The gather at nodes. Where max_error is above 0 the exact gather decides about refinement, and
  /// random rays only give the nodes of the final mesh their colours.
  gather::GatherOptions gather{};
  gather::Ends ends = gather::Ends::soft;  ///< the colours ahead of the ends of open curves
  bool ignore_blur = false;  ///< draw diffusion curves sharp, as if their blur radii were 0

  /// Solves only for rasterize() with antialiasing at `pixels_per_unit`, 1.4 to 5 times as
  /// fast. Chords are coarser, and pixels correct the area between a chord and its curve. Triangles
  /// smaller than a few pixels are not refined, and dense layers have no patches: pixels gather
  /// their colours when they are drawn. All other outputs refuse the picture
  /// (Picture::for_pixel_grid). No effect if `tolerance` is set or `max_error` is 0.
  bool pixel_grid = false;

  /// Solves for rasterize() alone, without patches: gathers at every pixel when it is drawn. Use it
  /// as ground truth for patches.
  bool exact_pixels = false;

  /// Whether layers get PatchLayer::exact. Use it for viewers that compute exact pixels.
  bool exact_fields = false;

  /// Compares all members exactly.
  friend bool operator==(const DiffuseOptions&, const DiffuseOptions&) = default;
};

/// Sizes and times of the solution of a document, summed over the layers that are painted.
/// Functions add to these.
struct DiffuseStats {
  std::uint64_t curves = 0;          ///< diffusion curves
  std::uint64_t segments = 0;        ///< straight segments of the flattened curves
  std::uint64_t triangles = 0;       ///< triangles of the patch meshes
  std::uint64_t vertices = 0;        ///< vertices of the patch meshes
  std::uint64_t nodes = 0;           ///< points where colour or opacity was gathered
  double geometry_seconds = 0;       ///< flattening the curves and sampling their attributes
  double triangulation_seconds = 0;  ///< making and refining meshes
  double gather_seconds = 0;         ///< gathering at nodes and probe points
};

/// Makes the picture of a document without its layers: artboard, background, shaders and stack,
/// which a picture takes over unchanged. Its `layers` are empty; the caller must add the layers
/// that the stack refers to.
///
/// Precondition: validate() accepts the document, which is not checked again.
/// Errors: limit, cancelled, out_of_memory.
Result<Picture> picture_frame(Context& context, const Document& document, const Box& viewport);

/// Makes the picture of a document (paper sections 3–5): flattens the curves, triangulates them,
/// gathers colours and opacities at the nodes of the triangles, and refines. Each layer is solved
/// once, however often it is painted; layers outside the viewport are not solved. Use a Solution
/// for a document that changes.
///
/// `stats`, unless null, is added to. The result has the same bits for any thread count and SIMD
/// level.
///
/// Errors: bad_input (an invalid document or option), limit, cancelled, out_of_memory.
/// Cost: O(n log n) in the segments for the triangulations, in the calling thread; then a gather at
/// each node and probe, shared among the context's threads. In all 1.3 to 3.1 µs a node on one
/// thread: 67 ms for 71 curves and 51,000 nodes, 1.9 s for 1521 curves and 626,000 nodes
/// (docs/benchmarks.md, without blur). Visible curves, blurs and changes of colour determine the
/// number of nodes.
Result<Picture> diffuse(Context& context, const Document& document, const DiffuseOptions& options,
                        DiffuseStats* stats = nullptr);

}  // namespace sfumato
