#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"

namespace sfumato::tracing {

/// A curve passes through the same place twice.
struct SelfCrossing {
  std::uint32_t curve = 0;
  double first = 0;  ///< parameters
  double second = 0;
};

/// Two curves cross, and colours that face each other there do not fit.
struct Clash {
  std::array<std::uint32_t, 2> curve{};
  std::array<double, 2> parameter{};
};

struct Crossings {
  std::vector<SelfCrossing> self;
  std::vector<Clash> clash;
};

/// Where curves cross as a drawing has them.
///
/// width, height   of the picture, pixels
/// Errors          limit, cancelled
Result<Crossings> find_crossings(Context& context, std::span<const TracedCurve> curves, int width,
                                 int height);

}  // namespace sfumato::tracing
