#include "formats/svg/picture_size.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "base/ascii.hpp"
#include "formats/svg/length.hpp"
#include "formats/svg/view_box.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

/// Aspects that differ by no more are one: rounding of numbers that were written for each other.
constexpr double kSameAspect = 1e-9;

/// A side of the picture as <svg> says it.
struct SideLength {
  std::optional<double> pixels;
  bool is_share = false;  ///< of the viewBox
};

SideLength read_side(Input& input, const char* name, const Box& view_box, Axis axis) {
  const auto text = input.attribute(input.root(), name);
  if (!text || ascii_lower(ascii_trimmed(*text)) == "auto") return {};
  const Result<double> length = parse_length(*text, view_box, axis);
  if (length && *length > 0) return {*length, ascii_trimmed(*text).ends_with('%')};
  const std::string wrong = length ? " is " + text::quoted(*text) + "; expected a length above 0"
                                   : ": " + length.status().message;
  input.warn(std::string("/svg ") + name, input.root(),
             std::string(name) + " of <svg>" + wrong + ": the viewBox says the size");
  return {};
}

AspectRatio read_ratio(Input& input) {
  const auto text = input.attribute(input.root(), "preserveAspectRatio");
  if (!text) return {};
  const Result<AspectRatio> ratio = parse_aspect_ratio(*text);
  if (ratio) return *ratio;
  input.warn("/svg ratio", input.root(),
             "preserveAspectRatio of <svg> is " + ratio.status().message);
  return {};
}

std::optional<Vec2> read_size(Input& input, const Box& view_box) {
  SideLength width = read_side(input, "width", view_box, Axis::x);
  SideLength height = read_side(input, "height", view_box, Axis::y);
  // Beside a length a share is of nothing known: the other side follows the aspect.
  if (!(width.is_share && height.is_share)) {
    if (width.is_share) width.pixels.reset();
    if (height.is_share) height.pixels.reset();
  }
  if (!width.pixels && !height.pixels) return std::nullopt;
  const double aspect = view_box.width() / view_box.height();
  return Vec2{width.pixels ? *width.pixels : *height.pixels * aspect,
              height.pixels ? *height.pixels : *width.pixels / aspect};
}

}  // namespace

PictureFrame read_picture_frame(Input& input, const Box& view_box) {
  PictureFrame frame{view_box, {}, read_size(input, view_box)};
  if (!frame.size_px) return frame;
  const Vec2 size = *frame.size_px;
  const AspectRatio ratio = read_ratio(input);
  if (size == Vec2{view_box.width(), view_box.height()}) frame.size_px.reset();
  const double stretch = size.y / view_box.height() / (size.x / view_box.width());
  if (std::abs(stretch - 1) <= kSameAspect) return frame;
  if (ratio.fit == AspectRatio::Fit::stretch) {
    frame.artboard_from_view_box = {1, 0, 0, stretch, 0, 0};
    frame.artboard = {frame.artboard_from_view_box(view_box.min),
                      frame.artboard_from_view_box(view_box.max)};
    return frame;
  }
  const Affine user_from_pixels = inverse(fit(view_box, {{0, 0}, size}, ratio));
  frame.artboard = {user_from_pixels({0, 0}), user_from_pixels(size)};
  return frame;
}

void show_in_frame(const PictureFrame& frame, Document& document) {
  document.artboard = frame.artboard;
  document.size_px = frame.size_px;
  if (frame.artboard_from_view_box == Affine{}) return;
  const Affine& stretch = frame.artboard_from_view_box;
  for (StackItem& item : document.stack) {
    if (auto* instance = std::get_if<LayerInstance>(&item)) {
      instance->artboard_from_layer = stretch * instance->artboard_from_layer;
    } else if (auto* stroke = std::get_if<LocalStroke>(&item)) {
      stroke->artboard_from_stroke = stretch * stroke->artboard_from_stroke;
    }
  }
}

}  // namespace sfumato::svg
