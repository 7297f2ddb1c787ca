#include "sfumato/import/combine.hpp"

#include <cmath>
#include <string>

#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "import/boundary.hpp"
#include "import/placed_contours.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato {
namespace {

Status check_contours(const RegionContours& contours) {
  for (const std::vector<Vec2>& chain : contours) {
    if (chain.size() < 4 || chain.size() % 3 != 1) {
      return make_error(StatusCode::bad_input,
                        "a contour has 3 n + 1 points, not " + std::to_string(chain.size()));
    }
  }
  if (svg_import::are_in_range(contours)) return ok_status();
  return make_error(StatusCode::bad_input,
                    "a contour reaches farther than " +
                        std::to_string(static_cast<long>(limits::kCoordinate)) +
                        " from the origin; keep coordinates within that");
}

}  // namespace

Result<RegionContours> combine_regions(Context& context, RegionOperation operation,
                                       const RegionContours& first, const RegionContours& second,
                                       double tolerance) {
  return public_verb(context, [&]() -> Result<RegionContours> {
    if (!(tolerance > 0) || !std::isfinite(tolerance)) {
      return make_error(StatusCode::bad_input, "the tolerance is a finite number above 0");
    }
    SFUMATO_TRY(check_contours(first));
    SFUMATO_TRY(check_contours(second));
    return svg_import::combined_boundary(context, operation, {first, false}, {second, false},
                                         tolerance);
  });
}

}  // namespace sfumato
