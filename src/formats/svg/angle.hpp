#pragma once

namespace sfumato::svg {

struct SinCos {
  double sin = 0;
  double cos = 1;
};

/// Sine and cosine with an error of a few last bits, exact at multiples of 90. The bits are the
/// same on every machine, because control points are computed from them.
SinCos sin_cos_degrees(double degrees);

}  // namespace sfumato::svg
