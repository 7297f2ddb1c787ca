#include "trace/stop_map.hpp"

#include <cstddef>

namespace sfumato::tracing {

StopMap::StopMap(std::span<const TracedCurve> curves, std::span<const std::uint8_t> goes) {
  for (const TracedCurve& curve : curves) {
    for (const SideStops& side : curve.side) add_side(side, goes);
  }
}

void StopMap::add_side(const SideStops& side, std::span<const std::uint8_t> goes) {
  const std::size_t first = place_.size(), end = first + side.place.size();
  place_.insert(place_.end(), side.place.begin(), side.place.end());
  auto before = static_cast<std::uint32_t>(first);
  for (std::size_t i = first; i < end; ++i) {
    if (!goes[i]) {
      before = static_cast<std::uint32_t>(i);
      ++kept_count_;
    }
    before_.push_back(before);
    kept_.push_back(kept_count_ - 1);
  }
  next_.resize(end);
  std::uint32_t next = 0;
  for (std::size_t i = end; i-- > first;) {
    next_[i] = next;
    if (!goes[i]) next = static_cast<std::uint32_t>(i);
  }
}

void StopMap::move(gather::RowSide& side) const {
  if (!side.has_value || side.shader >= 0) return;
  const std::uint32_t from = before_[side.column], to = next_[side.column];
  const bool is_between = side.from > 0 || side.to > 0 || from != side.column;
  if (is_between) {
    const double begin = place_[side.column], step = place_[side.column + 1] - begin;
    const double way = place_[to] - place_[from];
    const auto moved = [&](float t) {
      return static_cast<float>((begin + step * t - place_[from]) / way);
    };
    side.from = moved(side.from);
    side.to = moved(side.to);
  }
  side.column = kept_[side.column];
}

}  // namespace sfumato::tracing
