#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/charge.hpp"
#include "base/stopwatch.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/trace/trace.hpp"
#include "trace/drawing_fit.hpp"
#include "trace/edges.hpp"
#include "trace/picture.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// One trace (docs/tracing.md). First curves come from the picture's edges, then in rounds from the
/// edges of what is still missing; after each round shapes, colours and radii are fitted.
class Tracer {
 public:
  /// The image and the options are valid and outlive this.
  Tracer(Context& context, const Image& image, const TraceOptions& options)
      : context_(context), image_(image), options_(options) {}

  /// Errors: limit, cancelled.
  Result<Document> run();

  const TraceStats& stats() const { return stats_; }

 private:
  Status begin();
  Status add_edges_of_picture();
  Status add_edges_of_missing(int round);
  Status add(std::span<const Plane> edges, std::span<const Plane> blurred,
             const EdgeOptions& options, double tolerance, double budget);
  bool fits_radii() const { return options_.blur == TraceBlur::fitted; }
  Status fit();
  Status fit_again();
  Status charge_curves();
  Status prepare_fit();
  Status improve_radii();
  Status finish();
  Status improve_shapes();
  Status snap(float leak);
  Result<bool> tidy();
  void drop_excess();
  void forget_blur();
  bool goes_on() const;
  TraceState state(int round) const;
  void note(int round);
  void tell_progress(int steps) const;
  void measure_curves();
  Result<Document> finished_drawing();
  std::size_t point_count() const;
  std::size_t stop_count() const;
  std::size_t curve_limit() const;
  Document drawing() const;

  Context& context_;
  const Image& image_;
  const TraceOptions& options_;
  std::optional<Picture> picture_;
  bool is_drawn_ = false;  ///< Noise::is_drawn
  std::optional<DrawingFit> fit_;
  std::vector<TracedCurve> curves_;
  ScopedCharge curves_charge_;
  TableMemory memory_{"what a trace misses"};
  std::vector<Plane> missing_;
  std::size_t budget_ = 0;  ///< control points
  TraceStats stats_;
  Stopwatch watch_;
};

}  // namespace sfumato::tracing
