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

Result<ShareBound> ShareBound::create(const Context& context, std::span<const Polyline> polylines,
                                      double weight, double most, std::size_t most_runs) {
  ShareBound bound;
  bound.weight_ = weight;
  bound.most_ = most;
  std::size_t vertices = 0;
  Box box;
  for (const Polyline polyline : polylines) {
    vertices += polyline.size();
    for (const Vec2 vertex : polyline) box.extend(vertex);
  }
  const std::size_t per_run = std::max(kSegmentsPerRun, vertices / most_runs + 1);
  for (const Polyline polyline : polylines) SFUMATO_TRY(bound.add(context, polyline, per_run));
  if (vertices > 0) bound.whole_ = {box.center(), length(box.max - box.center()), 0};
  for (const Run& run : bound.runs_) bound.whole_.length += run.length;
  return bound;
}

/// Adds the runs and groups of a curve.
Status ShareBound::add(const Context& context, Polyline polyline, std::size_t per_run) {
  const std::size_t per_group = per_run * kRunsPerGroup;
  for (std::size_t begin = 0; begin + 1 < polyline.size(); begin += per_group) {
    const std::size_t end = std::min(begin + per_group, polyline.size() - 1);
    Group group{run_of(polyline.subspan(begin, end - begin + 1)), runs_.size(), 0};
    for (std::size_t first = begin; first < end; first += per_run) {
      const std::size_t last = std::min(first + per_run, end);
      SFUMATO_TRY(
          memory_.push_back(context, runs_, run_of(polyline.subspan(first, last - first + 1))));
      ++group.count;
    }
    SFUMATO_TRY(memory_.push_back(context, groups_, group));
  }
  return ok_status();
}

ShareBound::Run ShareBound::run_of(Polyline polyline) {
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

double ShareBound::angle_of_group(const Group& group, Vec2 p) const {
  if (length(p - group.all.center) >= kFar * group.all.radius) {
    return angle_over_distance_squared(group.all, p);
  }
  double sum = 0;
  for (const Run& run : std::span(runs_).subspan(group.first, group.count))
    sum += angle_over_distance_squared(run, p);
  return sum;
}

bool ShareBound::holds_at(Vec2 p, float weight, float weight_unit) const {
  const double k = weight_ / double{weight_unit};
  // (1 + k) Â <= most (W₀ - Â)
  const double room = most_ * double{weight} / (1 + k + most_);
  if (angle_over_distance_squared(whole_, p) <= room) return true;
  double sum = 0;
  for (const Group& group : groups_) {
    sum += angle_of_group(group, p);
    if (!(sum <= room)) return false;
  }
  return true;
}

double ShareBound::share_at(Vec2 p, float weight, float weight_unit) const {
  double angle = 0, room = weight;
  for (const Group& group : groups_) {
    angle += angle_of_group(group, p);
    room = double{weight} - angle;
    if (!(room > 0)) break;
  }
  if (!(room > 0)) return std::numeric_limits<double>::infinity();
  return (1 + weight_ / double{weight_unit}) * angle / room;
}

}  // namespace sfumato::gather
