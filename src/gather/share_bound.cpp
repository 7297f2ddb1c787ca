#include "gather/share_bound.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "sfumato/base/box.hpp"

namespace sfumato::gather {
namespace {

constexpr std::size_t kSegmentsPerRun = 8;

}  // namespace

Result<ShareBound> ShareBound::create(const Context& context, std::span<const Vec2> polyline,
                                      double weight, double most, std::size_t most_runs) {
  ShareBound bound;
  bound.weight_ = weight;
  bound.most_ = most;
  const std::size_t per_run = std::max(kSegmentsPerRun, polyline.size() / most_runs + 1);
  Status status = bound.memory_.reserve(context, bound.runs_, polyline.size() / per_run + 1);
  if (!status) return status;
  Box whole;
  for (std::size_t first = 0; first + 1 < polyline.size(); first += per_run) {
    const std::size_t last = std::min(first + per_run, polyline.size() - 1);
    Box box;
    double length_of_run = 0;
    for (std::size_t v = first; v <= last; ++v) {
      box.extend(polyline[v]);
      if (v > first) length_of_run += length(polyline[v] - polyline[v - 1]);
    }
    bound.runs_.push_back({box.center(), length(box.max - box.center()), length_of_run});
    whole.extend(box.min);
    whole.extend(box.max);
    bound.whole_.length += length_of_run;
  }
  if (!bound.runs_.empty()) {
    bound.whole_.center = whole.center();
    bound.whole_.radius = length(whole.max - whole.center());
  }
  return bound;
}

double ShareBound::angle_over_distance_squared(const Run& run, Vec2 p) {
  const double d = length(p - run.center) - run.radius;
  if (!(d > 0)) return std::numeric_limits<double>::infinity();
  return std::min(std::numbers::pi, run.length / d) / (d * d);
}

bool ShareBound::holds_at(Vec2 p, float weight, float weight_unit) const {
  const double k = weight_ / double{weight_unit};
  // (1 + k) Â <= most (W₀ - Â)
  const double room = most_ * double{weight} / (1 + k + most_);
  if (angle_over_distance_squared(whole_, p) <= room) return true;
  double sum = 0;
  for (const Run& run : runs_) {
    sum += angle_over_distance_squared(run, p);
    if (!(sum <= room)) return false;
  }
  return true;
}

double ShareBound::share_at(Vec2 p, float weight, float weight_unit) const {
  double angle = 0;
  for (const Run& run : runs_) angle += angle_over_distance_squared(run, p);
  const double room = double{weight} - angle;
  if (!(room > 0)) return std::numeric_limits<double>::infinity();
  return (1 + weight_ / double{weight_unit}) * angle / room;
}

}  // namespace sfumato::gather
