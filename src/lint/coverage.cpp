#include "lint/coverage.hpp"

#include <algorithm>
#include <span>

#include "base/try.hpp"

namespace sfumato::lint_detail {
namespace {

constexpr int kPointsPerSide = 17;

/// Points inside, in a grid. A layer that frames the picture leaves them uncovered.
constexpr int kInnerPointsPerSide = 5;

/// A first sample that is mostly enough to decide: one packet of the widest kernels.
constexpr std::size_t kFirstPoints = 16;

/// The distance from the border, as a share of the artboard's sides. Frames of curves often lie on
/// the border itself.
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
  // These are not simple fractions, so that points do not lie on curves.
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

/// Counts the points (in the layer's frame) that are painted.
Result<std::size_t> count_painted(const LayerUnderTest& test, std::span<const Vec2> points) {
  const gather::Gatherer& color = test.prepared.color.gatherer;
  std::vector<float> values(points.size() * static_cast<std::size_t>(color.channel_count()));
  std::vector<std::uint8_t> hit(points.size());
  SFUMATO_TRY(color.gather(test.context, points, {}, values, hit));
  if (test.prepared.opacity) {
    const gather::Gatherer& opacity = test.prepared.opacity->gatherer;
    const auto channels = static_cast<std::size_t>(opacity.channel_count());
    std::vector<float> shares(points.size() * channels);
    SFUMATO_TRY(opacity.gather(test.context, points, {}, shares));
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
    SFUMATO_TRY_ASSIGN(const std::size_t count, count_painted(test, part));
    painted += count;
    seen += part.size();
    if (painted > 0 && (painted < seen || !all_matters)) return Cover::some;
  }
  return painted == 0 ? Cover::none : Cover::all;
}

}  // namespace sfumato::lint_detail
