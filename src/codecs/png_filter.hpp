#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace sfumato::codecs {

/// Applies that of PNG's five row filters whose bytes, as signed numbers, have the smallest sum of
/// magnitudes.
class PngFilter {
 public:
  /// pixel_bytes: the distance to the pixel at the left, 1 to 8.
  /// candidate: a buffer as long as a row, for the filtered rows that are tried.
  PngFilter(std::size_t pixel_bytes, std::span<std::uint8_t> candidate)
      : pixel_bytes_(pixel_bytes), candidate_(candidate) {}

  /// Writes the filter's number and a row of filtered bytes to `out`.
  /// current, previous: a row each; previous is all 0 for the first row.
  void filter(const std::uint8_t* current, const std::uint8_t* previous, std::uint8_t* out);

 private:
  std::size_t pixel_bytes_;
  std::span<std::uint8_t> candidate_;
};

}  // namespace sfumato::codecs
