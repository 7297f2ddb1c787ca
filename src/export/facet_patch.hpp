#pragma once

#include <array>
#include <cstdint>

#include "export/facet_grid.hpp"
#include "export/facets.hpp"

namespace sfumato::outputs {

/// Most cuts of a patch's edge. A cubic whose Bézier ordinates lie in [0, 1] never needs more for
/// an error of 0.5/255; one that needs more is cut so often and misses by more than was asked for.
inline constexpr int kMostCuts = 64;

/// The same for a patch that is clamped. Along the line where it leaves [0, 1] the picture is bent,
/// and no number of cuts pays there: such patches are steep, and smaller than a pixel.
inline constexpr int kMostClampedCuts = 16;

/// One patch as an exporter shows it: values clamped to [0, 1], and what facets miss of them
/// (docs/mathematics.md, "Facets").
class FacetPatch {
 public:
  static constexpr int kMostChannels = 4;
  using Value = std::array<double, kMostChannels>;

  /// Nothing of `layer` is kept.
  FacetPatch(const PatchLayer& layer, InterpolationSpace space, const FacetSource& source,
             std::uint32_t triangle, double max_error);

  /// What is shown at a point: code values, an opacity or a weight. Never out of [0, 1].
  Value shown(const Barycentric& at) const;

  /// Into how many parts the edges must be cut, 1 to `most`, which is at most kMostCuts.
  int cuts(int most) const;

  /// Whether every facet of a cut stays within the error.
  bool is_met_by(const FacetGrid& grid) const;

 private:
  /// Second derivatives in a frame where the patch is an equilateral triangle of side 1.
  struct Hessian {
    double xx = 0, xy = 0, yy = 0;
    double norm() const;
  };
  static Hessian hessian(double uu, double uv, double vv);
  static Hessian turned(const Hessian& h, int k);

  void read(const PatchLayer& layer, const FacetSource& source, std::uint32_t triangle);
  Value unclamped(const Barycentric& at) const;
  /// The share that a quotient is over; 1 where there is none.
  double share(const Barycentric& at) const;
  void find_curvature();
  double find_curvature(int channel);
  Hessian hessian_at(int channel, const Barycentric& at) const;
  double bound(const std::array<Barycentric, 3>& facet) const;
  int most_cuts() const { return is_clamped_ ? kMostClampedCuts : kMostCuts; }
  bool is_met_by(const std::array<Barycentric, 3>& facet) const;
  double light_error(const std::array<Barycentric, 3>& facet) const;
  double sampled_error(const std::array<Barycentric, 3>& facet) const;

  PatchOrder order_;
  InterpolationSpace space_ = InterpolationSpace::srgb;  ///< weights and opacities stay as they are
  int channel_count_;
  double max_error_;
  std::array<std::array<double, 10>, kMostChannels> node_{};
  bool has_share_ = false;
  std::array<double, 10> share_{};  ///< at the nodes: what values are divided by
  std::array<std::array<Hessian, 3>, kMostChannels> corner_{};  ///< they are linear in between
  bool is_light_ = false;                                       ///< facets are linear in light
  bool is_clamped_ = false;  ///< an sRGB patch that leaves [0, 1]
  bool is_sampled_ = false;  ///< clamping or conversion bend the patch: no bound by derivatives
};

int channel_count_of(const FacetSource& source);

bool reads_color(const FacetSource& source);

/// The field that a source reads.
const PatchField& field_of(const PatchLayer& layer, const FacetSource& source);

}  // namespace sfumato::outputs
