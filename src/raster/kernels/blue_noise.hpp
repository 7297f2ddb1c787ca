#pragma once

#include <cstdint>

namespace sfumato::raster {

inline constexpr int kBlueNoiseSide = 64;

/// Blue noise on a torus. Each number from 0 to 255 occurs 16 times, as far from its equals as
/// possible; for every number, the places with smaller numbers are as far apart as possible too
/// (scripts/make-blue-noise).
extern const std::uint8_t kBlueNoise[kBlueNoiseSide][kBlueNoiseSide];

}  // namespace sfumato::raster
