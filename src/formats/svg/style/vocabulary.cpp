#include "formats/svg/style/vocabulary.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

constexpr std::array<std::string_view, 7> kShapes{"path",   "line",    "polyline", "polygon",
                                                  "circle", "ellipse", "rect"};

/// Where an attribute stands.
enum class Bearer : unsigned char {
  root,
  group,
  any_curve,
  diffusion_curve,
  local_curve,
  image,
  pattern
};

struct Attribute {
  std::string_view name;
  Bearer bearer;
};

constexpr std::array<Attribute, 17> kAttributes{{
    {"version", Bearer::root},
    {"interpolation", Bearer::root},
    {"background", Bearer::root},
    {"diffuse", Bearer::group},
    {"left", Bearer::any_curve},
    {"right", Bearer::any_curve},
    {"blur", Bearer::any_curve},
    {"left-blur", Bearer::diffusion_curve},
    {"right-blur", Bearer::diffusion_curve},
    {"opacity", Bearer::diffusion_curve},
    {"left-opacity", Bearer::diffusion_curve},
    {"right-opacity", Bearer::diffusion_curve},
    {"weight", Bearer::diffusion_curve},
    {"radius", Bearer::local_curve},
    {"alpha", Bearer::local_curve},
    {"reference", Bearer::image},
    {"repeats", Bearer::pattern},
}};

/// In the order of Bearer.
constexpr const char* kPlaces[] = {"the outermost <svg>",
                                   "a <g>",
                                   "a shape: path, line, polyline, polygon, circle, ellipse, rect",
                                   "a shape in a layer, one without sf:radius",
                                   "a shape with sf:radius, a local curve",
                                   "an <image>",
                                   "a <pattern>"};
static_assert(std::size(kPlaces) == static_cast<std::size_t>(Bearer::pattern) + 1);

bool fits(std::string_view name, bool is_root, bool has_radius, Bearer bearer) {
  switch (bearer) {
    case Bearer::root:
      return is_root;
    case Bearer::group:
      return name == "g";
    case Bearer::any_curve:
      return is_shape(name);
    case Bearer::diffusion_curve:
      return is_shape(name) && !has_radius;
    case Bearer::local_curve:
      return is_shape(name) && has_radius;
    case Bearer::image:
      return name == "image";
    case Bearer::pattern:
      return name == "pattern";
  }
  return false;
}

std::string suggestion(std::string_view name) {
  std::array<std::string_view, kAttributes.size()> names;
  std::ranges::transform(kAttributes, names.begin(), &Attribute::name);
  const std::string_view best = text::nearest(name, names);
  return best.empty() ? "; docs/format.md lists the attributes"
                      : "; did you mean sf:" + std::string(best) + "?";
}

}  // namespace

bool is_shape(std::string_view element_name) {
  return std::ranges::find(kShapes, element_name) != kShapes.end();
}

Status check_sf_attributes(Input& input, Element element) {
  const bool is_root = element == input.root();
  const bool has_radius = input.sf(element, "radius").has_value();
  for (const pugi::xml_attribute attribute : element.attributes()) {
    std::string_view name = attribute.name();
    if (!name.starts_with(':')) continue;
    name.remove_prefix(1);
    const auto known = std::ranges::find(kAttributes, name, &Attribute::name);
    const std::string shown = "sf:" + std::string(name).substr(0, 64);
    if (known == kAttributes.end()) {
      return input.error(element, "there is no attribute " + shown + suggestion(name));
    }
    if (!fits(element.name(), is_root, has_radius, known->bearer)) {
      return input.error(element, shown + " on " + tag(element) + " means nothing; it belongs on " +
                                      kPlaces[static_cast<std::size_t>(known->bearer)]);
    }
  }
  return ok_status();
}

}  // namespace sfumato::svg
