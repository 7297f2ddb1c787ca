#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// The exact differences of two images: a histogram of the absolute differences of all channels, in
/// 65535ths (a code value of 255 is 257 of them). Alpha counts if either image has it; an image
/// without alpha is opaque.
class Difference {
 public:
  /// Computes the difference. Precondition: the images have the same size. Error: cancelled.
  static Result<Difference> of(const Context& context, const Image& a, const Image& b);

  /// Root mean square, in code values of 255.
  double rms() const;
  double maximum() const;

  /// Returns the PSNR in decibels against 255; infinite for equal images.
  double psnr_db() const;

  /// Returns the smallest difference, in code values of 255, that at least per_mille thousandths of
  /// all channels do not exceed (nearest rank). per_mille in 1 to 1000.
  double percentile(int per_mille) const;

 private:
  Difference() = default;

  std::uint64_t sample_count_ = 0;
  std::vector<std::uint64_t> count_of_;  ///< 65536 counts
};

/// Returns |a − b| · scale in each colour channel, clamped, as rgb8. A greater difference in alpha
/// shows in all three channels. The picture is charged to `memory`. Precondition: the images have
/// the same size. Errors: limit (memory), cancelled.
Result<Image> difference_image(const Context& context, const Image& a, const Image& b, double scale,
                               TableMemory& memory);

}  // namespace sfumato::cli
