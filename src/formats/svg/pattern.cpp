#include "formats/svg/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "formats/svg/shapes.hpp"
#include "formats/svg/transform.hpp"
#include "formats/svg/view_box.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// Of a tile's size: nearer edges are the same.
constexpr double kSameEdge = 1e-6;

class PatternReader {
 public:
  PatternReader(Input& input, TextureFiles& files, const PaintAttributes& attributes,
                const PaintedShape& shape, const Box& viewport)
      : input_(input), files_(files), attributes_(attributes), shape_(shape), viewport_(viewport) {}

  Result<PatternPlace> read();

 private:
  Status find_image();
  Status read_tile();
  Status read_content();
  Status read_image(Affine& content_from_texture);
  Status read_image_box(Box& box);
  Status check_place(const Affine& pattern_from_texture);
  Result<AspectRatio> aspect_ratio(Element bearer);
  Vec2 texture_size() const {
    return {static_cast<double>(place_.file->image.width),
            static_cast<double>(place_.file->image.height)};
  }

  Input& input_;
  TextureFiles& files_;
  const PaintAttributes& attributes_;
  const PaintedShape& shape_;
  const Box& viewport_;
  Element image_;
  Box tile_;  ///< pattern frame: the user space before patternTransform
  Affine pattern_from_content_;
  PatternPlace place_;
};

bool is_description(std::string_view name) {
  return name == "title" || name == "desc" || name == "metadata";
}

/// The elements that a pattern paints.
std::vector<Element> painted(Element pattern) {
  std::vector<Element> elements;
  for (const Element child : pattern.children()) {
    if (child.type() != pugi::node_element || is_description(child.name())) continue;
    elements.push_back(child);
    if (elements.size() == 2) break;
  }
  return elements;
}

Result<PatternPlace> PatternReader::read() {
  const Result<Affine> transform = attributes_.transform("patternTransform");
  if (!transform) return transform.status();
  Affine content_from_texture;
  Status status = find_image();
  if (status) status = read_tile();
  if (status) status = read_content();
  if (status) status = read_image(content_from_texture);
  const Affine pattern_from_texture = pattern_from_content_ * content_from_texture;
  if (status) status = check_place(pattern_from_texture);
  if (!status) return status;
  place_.layer_from_texture = shape_.layer_from_user * *transform * pattern_from_texture;
  if (!is_usable(place_.layer_from_texture)) {
    return input_.error(attributes_.paint(),
                        "the pattern's place cannot be computed; expected a "
                        "transform that can be inverted, of usual size");
  }
  place_.period = {tile_.width() / pattern_from_texture.a, tile_.height() / pattern_from_texture.d};
  const auto is_period = [](double texels) { return texels > 0 && texels <= limits::kCoordinate; };
  if (!is_period(place_.period.x) || !is_period(place_.period.y)) {
    return input_.error(attributes_.paint(),
                        "the pattern's tile is too large or too small for its "
                        "<image>; expected sizes of one kind");
  }
  const Vec2 size = texture_size();
  if (std::abs(place_.period.x - size.x) <= kSameEdge * size.x &&
      std::abs(place_.period.y - size.y) <= kSameEdge * size.y) {
    place_.period = {};
  }
  return place_;
}

Status PatternReader::find_image() {
  Element pattern = attributes_.first_with([](Element paint) { return !painted(paint).empty(); });
  const std::vector<Element> content = pattern ? painted(pattern) : std::vector<Element>();
  if (content.size() != 1 || std::string_view(content.front().name()) != "image") {
    return input_.error(pattern ? pattern : attributes_.paint(),
                        "the pattern holds something else; expected exactly one <image>");
  }
  image_ = content.front();
  const Result<const TextureFile*> file = files_.find(image_);
  if (file) place_.file = *file;
  return file.status();
}

Status PatternReader::read_tile() {
  const Result<bool> in_box = attributes_.in_bounding_box("patternUnits", true);
  if (!in_box) return in_box.status();
  Affine user_from_tile;
  if (*in_box) {
    const Result<Affine> user_from_box = user_from_bounds(input_, shape_, attributes_.paint());
    if (!user_from_box) return user_from_box.status();
    user_from_tile = *user_from_box;
  }
  Vec2 corner, size;
  const auto length = [&](const char* name, Axis axis, double& value) {
    const Result<double> read = attributes_.length(name, *in_box, viewport_, axis, 0);
    if (read) value = *read;
    return read.status();
  };
  Status status = length("x", Axis::x, corner.x);
  if (status) status = length("y", Axis::y, corner.y);
  if (status) status = length("width", Axis::x, size.x);
  if (status) status = length("height", Axis::y, size.y);
  if (!status) return status;
  if (!(size.x > 0 && size.y > 0)) {
    return input_.error(attributes_.paint(),
                        "the pattern's tile has no area; expected width and height above 0");
  }
  tile_ = {user_from_tile(corner), user_from_tile(corner + size)};
  return ok_status();
}

Status PatternReader::read_content() {
  if (const Element bearer = attributes_.bearer("viewBox")) {
    const Result<Box> box = parse_view_box(bearer.attribute("viewBox").value());
    if (!box) return input_.in(bearer, "viewBox", box.status());
    const Result<AspectRatio> ratio = aspect_ratio(attributes_.bearer("preserveAspectRatio"));
    if (ratio) pattern_from_content_ = fit(*box, tile_, *ratio);
    return ratio.status();
  }
  const Result<bool> in_box = attributes_.in_bounding_box("patternContentUnits", false);
  if (!in_box) return in_box.status();
  pattern_from_content_ = {1, 0, 0, 1, tile_.min.x, tile_.min.y};
  if (!*in_box) return ok_status();
  const Result<Affine> user_from_box = user_from_bounds(input_, shape_, attributes_.paint());
  if (!user_from_box) return user_from_box.status();
  pattern_from_content_.a = user_from_box->a;
  pattern_from_content_.d = user_from_box->d;
  return ok_status();
}

Result<AspectRatio> PatternReader::aspect_ratio(Element bearer) {
  if (!bearer || !bearer.attribute("preserveAspectRatio")) return AspectRatio{};
  Result<AspectRatio> ratio = parse_aspect_ratio(bearer.attribute("preserveAspectRatio").value());
  if (!ratio) return input_.in(bearer, "preserveAspectRatio", ratio.status());
  return ratio;
}

/// Sizes that are left out are the image's own; one of them keeps its shape.
Status PatternReader::read_image_box(Box& box) {
  const Vec2 natural = texture_size();
  const auto is_auto = [this](const char* name) {
    return input_.attribute(image_, name).value_or("auto") == "auto";
  };
  const auto length = [this](const char* name, Axis axis, double& value) {
    const Result<double> read = length_of(input_, image_, name, viewport_, axis, value);
    if (read) value = *read;
    return read.status();
  };
  Vec2 corner, size;
  Status status = length("x", Axis::x, corner.x);
  if (status) status = length("y", Axis::y, corner.y);
  if (status && !is_auto("width")) status = length("width", Axis::x, size.x);
  if (status && !is_auto("height")) status = length("height", Axis::y, size.y);
  if (!status) return status;
  if (is_auto("width")) {
    size.x = is_auto("height") ? natural.x : size.y * natural.x / natural.y;
  }
  if (is_auto("height")) size.y = size.x * natural.y / natural.x;
  if (!(size.x > 0 && size.y > 0)) {
    return input_.error(image_, "the <image> has no area; expected width and height above 0");
  }
  box = {corner, corner + size};
  return ok_status();
}

Status PatternReader::read_image(Affine& content_from_texture) {
  Box box;
  if (Status status = read_image_box(box); !status) return status;
  const Result<AspectRatio> ratio = aspect_ratio(image_);
  if (!ratio) return ratio.status();
  const Result<Affine> transform =
      parse_transform(input_.context(), input_.attribute(image_, "transform").value_or(""));
  if (!transform) return input_.in(image_, "transform", transform.status());
  content_from_texture = *transform * fit({{0, 0}, texture_size()}, box, *ratio);
  return ok_status();
}

Status PatternReader::check_place(const Affine& pattern_from_texture) {
  if (pattern_from_texture.b != 0 || pattern_from_texture.c != 0 ||
      !(pattern_from_texture.a > 0 && pattern_from_texture.d > 0)) {
    return input_.error(image_,
                        "the <image> is turned or mirrored within its tile; expected "
                        "patternTransform on the pattern to do that");
  }
  const Box image{pattern_from_texture({0, 0}), pattern_from_texture(texture_size())};
  const Vec2 slack{kSameEdge * tile_.width(), kSameEdge * tile_.height()};
  if (image.min.x < tile_.min.x - slack.x || image.min.y < tile_.min.y - slack.y) {
    return input_.error(image_,
                        "the <image> begins outside of its tile; expected its upper left "
                        "corner at the tile's");
  }
  const bool begins_late =
      image.min.x > tile_.min.x + slack.x || image.min.y > tile_.min.y + slack.y;
  if (begins_late || image.max.x < tile_.max.x - slack.x || image.max.y < tile_.max.y - slack.y) {
    input_.warn("/tile", image_,
                "the <image> does not cover the pattern's tile; the colours at "
                "its edge are drawn on");
  }
  return ok_status();
}

}  // namespace

Result<PatternPlace> read_pattern(Input& input, TextureFiles& files,
                                  const PaintAttributes& attributes, const PaintedShape& shape,
                                  const Box& viewport) {
  return PatternReader(input, files, attributes, shape, viewport).read();
}

}  // namespace sfumato::svg
