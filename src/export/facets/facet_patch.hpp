#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "export/facets/facets.hpp"

namespace sfumato::outputs {

/// Barycentric weights of a patch's corners 0, 1, 2.
using Barycentric = std::array<double, 3>;

Barycentric centroid(const Barycentric& a, const Barycentric& b, const Barycentric& c);

/// Distance in the frame that makes the patch an equilateral triangle of side 1.
double side_length(const Barycentric& a, const Barycentric& b);

/// Most parts of a patch's edge. A cubic whose Bézier ordinates lie in [0, 1] never needs more for
/// an error of 0.5/255. A patch that needs more gets this number, and its error exceeds the
/// requested one.
inline constexpr int kMostCuts = 64;

/// The same for a patch that is clamped. The picture has a kink along the line where the patch
/// leaves [0, 1], and more cuts do not help there: such patches are steep, and smaller than a
/// pixel.
inline constexpr int kMostClampedCuts = 16;

/// A channel at the ten nodes of a patch.
using NodeValues = std::array<double, kNodesPerTriangle>;

/// One patch as an exporter shows it: values clamped to [0, 1], and the error of facets
/// (docs/mathematics.md, "Facets").
class FacetPatch {
 public:
  static constexpr int kMostChannels = 4;
  using Value = std::array<double, kMostChannels>;

  /// Nothing of `layer` is kept.
  FacetPatch(const PatchLayer& layer, InterpolationSpace space, const FacetSource& source,
             std::uint32_t triangle, double max_error);

  /// Returns the value at a point: code values, an opacity or a weight; always in [0, 1].
  Value shown(const Barycentric& at) const;

  /// Returns a patch whose edge 0 is edge k of this one, and that is 0 elsewhere; reversed: from
  /// the edge's other end. Neighbours that share the edge's nodes get the same bits.
  FacetPatch edge(std::size_t k, bool is_reversed) const;

  /// Returns an upper bound of the error of a straight side between two points.
  double bend(const Barycentric& a, const Barycentric& b) const;

  /// Returns whether one of the patch's own edges, or a side inside the patch, is straight enough
  /// between two points of it. Edges must be straighter, so that sides next to them, which bend in
  /// the same way, are not halved endlessly.
  bool is_straight_edge(const Barycentric& a, const Barycentric& b) const;
  bool is_straight(const Barycentric& a, const Barycentric& b) const;

  /// Returns whether a facet with straight sides is accurate enough at points inside.
  bool is_flat(const std::array<Barycentric, 3>& facet) const;

  /// Returns the largest number of parts, whatever the error.
  int most_cuts() const { return is_clamped_ ? kMostClampedCuts : kMostCuts; }

 private:
  /// Second derivatives in the frame that makes the patch an equilateral triangle of side 1.
  struct Hessian {
    double xx = 0, xy = 0, yy = 0;
    double along(Vec2 side) const;  ///< second derivative, times its length squared
  };
  static Hessian hessian(double uu, double uv, double vv);
  static Hessian turned(const Hessian& h, int k);

  void read(const PatchLayer& layer, const FacetSource& source, std::uint32_t triangle);
  void find_covered(const PatchLayer& layer, const FacetSource& source, std::uint32_t triangle);
  Value unclamped(const Barycentric& at) const;
  /// Returns the denominator of a quotient; 1 if there is no quotient.
  double share(const Barycentric& at) const;
  void find_curvature();
  double find_curvature(int channel);
  Hessian hessian_at(int channel, const Barycentric& at) const;
  double curved_bend(const Barycentric& a, const Barycentric& b) const;
  double light_bend(const Barycentric& a, const Barycentric& b) const;
  double sampled_bend(const Barycentric& a, const Barycentric& b) const;

  PatchOrder order_;
  InterpolationSpace space_ = InterpolationSpace::srgb;  ///< not for weights and opacities
  int channel_count_;
  double asked_error_;  ///< before the part for overshoot is subtracted
  double max_error_;
  bool is_edge_ = false;  ///< made by edge()
  std::array<NodeValues, kMostChannels> node_{};
  bool has_share_ = false;
  Value covered_{};                                             ///< shown if no share is left
  NodeValues share_{};                                          ///< denominators at the nodes
  std::array<std::array<Hessian, 3>, kMostChannels> corner_{};  ///< they are linear in between
  bool is_light_ = false;                                       ///< facets are linear in light
  bool is_clamped_ = false;  ///< an sRGB patch that leaves [0, 1]
  bool is_sampled_ = false;  ///< clamping or conversion bends the patch: derivatives give no bound
};

int channel_count_of(const FacetSource& source);

bool reads_color(const FacetSource& source);

/// Returns the field that a source reads.
const PatchField& field_of(const PatchLayer& layer, const FacetSource& source);

}  // namespace sfumato::outputs
