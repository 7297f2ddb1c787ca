#include "solve/session/moving_curves.hpp"

#include <algorithm>
#include <numeric>

#include "base/try.hpp"

namespace sfumato::solve {

Result<std::vector<std::uint8_t>> marks_of(const Context& context, const curves::FlatCurves& flat,
                                           std::span<const std::uint32_t> which,
                                           TableMemory& memory) {
  std::vector<std::uint8_t> marks;
  SFUMATO_TRY(memory.resize(context, marks, flat.vertex.size()));
  for (const std::uint32_t curve : which) {
    std::fill(marks.begin() + flat.curve_begin[curve], marks.begin() + flat.curve_begin[curve + 1],
              std::uint8_t{1});
  }
  return marks;
}

std::vector<gather::ShareBound::Polyline> polylines_of(const curves::FlatCurves& flat,
                                                       std::span<const std::uint32_t> which) {
  std::vector<gather::ShareBound::Polyline> polylines;
  polylines.reserve(which.size());
  for (const std::uint32_t curve : which) {
    const std::uint32_t first = flat.curve_begin[curve], end = flat.curve_begin[curve + 1];
    polylines.push_back(std::span(flat.vertex).subspan(first, end - first));
  }
  return polylines;
}

std::vector<std::uint32_t> numbers(std::size_t count) {
  std::vector<std::uint32_t> list(count);
  std::iota(list.begin(), list.end(), 0u);
  return list;
}

double largest_weight(std::span<const Curve> curves, std::span<const std::uint32_t> which) {
  double largest = 0;
  for (const std::uint32_t curve : which) largest = std::max(largest, double{curves[curve].weight});
  return largest;
}

}  // namespace sfumato::solve
