#include "gather/scene/share_bound.hpp"

#include <algorithm>
#include <numbers>

#include "base/try.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::gather {
namespace {

constexpr std::size_t kSegmentsPerRun = 8;
constexpr std::size_t kRunsPerGroup = 4;

/// A group at this many radii from its centre, or farther, is used instead of its runs.
constexpr double kFar = 3;

}  // namespace

Result<ShareBound> ShareBound::create(const Context& context, std::span<const Vec2> polyline,
                                      double weight, double most, std::size_t most_runs) {
  ShareBound bound;
  bound.weight_ = weight;
  bound.most_ = most;
  const std::size_t per_run = std::max(kSegmentsPerRun, polyline.size() / most_runs + 1);
  SFUMATO_TRY(bound.memory_.reserve(context, bound.runs_, polyline.size() / per_run + 1));
  for (std::size_t first = 0; first + 1 < polyline.size(); first += per_run) {
    const std::size_t last = std::min(first + per_run, polyline.size() - 1);
    bound.runs_.push_back(run_of(polyline.subspan(first, last - first + 1)));
  }
  const std::size_t per_group = per_run * kRunsPerGroup;
  SFUMATO_TRY(bound.memory_.reserve(context, bound.groups_, polyline.size() / per_group + 1));
  for (std::size_t first = 0; first + 1 < polyline.size(); first += per_group) {
    const std::size_t last = std::min(first + per_group, polyline.size() - 1);
    bound.groups_.push_back(run_of(polyline.subspan(first, last - first + 1)));
  }
  if (!polyline.empty()) bound.whole_ = run_of(polyline);
  return bound;
}

ShareBound::Run ShareBound::run_of(std::span<const Vec2> polyline) {
  Box box;
  double length_of_run = 0;
  for (std::size_t v = 0; v < polyline.size(); ++v) {
    box.extend(polyline[v]);
    if (v > 0) length_of_run += length(polyline[v] - polyline[v - 1]);
  }
  return {box.center(), length(box.max - box.center()), length_of_run};
}

double ShareBound::angle_over_distance_squared(const Run& run, Vec2 p) {
  const double d = length(p - run.center) - run.radius;
  if (!(d > 0)) return std::numeric_limits<double>::infinity();
  return std::min(std::numbers::pi, run.length / d) / (d * d);
}

double ShareBound::angle_of_group(std::size_t group, Vec2 p) const {
  const Run& all = groups_[group];
  if (length(p - all.center) >= kFar * all.radius) return angle_over_distance_squared(all, p);
  const std::size_t first = group * kRunsPerGroup;
  const std::size_t count = std::min(kRunsPerGroup, runs_.size() - first);
  double sum = 0;
  for (const Run& run : std::span(runs_).subspan(first, count))
    sum += angle_over_distance_squared(run, p);
  return sum;
}

bool ShareBound::holds_at(Vec2 p, float weight, float weight_unit) const {
  const double k = weight_ / double{weight_unit};
  // (1 + k) Â <= most (W₀ - Â)
  const double room = most_ * double{weight} / (1 + k + most_);
  if (angle_over_distance_squared(whole_, p) <= room) return true;
  double sum = 0;
  for (std::size_t group = 0; group < groups_.size(); ++group) {
    sum += angle_of_group(group, p);
    if (!(sum <= room)) return false;
  }
  return true;
}

double ShareBound::share_at(Vec2 p, float weight, float weight_unit) const {
  double angle = 0, room = weight;
  for (std::size_t group = 0; group < groups_.size() && room > 0; ++group) {
    angle += angle_of_group(group, p);
    room = double{weight} - angle;
  }
  if (!(room > 0)) return std::numeric_limits<double>::infinity();
  return (1 + weight_ / double{weight_unit}) * angle / room;
}

}  // namespace sfumato::gather
