#pragma once

#include <atomic>

#include "picture/point_fields.hpp"
#include "sfumato/gather/options.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// The exact fields of a layer, gathered where they are asked for.
class LayerPoints final : public picture::PointFields {
 public:
  /// The fields no longer count for their Budget, and may outlive it. No field holds both colour
  /// and opacity.
  ///
  /// may_see_none   whether points may see no colour: they are transparent then
  LayerPoints(PreparedFields fields, const gather::GatherOptions& options, bool may_see_none,
              float max_miss);

  /// Colours are gathered where the opacity is not 0; elsewhere they are 0 and not hit.
  Status read(Context& context, std::span<const Vec2> points,
              std::span<const std::uint32_t> group_end,
              picture::PointValues* values) const override;

  float max_miss() const override { return max_miss_; }
  std::uint64_t read_count() const override { return read_count_; }
  std::size_t bytes() const override { return bytes_; }

  /// Returns a field of the layer with these channels, without nodes.
  PatchField color_field() const;
  /// Returns the same of the opacity; without channels if the layer is opaque.
  PatchField opacity_field() const;

 private:
  PreparedFields fields_;
  gather::GatherOptions options_;
  bool may_see_none_;
  float max_miss_;
  std::size_t bytes_ = 0;
  mutable std::atomic<std::uint64_t> read_count_{0};
};

}  // namespace sfumato::solve
