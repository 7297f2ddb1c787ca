#pragma once

#include <cstdint>

#include "base/charge.hpp"
#include "picture/field_source.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/point_evaluator.hpp"

namespace sfumato::solve {

/// A document solved at any requested points, without patches: the ground truth for pictures. The
/// colour of a pixel is that of its centre.
class ExactPicture final : public picture::FieldSource {
 public:
  /// Prepares a document. Context and document must outlive this.
  ///
  /// options  options for mesh and patches are ignored
  /// stats    optional: curves, segments and times are added
  ///
  /// Errors: as diffuse().
  static Result<ExactPicture> create(Context& context, const Document& document,
                                     const DiffuseOptions& options, DiffuseStats* stats = nullptr);

  /// Returns the stack, with two triangles and no values for each layer.
  const Picture& picture() const { return picture_; }

  /// Reads the fields of a layer. Errors: limit (memory), cancelled.
  Status read(std::uint32_t layer, const Affine& layer_from_image, const PixelRect& rect,
              picture::FieldPixels* out) const override;

 private:
  ExactPicture(Context& context, PointEvaluator evaluator)
      : context_(&context), evaluator_(std::move(evaluator)) {}

  Context* context_;
  PointEvaluator evaluator_;
  Picture picture_;
  ScopedCharge charge_;
};

}  // namespace sfumato::solve
