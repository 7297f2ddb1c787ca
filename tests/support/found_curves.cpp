#include "support/found_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "curves/bezier.hpp"

namespace sfumato::test {
namespace {

constexpr double kStepPx = 0.5;
constexpr double kVisibleSlope = 0.02;
constexpr double kBorderPx = 1;

/// A short part of a curve.
struct Stretch {
  Vec2 middle;
  double length = 0;
};

void append_piece(const curves::Cubic& piece, const Plane& size, std::vector<Stretch>& out) {
  double polygon = 0;
  for (std::size_t i = 0; i < 3; ++i) polygon += length(piece[i + 1] - piece[i]);
  const int count = std::max(1, static_cast<int>(std::ceil(polygon / kStepPx)));
  Vec2 from = piece[0];
  for (int i = 0; i < count; ++i) {
    const Vec2 to = curves::point_at(piece, (i + 1.0) / count);
    const Vec2 middle = curves::point_at(piece, (i + 0.5) / count);
    const bool is_inside = middle.x > kBorderPx && middle.x < size.width - kBorderPx &&
                           middle.y > kBorderPx && middle.y < size.height - kBorderPx;
    if (is_inside) out.push_back({middle, length(to - from)});
    from = to;
  }
}

/// Returns all curves of all layers as they are painted, in pixels.
std::vector<Stretch> stretches_of(const Document& document, const Plane& size) {
  const Box& artboard = document.artboard;
  const double sx = size.width / artboard.width(), sy = size.height / artboard.height();
  const Affine px_from_artboard{sx, 0, 0, sy, -sx * artboard.min.x, -sy * artboard.min.y};
  std::vector<Stretch> stretches;
  for (const StackItem& item : document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance) continue;
    const Affine px_from_layer = px_from_artboard * instance->artboard_from_layer;
    for (const Curve& curve : document.layers[instance->layer].curves) {
      for (std::size_t i = 0; i < curve.piece_count(); ++i) {
        curves::Cubic piece = curves::piece(curve.control_points, i);
        for (Vec2& point : piece) point = px_from_layer(point);
        append_piece(piece, size, stretches);
      }
    }
  }
  return stretches;
}

/// Points in square cells, for finding near ones.
class NearPoints {
 public:
  NearPoints(const std::vector<Stretch>& stretches, const Plane& size, double near)
      : near_(near),
        columns_(static_cast<int>(size.width / near) + 3),
        rows_(static_cast<int>(size.height / near) + 3),
        cells_(static_cast<std::size_t>(columns_) * rows_) {
    for (const Stretch& one : stretches) {
      cells_[cell(column(one.middle), row(one.middle))].push_back(one.middle);
    }
  }

  /// Returns the distance to the nearest point; infinite if none is near.
  double distance(Vec2 from) const {
    double least = std::numeric_limits<double>::infinity();
    for (int y = row(from) - 1; y <= row(from) + 1; ++y) {
      for (int x = column(from) - 1; x <= column(from) + 1; ++x) {
        for (const Vec2 point : cells_[cell(x, y)]) least = std::min(least, length(point - from));
      }
    }
    return least <= near_ ? least : std::numeric_limits<double>::infinity();
  }

 private:
  int column(Vec2 p) const { return 1 + static_cast<int>(p.x / near_); }
  int row(Vec2 p) const { return 1 + static_cast<int>(p.y / near_); }
  std::size_t cell(int x, int y) const { return static_cast<std::size_t>(y) * columns_ + x; }

  double near_;
  int columns_, rows_;
  std::vector<std::vector<Vec2>> cells_;
};

/// Returns how fast colours change at each pixel, 1/pixel.
Plane slopes_of(const Planes& picture) {
  const std::vector<double> bell = gaussian_weights(1, 4), slope = gaussian_weights(1, 4, true);
  Plane slopes{picture[0].width, picture[0].height,
               std::vector<float>(picture[0].value.size(), 0.0F)};
  for (const Plane& channel : picture) {
    const Plane dx = filtered(channel, slope, bell), dy = filtered(channel, bell, slope);
    for (std::size_t i = 0; i < slopes.value.size(); ++i) {
      slopes.value[i] += dx.value[i] * dx.value[i] + dy.value[i] * dy.value[i];
    }
  }
  for (float& value : slopes.value) value = std::sqrt(value);
  return slopes;
}

}  // namespace

FoundCurves find_curves(const Document& truth, const Document& trace, const Planes& picture,
                        double near_px) {
  const std::vector<Stretch> true_ones = stretches_of(truth, picture[0]);
  const std::vector<Stretch> traced = stretches_of(trace, picture[0]);
  const NearPoints near_trace(traced, picture[0], near_px);
  const NearPoints near_truth(true_ones, picture[0], near_px);
  const Plane slopes = slopes_of(picture);
  double visible = 0, found = 0, distances = 0, traced_length = 0, on_truth = 0;
  FoundCurves result;
  for (const Stretch& one : true_ones) {
    result.true_length_px += one.length;
    const int x = static_cast<int>(one.middle.x), y = static_cast<int>(one.middle.y);
    if (slopes.at(x, y) <= kVisibleSlope) continue;
    visible += one.length;
    const double distance = near_trace.distance(one.middle);
    if (distance > near_px) continue;
    found += one.length;
    distances += distance * one.length;
  }
  for (const Stretch& one : traced) {
    traced_length += one.length;
    if (near_truth.distance(one.middle) <= near_px) on_truth += one.length;
  }
  if (result.true_length_px > 0) result.visible_share = visible / result.true_length_px;
  if (visible > 0) result.found_share = found / visible;
  if (traced_length > 0) result.true_share = on_truth / traced_length;
  if (found > 0) result.mean_distance_px = distances / found;
  return result;
}

}  // namespace sfumato::test
