#include "formats/svg/shapes/marker.hpp"

#include <array>
#include <string>

#include "base/angle.hpp"
#include "base/try.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/shapes/overflow.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

/// The words for the least, the middle and the greatest coordinate of the content's box.
using SideWords = std::array<std::string_view, 3>;
constexpr SideWords kAcross{"left", "center", "right"};
constexpr SideWords kDown{"top", "center", "bottom"};

class MarkerReader {
 public:
  MarkerReader(Input& input, Element element, const Box& viewport)
      : input_(input), element_(element), viewport_(viewport) {}

  Result<Marker> read();

 private:
  Status read_length(const char* name, Axis axis, double& value);
  Status read_size();
  Status read_view();
  Status read_reference(const char* name, Axis axis, const SideWords& words, double least,
                        double greatest, double& value);
  void read_orient();

  Input& input_;
  Element element_;
  const Box& viewport_;
  Marker marker_{};
  Box content_;  ///< the viewBox or, without one, the viewport
};

/// `value` stays where the attribute is absent.
Status MarkerReader::read_length(const char* name, Axis axis, double& value) {
  const auto text = input_.attribute(element_, name);
  if (!text) return ok_status();
  const Result<double> length = input_.length(element_, *text, viewport_, axis);
  if (!length) return input_.in(element_, name, length.status());
  value = *length;
  return ok_status();
}

Status MarkerReader::read_size() {
  SFUMATO_TRY(read_length("markerWidth", Axis::x, marker_.size.x));
  SFUMATO_TRY(read_length("markerHeight", Axis::y, marker_.size.y));
  if (marker_.size.x >= 0 && marker_.size.y >= 0) return ok_status();
  return input_.error(element_, "the size of " + tag(element_) + " is negative; use 0 or more");
}

Status MarkerReader::read_view() {
  const Box area{{0, 0}, marker_.size};
  content_ = area;
  if (hides_overflow(input_, element_)) marker_.clip = area;
  const auto view_box = input_.attribute(element_, "viewBox");
  if (!view_box || !marker_.has_area()) return ok_status();
  const Result<Box> box = parse_view_box(*view_box);
  if (!box) return input_.in(element_, "viewBox", box.status());
  AspectRatio ratio;
  if (const auto text = input_.attribute(element_, "preserveAspectRatio")) {
    const Result<AspectRatio> parsed = parse_aspect_ratio(*text);
    if (!parsed) return input_.in(element_, "preserveAspectRatio", parsed.status());
    ratio = *parsed;
  }
  content_ = *box;
  marker_.viewport_from_content = fit(*box, area, ratio);
  return ok_status();
}

Status MarkerReader::read_reference(const char* name, Axis axis, const SideWords& words,
                                    double least, double greatest, double& value) {
  const auto text = input_.attribute(element_, name);
  const auto word = text ? css::keyword_of(*text, input_.text_poll()) : std::nullopt;
  for (std::size_t i = 0; word && i < words.size(); ++i) {
    if (*word != words[i]) continue;
    value = least + 0.5 * static_cast<double>(i) * (greatest - least);
    return ok_status();
  }
  return read_length(name, axis, value);
}

void MarkerReader::read_orient() {
  const auto text = input_.attribute(element_, "orient");
  if (!text) return;
  const std::string word = css::keyword_of(*text, input_.text_poll()).value_or("");
  if (word == "auto") marker_.orient = Marker::Orient::along;
  if (word == "auto-start-reverse") marker_.orient = Marker::Orient::along_start_reversed;
  if (marker_.orient != Marker::Orient::angle) return;
  const auto token = css::only_token(*text, input_.text_poll());
  const auto degrees = token ? css::degrees_of(*token) : std::nullopt;
  if (!degrees) {
    input_.warn("/marker orient", element_,
                "orient of " + tag(element_) + " is " + text::quoted(text->substr(0, 64)) +
                    "; use auto, auto-start-reverse or an angle; 0 is used");
  }
  marker_.degrees = degrees.value_or(0);
}

Result<Marker> MarkerReader::read() {
  marker_.element = element_;
  marker_.is_of_stroke_width =
      input_.attribute(element_, "markerUnits").value_or("") != "userSpaceOnUse";
  SFUMATO_TRY(read_size());
  SFUMATO_TRY(read_view());
  SFUMATO_TRY(read_reference("refX", Axis::x, kAcross, content_.min.x, content_.max.x,
                             marker_.reference.x));
  SFUMATO_TRY(
      read_reference("refY", Axis::y, kDown, content_.min.y, content_.max.y, marker_.reference.y));
  read_orient();
  return marker_;
}

}  // namespace

Result<Marker> read_marker(Input& input, Element element, const Box& viewport) {
  return MarkerReader(input, element, viewport).read();
}

Affine user_from_marker(const Marker& marker, const MarkerVertex& vertex, bool is_start,
                        double stroke_width) {
  Vec2 along = vertex.direction;
  if (marker.orient == Marker::Orient::angle) {
    const SinCos turn = sin_cos_degrees(marker.degrees);
    along = {turn.cos, turn.sin};
  } else if (is_start && marker.orient == Marker::Orient::along_start_reversed) {
    along = -1.0 * along;
  }
  const double scale = marker.is_of_stroke_width ? stroke_width : 1;
  const Vec2 reference = marker.viewport_from_content(marker.reference);
  const Affine user_from_turned{along.x * scale, along.y * scale, -along.y * scale,
                                along.x * scale, vertex.point.x,  vertex.point.y};
  return user_from_turned * Affine{1, 0, 0, 1, -reference.x, -reference.y} *
         marker.viewport_from_content;
}

}  // namespace sfumato::svg
