#include "gather/changes.hpp"

#include <algorithm>
#include <utility>

#include "base/poll.hpp"
#include "gather/weak_visibility.hpp"
#include "gather/weight_class.hpp"

namespace sfumato::gather {
namespace {

/// What the triangles of the mesh before say of the points in them.
constexpr std::uint8_t kSame = 0;     ///< their values are what they were
constexpr std::uint8_t kNearEnd = 1;  ///< a changed end may reach them
constexpr std::uint8_t kSees = 2;     ///< they may see a watched segment, or be reached
constexpr std::uint8_t kGone = 3;     ///< the triangle is no more

/// A bound on what a curve of many segments changes takes up to 0.1 ms at a point.
constexpr std::size_t kPointsPerPoll = 256;

EndBox box_of(const SceneTriangle& t) {
  const auto [x0, x1] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [y0, y1] = std::minmax({t.y[0], t.y[1], t.y[2]});
  return {x0, y0, x1, y1};
}

}  // namespace

Result<ChangedEnds> changed_ends(Context& context, const FreeEnds& before, const FreeEnds& now) {
  const auto differences = [&](const FreeEnds& then, const FreeEnds& after) -> Result<ChangedEnds> {
    Result<FreeEnds> gone = then.without(context, after);
    if (!gone) return gone.status();
    Result<FreeEnds> fresh = after.without(context, then);
    if (!fresh) return fresh.status();
    return ChangedEnds{std::move(*gone), std::move(*fresh)};
  };
  if (!now.extends(before) && !before.extends(now)) return differences(before, now);
  // If `before` is of the change, what was gone is there now.
  const FreeEnds& changed = now.extends(before) ? now : before;
  const Result<FreeEnds> gone = changed.gone(context), fresh = changed.fresh(context);
  if (!gone) return gone.status();
  return fresh ? differences(*gone, *fresh) : fresh.status();
}

Status ChangeSearch::run(TableMemory& memory, std::vector<std::uint32_t>& changed) {
  Status status = classify();
  if (status) status = list(memory, changed);
  return status ? list_unknown(memory, changed) : status;
}

bool ChangeSearch::may_matter(std::uint32_t slot) const {
  if (!known_.bound) return true;
  const float weight = least_weight(known_.weight[slot]);
  return !known_.bound->holds_at(position_[slot], weight, now_.weight_unit_before);
}

std::span<const std::uint32_t> ChangeSearch::points_in(std::size_t triangle) const {
  const PointPlaces& points = known_.points;
  return std::span(points.slot)
      .subspan(points.begin[triangle], points.begin[triangle + 1] - points.begin[triangle]);
}

/// Answers for each triangle of the mesh before.
Status ChangeSearch::classify() {
  const Scene& scene = now_.scene;
  Result<std::vector<std::uint8_t>> sees = find_viewers(context_, scene, memory_);
  if (!sees) return sees.status();
  sees_ = std::move(*sees);
  Status status = memory_.resize(context_, answer_, known_.is_same.size(), kSame);
  if (!status) return status;
  const bool has_ends = !now_.ends.empty();
  RarePoll<65536> poll(context_);
  for (std::size_t i = 0; i < scene.triangle.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    const std::size_t t = scene.source[i];
    if (t >= answer_.size()) continue;  // it is new
    if (!known_.is_same[t]) {
      answer_[t] = kGone;
    } else if (sees_[i]) {
      answer_[t] = kSees;
    } else if (has_ends && now_.ends.may_reach(box_of(scene.triangle[i]))) {
      answer_[t] = kNearEnd;
    }
  }
  return ok_status();
}

Status ChangeSearch::list(TableMemory& memory, std::vector<std::uint32_t>& changed) {
  RarePoll<kPointsPerPoll> poll(context_);
  Status status;
  for (std::size_t t = 0; status && t < answer_.size(); ++t) {
    if (answer_[t] == kSame) continue;
    const std::span<const std::uint32_t> points = points_in(t);
    if (answer_[t] == kGone) {
      status = memory_.append(context_, points, unknown_);
    } else {
      status = memory.make_room(context_, changed, points.size());
      const bool sees = answer_[t] == kSees;
      if (!status) return status;
      for (const std::uint32_t slot : points) {
        if (poll.cancelled()) return context_.cancel_status();
        if ((sees && may_matter(slot)) || is_reached(slot)) changed.push_back(slot);
      }
    }
  }
  return status;
}

/// Points whose triangle is no more are located in what came in its place.
Status ChangeSearch::list_unknown(TableMemory& memory, std::vector<std::uint32_t>& changed) {
  const Result<LocatedPoints> located = now_.locator.locate(context_, {position_, unknown_});
  if (!located) return located.status();
  Status status = memory.make_room(context_, changed, unknown_.size());
  RarePoll<kPointsPerPoll> poll(context_);
  for (std::size_t i = 0; status && i < unknown_.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    const std::uint32_t slot = unknown_[i];
    const bool sees = sees_[located->triangle[i]] != 0;
    if ((sees && may_matter(slot)) || is_reached(slot)) changed.push_back(slot);
  }
  return status;
}

}  // namespace sfumato::gather
