#include "raster/layers/exact_blocks.hpp"

#include <algorithm>
#include <cmath>

namespace sfumato::raster {
namespace {

bool holds(const PixelMask& mask, int x, int y) {
  return (mask.word[y][x / 64] >> (x % 64) & 1) != 0;
}

/// The share of each of three nodes in the quadratic through them; of two nodes if there are no
/// more pixels.
struct NodeShares {
  NodeShares(int begin, int middle, int end) : first(begin) {
    for (int x = begin; x <= end; ++x) {
      const auto a = static_cast<float>(begin), m = static_cast<float>(middle),
                 b = static_cast<float>(end), p = static_cast<float>(x);
      if (end - begin < 2) {
        share[x - begin][0] = x == begin ? 1.0f : 0.0f;
        share[x - begin][1] = 0;
        share[x - begin][2] = x == begin ? 0.0f : 1.0f;
        continue;
      }
      share[x - begin][0] = (p - m) * (p - b) / ((a - m) * (a - b));
      share[x - begin][1] = (p - a) * (p - b) / ((m - a) * (m - b));
      share[x - begin][2] = (p - a) * (p - m) / ((b - a) * (b - m));
    }
  }

  const float* at(int x) const { return share[x - first]; }

  int first;
  float share[17][3];
};

/// The quadratic of a block in one channel.
class BlockPatch {
 public:
  BlockPatch(const ExactBlock& block, const NodeShares& x, const NodeShares& y)
      : block_(block), x_(x), y_(y) {}

  void read(const float* plane) {
    const int columns[3] = {block_.x0, block_.middle_x(), block_.x1};
    const int rows[3] = {block_.y0, block_.middle_y(), block_.y1};
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) node_[j][i] = plane[rows[j] * kTileStride + columns[i]];
  }
  float at(int x, int y) const {
    float row[3];
    combine(y, row);
    const float* share = x_.at(x);
    return share[0] * row[0] + share[1] * row[1] + share[2] * row[2];
  }
  void write(float* plane) const {
    for (int y = block_.y0; y <= block_.y1; ++y) {
      float row[3];
      combine(y, row);
      float* out = plane + y * kTileStride;
      for (int x = block_.x0; x <= block_.x1; ++x) {
        const float* share = x_.at(x);
        out[x] = share[0] * row[0] + share[1] * row[1] + share[2] * row[2];
      }
    }
  }

 private:
  void combine(int y, float (&row)[3]) const {
    const float* share = y_.at(y);
    for (int i = 0; i < 3; ++i)
      row[i] = share[0] * node_[0][i] + share[1] * node_[1][i] + share[2] * node_[2][i];
  }

  const ExactBlock& block_;
  const NodeShares& x_;
  const NodeShares& y_;
  float node_[3][3];
};

}  // namespace

void ExactBlocks::start(const Tile& tile, const PixelMask& usable, const PixelMask* cut,
                        float most) {
  usable_ = usable;
  most_ = most;
  asked_ = {};
  cut_ = cut;
  width_ = tile.width;
  height_ = tile.height;
  waiting_.clear();
  rejected_.clear();
  const auto begin = [](int from, int origin) {
    return (from + origin) / kLargest * kLargest - origin;
  };
  for (int y = begin(0, tile.y0); y < height_; y += kLargest) {
    for (int x = begin(0, tile.x0); x < width_; x += kLargest) {
      waiting_.push_back({static_cast<std::int16_t>(std::max(x, 0)),
                          static_cast<std::int16_t>(std::min(x + kLargest, width_ - 1)),
                          static_cast<std::int16_t>(std::max(y, 0)),
                          static_cast<std::int16_t>(std::min(y + kLargest, height_ - 1))});
    }
  }
}

void ExactBlocks::ask(int x, int y) {
  if (!holds(usable_, x, y) || holds(asked_, x, y)) return;
  asked_.word[y][x / 64] |= std::uint64_t{1} << (x % 64);
  pixel_.push_back(static_cast<std::uint32_t>(y * kTileStride + x));
}

/// Returns whether a block has a quarter of its size between it and every curve.
bool ExactBlocks::is_smooth(const ExactBlock& block) const {
  const PixelRange range{block.x0, block.x1 + 1, block.y0, block.y1 + 1};
  if (!holds_all(usable_, range)) return false;
  if (!cut_) return true;
  const int reach = std::max(block.x1 - block.x0, block.y1 - block.y0) / 4;
  return !holds_any(
      *cut_, {std::max(range.begin - reach, 0), std::min(range.end + reach, width_),
              std::max(range.first_row - reach, 0), std::min(range.end_row + reach, height_)});
}

/// Replaces a block by its quarters, or by its halves if it is narrow.
void ExactBlocks::divide(const ExactBlock& block) {
  const auto x = static_cast<std::int16_t>(block.middle_x());
  const auto y = static_cast<std::int16_t>(block.middle_y());
  const bool wide = block.x1 - block.x0 > 2, high = block.y1 - block.y0 > 2;
  const ExactBlock left{block.x0, wide ? x : block.x1, block.y0, high ? y : block.y1};
  waiting_.push_back(left);
  if (wide) waiting_.push_back({x, block.x1, left.y0, left.y1});
  if (high) waiting_.push_back({left.x0, left.x1, y, block.y1});
  if (wide && high) waiting_.push_back({x, block.x1, y, block.y1});
}

/// Visits the nodes and the probes of a block.
template <class Visit>
void ExactBlocks::for_each_sample(const ExactBlock& block, const Visit& visit) {
  for (const int y : {int{block.y0}, block.middle_y(), int{block.y1}})
    for (const int x : {int{block.x0}, block.middle_x(), int{block.x1}}) visit(x, y);
  for_each_probe(block, visit);
}

template <class Visit>
void ExactBlocks::for_each_probe(const ExactBlock& block, const Visit& visit) {
  const int x = block.middle_x(), y = block.middle_y();
  for (const int py : {(block.y0 + y) / 2, (y + block.y1) / 2})
    for (const int px : {(block.x0 + x) / 2, (x + block.x1) / 2}) visit(px, py);
}

void ExactBlocks::place(const ExactBlock& block) {
  if (most_ == 0 && std::max(block.x1 - block.x0, block.y1 - block.y0) < kLeastClear)
    return ask_all(block);
  if (block.is_small()) {
    if (!is_smooth(block) || block.x1 - block.x0 < 2 || block.y1 - block.y0 < 2)
      return ask_all(block);
    for (const int y : {block.y0, block.y1})
      for (const int x : {block.x0, block.x1}) ask(x, y);
    ask(block.middle_x(), block.middle_y());
    tried_.push_back(block);
    return;
  }
  if (!is_smooth(block)) return divide(block);
  for_each_sample(block, [&](int x, int y) { ask(x, y); });
  tried_.push_back(block);
}

void ExactBlocks::ask_all(const ExactBlock& block) {
  for (int y = block.y0; y <= block.y1; ++y)
    for (int x = block.x0; x <= block.x1; ++x) ask(x, y);
}

/// Fills a block of nine pixels from its corners if they tell its centre.
bool ExactBlocks::fill_small(const ExactBlock& block, const Tile& tile) const {
  float* const plane[4] = {tile.color[0], tile.color[1], tile.color[2], tile.alpha};
  const int planes = tile.alpha ? 4 : 3;
  const int x = block.middle_x(), y = block.middle_y();
  const auto at = [&](int c, int px, int py) -> float& { return plane[c][py * kTileStride + px]; };
  for (int c = 0; c < planes; ++c) {
    const float mean = 0.25f * (at(c, block.x0, block.y0) + at(c, block.x1, block.y0) +
                                at(c, block.x0, block.y1) + at(c, block.x1, block.y1));
    if (!(std::fabs(mean - at(c, x, y)) <= most_)) return false;
  }
  const auto fill = [&](int px, int py, int ax, int ay, int bx, int by) {
    if (holds(asked_, px, py)) return;
    for (int c = 0; c < planes; ++c) at(c, px, py) = 0.5f * (at(c, ax, ay) + at(c, bx, by));
  };
  for (const int py : {block.y0, block.y1}) fill(x, py, block.x0, py, block.x1, py);
  for (const int px : {block.x0, block.x1}) fill(px, y, px, block.y0, px, block.y1);
  return true;
}

bool ExactBlocks::next_round() {
  pixel_.clear();
  tried_.clear();
  for (const ExactBlock& block : rejected_) ask_all(block);
  rejected_.clear();
  while (!waiting_.empty()) {
    const ExactBlock block = waiting_.back();
    waiting_.pop_back();
    place(block);
  }
  return !pixel_.empty() || !tried_.empty();
}

/// Returns whether the opacity is 0 at the block's nodes and probes.
bool ExactBlocks::is_clear(const ExactBlock& block, const Tile& tile) const {
  if (!tile.alpha) return false;
  bool is_clear = true;
  for_each_sample(
      block, [&](int x, int y) { is_clear = is_clear && tile.alpha[y * kTileStride + x] == 0; });
  return is_clear;
}

/// Interpolates a block if its probes fit, and returns whether they do.
bool ExactBlocks::fill(const ExactBlock& block, const Tile& tile) const {
  float* const plane[4] = {tile.color[0], tile.color[1], tile.color[2], tile.alpha};
  const int planes = tile.alpha ? 4 : 3;
  const NodeShares x_shares(block.x0, block.middle_x(), block.x1);
  const NodeShares y_shares(block.y0, block.middle_y(), block.y1);
  BlockPatch patch(block, x_shares, y_shares);
  bool fits = true;
  for (int c = 0; c < planes && fits; ++c) {
    patch.read(plane[c]);
    for_each_probe(block, [&](int x, int y) {
      fits = fits && std::fabs(patch.at(x, y) - plane[c][y * kTileStride + x]) <= most_;
    });
  }
  if (!fits) return false;
  for (int c = 0; c < planes; ++c) {
    patch.read(plane[c]);
    patch.write(plane[c]);
  }
  return true;
}

void ExactBlocks::end_round(const Tile& tile) {
  for (const ExactBlock& block : tried_) {
    if (block.is_small()) {
      if (!fill_small(block, tile)) rejected_.push_back(block);
    } else if (most_ == 0 ? !is_clear(block, tile) : !fill(block, tile)) {
      divide(block);
    }
  }
}

}  // namespace sfumato::raster
