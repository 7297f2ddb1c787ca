#include "raster/layers/local_stroke_tree.hpp"

#include <algorithm>
#include <cmath>

#include "base/try.hpp"

namespace sfumato::raster {
namespace {

constexpr std::size_t kFan = 8;

/// Returns the number in single precision, moved up (sign 1) or down (-1) by more than the rounding
/// of pixels of any image.
float rounded(double x, double sign) {
  constexpr double kMargin = 0.01, kShare = 0x1p-23;
  return static_cast<float>(x + sign * std::max(kMargin, kShare * std::fabs(x)));
}

}  // namespace

struct StrokeTree::Search {
  float low[2];
  float high[2];
  FunctionRef<void(std::span<const std::uint32_t>)> found;
  std::uint32_t batch[kBatch];
  std::size_t count = 0;

  bool meets(const Bounds& bounds) const {
    return bounds.low[0] <= high[0] && low[0] <= bounds.high[0] && bounds.low[1] <= high[1] &&
           low[1] <= bounds.high[1];
  }

  void flush() {
    if (count > 0) found(std::span<const std::uint32_t>(batch, count));
    count = 0;
  }
};

Result<StrokeTree> StrokeTree::create(Context& context, std::span<const Box> boxes) {
  StrokeTree tree;
  std::size_t total = boxes.size();
  for (std::size_t count = boxes.size(); count > 1;) {
    count = (count + kFan - 1) / kFan;
    total += count;
  }
  SFUMATO_TRY(tree.memory_.reserve(context, tree.bounds_, total));
  tree.level_begin_.push_back(0);
  for (const Box& box : boxes) {
    tree.bounds_.push_back({{rounded(box.min.x, -1), rounded(box.min.y, -1)},
                            {rounded(box.max.x, 1), rounded(box.max.y, 1)}});
  }
  for (std::size_t begin = 0, end = boxes.size(); end - begin > 1;) {
    tree.level_begin_.push_back(end);
    for (std::size_t i = begin; i < end; i += kFan) {
      Bounds joined = tree.bounds_[i];
      for (std::size_t k = i + 1; k < std::min(i + kFan, end); ++k) {
        for (int axis = 0; axis < 2; ++axis) {
          joined.low[axis] = std::min(joined.low[axis], tree.bounds_[k].low[axis]);
          joined.high[axis] = std::max(joined.high[axis], tree.bounds_[k].high[axis]);
        }
      }
      tree.bounds_.push_back(joined);
    }
    begin = end;
    end = tree.bounds_.size();
  }
  return tree;
}

void StrokeTree::find(const Box& box,
                      FunctionRef<void(std::span<const std::uint32_t>)> found) const {
  if (bounds_.empty()) return;
  Search state{{static_cast<float>(box.min.x), static_cast<float>(box.min.y)},
               {static_cast<float>(box.max.x), static_cast<float>(box.max.y)},
               found,
               {},
               0};
  search(level_begin_.size() - 1, 0, state);
  state.flush();
}

void StrokeTree::search(std::size_t level, std::size_t index, Search& state) const {
  if (!state.meets(bounds_[level_begin_[level] + index])) return;
  if (level == 0) {
    state.batch[state.count++] = static_cast<std::uint32_t>(index);
    if (state.count == kBatch) state.flush();
    return;
  }
  const std::size_t below = level_begin_[level] - level_begin_[level - 1];
  const std::size_t end = std::min(kFan * index + kFan, below);
  for (std::size_t i = kFan * index; i < end; ++i) search(level - 1, i, state);
}

}  // namespace sfumato::raster
