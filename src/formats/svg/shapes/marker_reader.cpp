#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/read/plain_reader.hpp"
#include "formats/svg/shapes/marker.hpp"
#include "formats/svg/shapes/marker_vertices.hpp"

/// The part of PlainReader that draws markers of ordinary SVG.
namespace sfumato::svg {
namespace {

/// Returns whether markers are drawn on such a shape.
bool has_vertices(std::string_view shape_name) {
  return shape_name == "path" || shape_name == "line" || shape_name == "polyline" ||
         shape_name == "polygon";
}

std::vector<Element> ancestors_of(Element element) {
  std::vector<Element> ancestors;
  for (Element at = element.parent(); at.type() == pugi::node_element; at = at.parent()) {
    ancestors.push_back(at);
  }
  std::ranges::reverse(ancestors);
  return ancestors;
}

}  // namespace

/// Returns the marker that a property of the shape names; none where it cannot be drawn.
Result<std::optional<Marker>> PlainReader::marker_of(Element element, css::Property which,
                                                     const PlainStyle& style) {
  const std::string_view text = style.marker(which);
  const std::optional<std::string> url = css::url_of(text, input_.text_poll());
  if (!url) return std::optional<Marker>();
  if (!has_vertices(element.name())) {
    input_.warn("/marker on a shape", element,
                "markers of " + tag(element) +
                    " are not drawn; put them on a <path>, <line>, "
                    "<polyline> or <polygon>");
    return std::optional<Marker>();
  }
  const auto left_out = [&](const Status& status) -> Result<std::optional<Marker>> {
    if (!can_be_left_out(status)) return status;
    input_.warn("/marker", element,
                std::string(css::property_name(which)) + " of " + tag(element) +
                    " is left out: " + status.message);
    return std::optional<Marker>();
  };
  if (url->size() < 2 || url->front() != '#') {
    return left_out(input_.error(element, "use url(#id) of a <marker> in the file"));
  }
  const Result<Element> target = input_.element_of(element, url->substr(1));
  if (!target) return left_out(target.status());
  if (std::string_view(target->name()) != "marker") {
    return left_out(input_.error(element, *url + " is " + tag(*target) + "; use a <marker>"));
  }
  if (is_drawn(marker_, *target)) return std::optional<Marker>();
  SFUMATO_TRY(input_.charge_reading(*target, "markers"));
  const Result<Marker> marker = read_marker(input_, *target, document_.artboard);
  if (!marker) return left_out(marker.status());
  return marker->has_area() ? std::optional(*marker) : std::nullopt;
}

Result<PlainReader::ShapeMarkers> PlainReader::markers_of(Element element,
                                                          const PlainStyle& style) {
  ShapeMarkers markers;
  constexpr std::array<css::Property, 3> kProperties{
      css::Property::marker_start, css::Property::marker_mid, css::Property::marker_end};
  for (std::size_t i = 0; i < kProperties.size(); ++i) {
    SFUMATO_TRY_ASSIGN(auto&& marker, marker_of(element, kProperties[i], style));
    markers.any |= marker.has_value();
    markers.marker[i] = std::move(marker);
  }
  return markers;
}

/// Counts markers before they are drawn. False if they are left out.
bool PlainReader::take_markers(Element element, std::size_t count) {
  if (depth_of(marker_) >= input_.limits().marker_depth) {  // the reader recurses for each
    input_.warn("/marker depth", element,
                "markers of " + tag(element) + " are left out: more than the limit of " +
                    limit_text(input_.limits(), &Limits::marker_depth,
                               "markers within each other; raise the limit marker-depth"));
    return false;
  }
  const std::size_t limit = input_.limits().markers;
  if (count <= limit - std::min(limit, marker_count_)) {
    marker_count_ += count;
    return true;
  }
  input_.warn("/marker count", element,
              "markers of " + tag(element) + " are left out: more than the limit of " +
                  limit_text(input_.limits(), &Limits::markers, "markers in all") +
                  "; raise the limit markers");
  return false;
}

/// The first vertex has marker-start, the last marker-end, the others marker-mid.
Status PlainReader::draw_markers(Element element, const Place& place, const ShapeMarkers& markers) {
  if (!markers.any) return ok_status();
  TableMemory memory("vertices with markers");
  const auto vertices = marker_vertices(input_.context(), markers.subpaths, memory);
  if (!vertices) return input_.placed(element, vertices.status());
  const auto& [start, mid, end] = markers.marker;
  const std::size_t count = vertices->size();
  if (!take_markers(element, (mid ? count - 2 : 0) + (start ? 1 : 0) + (end ? 1 : 0))) {
    return ok_status();
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Marker>& marker = i == 0 ? start : i + 1 == count ? end : mid;
    if (!marker) {
      if (i > 0 && !mid && i + 1 < count) i = count - 2;
      continue;
    }
    const Affine user_from_content =
        user_from_marker(*marker, (*vertices)[i], i == 0, markers.stroke_width);
    SFUMATO_TRY(draw_marker(*marker, element, place, user_from_content, markers.context));
  }
  return ok_status();
}

Status PlainReader::draw_marker(const Marker& marker, Element element, const Place& place,
                                const Affine& user_from_content, const ContextPaints& context) {
  Place inside;
  inside.frame_from_user = place.frame_from_user * user_from_content;
  inside.clip = place.clip;
  inside.mask = place.mask;
  if (inside.frame_from_user.determinant() == 0) return ok_status();
  if (Status status = check_map(element, inside.frame_from_user); !status) {
    return leave_out(element, place, std::move(status));
  }
  const std::string visibility = input_.keyword(marker.element, css::Property::visibility);
  inside.is_visible = visibility.empty() || visibility == "visible";
  inside.depth = place.depth + 1;
  inside.is_copy = true;
  DrawnMarker drawn{marker.element, ancestors_of(marker.element),
                    context,        inside.frame_from_user * inverse(marker.viewport_from_content),
                    marker.clip,    marker_};
  marker_ = &drawn;
  // A marker may use elements around the shapes that have it.
  const Scope outer = std::exchange(scope_, {"markers", open_.size(), used_.size()});
  Status status = count_visit(marker.element, inside);
  if (status) {
    open_children(marker.element, inside, std::nullopt);
    status = visit_open(scope_.open_begin);
  }
  scope_ = outer;
  marker_ = drawn.outer;
  // Only errors that leave out no element get here.
  is_refused_ |= !status;
  return status;
}

}  // namespace sfumato::svg
