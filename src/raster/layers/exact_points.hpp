#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "picture/point_fields.hpp"
#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// Points of one tile at which the exact fields of a layer are read: all at once, in blocks of the
/// image, so that the values depend neither on the window nor on the threads.
class ExactPoints {
 public:
  /// Starts a list for a layer with exact fields, which must outlive it.
  void start(const LayerView& layer, const Affine& layer_from_image);

  /// Adds a point that represents (a part of) the pixel (x, y). Returns its index.
  std::uint32_t add(Vec2 point, int x, int y) {
    point_.push_back(point);
    block_.push_back(block_of(x, y));
    return static_cast<std::uint32_t>(point_.size()) - 1;
  }
  /// Charges the points that were added. Error: limit (memory).
  Status settle(const Context& context) {
    return memory_.settle(
        context,
        capacity_bytes(point_, block_, group_, values_.color, values_.opacity, values_.hit),
        charged_);
  }

  /// Reads the fields at all points. Errors: limit, cancelled.
  Status read(Context& context);

  std::size_t size() const { return point_.size(); }

  /// @name Values at a point, after read()
  /// @{
  const float* color(std::uint32_t index) const {
    return values_.color.data() + color_channels_ * slot_[index];
  }
  /// Returns null for an opaque layer.
  const float* opacity(std::uint32_t index) const {
    return values_.opacity.empty() ? nullptr
                                   : values_.opacity.data() + opacity_channels_ * slot_[index];
  }
  bool is_hit(std::uint32_t index) const { return values_.hit[slot_[index]] != 0; }
  /// @}

 private:
  /// Points of a square with this side, pixels, are gathered in common packets.
  static constexpr int kBlock = 16;
  static constexpr int kColumns = kTileWidth / kBlock, kRows = kTileHeight / kBlock;

  /// Returns the number of a pixel's block in its tile.
  static std::uint8_t block_of(int x, int y) {
    static_assert(kColumns * kRows <= 256);
    return static_cast<std::uint8_t>(y / kBlock % kRows * kColumns + x / kBlock % kColumns);
  }

  const picture::PointFields* fields_ = nullptr;
  Affine layer_from_image_;
  std::size_t color_channels_ = 0, opacity_channels_ = 0;
  std::vector<Vec2> point_;           ///< pixels of the image
  std::vector<std::uint8_t> block_;   ///< per point
  std::vector<std::uint32_t> slot_;   ///< per point: its index in `sorted_` and `values_`
  std::vector<Vec2> sorted_;          ///< layer frame, block by block
  std::vector<std::uint32_t> group_;  ///< the ends of the blocks in `sorted_`
  picture::PointValues values_;
  std::size_t charged_ = 0;
  TableMemory memory_{"exact pixels"};
};

}  // namespace sfumato::raster
