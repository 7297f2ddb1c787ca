#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Shrinks an image while its rows are read, so that the whole image is never in memory. A pixel is
/// the mean of the area that it covers, with colours weighted by alpha.
class RowShrinker {
 public:
  /// Some pixels of a row: the first one, and the distance to the next.
  struct Columns {
    std::size_t first = 0;
    std::size_t step = 1;
  };

  /// width, height: of the image that is read. format: of the rows that are read. to: the longer
  /// side of the small image, at most the image's own. Errors: limit (memory), cancelled.
  Status create(const Context& context, int width, int height, PixelFormat format, int to);

  /// Adds pixels of row y. Rows come in any order, each pixel once.
  void add(std::size_t y, std::span<const std::uint8_t> row, const Columns& columns);

  /// Makes the image of the means of all added pixels, with 16 bits. Errors: limit (memory),
  /// cancelled.
  Status finish(const Context& context, bool has_alpha, TableMemory& memory, Image& out);

 private:
  /// The one or two smaller pixels that a pixel covers on one axis, and its share of each.
  struct Cover {
    std::uint32_t first = 0;
    double share[2] = {};
  };

  static Cover cover_of(std::size_t at, std::size_t small_count, std::size_t count);

  int width_ = 0, height_ = 0;
  int small_width_ = 0, small_height_ = 0;
  PixelFormat format_ = PixelFormat::rgba8;
  TableMemory memory_{"a photo"};
  std::vector<Cover> column_;
  std::vector<double> sum_;  ///< per smaller pixel: red, green, blue times alpha, and alpha
};

}  // namespace sfumato::codecs
