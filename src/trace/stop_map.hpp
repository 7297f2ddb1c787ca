#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gather/rows.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// Where sides of edges lie among the stops that are left when some go: rows of the gather need not
/// be gathered again.
class StopMap {
 public:
  /// goes   per stop of the curves, in the order of curves, sides and stops; never the first or the
  ///        last of a side
  StopMap(std::span<const TracedCurve> curves, std::span<const std::uint8_t> goes);

  void move(gather::RowSide& side) const;

 private:
  void add_side(const SideStops& side, std::span<const std::uint8_t> goes);

  std::uint32_t kept_count_ = 0;
  // Per stop, before:
  std::vector<double> place_;
  std::vector<std::uint32_t> before_;  ///< the last that is left up to it
  std::vector<std::uint32_t> next_;    ///< the first that is left behind it
  std::vector<std::uint32_t> kept_;    ///< the index of before_ among those that are left
};

}  // namespace sfumato::tracing
