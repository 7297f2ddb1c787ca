#include "lint/coverage.hpp"

#include <algorithm>
#include <span>

namespace sfumato::lint_detail {
namespace {

constexpr int kPointsPerSide = 17;

/// Inside, in a grid: a layer that frames the picture leaves them free.
constexpr int kInnerPointsPerSide = 5;

/// Mostly enough to tell: one packet of the widest kernels.
constexpr std::size_t kFirstPoints = 16;

/// From the border, as a share of the artboard's sides: off the border itself, where frames of
/// curves like to lie.
constexpr double kInset = 0.0017;

/// Below this a layer leaves no trace in 8 bits.
constexpr float kLeastOpacity = 0.5f / 255;

/// Points along the artboard's border and inside it, in the layer's frame.
std::vector<Vec2> sample_points(const Box& artboard, const Affine& artboard_from_layer) {
  const Affine layer_from_artboard = inverse(artboard_from_layer);
  const Vec2 size{artboard.width(), artboard.height()};
  std::vector<Vec2> points;
  const auto add = [&](Vec2 share) {
    points.push_back(layer_from_artboard(artboard.min + Vec2{share.x * size.x, share.y * size.y}));
  };
  // No simple fractions: points are not to lie on curves.
  for (int i = 0; i < kPointsPerSide; ++i) {
    const double along = (i + 0.4142) / kPointsPerSide;
    add({along, kInset});
    add({1 - kInset, along});
    add({1 - along, 1 - kInset});
    add({kInset, 1 - along});
  }
  for (int i = 0; i < kInnerPointsPerSide * kInnerPointsPerSide; ++i) {
    add({(i % kInnerPointsPerSide + 0.4142) / kInnerPointsPerSide,
         (i / kInnerPointsPerSide + 0.5774) / kInnerPointsPerSide});
  }
  return points;
}

/// How many of the points (in the layer's frame) are painted.
Result<std::size_t> count_painted(const LayerUnderTest& test, std::span<const Vec2> points) {
  const gather::Gatherer& color = test.prepared.color.gatherer;
  std::vector<float> values(points.size() * static_cast<std::size_t>(color.channel_count()));
  std::vector<std::uint8_t> hit(points.size());
  Status status = color.gather(test.context, points, {}, values, hit);
  if (!status) return status;
  if (test.prepared.opacity) {
    const gather::Gatherer& opacity = test.prepared.opacity->gatherer;
    const auto channels = static_cast<std::size_t>(opacity.channel_count());
    std::vector<float> shares(points.size() * channels);
    status = opacity.gather(test.context, points, {}, shares);
    if (!status) return status;
    for (std::size_t i = 0; i < points.size(); ++i) {
      float largest = 0;
      for (std::size_t c = 0; c < channels; ++c) {
        largest = std::max(largest, shares[channels * i + c]);
      }
      if (largest < kLeastOpacity) hit[i] = 0;
    }
  }
  return static_cast<std::size_t>(std::count(hit.begin(), hit.end(), std::uint8_t{1}));
}

}  // namespace

Result<Cover> cover_of(const LayerUnderTest& test, const Affine& artboard_from_layer,
                       bool all_matters) {
  const std::vector<Vec2> points = sample_points(test.document.artboard, artboard_from_layer);
  const std::span<const Vec2> all(points);
  std::size_t painted = 0, seen = 0;
  for (const std::span<const Vec2> part : {all.first(kFirstPoints), all.subspan(kFirstPoints)}) {
    const Result<std::size_t> count = count_painted(test, part);
    if (!count) return count.status();
    painted += *count;
    seen += part.size();
    if (painted > 0 && (painted < seen || !all_matters)) return Cover::some;
  }
  return painted == 0 ? Cover::none : Cover::all;
}

}  // namespace sfumato::lint_detail
