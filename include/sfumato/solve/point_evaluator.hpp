#pragma once

#include <cstdint>
#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato {

namespace solve {
class ExactPicture;
}

/// The fields of a document's layers at single points, with no patch mesh between: the ground truth
/// that pictures are held against. What the channels of a field are: picture/picture.hpp. Movable;
/// several threads may ask it at once, each with a Context of its own.
class PointEvaluator {
 public:
  /// Prepares the layers for gathering. Of the options, those of mesh and patches are ignored.
  /// Adds curves, segments and times to `stats` if not null. Errors: as diffuse().
  static Result<PointEvaluator> create(Context& context, const Document& document,
                                       const DiffuseOptions& options,
                                       DiffuseStats* stats = nullptr);

  PointEvaluator(PointEvaluator&& other) noexcept : state_(other.state_) { other.state_ = nullptr; }
  PointEvaluator& operator=(PointEvaluator&& other) noexcept;
  ~PointEvaluator();

  /// Channels of a layer's fields; 0: no instance shows the layer in the viewport, or it has no
  /// such field. The last ones belong to the shaders, indices into Document::shaders.
  int color_channels(std::uint32_t layer) const;
  int opacity_channels(std::uint32_t layer) const;
  std::span<const std::uint32_t> color_shaders(std::uint32_t layer) const;
  std::span<const std::uint32_t> opacity_shaders(std::uint32_t layer) const;

  /// The fields of a layer that has colours, at points.
  /// points   layer frame, inside what an instance brings into the viewport that `create` was
  ///          given; neighbours in the list should be neighbours in the plane
  /// color    color_channels floats per point, in the space of Document::interpolation
  /// hit      per point: 0 where no colour is seen (color is 0 there), else 1
  /// opacity  opacity_channels floats per point, or empty: not asked for
  /// Errors   bad_input (a layer without colours, tables of other sizes, a point outside), limit,
  ///          cancelled, out_of_memory; what the tables then hold means nothing.
  /// Cost     about 1 µs a point (docs/benchmarks.md), shared by the context's threads.
  Status evaluate(Context& context, std::uint32_t layer, std::span<const Vec2> points,
                  std::span<float> color, std::span<std::uint8_t> hit,
                  std::span<float> opacity = {}) const;

 private:
  friend class solve::ExactPicture;
  struct State;

  /// evaluate() without its checks.
  Status gather(Context& context, std::uint32_t layer, std::span<const Vec2> points,
                std::span<float> color, std::span<std::uint8_t> hit,
                std::span<float> opacity) const;

  explicit PointEvaluator(State* state) : state_(state) {}
  State* state_;  ///< owned
};

}  // namespace sfumato
