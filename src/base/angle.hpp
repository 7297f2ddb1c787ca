#pragma once

namespace sfumato {

struct SinCos {
  double sin = 0;
  double cos = 1;
};

/// Returns sine and cosine with an error of a few last bits, exact at multiples of 90. The bits are
/// the same on every machine, because control points are computed from them.
SinCos sin_cos_degrees(double degrees);

}  // namespace sfumato
