#include "gather/rays.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "curves/front_share.hpp"
#include "gather/scene/ray_grid.hpp"

namespace sfumato::gather {
namespace {

constexpr std::size_t kRayPointsPerTask = 64;

/// Computes the output function of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

struct UnitVector {
  float x, y;
};

/// Returns the direction `turns` of a circle from the x axis, by polynomials of this project: the
/// same bits on every machine. Precondition: 0 <= turns <= 1.
UnitVector unit_vector(float turns) {
  const int quarter = static_cast<int>(turns * 4 + 0.5f);
  const float a = (turns * 4 - static_cast<float>(quarter)) * 1.57079633f;
  const float a2 = a * a;
  const float s = a * (1 + a2 * (-1.66666667e-1f + a2 * (8.33333333e-3f + a2 * -1.98412698e-4f)));
  const float c =
      1 + a2 * (-0.5f + a2 * (4.16666667e-2f + a2 * (-1.38888889e-3f + a2 * 2.48015873e-5f)));
  switch (quarter & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

/// The estimate of one point.
class PointSums {
 public:
  /// share  workspace, scene.shader_count of them.
  PointSums(const Scene& scene, std::span<float> share) : scene_(scene), share_(share) {
    std::ranges::fill(share_, 0.0f);
  }

  /// (dx, dy): the ray's unit vector.
  void add(const RayHit& hit, UnitVector d) {
    if (!hit.edge) return;
    const HitEdge& edge = *hit.edge;
    const float falloff = 1 / std::max(hit.distance * hit.distance, 1e-16f);
    const float lean = 2 * hit.fraction - 1;
    weight_ += falloff * edge.weight;
    if (scene_.blend.empty()) {
      add_value(falloff, lean, edge.middle, edge.half_change);
      return;
    }
    const HitBlend& blend = scene_.blend[static_cast<std::size_t>(&edge - scene_.hit_edge.data())];
    const float normal_distance =
        hit.distance * std::fabs(d.x * edge.ey - d.y * edge.ex) * blend.inverse_length;
    const float radius = blend.blur_middle + lean * blend.blur_half_change;
    const float front = curves::front_share(normal_distance, radius);
    add_side(front * falloff, lean, edge, blend.front_shader, edge.middle, edge.half_change);
    if (!(blend.blur_middle > 0)) return;
    add_side((1 - front) * falloff, lean, edge, blend.back_shader, blend.back_middle,
             blend.back_half_change);
  }

  bool hit() const { return weight_ > 0; }
  float weight() const { return weight_; }

  /// Writes Z_C / W and the shares W_s / W; 0 where nothing was hit.
  void store(float* out) const {
    const auto mean = [&](float sum) { return hit() ? sum / weight_ : 0.0f; };
    for (int c = 0; c < scene_.base_channels; ++c) *out++ = mean(value_[c]);
    for (int s = 0; s < scene_.shader_count; ++s) *out++ = mean(share_[s]);
  }

 private:
  void add_value(float weight, float lean, const float (&middle)[kValueChannels],
                 const float (&half_change)[kValueChannels]) {
    for (int c = 0; c < kValueChannels; ++c)
      value_[c] += weight * (middle[c] + lean * half_change[c]);
  }

  void add_side(float weight, float lean, const HitEdge& edge, std::int32_t shader,
                const float (&middle)[kValueChannels], const float (&half_change)[kValueChannels]) {
    if (shader < 0) return add_value(weight, lean, middle, half_change);
    share_[shader] += weight * edge.weight;
  }

  const Scene& scene_;
  float weight_ = 0;
  float value_[kValueChannels] = {};
  std::span<float> share_;
};

PointSums sample(const Scene& scene, const RayGrid& grid, float x, float y,
                 const GatherOptions& options, std::span<float> shares) {
  const std::uint64_t place =
      std::uint64_t{std::bit_cast<std::uint32_t>(x)} << 32 | std::bit_cast<std::uint32_t>(y);
  const std::uint64_t point_hash = mix(options.seed + mix(place + 0x9e3779b97f4a7c15ull));
  const float share = 1 / static_cast<float>(options.rays_per_node);
  PointSums sums(scene, shares);
  for (int ray = 0; ray < options.rays_per_node; ++ray) {
    const std::uint64_t hash =
        mix(point_hash + static_cast<std::uint64_t>(ray + 1) * 0x9e3779b97f4a7c15ull);
    const float jitter = static_cast<float>(hash >> 40) * 0x1p-24f;
    const UnitVector d = unit_vector((static_cast<float>(ray) + jitter) * share);
    sums.add(grid.first_hit(x, y, d.x, d.y), d);
  }
  return sums;
}

}  // namespace

Status gather_rays(Context& context, const Scene& scene, const FreeEnds& ends,
                   const PointList& points, const GatherOptions& options, std::span<float> out,
                   std::span<std::uint8_t> hit) {
  if (options.rays_per_node < 1 || options.rays_per_node > limits::kRays) {
    return make_error(StatusCode::limit,
                      "rays per node: expected 1 to " + std::to_string(limits::kRays));
  }
  SFUMATO_TRY_ASSIGN(const RayGrid& grid, RayGrid::create(context, scene));
  const auto channel_count = static_cast<std::size_t>(scene.channel_count());
  const float per_ray =
      static_cast<float>(2 * std::numbers::pi) / static_cast<float>(options.rays_per_node);
  return parallel_for(context, points.size(), kRayPointsPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        std::vector<float> shares(scene.shader_count);
                        for (std::size_t i = begin; i < end; ++i) {
                          const auto x = static_cast<float>(points[i].x - scene.origin.x);
                          const auto y = static_cast<float>(points[i].y - scene.origin.y);
                          const PointSums sums = sample(scene, grid, x, y, options, shares);
                          const std::size_t slot = points.slot(i);
                          const auto value = out.subspan(slot * channel_count, channel_count);
                          sums.store(value.data());
                          const float weight = ends.add({x, y}, sums.weight() * per_ray, value);
                          if (!hit.empty()) hit[slot] = weight > 0;
                        }
                      });
}

}  // namespace sfumato::gather
