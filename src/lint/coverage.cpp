#include "lint/coverage.hpp"

#include <algorithm>

namespace sfumato::lint_detail {
namespace {

constexpr int kPointsPerSide = 17;

/// Inside, in a grid: a layer that frames the picture leaves them free.
constexpr int kInnerPointsPerSide = 5;

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

}  // namespace

Result<Cover> cover_of(Context& context, const LayerUnderTest& test,
                       const Affine& artboard_from_layer) {
  const std::vector<Vec2> points = sample_points(test.document.artboard, artboard_from_layer);
  const gather::Gatherer& color = test.scene.color.gatherer;
  std::vector<float> values(points.size() * static_cast<std::size_t>(color.channel_count()));
  std::vector<std::uint8_t> hit(points.size());
  Status status = color.gather(context, points, {}, values, hit);
  if (!status) return status;
  if (test.scene.opacity) {
    const gather::Gatherer& opacity = test.scene.opacity->gatherer;
    const auto channels = static_cast<std::size_t>(opacity.channel_count());
    std::vector<float> shares(points.size() * channels);
    status = opacity.gather(context, points, {}, shares);
    if (!status) return status;
    for (std::size_t i = 0; i < points.size(); ++i) {
      float largest = 0;
      for (std::size_t c = 0; c < channels; ++c) {
        largest = std::max(largest, shares[channels * i + c]);
      }
      if (largest < kLeastOpacity) hit[i] = 0;
    }
  }
  const auto painted = std::count(hit.begin(), hit.end(), std::uint8_t{1});
  if (painted == 0) return Cover::none;
  return painted == static_cast<std::ptrdiff_t>(points.size()) ? Cover::all : Cover::some;
}

}  // namespace sfumato::lint_detail
