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

/// Computes the colours and opacities of a document's layers at single points, without a patch
/// mesh: the ground truth for pictures. PatchLayer explains the channels. Use it for few points;
/// use diffuse() for pictures.
///
/// Several threads may call evaluate() at once, each with its own Context. Memory stays charged to
/// the Context of create(), which must therefore outlive the evaluator. A moved-from evaluator can
/// only be assigned to or destroyed.
class PointEvaluator {
 public:
  /// Prepares the layers for gathering.
  ///
  /// The options of the patch mesh (angles, areas, order) have no effect, but all options must be
  /// valid; DiffuseOptions::max_error counts only for the default tolerance. `stats`, unless null,
  /// is added to: curves, segments and times. Errors: as diffuse(). Cost: flattening and
  /// triangulating all curves, O(n log n) in their segments.
  static Result<PointEvaluator> create(Context& context, const Document& document,
                                       const DiffuseOptions& options,
                                       DiffuseStats* stats = nullptr);

  /// Takes over the content of `other`.
  PointEvaluator(PointEvaluator&& other) noexcept : state_(other.state_) { other.state_ = nullptr; }
  /// Exchanges the content of both objects.
  PointEvaluator& operator=(PointEvaluator&& other) noexcept;
  ~PointEvaluator();

  /// Returns the floats per point of a layer's colours; 0 where it has no curves, or is not in the
  /// viewport.
  int color_channels(std::uint32_t layer) const;
  /// Returns the floats per point of a layer's opacity; 0 where it has none, or is not in the
  /// viewport.
  int opacity_channels(std::uint32_t layer) const;
  /// Returns the shaders of the last colour channels, as indices into Document::shaders.
  std::span<const std::uint32_t> color_shaders(std::uint32_t layer) const;
  /// Returns the shaders of the last opacity channels, as indices into Document::shaders.
  std::span<const std::uint32_t> opacity_shaders(std::uint32_t layer) const;

  /// Computes the colours, and if wanted the opacities, of a layer at points.
  ///
  /// - `points`: layer frame, inside the box around the parts that the instances bring into the
  ///   viewport; not on a curve, where the fields jump. Neighbours in the list should be neighbours
  ///   in the plane
  /// - `color`: receives color_channels() floats per point, in the space of Document::interpolation
  /// - `hit`: receives for each point 1, or 0 where no colour is seen; `color` is 0 there
  /// - `opacity`: receives opacity_channels() floats per point; empty: not wanted
  ///
  /// Errors: bad_input (a layer whose color_channels() is 0, spans of other sizes, a point
  /// outside), limit, cancelled, out_of_memory. After an error the content of the spans is
  /// undefined.
  ///
  /// Cost: about 1 µs a point (docs/benchmarks.md), divided among the context's threads.
  Status evaluate(Context& context, std::uint32_t layer, std::span<const Vec2> points,
                  std::span<float> color, std::span<std::uint8_t> hit,
                  std::span<float> opacity = {}) const;

 private:
  friend class solve::ExactPicture;
  struct State;

  /// Does evaluate() without its checks.
  Status gather(Context& context, std::uint32_t layer, std::span<const Vec2> points,
                std::span<float> color, std::span<std::uint8_t> hit,
                std::span<float> opacity) const;

  explicit PointEvaluator(State* state) : state_(state) {}
  State* state_;  ///< owned
};

}  // namespace sfumato
