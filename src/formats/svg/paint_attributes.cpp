#include "formats/svg/paint_attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ascii.hpp"
#include "formats/svg/transform.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

bool is_paint(std::string_view name) {
  return name == "linearGradient" || name == "radialGradient" || name == "pattern";
}

/// The circle that the chain goes round in, or that it is too long.
Status chain_error(Input& input, const std::vector<Element>& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto end = chain.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(chain.begin(), end, chain[i]) == end) continue;
    std::string names;
    for (std::size_t k = 0; k < i; ++k) names += hash_id(chain[k]) + " → ";
    return input.error(chain.front(),
                       "the hrefs of paints go round in a circle: " + names + hash_id(chain[i]));
  }
  return input.over_limit(chain.front(), &Limits::xml_depth, "paints that inherit from each other");
}

bool is_gradient(Element element) {
  return std::string_view(element.name()) != "pattern";
}

}  // namespace

bool is_usable(const Affine& map) {
  const std::array<double, 6> entries{map.a, map.b, map.c, map.d, map.e, map.f};
  return std::ranges::all_of(entries,
                             [](double x) { return std::abs(x) <= limits::kCoordinate; }) &&
         std::isfinite(1 / map.determinant());
}

Result<PaintAttributes> PaintAttributes::read(Input& input, Element paint) {
  std::vector<Element> chain{paint};
  Status status = input.charge_text(paint);
  while (status && input.attribute(chain.back(), "href")) {
    const Result<Element> next = input.referred(chain.back());
    if (!next) return next.status();
    if (!is_paint(next->name()) || is_gradient(*next) != is_gradient(paint)) {
      return input.error(chain.back(), "href of " + tag(chain.back()) + " leads to " + tag(*next) +
                                           "; expected a paint of the same kind");
    }
    // Circles are looked for where the chain is too long: not for every curve of the paint.
    if (chain.size() >= input.limits().xml_depth) return chain_error(input, chain);
    chain.push_back(*next);
    status = input.charge_reading(*next, "href of paints");
  }
  if (!status) return status;
  return PaintAttributes(input, std::move(chain));
}

Element PaintAttributes::bearer(const char* name, bool same_kind) const {
  for (const Element element : chain_) {
    if (same_kind && std::string_view(element.name()) != paint().name()) continue;
    if (element.attribute(name)) return element;
  }
  return {};
}

std::optional<std::string_view> PaintAttributes::text(const char* name) const {
  const Element element = bearer(name);
  if (!element) return std::nullopt;
  return ascii_trimmed(element.attribute(name).value());
}

Result<bool> PaintAttributes::in_bounding_box(const char* name, bool by_default) const {
  const auto units = text(name);
  if (!units) return by_default;
  if (*units == "objectBoundingBox") return true;
  if (*units == "userSpaceOnUse") return false;
  return input_->error(bearer(name), std::string(name) + " is " + text::quoted(*units) +
                                         "; expected userSpaceOnUse or objectBoundingBox");
}

Result<double> PaintAttributes::length(const char* name, bool in_box, const Box& viewport,
                                       Axis axis, double share_by_default) const {
  static constexpr Box kUnitBox{{0, 0}, {1, 1}};
  const Box& box = in_box ? kUnitBox : viewport;
  const Element element = bearer(name, is_gradient(paint()));
  if (!element) return share_by_default * extent(box, axis);
  Result<double> value = parse_length(element.attribute(name).value(), box, axis);
  if (!value) return input_->in(element, name, value.status());
  return value;
}

Result<Affine> PaintAttributes::transform(const char* name) const {
  const Element element = bearer(name);
  if (!element) return Affine{};
  const Result<Affine> map = parse_transform(input_->context(), element.attribute(name).value());
  if (!map) return input_->in(element, name, map.status());
  if (!is_usable(*map)) {
    return input_->error(element, std::string(name) + " of " + tag(element) +
                                      " cannot be inverted; expected a map that can");
  }
  return *map;
}

Result<Affine> user_from_bounds(Input& input, const PaintedShape& shape, Element paint) {
  const Box& box = shape.bounds;
  if (box.width() > 0 && box.height() > 0) {
    return Affine{box.width(), 0, 0, box.height(), box.min.x, box.min.y};
  }
  return input.error(shape.element, "the bounding box of " + tag(shape.element) +
                                        " has no area for " + tag(paint) + " " + hash_id(paint) +
                                        " of objectBoundingBox units; expected userSpaceOnUse");
}

}  // namespace sfumato::svg
