#include "lint/stroke_hints.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/boxes.hpp"
#include "base/text/number_text.hpp"
#include "curves/stroke_segments.hpp"
#include "lint/layer_under_test.hpp"

namespace sfumato::lint_detail {
namespace {

/// A stroke thinner than a pixel is fainter in proportion: with this radius, white on black, it
/// changes pixels by two code values.
constexpr double kFaintPx = 2.0 / 255;

float largest(const ScalarStops& stops) {
  float value = 0;
  for (const Stop<float>& stop : stops.stops) value = std::max(value, stop.value);
  return value;
}

float smallest(const ScalarStops& stops) {
  const auto least = std::ranges::min_element(stops.stops, {}, &Stop<float>::value);
  return least == stops.stops.end() ? 0 : least->value;
}

class StrokeCheck {
 public:
  StrokeCheck(const Document& document, std::uint32_t item, const LocalStroke& stroke,
              std::vector<Hint>& hints)
      : document_(document), item_(item), stroke_(stroke), curve_(stroke.curve), hints_(hints) {}

  void run() {
    if (curve_.alpha == 0)
      add(HintKind::invisible,
          "its alpha is 0, so nothing of it shows; raise sf:alpha, or delete it");
    if (curve_.left_color.empty() && curve_.right_color.empty()) {
      add(HintKind::no_attribute, "it has no colour, so it draws nothing; add sf:left or sf:right");
    } else {
      check_blur();
    }
    check_radius();
    check_place();
  }

 private:
  void add(HintKind kind, std::string message) {
    hints_.push_back({.kind = kind, .stack_item = item_, .message = std::move(message)});
  }

  /// Checks the blur, which mixes the two colours across the curve and does not soften the stroke's
  /// border.
  void check_blur() {
    const float blur = smallest(curve_.blur_radius);
    if (largest(curve_.blur_radius) == 0) return;
    if (!curves::is_two_sided(curve_)) {
      add(HintKind::stroke_blur,
          "its blur does nothing, because both sides have the same colour; remove the blur, or "
          "soften the border with sf:radius");
    } else if (blur > largest(curve_.influence_radius)) {
      add(HintKind::stroke_blur,
          "its blur of " + rounded_number_text(blur, 4) + " is wider than its radius of " +
              rounded_number_text(largest(curve_.influence_radius), 4) +
              ", so neither of its two colours shows unmixed; use a blur below sf:radius");
    }
  }

  void check_radius() {
    const double scale = std::sqrt(std::abs(stroke_.artboard_from_stroke.determinant()));
    const double most = largest(curve_.influence_radius) * scale;
    const double least = smallest(curve_.influence_radius) * scale;
    const Box& artboard = document_.artboard;
    // A stroke thinner than a pixel is fainter, and alpha above 1 compensates for it.
    if (most * curve_.alpha < kFaintPx * artboard_pixel(document_)) {
      add(HintKind::stroke_radius,
          "its radius is nowhere above " + rounded_number_text(most, 2) +
              " units of the artboard, too thin to be seen; use a larger sf:radius");
    } else if (least > std::hypot(artboard.width(), artboard.height()) && meets_artboard(0)) {
      add(HintKind::stroke_radius, "its radius is nowhere below " + rounded_number_text(least, 4) +
                                       " units of the artboard, which is smaller, so it covers the "
                                       "whole picture; use a radius as wide as the stroke");
    }
  }

  /// Returns whether the curve's box, with this margin, meets the artboard.
  bool meets_artboard(double margin) const {
    const Box grown = box_of_points(curve_.control_points).grown_by(margin);
    return overlap(mapped_box(stroke_.artboard_from_stroke, grown), document_.artboard);
  }

  void check_place() {
    if (meets_artboard(largest(curve_.influence_radius))) return;
    add(HintKind::outside,
        "it lies outside the artboard, so nothing of it shows; move or delete it");
  }

  const Document& document_;
  std::uint32_t item_;
  const LocalStroke& stroke_;
  const LocalCurve& curve_;
  std::vector<Hint>& hints_;
};

}  // namespace

void check_stroke(const Document& document, std::uint32_t item, const LocalStroke& stroke,
                  std::vector<Hint>& hints) {
  StrokeCheck(document, item, stroke, hints).run();
}

}  // namespace sfumato::lint_detail
