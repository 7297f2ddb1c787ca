#include "import/placed_contours.hpp"

#include <algorithm>
#include <cmath>

#include "base/try.hpp"
#include "document/rules.hpp"
#include "import/stroke_outline.hpp"

namespace sfumato::svg_import {

Result<Contours> copy_of(Context& context, const Contours& from, TableMemory& memory) {
  Contours to;
  SFUMATO_TRY(memory.reserve(context, to, from.size()));
  for (std::size_t i = 0; i < from.size(); ++i) {
    SFUMATO_TRY(memory.append(context, from[i], to.emplace_back()));
  }
  return to;
}

bool are_in_range(const Contours& contours) {
  const auto is_in_range = [](Vec2 point) { return rules::is_coordinate(point); };
  return std::ranges::all_of(contours, [&](const std::vector<Vec2>& contour) {
    return std::ranges::all_of(contour, is_in_range);
  });
}

void map_points(const Affine& map, Contours& contours) {
  for (std::vector<Vec2>& contour : contours) {
    for (Vec2& point : contour) point = map(point);
  }
}

Result<Contours> placed_stroke(Context& context, const Contours& chains,
                               const svg::StrokeStyle& style, const Affine& artboard_from_user,
                               double tolerance, TableMemory& memory) {
  if (style.is_scaled) {
    const double scale = std::sqrt(std::abs(artboard_from_user.determinant()));
    Result<Contours> made = stroke_outline(context, chains, style, tolerance / scale, &memory);
    if (made) map_points(artboard_from_user, *made);
    return made;
  }
  TableMemory working("the curves");
  SFUMATO_TRY_ASSIGN(auto&& mapped, copy_of(context, chains, working));
  map_points(artboard_from_user, mapped);
  return stroke_outline(context, mapped, style, tolerance, &memory);
}

}  // namespace sfumato::svg_import
