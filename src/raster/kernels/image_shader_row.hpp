#pragma once

namespace sfumato::raster {

/// Destination of the colours of a row of samples: one plane per channel, not premultiplied.
struct ShaderRow {
  float* r = nullptr;
  float* g = nullptr;
  float* b = nullptr;
  float* alpha = nullptr;

  void set(int i, const float (&rgba)[4]) const {
    r[i] = rgba[0];
    g[i] = rgba[1];
    b[i] = rgba[2];
    alpha[i] = rgba[3];
  }
};

}  // namespace sfumato::raster
