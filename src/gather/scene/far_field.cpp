#include "gather/scene/far_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::gather {
namespace {

/// The number of loose ends below which a gather is fast without a far field.
constexpr std::size_t kFewestEnds = 512;

/// A layer is thin where curves block less than this share of a ray on the way from one curve to
/// the next. It is 0.13 for 10,000 strokes as long as a fifth of their distance and 0.03 for specks
/// of a twentieth; the public drawings with this many loose ends have 0.55 or more.
constexpr double kThin = 0.3;

/// The largest mean square of the opacity of squares that have any, relative to its mean's square:
/// 1.1 among specks at random. Walls among them make it 2 and more, and a mean would then represent
/// neither.
constexpr double kMostUneven = 1.6;

/// Each shader takes a number in each direction of each square.
constexpr int kMostShaders = 16;

constexpr std::size_t kHitsPerCell = 32;
constexpr int kLargestSide = 1 << (kFarLevels - 1);

/// A curve is far enough for eq. 8 to give β = 1, except for parts that are seen along themselves,
/// at a distance of this many of its radii.
constexpr float kRadiiAway = 4;

/// cos and sin of a sixteenth of the circle, and of its multiples.
constexpr float kCos1 = 0.923879533f, kCos2 = 0.707106781f, kCos3 = 0.382683432f;
constexpr float kFarCosine[kFarDirections] = {1,  kCos1,  kCos2,  kCos3,  0, -kCos3, -kCos2, -kCos1,
                                              -1, -kCos1, -kCos2, -kCos3, 0, kCos3,  kCos2,  kCos1};

struct FarDirection {
  float x, y;
};
constexpr FarDirection far_unit(int direction) {
  return {kFarCosine[direction], kFarCosine[(direction + 3 * kFarDirections / 4) % kFarDirections]};
}

/// A half-edge that stops rays. A barrier has no hit edge.
struct Wall {
  float ax, ay;
  float ex, ey;
  const HitEdge* hit;
};

class FarFieldBuilder {
 public:
  FarFieldBuilder(const Context& context, Scene& scene)
      : context_(context), poll_(context), scene_(scene) {}

  Status build() {
    if (scene_.shader_count > kMostShaders) return ok_status();
    if (Status status = measure(); !status || !is_thin()) return status;
    SFUMATO_TRY(make_room());
    const Status status = for_each_wall([&](const Wall& wall, std::uint32_t) { add(wall); });
    if (!status || is_even()) return status ? add_levels() : status;
    scene_.memory.free(scene_.far_mean);
    return status;
  }

 private:
  template <class Body>
  Status for_each_wall(Body body) {
    for (std::uint32_t t = 0; t < scene_.triangle.size(); ++t) {
      if (poll_.cancelled()) return context_.cancel_status();
      const SceneTriangle& triangle = scene_.triangle[t];
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (!is_wall(3 * t + k)) continue;
        const std::uint32_t end = (k + 1) % 3;
        body({triangle.x[k], triangle.y[k], triangle.x[end] - triangle.x[k],
              triangle.y[end] - triangle.y[k],
              is_hit(triangle.edge[k]) ? &scene_.hit_edge[hit_index(triangle.edge[k])] : nullptr},
             3 * t + k);
      }
    }
    return ok_status();
  }

  /// Returns whether a half-edge is a wall. The mesh's border does not count as a wall.
  bool is_wall(std::uint32_t half_edge) const {
    const SceneTriangle& triangle = scene_.triangle[half_edge / 3];
    const EdgeCode code = triangle.edge[half_edge % 3];
    return is_hit(code) || (code == kBorder && triangle.twin[half_edge % 3] >= 0);
  }

  Status measure() {
    return for_each_wall([&](const Wall& wall, std::uint32_t half_edge) {
      box_.extend({wall.ax, wall.ay});
      box_.extend({wall.ax + wall.ex, wall.ay + wall.ey});
      length_ += length_of(wall);
      ends_ += ends_loosely(half_edge);
    });
  }

  static double length_of(const Wall& wall) {
    const Vec2 along{wall.ex, wall.ey};
    return std::sqrt(dot(along, along));
  }

  /// Returns whether no other half-edge that stops rays begins at the end of the half-edge.
  bool ends_loosely(std::uint32_t half_edge) const {
    for (std::uint32_t h = next_half_edge(half_edge);;) {
      const std::int32_t twin = scene_.triangle[h / 3].twin[h % 3];
      if (twin < 0) return false;
      const auto other = static_cast<std::uint32_t>(twin);
      if (other == half_edge) return true;
      if (is_wall(h) || is_wall(other)) return false;
      h = next_half_edge(other);
    }
  }

  /// Rays in all directions meet length / π per area, half of the sides from behind; there is one
  /// curve for two ends.
  bool is_thin() const {
    if (ends_ < kFewestEnds) return false;
    const double area = box_.width() * box_.height();
    const double met = length_ / std::numbers::pi;
    return 2 * met * met < kThin * kThin * area * static_cast<double>(ends_);
  }

  Status make_room() {
    FarField& far = scene_.far;
    const auto enough = scene_.hit_edge.size() / kHitsPerCell;
    while (far.side < kLargestSide && static_cast<std::size_t>(cells_of(far.side)) < enough) {
      far.side *= 2;
      ++far.level_count;
    }
    // A little larger, so that rounding leaves no end outside.
    const double size = 1.0001 * std::max(box_.width(), box_.height());
    far.x0 = static_cast<float>(box_.center().x - size / 2);
    far.y0 = static_cast<float>(box_.center().y - size / 2);
    far.cells_per_unit = static_cast<float>(far.side / size);
    far.numbers = kFarValue + kValueChannels + scene_.shader_count;
    for (const HitBlend& blend : scene_.blend) {
      const float widest = blend.blur_middle + std::fabs(blend.blur_half_change);
      far.nearest = std::max(far.nearest, kRadiiAway * widest);
    }
    int cells = 0;
    for (int level = 0; level < far.level_count; ++level) {
      far.first[level] = cells;
      cells += cells_of(far.side >> level);
    }
    return scene_.memory.resize(context_, scene_.far_mean,
                                static_cast<std::size_t>(cells) * numbers_of_cell());
  }

  static int cells_of(int side) { return side * side; }
  std::size_t numbers_of_cell() const {
    return static_cast<std::size_t>(kFarDirections * scene_.far.numbers);
  }

  /// Adds a wall. Long walls are added in pieces no longer than half a square; each piece is shared
  /// by the four squares whose centres are nearest.
  void add(const Wall& wall) {
    const auto cells_per_unit = static_cast<double>(scene_.far.cells_per_unit);
    const auto pieces = static_cast<int>(2 * length_of(wall) * cells_per_unit) + 1;
    for (int i = 0; i < pieces; ++i) {
      const float place = (static_cast<float>(i) + 0.5f) / static_cast<float>(pieces);
      const float column = in_squares(wall.ax + place * wall.ex - scene_.far.x0);
      const float row = in_squares(wall.ay + place * wall.ey - scene_.far.y0);
      const auto left = static_cast<int>(column), top = static_cast<int>(row);
      const float right_share = column - static_cast<float>(left);
      const float lower_share = row - static_cast<float>(top);
      const auto share = static_cast<float>(cells_per_unit * cells_per_unit / pieces);
      const float upper = share * (1 - lower_share), lower = share * lower_share;
      add_to(left, top, upper * (1 - right_share), wall, place);
      add_to(left + 1, top, upper * right_share, wall, place);
      add_to(left, top + 1, lower * (1 - right_share), wall, place);
      add_to(left + 1, top + 1, lower * right_share, wall, place);
    }
  }

  /// Converts an offset to squares, from the centre of the first square, at least 0.
  float in_squares(float offset) const {
    return std::max(offset * scene_.far.cells_per_unit - 0.5f, 0.0f);
  }

  /// Adds the piece `place` along the wall.
  void add_to(int column, int row, float share, const Wall& wall, float place) {
    const FarField& far = scene_.far;
    const int square = std::min(row, far.side - 1) * far.side + std::min(column, far.side - 1);
    float* mean = scene_.far_mean.data() + static_cast<std::size_t>(square) * numbers_of_cell();
    for (int d = 0; d < kFarDirections; ++d, mean += far.numbers) {
      const FarDirection u = far_unit(d);
      const float met = share * (u.x * wall.ey - u.y * wall.ex);
      if (met > 0) add_side(wall, met, place, mean);
    }
  }

  void add_side(const Wall& wall, float met, float place, float* mean) const {
    mean[kFarOpacity] += met;
    if (!wall.hit) return;
    mean[kFarWeight] += met * wall.hit->weight;
    for (int c = 0; c < kValueChannels; ++c) {
      mean[kFarValue + c] +=
          met * (wall.hit->middle[c] + (2 * place - 1) * wall.hit->half_change[c]);
    }
    if (scene_.shader_count == 0 || scene_.blend.empty()) return;
    const std::int32_t shader = scene_.blend[hit_index_of(wall)].front_shader;
    if (shader >= 0) mean[kFarValue + kValueChannels + shader] += met * wall.hit->weight;
  }

  std::size_t hit_index_of(const Wall& wall) const {
    return static_cast<std::size_t>(wall.hit - scene_.hit_edge.data());
  }

  bool is_even() const {
    double count = 0, sum = 0, sum_of_squares = 0;
    const std::size_t end = static_cast<std::size_t>(cells_of(scene_.far.side)) * numbers_of_cell();
    for (std::size_t cell = 0; cell < end; cell += numbers_of_cell()) {
      double met = 0;
      for (std::size_t i = cell; i < cell + numbers_of_cell();
           i += static_cast<std::size_t>(scene_.far.numbers)) {
        met += double{scene_.far_mean[i + kFarOpacity]};
      }
      count += met > 0;
      sum += met;
      sum_of_squares += met * met;
    }
    return count * sum_of_squares <= kMostUneven * sum * sum;
  }

  /// Adds the levels, each the mean of four squares of the level before.
  Status add_levels() {
    const std::size_t numbers = numbers_of_cell();
    float* level = scene_.far_mean.data();
    for (auto side = static_cast<std::size_t>(scene_.far.side); side > 1; side /= 2) {
      float* mean = level + side * side * numbers;
      for (std::size_t row = 0; row < side; row += 2) {
        if (context_.cancelled()) return context_.cancel_status();
        for (std::size_t column = 0; column < side; column += 2) {
          const float* finer = level + (row * side + column) * numbers;
          for (std::size_t i = 0; i < numbers; ++i, ++finer) {
            *mean++ = 0.25f * ((finer[0] + finer[numbers]) +
                               (finer[side * numbers] + finer[(side + 1) * numbers]));
          }
        }
      }
      level += side * side * numbers;
    }
    return ok_status();
  }

  const Context& context_;
  RarePoll<8192> poll_;
  Scene& scene_;
  Box box_;
  double length_ = 0;
  std::size_t ends_ = 0;
};

}  // namespace

Status add_far_field(const Context& context, Scene& scene) {
  return FarFieldBuilder(context, scene).build();
}

}  // namespace sfumato::gather
