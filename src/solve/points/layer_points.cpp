#include "solve/points/layer_points.hpp"

#include <algorithm>
#include <utility>

#include "base/try.hpp"

namespace sfumato::solve {
namespace {

std::size_t leave_budget(PreparedField& field) {
  return field.memory.leave_budget() + field.gatherer.leave_budget();
}

PatchField field_without_nodes(int channels, const std::vector<std::uint32_t>& shaders) {
  return {channels, {}, {}, shaders};
}

/// The points at which the opacity is not 0, in the same groups.
struct ShownPoints {
  ShownPoints(std::span<const float> opacity, std::size_t count,
              std::span<const std::uint32_t> all_ends) {
    const std::size_t channels = opacity.size() / std::max<std::size_t>(count, 1);
    std::uint32_t i = 0;
    for (const std::uint32_t end : all_ends) {
      for (; i < end; ++i) {
        const std::span<const float> value = opacity.subspan(channels * i, channels);
        if (std::ranges::any_of(value, [](float v) { return v != 0; })) point.push_back(i);
      }
      group_end.push_back(static_cast<std::uint32_t>(point.size()));
    }
  }

  std::vector<std::uint32_t> point;
  std::vector<std::uint32_t> group_end;
};

}  // namespace

LayerPoints::LayerPoints(PreparedFields fields, const gather::GatherOptions& options,
                         bool may_see_none, float max_miss)
    : fields_(std::move(fields)),
      options_(options),
      may_see_none_(may_see_none),
      max_miss_(max_miss) {
  bytes_ = leave_budget(fields_.color);
  if (fields_.opacity) bytes_ += leave_budget(*fields_.opacity);
}

PatchField LayerPoints::color_field() const {
  const curves::SegmentAttributes& attributes = fields_.color.attributes;
  return field_without_nodes(attributes.channel_count(), attributes.shader);
}

PatchField LayerPoints::opacity_field() const {
  if (fields_.opacity) {
    const curves::SegmentAttributes& attributes = fields_.opacity->attributes;
    return field_without_nodes(attributes.channel_count(), attributes.shader);
  }
  return field_without_nodes(may_see_none_ ? 1 : 0, {});
}

Status LayerPoints::read(Context& context, std::span<const Vec2> points,
                         std::span<const std::uint32_t> group_end,
                         picture::PointValues* values) const {
  const auto gather = [&](const PreparedField& field, const gather::PointList& list,
                          std::vector<float>& value, std::span<std::uint8_t> hit) {
    value.assign(static_cast<std::size_t>(field.gatherer.channel_count()) * points.size(), 0.0f);
    return field.gatherer.gather(context, list, options_, value, hit);
  };
  read_count_ += points.size();
  values->hit.assign(points.size(), 0);
  values->opacity.clear();
  const gather::PointList all = gather::PointList(points).in_groups(group_end);
  if (!fields_.opacity) {
    SFUMATO_TRY(gather(fields_.color, all, values->color, values->hit));
    if (may_see_none_) values->opacity.assign(points.size(), 1);
    return ok_status();
  }
  SFUMATO_TRY(gather(*fields_.opacity, all, values->opacity, {}));
  const ShownPoints shown(values->opacity, points.size(), group_end);
  const gather::PointList listed(points, shown.point);
  return gather(fields_.color, listed.in_groups(shown.group_end), values->color, values->hit);
}

}  // namespace sfumato::solve
