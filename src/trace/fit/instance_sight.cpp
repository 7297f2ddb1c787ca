#include "trace/fit/instance_sight.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "raster/shaders/shader_set.hpp"

namespace sfumato::tracing {
namespace {

/// Terms of rows below this share of a point's weight are left out.
constexpr float kNegligibleShare = 2e-4f;
/// Points of one task.
constexpr std::size_t kPointsPerTask = 1024;
/// Places along each side of a box at which it is asked whether a layer shows outside of it.
constexpr int kPlaces = 64;

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

std::vector<Vec2> places_around(const Box& box) {
  std::vector<Vec2> places;
  const Vec2 corner[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}, box.min};
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < kPlaces; ++i) {
      places.push_back(lerp(corner[side], corner[side + 1], (i + 0.5) / kPlaces));
    }
  }
  return places;
}

}  // namespace

Status LayerLooker::prepare_shaders(std::span<const std::uint32_t> named, InterpolationSpace space,
                                    ImageShaders& shaders) {
  for (const std::uint32_t index : named) {
    if (shaders[index]) continue;
    SFUMATO_TRY_ASSIGN(auto&& made,
                       raster::ImageShader::create(context_, drawing_.shaders[index], space));
    shaders[index].emplace(std::move(made));
  }
  return ok_status();
}

/// The opacities of a layer at points of its frame.
Status LayerLooker::find_opacities(const DrawnLayer& layer, std::span<const Vec2> points,
                                   const Affine& layer_from_pixel, std::span<float> opacity) {
  const std::vector<std::uint32_t>& named = layer.opacities->shader;
  SFUMATO_TRY(prepare_shaders(named, InterpolationSpace::srgb, opacity_shaders_));
  const std::size_t channels = named.size() + 1;
  TableMemory memory("what a drawing shows");
  std::vector<float> value;
  SFUMATO_TRY(memory.resize(context_, value, channels * points.size()));
  SFUMATO_TRY(layer.opacity_gatherer->gather(context_, points, {}, value));
  const Affine pixel_from_layer = inverse(layer_from_pixel);
  return parallel_for(context_, points.size(), kPointsPerTask, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      const ShadersAt shaders{opacity_shaders_, named, layer_from_pixel,
                              pixel_from_layer(points[i])};
      float sum = value[channels * i];
      for (std::size_t slot = 0; slot < named.size(); ++slot) {
        const float weight = value[channels * i + 1 + slot];
        if (weight == 0) continue;
        const auto [color, alpha] = shaders.sample(slot);
        sum += weight * raster::opacity_of(color.r, color.g, color.b, alpha);
      }
      opacity[i] = std::clamp(sum, 0.0f, 1.0f);
    }
  });
}

/// The area where a layer may show. A point outside a box sees the curves in it as the point does
/// where the ray enters the box. If all points of the border see opacity 0, there is no opacity
/// outside.
Result<Box> LayerLooker::reach_of(std::uint32_t layer, const Affine& layer_from_pixel) {
  if (reach_[layer]) return *reach_[layer];
  const DrawnLayer& drawn = *layers_[layer];
  Box reach{{-kEverywhere, -kEverywhere}, {kEverywhere, kEverywhere}};
  const Box& box = drawn.opacity_box;
  if (drawn.opacities && drawn.opacities->shader.empty() &&
      united(drawn.frame, box) == drawn.frame) {
    const std::vector<Vec2> places = places_around(box);
    std::vector<float> opacity(places.size());
    SFUMATO_TRY(find_opacities(drawn, places, layer_from_pixel, opacity));
    if (std::ranges::all_of(opacity, [](float a) { return a < kUnseen / 4; })) reach = box;
  }
  reach_[layer] = reach;
  return reach;
}

Result<InstanceSight> LayerLooker::look(std::uint32_t layer, const Affine& layer_from_pixel,
                                        FunctionRef<bool(std::uint32_t)> is_open) {
  const DrawnLayer& drawn = *layers_[layer];
  InstanceSight sight;
  sight.layer_from_pixel = layer_from_pixel;
  SFUMATO_TRY_ASSIGN(const Box& reach, reach_of(layer, layer_from_pixel));
  SFUMATO_TRY(prepare_shaders(drawn.color_places.shader, drawing_.interpolation, color_shaders_));
  TableMemory memory("what a drawing shows");
  std::vector<Vec2> place;
  RarePoll<4096> poll(context_);
  for (std::uint32_t p = 0; p < pixels_.point.size(); ++p) {
    if (poll.cancelled()) return context_.cancel_status();
    if (!is_open(p)) continue;
    const Vec2 at = layer_from_pixel(pixels_.point[p]);
    if (!reach.contains(at) || !drawn.frame.contains(at)) continue;
    SFUMATO_TRY(sight.memory.push_back(context_, sight.point, p));
    SFUMATO_TRY(memory.push_back(context_, place, at));
  }
  SFUMATO_TRY(sight.memory.resize(context_, sight.opacity, place.size(), 1.0f));
  if (drawn.opacities) {
    SFUMATO_TRY(find_opacities(drawn, place, layer_from_pixel, sight.opacity));
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (sight.opacity[i] < kUnseen) continue;
    sight.point[kept] = sight.point[i];
    sight.opacity[kept] = sight.opacity[i];
    place[kept++] = place[i];
  }
  sight.point.resize(kept);
  sight.opacity.resize(kept);
  place.resize(kept);
  SFUMATO_TRY_ASSIGN(sight.rows, gather::gather_rows(context_, drawn.mesh, drawn.color_places,
                                                     place, {.negligible = kNegligibleShare}));
  for (std::size_t i = 0; i < kept; ++i) {
    if (sight.rows.begin[i] == sight.rows.begin[i + 1]) sight.opacity[i] = 0;
  }
  return sight;
}

Status LayerLooker::find_colors(std::uint32_t layer, const InstanceSight& sight,
                                std::span<Rgb> code) const {
  const DrawnLayer& drawn = *layers_[layer];
  return parallel_for(context_, code.size(), kPointsPerTask, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      const ShadersAt shaders{color_shaders_, drawn.color_places.shader, sight.layer_from_pixel,
                              pixels_.point[sight.point[i]]};
      const auto radius_of = [](const gather::RowSource& source, const gather::RowTerm& term) {
        return gather::radius_at(source, term.moment);
      };
      const Rgb color = row_color(sight.rows, i, drawn.color, radius_of, shaders);
      code[i] = clamped_color(to_srgb(drawing_.interpolation, color));
    }
  });
}

}  // namespace sfumato::tracing
