#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato {

/// The fields of a document's layers at single points, with no patch mesh between: the ground truth
/// that pictures are held against. What the channels of a field are: picture/picture.hpp.
class PointEvaluator {
 public:
  /// Prepares the layers for gathering. Of the options, those of mesh and patches are ignored.
  /// Adds curves, segments and times to `stats` if not null. Errors: as diffuse().
  static Result<PointEvaluator> create(Context& context, const Document& document,
                                       const DiffuseOptions& options,
                                       DiffuseStats* stats = nullptr);

  PointEvaluator(PointEvaluator&&) noexcept;
  PointEvaluator& operator=(PointEvaluator&&) noexcept;
  ~PointEvaluator();

  /// Channels of a layer's fields; 0: no instance shows the layer in the viewport, or it has no
  /// such field. The last ones belong to the shaders, indices into Document::shaders.
  int color_channels(std::uint32_t layer) const;
  int opacity_channels(std::uint32_t layer) const;
  std::span<const std::uint32_t> color_shaders(std::uint32_t layer) const;
  std::span<const std::uint32_t> opacity_shaders(std::uint32_t layer) const;

  /// Precondition: the layer has a colour field.
  /// points   layer frame, inside what an instance brings into the viewport that `create` was
  ///          given; neighbours in the list should be neighbours in the plane
  /// color    color_channels floats per point
  /// hit      per point: 0 where no colour is seen (color is 0 there), else 1
  /// opacity  opacity_channels floats per point
  /// Errors   limit, cancelled (output unspecified).
  Status evaluate(Context& context, std::uint32_t layer, std::span<const Vec2> points,
                  std::span<float> color, std::span<std::uint8_t> hit,
                  std::span<float> opacity = {}) const;

 private:
  struct State;
  explicit PointEvaluator(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato
