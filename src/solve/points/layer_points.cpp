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
  const auto gather = [&](const PreparedField& field, std::vector<float>& value,
                          std::span<std::uint8_t> hit) {
    value.resize(static_cast<std::size_t>(field.gatherer.channel_count()) * points.size());
    const gather::PointList list = gather::PointList(points).in_groups(group_end);
    return field.gatherer.gather(context, list, options_, value, hit);
  };
  read_count_ += points.size();
  values->hit.resize(points.size());
  values->opacity.clear();
  SFUMATO_TRY(gather(fields_.color, values->color, values->hit));
  if (fields_.opacity) return gather(*fields_.opacity, values->opacity, {});
  if (may_see_none_) values->opacity.assign(points.size(), 1);
  return ok_status();
}

}  // namespace sfumato::solve
