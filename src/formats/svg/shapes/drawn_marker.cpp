#include "formats/svg/shapes/drawn_marker.hpp"

#include <algorithm>

namespace sfumato::svg {
namespace {

/// A share of the viewport's longer side: parts that reach out less come from rounding.
constexpr double kClipSlack = 1e-6;

}  // namespace

bool is_drawn(const DrawnMarker* innermost, Element marker) {
  for (const DrawnMarker* each = innermost; each; each = each->outer) {
    if (each->element == marker) return true;
  }
  return false;
}

std::size_t depth_of(const DrawnMarker* innermost) {
  std::size_t depth = 0;
  for (const DrawnMarker* each = innermost; each; each = each->outer) ++depth;
  return depth;
}

bool cuts(const DrawnMarker& marker, const Affine& frame_from_user, const Box& box) {
  if (!marker.clip) return false;
  const Affine viewport_from_user = inverse(marker.frame_from_viewport) * frame_from_user;
  const double slack = kClipSlack * std::max(marker.clip->width(), marker.clip->height());
  const Box shown = marker.clip->grown_by(slack);
  const Vec2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  return !std::ranges::all_of(
      corners, [&](Vec2 corner) { return shown.contains(viewport_from_user(corner)); });
}

}  // namespace sfumato::svg
