#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sfumato/base/box.hpp"
#include "sfumato/sfumato.h"

namespace sfumato::capi {

/// x, y, width, height.
inline void write_box(const Box& from, double to[4]) {
  to[0] = from.min.x;
  to[1] = from.min.y;
  to[2] = from.width();
  to[3] = from.height();
}

/// Returns a view of `values` as rows of `columns` numbers of a type that takes `number_bytes`; an
/// element may be several numbers.
template <class Element>
sfumato_view view_of(const std::vector<Element>& values, std::uint32_t columns, std::uint32_t type,
                     std::size_t number_bytes) {
  const std::size_t row_bytes = columns * number_bytes;
  const std::size_t rows = row_bytes == 0 ? 0 : values.size() * sizeof(Element) / row_bytes;
  return {rows == 0 ? nullptr : values.data(), rows, row_bytes, columns, type};
}

}  // namespace sfumato::capi
