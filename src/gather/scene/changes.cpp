#include "gather/scene/changes.hpp"

#include <algorithm>
#include <utility>

#include "base/try.hpp"
#include "gather/kernels/end_tree.hpp"
#include "gather/rows/weight_class.hpp"
#include "gather/scene/weak_visibility.hpp"

namespace sfumato::gather {
namespace {

/// The steps of find_viewers() for each triangle. A frame of a drag has little time: with more
/// steps its nodes should rather wait to be gathered.
constexpr std::size_t kStepsOfChange = 16;

EndBox box_of(const SceneTriangle& t) {
  return {std::min(std::min(t.x[0], t.x[1]), t.x[2]), std::min(std::min(t.y[0], t.y[1]), t.y[2]),
          std::max(std::max(t.x[0], t.x[1]), t.x[2]), std::max(std::max(t.y[0], t.y[1]), t.y[2])};
}

}  // namespace

Result<ChangedEnds> changed_ends(Context& context, const FreeEnds& before, const FreeEnds& now) {
  const auto differences = [&](const FreeEnds& then, const FreeEnds& after) -> Result<ChangedEnds> {
    SFUMATO_TRY_ASSIGN(auto&& gone, then.without(context, after));
    SFUMATO_TRY_ASSIGN(auto&& fresh, after.without(context, then));
    return ChangedEnds{std::move(gone), std::move(fresh)};
  };
  if (!now.extends(before) && !before.extends(now)) return differences(before, now);
  // If `before` contains the change, the ends that are gone there exist now.
  const FreeEnds& changed = now.extends(before) ? now : before;
  const Result<FreeEnds> gone = changed.gone(context), fresh = changed.fresh(context);
  SFUMATO_TRY(gone);
  return fresh ? differences(*gone, *fresh) : fresh.status();
}

Status ChangeSearch::run(TableMemory& memory, std::vector<std::uint32_t>& changed) {
  SFUMATO_TRY_ASSIGN(sees_, find_viewers(context_, now_.scene, memory_, kStepsOfChange));
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

/// Lists known points in the order of the scene's triangles, which have the indices of the earlier
/// ones.
Status ChangeSearch::list_known(TableMemory& memory, std::vector<std::uint32_t>& changed) {
  const Scene& scene = now_.scene;
  const EndBox reached = united(now_.ends.gone.box(), now_.ends.fresh.box());
  RarePoll<65536> poll(context_);
  for (std::size_t i = 0; i < scene.triangle.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    const std::size_t t = scene.source[i];
    if (t >= known_.is_same.size()) continue;  // it is new
    if (!known_.is_same[t]) {
      SFUMATO_TRY(memory_.append(context_, points_in(t), unknown_));
    } else if (sees_[i]) {
      SFUMATO_TRY(list_in(t, true, memory, changed));
    } else if (const EndBox box = box_of(scene.triangle[i]);
               overlap(reached, box) && now_.ends.may_reach(box)) {
      SFUMATO_TRY(list_in(t, false, memory, changed));
    }
  }
  return ok_status();
}

Status ChangeSearch::list_in(std::size_t triangle, bool sees, TableMemory& memory,
                             std::vector<std::uint32_t>& changed) {
  const std::span<const std::uint32_t> points = points_in(triangle);
  SFUMATO_TRY(memory.make_room(context_, changed, points.size()));
  for (const std::uint32_t slot : points) {
    if (poll_.cancelled()) return context_.cancel_status();
    if ((sees && may_matter(slot)) || is_reached(slot)) changed.push_back(slot);
  }
  return ok_status();
}

/// Lists the other points. Points whose triangle no longer exists are located in its replacement.
Status ChangeSearch::list_unknown(TableMemory& memory, std::vector<std::uint32_t>& changed) {
  SFUMATO_TRY_ASSIGN(const LocatedPoints& located,
                     now_.locator.locate(context_, {position_, unknown_}));
  SFUMATO_TRY(memory.make_room(context_, changed, unknown_.size()));
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    if (poll_.cancelled()) return context_.cancel_status();
    const std::uint32_t slot = unknown_[i];
    const bool sees = sees_[located.triangle[i]] != 0;
    if ((sees && may_matter(slot)) || is_reached(slot)) changed.push_back(slot);
  }
  return ok_status();
}

}  // namespace sfumato::gather
