#pragma once

#include <optional>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// A picture as the tracer uses it.
struct Picture {
  Channels code;  ///< sRGB code values from 0 to 1; invisible pixels have the values of near pixels
  std::optional<Plane> opacity;  ///< 0 to 1; none: opaque everywhere
  double scale = 1;              ///< traced pixels per pixel of the image
  TableMemory memory{"the picture to trace"};

  int width() const { return code[0].width; }
  int height() const { return code[0].height; }
};

/// Scales a valid image down so that its longer side has at most `max_side` pixels; each pixel is
/// the mean of the area that it covers.
///
/// keeps_opacity   false: an image with alpha is shown on white
/// Errors          limit (memory), cancelled
Result<Picture> look_at(Context& context, const Image& image, int max_side, bool keeps_opacity);

/// The coordinates of OKLab of each pixel. Errors: limit (memory), cancelled.
Status to_oklab(Context& context, const Channels& code, TableMemory& memory, Channels& oklab);

struct Noise {
  double deviation = 0;   ///< standard deviation, as of white noise
  bool is_drawn = false;  ///< three pixels of four have none: the picture was drawn, not taken
};

/// Estimates the noise of a channel by the median of a Laplacian of a Laplacian, which texture
/// hardly affects (Immerkær 1996). Errors: limit (memory), cancelled.
Result<Noise> estimate_noise(Context& context, const Plane& channel);

}  // namespace sfumato::tracing
