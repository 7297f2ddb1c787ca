#include "raster/options.hpp"

#include <algorithm>
#include <string>

#include "base/limit_error.hpp"
#include "document/rules.hpp"

namespace sfumato::raster {

Status check_options(const Limits& limits, const RasterOptions& options) {
  const std::string size =
      std::to_string(options.width) + " x " + std::to_string(options.height) + " pixels";
  if (options.width < 1 || options.height < 1) {
    return make_error(StatusCode::bad_input, "an image of " + size + "; expected at least 1 x 1");
  }
  if (static_cast<std::size_t>(std::max(options.width, options.height)) > limits.image_side) {
    return make_limit_error(&Limits::image_side,
                            "an image of " + size + "; the limit is " +
                                limit_text(limits, &Limits::image_side, "pixels on a side"));
  }
  if (options.format > PixelFormat::rgba16) {
    return make_error(StatusCode::bad_input, "an unknown format of pixels");
  }
  return rules::check_background(options.background);
}

Backdrop choose_backdrop(const RasterOptions& options, const std::optional<Rgb>& document) {
  const std::optional<Rgb> color = options.background ? options.background : document;
  const bool has_alpha = channel_count(options.format) == 4;
  return {color.value_or(has_alpha ? Rgb{0, 0, 0} : Rgb{1, 1, 1}),
          has_alpha && !color ? 0.0f : 1.0f};
}

}  // namespace sfumato::raster
