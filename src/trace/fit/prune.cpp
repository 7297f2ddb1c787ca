#include "trace/fit/prune.hpp"

#include <algorithm>
#include <cstddef>

#include "base/try.hpp"

namespace sfumato::tracing {
namespace {

struct Price {
  double cost;
  std::uint32_t stop_index;
};

/// The squared distances of a stop's colour and opacity from the values that its neighbours would
/// give there.
struct SquaredBend {
  double color = 0, opacity = 0;
};

SquaredBend squared_bend(const SideStops& side, std::size_t i) {
  const double way = side.place[i + 1] - side.place[i - 1];
  const double t = way > 0 ? (side.place[i] - side.place[i - 1]) / way : 0.5;
  const auto squared = [&](std::size_t c) {
    const double between = side.value[i - 1][c] + t * (side.value[i + 1][c] - side.value[i - 1][c]);
    return (side.value[i][c] - between) * (side.value[i][c] - between);
  };
  return {squared(0) + squared(1) + squared(2), squared(3)};
}

template <class Item>
void keep(std::vector<Item>& items, std::span<const std::uint8_t> goes) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!goes[i]) items[kept++] = items[i];
  }
  items.resize(kept);
}

}  // namespace

std::vector<std::uint8_t> stops_to_prune(std::span<const TracedCurve> curves,
                                         const PruneWeights& weight, const PruneLimits& limits) {
  std::vector<Price> prices;
  std::uint32_t first = 0;
  for (const TracedCurve& curve : curves) {
    for (const SideStops& side : curve.side) {
      for (std::uint32_t i = 1; i + 1 < side.place.size(); ++i) {
        const SquaredBend bend = squared_bend(side, i);
        double cost = bend.color * weight.color[first + i];
        if (!weight.opacity.empty()) cost += bend.opacity * weight.opacity[first + i];
        prices.push_back({cost, first + i});
      }
      first += static_cast<std::uint32_t>(side.place.size());
    }
  }
  std::ranges::stable_sort(prices, {}, &Price::cost);
  std::vector<std::uint8_t> goes(first);
  const auto most = static_cast<std::size_t>(limits.share * first);
  std::size_t count = 0;
  double cost = 0;
  for (const Price& price : prices) {
    if (count == most || cost + price.cost > limits.cost) break;
    // The first and the last stop of a side have no price, so that both neighbours are of the side.
    if (goes[price.stop_index - 1] || goes[price.stop_index + 1]) continue;
    goes[price.stop_index] = 1;
    cost += price.cost;
    ++count;
  }
  return goes;
}

Result<SparseMatrix> values_without(Context& context, std::span<const TracedCurve> curves,
                                    std::span<const std::uint8_t> goes) {
  SparseMatrix out;
  std::vector<double> place;
  for (const TracedCurve& curve : curves) {
    for (const SideStops& side : curve.side) {
      place.insert(place.end(), side.place.begin(), side.place.end());
    }
  }
  SFUMATO_TRY(out.memory.reserve(context, out.begin, place.size() + 1));
  SFUMATO_TRY(out.memory.reserve(context, out.column, 2 * place.size()));
  SFUMATO_TRY(out.memory.reserve(context, out.value, 2 * place.size()));
  std::uint32_t kept = 0;  // remaining stops among the examined ones
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (!goes[i]) {
      out.column.push_back(kept++);
      out.value.push_back(1);
    } else {
      // No two neighbours go, nor the ends of a side.
      const double way = place[i + 1] - place[i - 1];
      const double t = way > 0 ? (place[i] - place[i - 1]) / way : 0.5;
      out.column.insert(out.column.end(), {kept - 1, kept});
      out.value.insert(out.value.end(), {static_cast<float>(1 - t), static_cast<float>(t)});
    }
    out.begin.push_back(static_cast<std::uint32_t>(out.column.size()));
  }
  out.column_count = kept;
  return out;
}

void prune_stops(std::span<const std::uint8_t> goes, std::span<TracedCurve> curves) {
  for (TracedCurve& curve : curves) {
    for (SideStops& side : curve.side) {
      const std::size_t count = side.place.size();
      keep(side.place, goes.first(count));
      keep(side.value, goes.first(count));
      goes = goes.subspan(count);
    }
  }
}

}  // namespace sfumato::tracing
