#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/curve_mesh.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/fit/bounded_solve.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/fit/value_equations.hpp"
#include "trace/image/picture.hpp"

namespace sfumato::tracing {

/// How much work one step of a fit may be.
struct FitBudget {
  double pixels = 0;  ///< the approximate number of pixels in the fit
  double products =
      0;  ///< about this many products of two entries of a row, in the equations of all pixels
};

/// Fits colours and radii of curves to a picture, through rows of the gather: as long as curves and
/// the places of stops stay, every step uses the same rows.
class DrawingFit {
 public:
  /// The picture outlives this.
  DrawingFit(Context& context, const Picture& picture) : context_(context), picture_(picture) {}

  /// Gathers the rows of pixels for these curves, whose sides have stops.
  /// seed     of the choice of pixels
  /// Errors   limit, cancelled
  Status prepare(std::span<const TracedCurve> curves, const FitBudget& budget, std::uint64_t seed);

  /// Least squares for the values of all stops. Errors: limit (memory), cancelled.
  Status fit_values(std::span<TracedCurve> curves);

  /// Uses the present values of all stops. Errors: limit (memory), cancelled.
  Status take_values(std::span<const TracedCurve> curves);

  /// One step of Gauss and Newton's method for all radii. Precondition: fit_values() or
  /// take_values() was called, and nothing changed since. Errors: limit (memory), cancelled.
  Status fit_radii(std::span<TracedCurve> curves);

  /// fit_values() to every pixel of the picture, or to as many as the budget has; radii stay.
  /// `times` times stops that do little are left out then, at most `share` of all and as long as
  /// that adds less than about half this share to the squared error, and the others fitted again.
  /// Precondition: prepare(), and curves and places of stops are the same. Errors: limit (memory),
  /// cancelled.
  Status fit_to_all(std::span<TracedCurve> curves, const FitBudget& budget, std::uint64_t seed,
                    double share, int times);

  /// As TraceState::psnr_db, of the values that were found or taken last.
  double psnr_db() const { return psnr_db_; }

 private:
  void list_neighbours(std::span<const TracedCurve> curves);
  /// Holds the target values of a picture's pixels and their weights.
  struct Targets {
    std::vector<FourFloats> value;
    std::vector<float> weight;          ///< of colours; empty: 1
    std::vector<float> opacity_weight;  ///< empty: 1
    TableMemory memory{"what a trace fits"};
  };
  /// For colours and, if the picture has it, for opacity.
  struct Equations {
    ValueEquations color, opacity;
  };

  Status find_targets(const SamplePixels& pixels, bool is_sampled, Targets& targets) const;
  Result<double> one_in(std::span<const TracedCurve> curves, const FitBudget& budget,
                        std::uint64_t seed, float negligible);
  Status add(const SparseMatrix& rows, const Targets& targets, Equations& equations);
  Status solve(const Equations& equations, std::span<TracedCurve> curves);
  Status build_matrix(std::span<const TracedCurve> curves);
  Status find_residual(std::span<const FourFloats> x);
  double mean_square() const;
  Result<double> mean_square(const Equations& equations, std::span<const FourFloats> x);
  Status for_each_band(std::span<const TracedCurve> curves, double one_in, std::uint64_t seed,
                       FunctionRef<Status(const PixelRows&, const SparseMatrix&)> visit);
  Result<double> squared_error(const Equations& equations, std::span<const FourFloats> x);
  Status prune(std::span<TracedCurve> curves, double share, Equations& equations);

  Context& context_;
  const Picture& picture_;
  std::optional<CurveMesh> mesh_;
  std::optional<PixelMarks> marks_;
  std::optional<PixelRows> seen_;
  std::optional<SparseMatrix> matrix_;  ///< values of stops to pixels, with the present radii
  Targets targets_;                     ///< per pixel of seen_
  std::vector<std::uint8_t> has_next_;  ///< per stop
  std::vector<Tie> ties_;               ///< where sides of closed curves begin and end
  std::vector<FourFloats> residual_;    ///< per pixel: target minus fitted value
  double psnr_db_ = 0;
};

}  // namespace sfumato::tracing
