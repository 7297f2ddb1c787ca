#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "gather/ends/free_ends.hpp"
#include "gather/gather.hpp"
#include "gather/scene/locate.hpp"
#include "gather/scene/scene.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// The free ends that exist in one field and not in another with the same origin.
struct ChangedEnds {
  FreeEnds gone, fresh;

  bool reach(Vec2 p) const { return gone.reach(p) || fresh.reach(p); }
  bool may_reach(const EndBox& box) const { return gone.may_reach(box) || fresh.may_reach(box); }
};

/// Finds them. Errors: limit (memory), cancelled.
Result<ChangedEnds> changed_ends(Context& context, const FreeEnds& before, const FreeEnds& now);

/// A field with the watched segments inserted into its mesh.
struct InsertedScene {
  const Scene& scene;
  const Locator& locator;
  const ChangedEnds& ends;
  float weight_unit_before;  ///< of the scene without the watched segments
};

/// Finds the points whose values an insertion may change: Gatherer::list_changes.
class ChangeSearch {
 public:
  ChangeSearch(Context& context, const InsertedScene& now, std::span<const Vec2> position,
               const KnownPlaces& known)
      : context_(context), now_(now), position_(position), known_(known) {}

  Status run(TableMemory& memory, std::vector<std::uint32_t>& changed);

 private:
  /// Lists the points in unchanged triangles; the others are collected in unknown_.
  Status list_known(TableMemory& memory, std::vector<std::uint32_t>& changed);
  Status list_in(std::size_t triangle, bool sees, TableMemory& memory,
                 std::vector<std::uint32_t>& changed);
  Status list_unknown(TableMemory& memory, std::vector<std::uint32_t>& changed);
  std::span<const std::uint32_t> points_in(std::size_t triangle) const;
  /// Returns whether a point may see a watched segment.
  bool may_matter(std::uint32_t slot) const;
  bool is_reached(std::uint32_t slot) const {
    return now_.ends.reach(position_[slot] - now_.scene.origin);
  }

  /// The bound on the change by a curve of many segments takes up to 0.1 ms at a point.
  static constexpr std::uint32_t kPointsPerPoll = 256;

  Context& context_;
  RarePoll<kPointsPerPoll> poll_{context_};
  InsertedScene now_;
  std::span<const Vec2> position_;
  const KnownPlaces& known_;
  std::vector<std::uint8_t> sees_;      ///< per triangle of the scene
  std::vector<std::uint32_t> unknown_;  ///< points whose triangle no longer exists
  TableMemory memory_{"who sees a curve"};
};

}  // namespace sfumato::gather
