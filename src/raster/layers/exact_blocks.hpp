#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "raster/kernels/pixel_mask.hpp"
#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// A block of pixels of a tile, counted from the tile's corner: columns x0 to x1 and rows y0 to y1,
/// both included. Its nine nodes are the pixels at its ends and in its middle. Neighbouring blocks
/// share the nodes at their common end.
struct ExactBlock {
  std::int16_t x0, x1, y0, y1;

  int middle_x() const { return (x0 + x1) / 2; }
  int middle_y() const { return (y0 + y1) / 2; }
  /// Returns whether all its pixels are its nodes and probes.
  bool is_small() const { return x1 - x0 <= 2 && y1 - y0 <= 2; }
};

/// Chooses the pixels of a tile that are gathered. Where a field is smooth, a quadratic through the
/// nine nodes of a block gives its other pixels. Four probes, the middles of its quarters, measure
/// the error. A block with too large an error is divided into quarters for the next round. Blocks
/// near curves are small. In the smallest, 3 by 3 pixels, the corners are interpolated and the
/// middle is the probe.
///
/// If the largest error is 0, no pixel is interpolated. A block far from curves is then clear if
/// the opacity is 0 at its nodes and probes. All pixels of the other blocks are gathered.
class ExactBlocks {
 public:
  /// Starts a tile.
  ///
  /// usable   the pixels to paint
  /// cut      pixels that curves pass through
  /// most     the largest error of a channel; 0: gathers all pixels outside clear blocks
  void start(const Tile& tile, const PixelMask& usable, const PixelMask* cut, float most);

  /// Lists the pixels to gather in the next round. Returns false if all pixels are known.
  bool next_round();
  /// Returns the pixels of the round, as x + kTileStride y.
  const std::vector<std::uint32_t>& pixels() const { return pixel_; }

  /// Returns the memory of the lists.
  std::size_t bytes() const { return capacity_bytes(waiting_, tried_, rejected_, pixel_); }

  /// Ends a round whose values were written into the tile: interpolates the blocks whose probes
  /// fit, and divides the others.
  void end_round(const Tile& tile);

 private:
  static constexpr int kLargest = 16;
  /// The least size of a clear block. All pixels of smaller blocks are gathered.
  static constexpr int kLeastClear = 8;

  void place(const ExactBlock& block);
  void divide(const ExactBlock& block);
  bool is_smooth(const ExactBlock& block) const;
  void ask(int x, int y);
  void ask_all(const ExactBlock& block);
  bool fill_small(const ExactBlock& block, const Tile& tile) const;
  bool is_clear(const ExactBlock& block, const Tile& tile) const;
  bool fill(const ExactBlock& block, const Tile& tile) const;
  template <class Visit>
  static void for_each_sample(const ExactBlock& block, const Visit& visit);
  template <class Visit>
  static void for_each_probe(const ExactBlock& block, const Visit& visit);

  PixelMask usable_, asked_;
  const PixelMask* cut_ = nullptr;
  int width_ = 0, height_ = 0;
  float most_ = 0;
  std::vector<ExactBlock> waiting_, tried_;
  std::vector<ExactBlock> rejected_;  ///< small ones, all of whose pixels are gathered
  std::vector<std::uint32_t> pixel_;
};

}  // namespace sfumato::raster
