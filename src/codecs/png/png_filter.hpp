#pragma once

#include <cstddef>
#include <cstdint>

namespace sfumato::codecs {

/// Filters a row by one of PNG's five filters and writes the number of the filter and the filtered
/// row to `out`. Chooses the filter whose bytes, as signed numbers, have the smallest sum of
/// magnitudes in samples of the row.
///
/// current, previous: rows of row_bytes; previous is all 0 for the first row. pixel_bytes: the
/// distance to the pixel at the left, 1 to 8.
void filter_row(const std::uint8_t* current, const std::uint8_t* previous, std::size_t row_bytes,
                std::size_t pixel_bytes, std::uint8_t* out);

}  // namespace sfumato::codecs
