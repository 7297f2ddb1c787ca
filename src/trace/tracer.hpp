#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/charge.hpp"
#include "base/stopwatch.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/trace/trace.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/fit/drawing_fit.hpp"
#include "trace/image/edges.hpp"
#include "trace/image/picture.hpp"

namespace sfumato::tracing {

/// One trace (docs/tracing.md). The first curves come from the picture's edges, later rounds from
/// the edges of the part that is still missing. After each round shapes, colours and radii are
/// fitted.
class Tracer {
 public:
  /// The image, of a picture of width × height pixels, and the options are valid and outlive this.
  Tracer(Context& context, const Image& image, int width, int height, const TraceOptions& options)
      : context_(context), image_(image), width_(width), height_(height), options_(options) {}

  /// Errors: limit, cancelled.
  Result<Document> run();

  const TraceStats& stats() const { return stats_; }

 private:
  /// The curves of a round that ended, for a trace whose time is over.
  struct KeptRound {
    std::vector<TracedCurve> curves;
    ScopedCharge charge;
  };

  Status run_rounds();
  Status begin();
  Status add_edges_of_picture();
  Status add_edges_of_missing(int round);
  /// Curves along edges, and their memory.
  struct Candidates {
    TableMemory memory{"curves along edges"};
    std::vector<TracedCurve> curves;
  };
  Status find(std::span<const Plane> edges, const EdgeOptions& options, double tolerance,
              Candidates& candidates);
  Status look_for_strokes(std::span<const Plane> planes, const EdgeOptions& options,
                          Candidates& candidates, double& share);
  Status add(Candidates& candidates, std::span<const Plane> blurred, double budget);
  Status choose(Candidates& candidates, std::size_t budget, std::vector<TracedCurve>& chosen);
  bool fits_radii() const { return options_.blur == TraceBlur::fitted; }
  Status fit();
  Status fit_again();
  Status charge_curves();
  Status prepare_fit();
  Status improve_radii();
  Status finish();
  Status improve_shapes();
  Status improve_outlines();
  Status snap(float leak);
  Result<bool> tidy();
  void drop_excess();
  void forget_blur();
  bool goes_on();
  bool is_time_over() const;
  Status keep();
  Result<Document> kept_drawing();
  TraceState state(int round) const;
  void note(int round);
  void tell_progress(int steps) const;
  void measure_curves();
  Result<Document> finished_drawing();
  std::size_t point_count() const;
  std::size_t stop_count() const;
  std::size_t curve_limit() const;
  std::size_t stops_left() const;
  FitBudget round_budget() const;
  FitBudget last_budget() const;
  Document drawing() const;

  Context& context_;
  const Image& image_;
  int width_, height_;
  const TraceOptions& options_;
  std::optional<Picture> picture_;
  bool is_drawn_ = false;     ///< Noise::is_drawn
  bool has_strokes_ = false;  ///< most of its edges are sides of thin strokes
  double slack_ = 1;          ///< by how much more than usual curves may miss edges
  std::optional<DrawingFit> fit_;
  std::vector<TracedCurve> curves_;
  ScopedCharge curves_charge_;
  std::optional<KeptRound> kept_;
  TableMemory memory_{"what a trace misses"};
  std::vector<Plane> missing_;
  std::size_t budget_ = 0;  ///< control points
  TraceStats stats_;
  Stopwatch watch_;
};

}  // namespace sfumato::tracing
