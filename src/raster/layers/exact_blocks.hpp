#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "raster/kernels/pixel_mask.hpp"
#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// Pixels of a tile from its corner; x1 and y1 belong to the block. Its nodes are the pixels at its
/// ends and in its middle: neighbouring blocks share those at their ends, and the nodes of its
/// quarters are nodes of the next round.
struct ExactBlock {
  std::int16_t x0, x1, y0, y1;

  int middle_x() const { return (x0 + x1) / 2; }
  int middle_y() const { return (y0 + y1) / 2; }
  /// Returns whether all its pixels are its nodes and probes.
  bool is_small() const { return x1 - x0 <= 2 && y1 - y0 <= 2; }
};

/// Chooses the pixels of a tile that are gathered. Where a field is smooth, a block of pixels is
/// interpolated from nine of them by a quadratic; four others tell whether that is good enough. If
/// it is not, the block is parted, in rounds. Blocks near curves are small.
class ExactBlocks {
 public:
  /// Starts a tile.
  ///
  /// usable   the pixels to paint
  /// cut      pixels that curves pass through
  void start(const Tile& tile, const PixelMask& usable, const PixelMask* cut);

  /// Lists the pixels to gather in this round; false: all pixels are known.
  bool next_round();
  /// Returns the pixels of the round: x + kTileStride y.
  const std::vector<std::uint32_t>& pixels() const { return pixel_; }

  /// Returns the memory of the lists.
  std::size_t bytes() const { return capacity_bytes(waiting_, tried_, rejected_, pixel_); }

  /// After their values were written into the tile: interpolates blocks, and parts others.
  ///
  /// most   the largest difference in a channel
  void end_round(const Tile& tile, float most);

 private:
  static constexpr int kLargest = 16;

  void place(const ExactBlock& block);
  void part(const ExactBlock& block, std::vector<ExactBlock>& parts) const;
  bool is_smooth(const ExactBlock& block) const;
  void ask(int x, int y);
  void ask_all(const ExactBlock& block);
  bool fill_small(const ExactBlock& block, const Tile& tile, float most) const;
  template <class Visit>
  static void for_each_probe(const ExactBlock& block, const Visit& visit);

  PixelMask usable_, asked_;
  const PixelMask* cut_ = nullptr;
  int width_ = 0, height_ = 0;
  std::vector<ExactBlock> waiting_, tried_;
  std::vector<ExactBlock> rejected_;  ///< small ones, all of whose pixels are gathered
  std::vector<std::uint32_t> pixel_;
};

}  // namespace sfumato::raster
