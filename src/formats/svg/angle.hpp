#pragma once

namespace sfumato::svg {

struct SinCos {
  double sin = 0;
  double cos = 1;
};

/// Sine and cosine to the last bits, exact at multiples of 90, the same bits on every machine:
/// control points come from them.
SinCos sin_cos_degrees(double degrees);

}  // namespace sfumato::svg
