#include "raster/options.hpp"

#include <algorithm>
#include <string>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "document/rules.hpp"

namespace sfumato::raster {

namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

Status check_whole_size(int width, int height) {
  if (width < 1 || height < 1) {
    return make_error(StatusCode::bad_input, "a window of an image of " + size_text(width, height) +
                                                 "; use at least 1 x 1");
  }
  if (std::max(width, height) > RasterWindow::kLargestSide) {
    return make_error(StatusCode::limit,
                      "a window of an image of " + size_text(width, height) + "; the limit is " +
                          std::to_string(RasterWindow::kLargestSide) + " pixels on a side");
  }
  return ok_status();
}

Status check_window(const RasterOptions& options) {
  const RasterWindow& window = *options.window;
  SFUMATO_TRY(check_whole_size(window.of_width, window.of_height));
  const bool is_inside = window.x >= 0 && window.y >= 0 &&
                         options.width <= window.of_width - window.x &&
                         options.height <= window.of_height - window.y;
  Status status;
  if (is_inside) return status;
  return make_error(StatusCode::bad_input,
                    "a window of " + size_text(options.width, options.height) + " at (" +
                        std::to_string(window.x) + ", " + std::to_string(window.y) +
                        ") that is not inside its image of " +
                        size_text(window.of_width, window.of_height));
}

Status check_colors(const RasterOptions& options) {
  if (options.format > PixelFormat::rgba16) {
    return make_error(StatusCode::bad_input, "an unknown format of pixels");
  }
  return rules::check_background(options.background);
}

}  // namespace

Status check_options(const Limits& limits, const RasterOptions& options) {
  const std::string size = size_text(options.width, options.height);
  if (options.width < 1 || options.height < 1) {
    return make_error(StatusCode::bad_input, "an image of " + size + "; use at least 1 x 1");
  }
  if (static_cast<std::size_t>(std::max(options.width, options.height)) > limits.image_side) {
    return make_limit_error(&Limits::image_side,
                            "an image of " + size + "; the limit is " +
                                limit_text(limits, &Limits::image_side, "pixels on a side"));
  }
  if (options.window) {
    SFUMATO_TRY(check_window(options));
  }
  return check_colors(options);
}

Status check_whole(const RasterOptions& options) {
  if (options.window) {
    return make_error(StatusCode::bad_input, "a window given where windows are yet to be chosen");
  }
  Status status = check_whole_size(options.width, options.height);
  return status ? check_colors(options) : status;
}

TileGrid grid_of(const RasterOptions& options) {
  if (!options.window) return {options.width, options.height};
  const RasterWindow& window = *options.window;
  return {window.of_width,
          window.of_height,
          {window.x, window.y, window.x + options.width, window.y + options.height}};
}

Backdrop choose_backdrop(const RasterOptions& options, const std::optional<Rgb>& document) {
  const std::optional<Rgb> color = options.background ? options.background : document;
  const bool has_alpha = channel_count(options.format) == 4;
  return {color.value_or(has_alpha ? Rgb{0, 0, 0} : Rgb{1, 1, 1}),
          has_alpha && !color ? 0.0f : 1.0f};
}

}  // namespace sfumato::raster
