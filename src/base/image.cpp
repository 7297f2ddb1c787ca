#include "sfumato/base/image.hpp"

#include <algorithm>

#include "base/limit_error.hpp"

namespace sfumato {

Status validate(const Limits& limits, const Image& image) {
  const auto bad = [](const char* what) { return make_error(StatusCode::bad_input, what); };
  if (image.width < 1 || image.height < 1) return bad("an image without pixels");
  if (static_cast<std::size_t>(std::max(image.width, image.height)) > limits.image_side) {
    return limit_error(limits, &Limits::image_side, "pixels on a side of the image");
  }
  if (image.format > PixelFormat::rgba16) return bad("an image in an unknown format");
  if (image.bytes.size() != image.row_bytes() * static_cast<std::size_t>(image.height)) {
    return bad("the image's size and bytes disagree");
  }
  return ok_status();
}

}  // namespace sfumato
