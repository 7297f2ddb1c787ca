#pragma once

#include <cstdint>

namespace sfumato::raster {

inline constexpr int kBlueNoiseSide = 64;

/// Blue noise on a torus: each of 0 to 255 stands 16 times, as far from its like, and those below a
/// number as far from each other, as can be (scripts/make-blue-noise).
extern const std::uint8_t kBlueNoise[kBlueNoiseSide][kBlueNoiseSide];

}  // namespace sfumato::raster
