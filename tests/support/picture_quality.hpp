#pragma once

#include <optional>

#include "support/planes.hpp"

namespace sfumato::test {

/// Returns 10 log10(1 / the mean square difference of all channels); infinite for equal pictures.
/// Precondition: equal sizes.
double psnr_db(const Planes& a, const Planes& b);

/// Returns the structural similarity of Wang et al. 2004, by the definition of scikit-image with
/// gaussian_weights, sigma = 1.5 and use_sample_covariance = False: windows of 11 × 11 inside the
/// picture, K1 = 0.01, K2 = 0.03, the mean over the channels. 1 for equal pictures; nothing for
/// pictures without such a window. Precondition: equal sizes.
std::optional<double> ssim(const Planes& a, const Planes& b);

}  // namespace sfumato::test
