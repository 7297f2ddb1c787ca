#include "formats/svg/paint/picture_size.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/svg/paint/paint_attributes.hpp"
#include "formats/svg/shapes/element_transform.hpp"
#include "formats/svg/shapes/view_box.hpp"
#include "formats/svg/style/length.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// Aspects that differ by no more are one: rounding of numbers that were written for each other.
constexpr double kSameAspect = 1e-9;

constexpr const char* kViewBox = "the viewBox";

bool is_within_limits(const Box& box) {
  const double largest = std::max(
      {std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
  return largest <= limits::kCoordinate;
}

/// A side of the picture as <svg> says it.
struct SideLength {
  double pixels = 0;      ///< 0: not said
  bool is_share = false;  ///< of the viewBox
};

/// `instead`   gives the size if this does not
SideLength read_side(Input& input, const char* name, const Box& view_box, Axis axis,
                     const char* instead) {
  const auto text = input.attribute(input.root(), name);
  if (!text || ascii_lower(ascii_trimmed(*text)) == "auto") return {};
  const Result<double> length = parse_length(*text, view_box, axis);
  if (length && *length > 0) return {*length, ascii_trimmed(*text).ends_with('%')};
  const std::string wrong = length ? " is " + text::quoted(*text) + "; use a length above 0"
                                   : ": " + length.status().message;
  input.warn(std::string("/svg ") + name, input.root(),
             std::string(name) + " of <svg>" + wrong + ": " + instead + " says the size");
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
  SideLength width = read_side(input, "width", view_box, Axis::x, kViewBox);
  SideLength height = read_side(input, "height", view_box, Axis::y, kViewBox);
  // Beside a length a share is of nothing known: the other side follows the aspect.
  if (!(width.is_share && height.is_share)) {
    if (width.is_share) width.pixels = 0;
    if (height.is_share) height.pixels = 0;
  }
  if (width.pixels == 0 && height.pixels == 0) return std::nullopt;
  const double aspect = view_box.width() / view_box.height();
  return Vec2{width.pixels > 0 ? width.pixels : height.pixels * aspect,
              height.pixels > 0 ? height.pixels : width.pixels / aspect};
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

Result<std::optional<Box>> read_view_box(Input& input) {
  const Element root = input.root();
  const auto text = input.attribute(root, "viewBox");
  if (!text) return std::optional<Box>();
  const Result<Box> box = parse_view_box(*text);
  if (!box) return input.in(root, "viewBox", box.status());
  if (is_within_limits(*box)) return std::optional(*box);
  return input.error(root, "viewBox of <svg> reaches farther than " +
                               std::to_string(static_cast<long>(limits::kCoordinate)) +
                               " from the origin; keep coordinates within that");
}

OpenSize read_open_size(Input& input) {
  const Box one{{0, 0}, {1, 1}};
  const auto length = [&](const char* name, Axis axis) {
    const SideLength side = read_side(input, name, one, axis, "the box of the shapes");
    return side.is_share || side.pixels == 0 ? std::nullopt : std::optional(side.pixels);
  };
  const auto width = length("width", Axis::x);
  return {width, length("height", Axis::y)};
}

Result<Affine> root_map(Input& input, const PictureFrame& frame) {
  const Box& shown = frame.artboard;
  const Vec2 size_px = frame.size_px.value_or(Vec2{shown.width(), shown.height()});
  const Affine artboard_from_px{shown.width() / size_px.x,  0,           0,
                                shown.height() / size_px.y, shown.min.x, shown.min.y};
  SFUMATO_TRY_ASSIGN(const Affine& map, root_transform(input, size_px));
  const Affine view_box_from_px = inverse(frame.artboard_from_view_box) * artboard_from_px;
  const Affine moved = view_box_from_px * map * inverse(view_box_from_px);
  if (is_usable(moved)) return moved;
  return input.error(input.root(),
                     "transform of <svg> cannot be inverted; use a transform that can");
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
