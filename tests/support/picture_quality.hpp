#pragma once

#include <optional>

#include "support/planes.hpp"

namespace sfumato::test {

/// 10 log10(1 / the mean square difference of all channels); infinite for equal pictures.
/// Precondition: one size.
double psnr_db(const Planes& a, const Planes& b);

/// The structural similarity of Wang et al. 2004 by the definition of scikit-image with
/// gaussian_weights, sigma = 1.5 and use_sample_covariance = False: windows of 11 × 11 that lie
/// within the picture, K1 = 0.01, K2 = 0.03, the mean over the channels. 1 for equal pictures;
/// nothing for pictures that have no such window. Precondition: one size.
std::optional<double> ssim(const Planes& a, const Planes& b);

}  // namespace sfumato::test
