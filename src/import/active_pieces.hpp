#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sfumato::svg_import {

/// The extent of a piece across a sweep, including the distance that counts as near; lattice steps.
struct Extent {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// Holds the pieces that a sweep has reached and not left, in one list for each band across the
/// sweep, so that a piece is compared only with pieces beside it. Each band lists the pieces that
/// pass it. The number of bands is the number of mean pieces that fit into the whole, at most 64.
class ActivePieces {
 public:
  explicit ActivePieces(std::span<const Extent> extents) {
    if (extents.empty()) return;
    std::int64_t high = extents.front().high;
    double sum = 0;
    low_ = extents.front().low;
    for (const Extent& extent : extents) {
      low_ = std::min(low_, extent.low);
      high = std::max(high, extent.high);
      sum += static_cast<double>(extent.high - extent.low);
    }
    const double mean = std::max(sum / static_cast<double>(extents.size()), 1.0);
    const double wanted = static_cast<double>(high - low_) / mean;
    const auto count = static_cast<std::int64_t>(std::clamp(wanted, 1.0, double{kMostBands}));
    width_ = (high - low_) / count + 1;
  }

  std::size_t band_of(std::int64_t at) const {
    return static_cast<std::size_t>((at - low_) / width_);
  }
  std::vector<std::uint32_t>& operator[](std::size_t band) { return pieces_[band]; }

 private:
  static constexpr int kMostBands = 64;

  std::int64_t low_ = 0;
  std::int64_t width_ = 1;  ///< of a band
  std::array<std::vector<std::uint32_t>, kMostBands> pieces_;
};

}  // namespace sfumato::svg_import
