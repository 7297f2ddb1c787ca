#include "raster/options.hpp"

#include <string>

namespace sfumato::raster {

Status check_size(const RasterOptions& options) {
  const std::string size =
      std::to_string(options.width) + " x " + std::to_string(options.height) + " pixels";
  if (options.width < 1 || options.height < 1) {
    return make_error(StatusCode::bad_input, "an image of " + size + "; expected at least 1 x 1");
  }
  if (options.width > limits::kImageSide || options.height > limits::kImageSide) {
    return make_error(StatusCode::limit, "an image of " + size + "; the limit is " +
                                             std::to_string(limits::kImageSide) + " a side");
  }
  return ok_status();
}

Backdrop choose_backdrop(const RasterOptions& options, const std::optional<Rgb>& document) {
  const std::optional<Rgb> color = options.background ? options.background : document;
  const bool has_alpha = channel_count(options.format) == 4;
  return {color.value_or(has_alpha ? Rgb{0, 0, 0} : Rgb{1, 1, 1}),
          has_alpha && !color ? 0.0f : 1.0f};
}

}  // namespace sfumato::raster
