#include "gather/rays.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "gather/ray_grid.hpp"

namespace sfumato::gather {
namespace {

constexpr std::size_t kPointsPerTask = 64;

/// The output function of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

struct UnitVector {
  float x, y;
};

/// The direction `turns` of a circle from the x axis. Our own polynomials: the same bits on every
/// machine. Precondition: 0 <= turns <= 1.
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
  void add(const RayHit& hit) {
    if (!hit.edge) return;
    const float falloff = 1 / std::max(hit.distance * hit.distance, 1e-16f);
    const float lean = 2 * hit.fraction - 1;
    weight_ += falloff * hit.edge->weight;
    for (int c = 0; c < kColorChannels; ++c) {
      color_[c] += falloff * (hit.edge->middle[c] + lean * hit.edge->half_change[c]);
    }
  }

  bool hit() const { return weight_ > 0; }
  float value(int c) const { return hit() ? color_[c] / weight_ : 0.0f; }

 private:
  float weight_ = 0;
  float color_[kColorChannels] = {};
};

PointSums sample(const RayGrid& grid, float x, float y, const GatherOptions& options) {
  const std::uint64_t place =
      std::uint64_t{std::bit_cast<std::uint32_t>(x)} << 32 | std::bit_cast<std::uint32_t>(y);
  const std::uint64_t point_hash = mix(options.seed + mix(place + 0x9e3779b97f4a7c15ull));
  const float share = 1 / static_cast<float>(options.rays_per_node);
  PointSums sums;
  for (int ray = 0; ray < options.rays_per_node; ++ray) {
    const std::uint64_t hash =
        mix(point_hash + static_cast<std::uint64_t>(ray + 1) * 0x9e3779b97f4a7c15ull);
    const float jitter = static_cast<float>(hash >> 40) * 0x1p-24f;
    const UnitVector d = unit_vector((static_cast<float>(ray) + jitter) * share);
    sums.add(grid.first_hit(x, y, d.x, d.y));
  }
  return sums;
}

}  // namespace

Status gather_rays(Context& context, const Scene& scene, std::span<const Vec2> points,
                   const GatherOptions& options, std::span<float> out,
                   std::span<std::uint8_t> hit) {
  if (options.rays_per_node < 1 || options.rays_per_node > limits::kRays) {
    return make_error(StatusCode::limit,
                      "rays per node: expected 1 to " + std::to_string(limits::kRays));
  }
  const Result<RayGrid> grid = RayGrid::create(context, scene);
  if (!grid) return grid.status();
  return parallel_for(context, points.size(), kPointsPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) {
                          const auto x = static_cast<float>(points[i].x - scene.origin.x);
                          const auto y = static_cast<float>(points[i].y - scene.origin.y);
                          const PointSums sums = sample(*grid, x, y, options);
                          for (int c = 0; c < kColorChannels; ++c) {
                            out[i * kColorChannels + static_cast<std::size_t>(c)] = sums.value(c);
                          }
                          if (!hit.empty()) hit[i] = sums.hit();
                        }
                      });
}

}  // namespace sfumato::gather
