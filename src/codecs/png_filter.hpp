#pragma once

#include <cstddef>
#include <cstdint>

namespace sfumato::codecs {

/// Writes the number of one of PNG's five row filters and a row filtered by it to `out`: of that
/// whose bytes, as signed numbers, have the smallest sum of magnitudes, in samples of the row.
///
/// current, previous   rows of row_bytes; previous is all 0 for the first row
/// pixel_bytes         the distance to the pixel at the left, 1 to 8
void filter_row(const std::uint8_t* current, const std::uint8_t* previous, std::size_t row_bytes,
                std::size_t pixel_bytes, std::uint8_t* out);

}  // namespace sfumato::codecs
