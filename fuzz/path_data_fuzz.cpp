// The `d` attribute of paths, and transforms, which use the same number syntax.
#include <algorithm>
#include <cmath>
#include <vector>

#include "formats/svg/shapes/path.hpp"
#include "formats/svg/shapes/transform.hpp"
#include "fuzz.hpp"

using namespace sfumato;

namespace {

void check(const svg::Subpath& subpath) {
  const std::size_t points = subpath.control_points.size();
  fuzz::require(points >= 4 && points % 3 == 1, "a chain that is not 3n+1 points long");
  fuzz::require(subpath.segment_begin.size() >= 2, "a subpath without a segment");
  fuzz::require(subpath.segment_begin.front() == 0, "the first segment begins elsewhere");
  fuzz::require(subpath.segment_begin.back() == (points - 1) / 3,
                "the last segment ends elsewhere");
  for (std::size_t i = 1; i < subpath.segment_begin.size(); ++i) {
    const std::uint32_t pieces = subpath.segment_begin[i] - subpath.segment_begin[i - 1];
    fuzz::require(pieces >= 1 && pieces <= svg::kMaxPieces, "a segment of no piece or of too many");
  }
}

/// Arcs with radii too small for their chord are stretched beyond all finite numbers; the
/// document's reader refuses points beyond limits::kCoordinate.
bool has_finite_points(const svg::Subpath& subpath) {
  return std::ranges::all_of(subpath.control_points,
                             [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::as_text({data, size});
  Context context;
  TableMemory memory("control points");
  const Result<std::vector<svg::Subpath>> path = svg::parse_path(context, text, memory);
  if (path) {
    std::size_t bytes = capacity_bytes(*path);
    for (const svg::Subpath& subpath : *path) {
      check(subpath);
      bytes += capacity_bytes(subpath.control_points, subpath.segment_begin);
    }
    fuzz::require(bytes == context.budget.used(), "what is charged is not what is there");
    const Result<Box> box = svg::bounds(context, *path);
    fuzz::require(box.ok(), "a box ends although nothing ends it");
    if (std::ranges::all_of(*path, has_finite_points)) {
      fuzz::require(box->empty() == path->empty(), "a box of nothing, or no box");
    }
  } else {
    fuzz::require_honest(path.status());
  }
  if (const Result<Affine> map = svg::parse_transform(context, text); !map) {
    fuzz::require_honest(map.status());
  }
  return 0;
}
