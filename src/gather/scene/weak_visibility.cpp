#include "gather/scene/weak_visibility.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "base/half_edge.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::gather {
namespace {

/// Returns a positive number where c lies to the left of the line from a to b. Differences of
/// single-precision coordinates are exact or nearly so.
double side_of(Vec2 a, Vec2 b, Vec2 c) {
  return cross(b - a, c - a);
}

/// A line that bounds the visible region: from a pivot, which is an obstacle's corner on one side
/// or an end of the source, through a corner on the other side.
struct Limit {
  Vec2 pivot;
  Vec2 corner;
};

/// The region seen outwards through a half-edge: right of the left limit and left of the right one.
struct PortalWindow {
  std::uint32_t portal;
  Limit right;  ///< the pivot is on the left
  Limit left;   ///< the pivot is on the right
};

class ViewerSearch {
 public:
  ViewerSearch(const Scene& scene, std::size_t steps_per_triangle, std::span<std::uint8_t> sees)
      : scene_(scene), steps_per_triangle_(steps_per_triangle), sees_(sees) {}

  Status run(const Context& context) {
    RarePoll<1024> poll(context);
    const std::size_t most = steps_per_triangle_ * scene_.triangle.size();
    std::size_t steps = 0;
    SFUMATO_TRY(memory_.reserve(context, waiting_, 64));
    for (const std::uint32_t h : scene_.watched) {
      start_from(h);
      while (!waiting_.empty()) {
        PortalWindow window = waiting_.back();
        waiting_.pop_back();
        do {
          if (poll.cancelled()) return context.cancel_status();
          if (++steps > most) {
            std::ranges::fill(sees_, std::uint8_t{1});
            return ok_status();
          }
          if (waiting_.size() == waiting_.capacity()) {
            SFUMATO_TRY(memory_.make_room(context, waiting_, 2));
          }
        } while (follow(window));
      }
    }
    return ok_status();
  }

 private:
  Vec2 origin(std::uint32_t h) const {
    const SceneTriangle& t = scene_.triangle[h / 3];
    return {t.x[h % 3], t.y[h % 3]};
  }
  Vec2 target(std::uint32_t h) const { return origin(next_half_edge(h)); }
  std::int32_t twin(std::uint32_t h) const { return scene_.triangle[h / 3].twin[h % 3]; }

  /// Returns whether a point beyond sees through it.
  bool is_passed(std::uint32_t h) const {
    const std::int32_t beyond = twin(h);
    return beyond >= 0 && scene_.triangle[beyond / 3].edge[beyond % 3] >= 0;
  }

  /// Starts from the source as its own triangle sees it, looking inwards: its origin is the left
  /// end.
  void start_from(std::uint32_t source) {
    sees_[source / 3] = 1;
    const Vec2 left_end = origin(source), right_end = target(source);
    for (const std::uint32_t h : {next_half_edge(source), previous_half_edge(source)}) {
      if (!is_passed(h)) continue;
      waiting_.push_back({h, {left_end, origin(h)}, {right_end, target(h)}});
    }
  }

  /// Enters the next triangle. Returns whether the window, which it updates, continues; other
  /// windows that continue wait.
  bool follow(PortalWindow& window) {
    const auto entered = static_cast<std::uint32_t>(twin(window.portal));
    sees_[entered / 3] = 1;
    const std::uint32_t left = previous_half_edge(entered), right = next_half_edge(entered);
    const Vec2 apex = origin(left);
    const bool reaches_left = side_of(window.left.pivot, window.left.corner, apex) <= 0;
    const bool reaches_right = side_of(window.right.pivot, window.right.corner, apex) >= 0;
    const bool goes_left = reaches_left && is_passed(left);
    if (reaches_right && is_passed(right)) {
      if (goes_left) waiting_.push_back({left, right_limit(window, apex), window.left});
      if (reaches_left) window.left = left_limit(window, apex);
      window.portal = right;
      return true;
    }
    if (goes_left && reaches_right) window.right = right_limit(window, apex);
    window.portal = left;
    return goes_left;
  }

  /// Returns the limits of a window that the apex narrows: the one of two pivots that bounds it
  /// more. A pivot between them may bound it even more; without it the window is too large, which
  /// is allowed.
  static Limit right_limit(const PortalWindow& window, Vec2 apex) {
    const Vec2 pivot = window.right.pivot, other = window.left.corner;
    return {side_of(pivot, apex, other) < 0 ? other : pivot, apex};
  }
  static Limit left_limit(const PortalWindow& window, Vec2 apex) {
    const Vec2 pivot = window.left.pivot, other = window.right.corner;
    return {side_of(pivot, apex, other) > 0 ? other : pivot, apex};
  }

  const Scene& scene_;
  std::size_t steps_per_triangle_;
  std::span<std::uint8_t> sees_;
  std::vector<PortalWindow> waiting_;
  TableMemory memory_{"who sees a curve"};
};

}  // namespace

Result<std::vector<std::uint8_t>> find_viewers(const Context& context, const Scene& scene,
                                               TableMemory& memory,
                                               std::size_t steps_per_triangle) {
  std::vector<std::uint8_t> sees;
  SFUMATO_TRY(memory.resize(context, sees, scene.triangle.size()));
  SFUMATO_TRY(ViewerSearch(scene, steps_per_triangle, sees).run(context));
  return sees;
}

}  // namespace sfumato::gather
