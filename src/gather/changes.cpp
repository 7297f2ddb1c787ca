#include "gather/changes.hpp"

#include <algorithm>
#include <utility>

#include "base/poll.hpp"
#include "gather/kernels/end_tree.hpp"
#include "gather/weak_visibility.hpp"
#include "gather/weight_class.hpp"

namespace sfumato::gather {
namespace {

/// A frame of a drag has little time: from here on its nodes had better wait to be gathered.
constexpr std::size_t kStepsOfChange = 16;

EndBox box_of(const SceneTriangle& t) {
  return {std::min(std::min(t.x[0], t.x[1]), t.x[2]), std::min(std::min(t.y[0], t.y[1]), t.y[2]),
          std::max(std::max(t.x[0], t.x[1]), t.x[2]), std::max(std::max(t.y[0], t.y[1]), t.y[2])};
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
  Result<std::vector<std::uint8_t>> sees =
      find_viewers(context_, now_.scene, memory_, kStepsOfChange);
  if (!sees) return sees.status();
  sees_ = std::move(*sees);
  Status status = list_known(memory, changed);
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

/// In the order of the scene's triangles, which have the indices of those before.
Status ChangeSearch::list_known(TableMemory& memory, std::vector<std::uint32_t>& changed) {
  const Scene& scene = now_.scene;
  const EndBox reached = united(now_.ends.gone.box(), now_.ends.fresh.box());
  RarePoll<65536> poll(context_);
  Status status;
  for (std::size_t i = 0; status && i < scene.triangle.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    const std::size_t t = scene.source[i];
    if (t >= known_.is_same.size()) continue;  // it is new
    if (!known_.is_same[t]) {
      status = memory_.append(context_, points_in(t), unknown_);
    } else if (sees_[i]) {
      status = list_in(t, true, memory, changed);
    } else if (const EndBox box = box_of(scene.triangle[i]);
               overlap(reached, box) && now_.ends.may_reach(box)) {
      status = list_in(t, false, memory, changed);
    }
  }
  return status;
}

Status ChangeSearch::list_in(std::size_t triangle, bool sees, TableMemory& memory,
                             std::vector<std::uint32_t>& changed) {
  const std::span<const std::uint32_t> points = points_in(triangle);
  Status status = memory.make_room(context_, changed, points.size());
  if (!status) return status;
  for (const std::uint32_t slot : points) {
    if (poll_.cancelled()) return context_.cancel_status();
    if ((sees && may_matter(slot)) || is_reached(slot)) changed.push_back(slot);
  }
  return status;
}

/// Points whose triangle is no more are located in what came in its place.
Status ChangeSearch::list_unknown(TableMemory& memory, std::vector<std::uint32_t>& changed) {
  const Result<LocatedPoints> located = now_.locator.locate(context_, {position_, unknown_});
  if (!located) return located.status();
  Status status = memory.make_room(context_, changed, unknown_.size());
  for (std::size_t i = 0; status && i < unknown_.size(); ++i) {
    if (poll_.cancelled()) return context_.cancel_status();
    const std::uint32_t slot = unknown_[i];
    const bool sees = sees_[located->triangle[i]] != 0;
    if ((sees && may_matter(slot)) || is_reached(slot)) changed.push_back(slot);
  }
  return status;
}

}  // namespace sfumato::gather
