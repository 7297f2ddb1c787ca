#include <algorithm>
#include <string>

#include "base/limit_error.hpp"
#include "codecs/image_file.hpp"

namespace sfumato::codecs {

Status check_image_size(const Limits& limits, std::uint64_t width, std::uint64_t height) {
  const std::string size =
      "an image of " + std::to_string(width) + " × " + std::to_string(height) + " pixels";
  if (std::max(width, height) > limits.image_side) {
    return make_limit_error(
        &Limits::image_side,
        size + "; the limit is " + limit_text(limits, &Limits::image_side, "pixels on a side"));
  }
  if (width * height > limits.texels) {
    return make_limit_error(
        &Limits::texels, size + "; the limit is " + limit_text(limits, &Limits::texels, "texels"));
  }
  return ok_status();
}

}  // namespace sfumato::codecs
