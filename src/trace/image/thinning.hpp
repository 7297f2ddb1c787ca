#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::tracing {

/// A set of pixels with a border of one pixel around it that is never set: row by row,
/// (width + 2) × (height + 2).
struct PixelSet {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> is_set;

  std::size_t stride() const { return static_cast<std::size_t>(width) + 2; }
  std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) + 1) * stride() + static_cast<std::size_t>(x) + 1;
  }
};

/// Thins lines to a width of one pixel and keeps them connected (Zhang and Suen 1984). Errors:
/// cancelled.
Status thin(const Context& context, PixelSet& set);

}  // namespace sfumato::tracing
