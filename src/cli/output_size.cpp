#include "cli/output_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/limits.hpp"

namespace sfumato::cli {
namespace {

std::string in_pixels(double length) {
  char text[32];
  std::snprintf(text, sizeof text, length < 1e9 ? "%.0f" : "%.3g", length);
  return text;
}

}  // namespace

Result<OutputSize> output_size(const SizeRequest& request, const Box& viewport) {
  double x_scale = request.scale.value_or(1);
  double y_scale = x_scale;
  if (request.width) x_scale = y_scale = *request.width / viewport.width();
  if (request.height) y_scale = *request.height / viewport.height();
  if (request.height && !request.width) x_scale = y_scale;
  const double width = std::max(1.0, std::round(viewport.width() * x_scale));
  const double height = std::max(1.0, std::round(viewport.height() * y_scale));
  if (width > limits::kImageSide || height > limits::kImageSide) {
    return make_error(StatusCode::limit, "the picture would be " + in_pixels(width) + " x " +
                                             in_pixels(height) + " pixels, the limit is " +
                                             std::to_string(limits::kImageSide) + " on a side");
  }
  return OutputSize{static_cast<int>(width), static_cast<int>(height), std::max(x_scale, y_scale)};
}

}  // namespace sfumato::cli
