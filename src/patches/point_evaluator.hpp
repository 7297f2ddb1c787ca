#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/context.hpp"
#include "base/status.hpp"
#include "document/document.hpp"
#include "patches/diffuse.hpp"

namespace sfumato {

/// The colour of a document at single points, with no patch mesh between: the ground truth that
/// pictures are held against.
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

  /// points   artboard frame, inside the viewport that `create` was given; neighbours in the list
  ///          should be neighbours in the plane
  /// rgb      3 floats per point, code values 0 to 1, topmost layer that has a colour there
  /// hit      per point: 0 where no layer has a colour (rgb is 0 there), else 1
  /// Errors   limit, cancelled (output unspecified).
  Status evaluate(Context& context, std::span<const Vec2> points, std::span<float> rgb,
                  std::span<std::uint8_t> hit) const;

 private:
  struct State;
  explicit PointEvaluator(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato
