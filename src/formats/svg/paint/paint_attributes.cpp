#include "formats/svg/paint/paint_attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/svg/shapes/element_transform.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

bool is_paint(std::string_view name) {
  return name == "linearGradient" || name == "radialGradient" || name == "pattern";
}

bool is_gradient(Element element) {
  return std::string_view(element.name()) != "pattern";
}

/// Returns the paint that the last one of the chain inherits from. Errors: bad_input, limit.
Result<Element> next_of(Input& input, const std::vector<Element>& chain) {
  const Element last = chain.back();
  SFUMATO_TRY_ASSIGN(auto&& next, input.referred(last));
  if (!is_paint(next.name()) || is_gradient(next) != is_gradient(last)) {
    return input.error(
        last, "href of " + tag(last) + " leads to " + tag(next) + "; use a paint of the same kind");
  }
  if (std::ranges::find(chain, next) != chain.end()) {
    std::string names;
    for (const Element paint : chain) names += hash_id(paint) + " → ";
    return input.error(chain.front(),
                       "the hrefs of paints go round in a circle: " + names + hash_id(next));
  }
  if (chain.size() < input.limits().xml_depth) return std::move(next);
  return input.over_limit(chain.front(), &Limits::xml_depth, "paints that inherit from each other");
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
    const Result<Element> next = next_of(input, chain);
    status = input.ignore(chain.back(), next.status());
    if (!next) break;
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
  Status status = input_->ignore(
      bearer(name), input_->error(bearer(name), std::string(name) + " is " + text::quoted(*units) +
                                                    "; use userSpaceOnUse or "
                                                    "objectBoundingBox"));
  return status ? Result<bool>(by_default) : Result<bool>(status);
}

Result<double> PaintAttributes::length(const char* name, bool in_box, const Box& viewport,
                                       Axis axis, double share_by_default) const {
  static constexpr Box kUnitBox{{0, 0}, {1, 1}};
  const Box& box = in_box ? kUnitBox : viewport;
  const Element element = bearer(name, is_gradient(paint()));
  if (!element) return share_by_default * extent(box, axis);
  Result<double> value = input_->length(element, element.attribute(name).value(), box, axis);
  if (value) return value;
  Status status = input_->ignore(element, input_->in(element, name, value.status()));
  return status ? Result<double>(share_by_default * extent(box, axis)) : Result<double>(status);
}

/// Returns the transform of one of the chain; none if it has none that can be read.
Result<std::optional<Affine>> PaintAttributes::transform_of(Element element, const char* name,
                                                            const Box& viewport) const {
  if (!element.attribute(name) && !has_transform_style(*input_, element))
    return std::optional<Affine>();
  const Result<Affine> map = paint_transform(*input_, element, name, viewport);
  if (!map) {
    SFUMATO_TRY(input_->ignore(element, map.status()));
    return std::optional<Affine>();
  }
  if (is_usable(*map)) return std::optional(*map);
  return input_->error(element, std::string(name) + " of " + tag(element) +
                                    " cannot be inverted; use a transform that can");
}

Result<Affine> PaintAttributes::transform(const char* name, const Box& viewport) const {
  for (const Element element : chain_) {
    SFUMATO_TRY_ASSIGN(const std::optional<Affine>& map, transform_of(element, name, viewport));
    if (map) return *map;
  }
  return Affine{};
}

Result<Affine> user_from_bounds(Input& input, const PaintedShape& shape, Element paint) {
  const Box& box = shape.bounds;
  if (box.width() > 0 && box.height() > 0) {
    return Affine{box.width(), 0, 0, box.height(), box.min.x, box.min.y};
  }
  return input.error(shape.element, "the bounding box of " + tag(shape.element) +
                                        " has no area for " + tag(paint) + " " + hash_id(paint) +
                                        " of objectBoundingBox units; use userSpaceOnUse");
}

}  // namespace sfumato::svg
