#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sfumato::codecs {

/// PNG's five row filters, and the choice between them: the one whose bytes, as signed numbers,
/// have the smallest sum of magnitudes.
class PngFilter {
 public:
  /// pixel_bytes: the distance to the pixel at the left, 1 to 8.
  PngFilter(std::size_t row_bytes, std::size_t pixel_bytes);

  /// Writes the filter's number and row_bytes filtered bytes to `out`.
  /// current, previous: row_bytes each; previous is all 0 for the first row.
  void filter(const std::uint8_t* current, const std::uint8_t* previous, std::uint8_t* out);

 private:
  std::size_t row_bytes_;
  std::size_t pixel_bytes_;
  std::vector<std::uint8_t> candidate_;
};

}  // namespace sfumato::codecs
