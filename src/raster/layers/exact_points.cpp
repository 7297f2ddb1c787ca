#include "raster/layers/exact_points.hpp"

#include <array>

#include "base/try.hpp"

namespace sfumato::raster {

void ExactPoints::start(const LayerView& layer, const Affine& layer_from_image) {
  fields_ = layer.exact;
  layer_from_image_ = layer_from_image;
  color_channels_ = static_cast<std::size_t>(layer.color.channel_count);
  opacity_channels_ = static_cast<std::size_t>(layer.opacity.channel_count);
  point_.clear();
  block_.clear();
}

Status ExactPoints::read(Context& context) {
  const std::size_t count = point_.size();
  SFUMATO_TRY(memory_.resize(context, slot_, count));
  SFUMATO_TRY(memory_.resize(context, sorted_, count));
  std::array<std::uint32_t, kColumns * kRows> next{};
  for (const std::uint8_t block : block_) ++next[block];
  group_.clear();
  std::uint32_t begin = 0;
  for (std::uint32_t& place : next) {
    const std::uint32_t size = place;
    place = begin;
    begin += size;
    if (size > 0) group_.push_back(begin);
  }
  for (std::size_t i = 0; i < count; ++i) {
    slot_[i] = next[block_[i]]++;
    sorted_[slot_[i]] = layer_from_image_(point_[i]);
  }
  SFUMATO_TRY(fields_->read(context, sorted_, group_, &values_));
  return settle(context);
}

}  // namespace sfumato::raster
