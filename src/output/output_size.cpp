#include "output/output_size.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/limit_error.hpp"
#include "base/text/number_text.hpp"

namespace sfumato::output {
namespace {

Vec2 scales(const SizeRequest& request, const Box& viewport, Vec2 own_scale) {
  Vec2 scale = request.scale ? Vec2{*request.scale, *request.scale} : own_scale;
  const double aspect = own_scale.y / own_scale.x;
  if (request.width) {
    scale.x = *request.width / viewport.width();
    scale.y = scale.x * aspect;
  }
  if (request.height) scale.y = *request.height / viewport.height();
  if (request.height && !request.width) scale.x = scale.y / aspect;
  return scale;
}

}  // namespace

Vec2 own_scale(const Document& document) {
  if (!document.size_px) return {1, 1};
  return {document.size_px->x / document.artboard.width(),
          document.size_px->y / document.artboard.height()};
}

double output_scale(const SizeRequest& request, const Box& viewport, Vec2 own_scale) {
  const Vec2 scale = scales(request, viewport, own_scale);
  return std::max(scale.x, scale.y);
}

Result<OutputSize> output_size(const Limits& limits, const SizeRequest& request,
                               const Box& viewport, Vec2 own_scale, bool has_window) {
  const Vec2 scale = scales(request, viewport, own_scale);
  const double width = std::max(1.0, std::round(viewport.width() * scale.x));
  const double height = std::max(1.0, std::round(viewport.height() * scale.y));
  const double longer = std::max(width, height);
  const std::string complaint = "the picture would be " + length_text(width) + " x " +
                                length_text(height) + " pixels, the limit is ";
  if (has_window && longer > RasterWindow::kLargestSide) {
    return make_error(StatusCode::limit,
                      complaint + std::to_string(RasterWindow::kLargestSide) + " pixels on a side");
  }
  if (!has_window && longer > static_cast<double>(limits.image_side)) {
    return make_limit_error(&Limits::image_side, complaint + limit_text(limits, &Limits::image_side,
                                                                        "pixels on a side"));
  }
  return OutputSize{static_cast<int>(width), static_cast<int>(height), std::max(scale.x, scale.y)};
}

void set_size(const OutputSize& size, const std::optional<PixelRect>& window,
              RasterOptions& options) {
  options.width = window ? window->x1 - window->x0 : size.width;
  options.height = window ? window->y1 - window->y0 : size.height;
  options.window.reset();
  if (window) options.window = RasterWindow{window->x0, window->y0, size.width, size.height};
}

}  // namespace sfumato::output
