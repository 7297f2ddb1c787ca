#include "formats/svg/paint/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/try.hpp"
#include "formats/svg/paint/image_place.hpp"
#include "formats/svg/shapes/transform.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// A share of a tile's size: nearer edges count as equal.
constexpr double kSameEdge = 1e-6;

class PatternReader {
 public:
  PatternReader(Input& input, TextureFiles& files, const PaintAttributes& attributes,
                const PaintedShape& shape)
      : input_(input), files_(files), attributes_(attributes), shape_(shape) {}

  Result<TexturePlace> read();
  Result<VectorPattern> read_vectors();

 private:
  Status find_image();
  Status read_tile();
  Status read_content();
  Status read_image(Affine& content_from_texture);
  Status check_place(const Affine& pattern_from_texture);
  Status read_repeats();

  Input& input_;
  TextureFiles& files_;
  const PaintAttributes& attributes_;
  const PaintedShape& shape_;
  Element image_;
  Box tile_;  ///< pattern frame: the user space before patternTransform
  Affine pattern_from_content_;
  TexturePlace place_;
};

bool is_description(std::string_view name) {
  return name == "title" || name == "desc" || name == "metadata";
}

/// Returns the elements that a pattern paints.
std::vector<Element> painted(Element pattern) {
  std::vector<Element> elements;
  for (const Element child : pattern.children()) {
    if (child.type() != pugi::node_element || is_description(child.name())) continue;
    elements.push_back(child);
    if (elements.size() == 2) break;
  }
  return elements;
}

/// Returns the pattern of the chain that has the content; null: none has.
Element content_of(const PaintAttributes& attributes) {
  return attributes.first_with([](Element paint) { return !painted(paint).empty(); });
}

Result<TexturePlace> PatternReader::read() {
  SFUMATO_TRY_ASSIGN(const Affine& transform,
                     attributes_.transform("patternTransform", shape_.viewport));
  Affine content_from_texture;
  SFUMATO_TRY(find_image());
  SFUMATO_TRY(read_tile());
  SFUMATO_TRY(read_content());
  SFUMATO_TRY(read_image(content_from_texture));
  const Affine pattern_from_texture = pattern_from_content_ * content_from_texture;
  SFUMATO_TRY(check_place(pattern_from_texture));
  place_.layer_from_texture = shape_.layer_from_user * transform * pattern_from_texture;
  if (!is_usable(place_.layer_from_texture)) {
    return input_.error(attributes_.paint(),
                        "the pattern's place cannot be computed; use a "
                        "transform that can be inverted, of usual size");
  }
  place_.period = {tile_.width() / pattern_from_texture.a, tile_.height() / pattern_from_texture.d};
  const auto is_period = [](double texels) { return texels > 0 && texels <= limits::kCoordinate; };
  if (!is_period(place_.period.x) || !is_period(place_.period.y)) {
    return input_.error(attributes_.paint(),
                        "the pattern's tile is too large or too small for its "
                        "<image>; use sizes of one kind");
  }
  const Vec2 size = place_.file->size();
  if (std::abs(place_.period.x - size.x) <= kSameEdge * size.x &&
      std::abs(place_.period.y - size.y) <= kSameEdge * size.y) {
    place_.period = {};
  }
  SFUMATO_TRY(read_repeats());
  return place_;
}

Result<VectorPattern> PatternReader::read_vectors() {
  SFUMATO_TRY_ASSIGN(const Affine& transform,
                     attributes_.transform("patternTransform", shape_.viewport));
  SFUMATO_TRY(read_tile());
  SFUMATO_TRY(read_content());
  return VectorPattern{content_of(attributes_), tile_, pattern_from_content_,
                       shape_.layer_from_user * transform};
}

Status PatternReader::read_repeats() {
  const std::string_view repeats = input_.sf(attributes_.paint(), "repeats").value_or("true");
  if (repeats != "true" && repeats != "false") {
    return input_.error(attributes_.paint(), "sf:repeats of <pattern> is " + text::quoted(repeats) +
                                                 "; use true or false");
  }
  place_.repeats = repeats == "true";
  if (!place_.repeats) place_.period = {};
  return ok_status();
}

Status PatternReader::find_image() {
  const Element pattern = content_of(attributes_);
  const std::vector<Element> content = pattern ? painted(pattern) : std::vector<Element>();
  if (content.size() != 1 || std::string_view(content.front().name()) != "image") {
    return input_.error(pattern ? pattern : attributes_.paint(),
                        "the pattern holds something else; use exactly one <image>");
  }
  image_ = content.front();
  SFUMATO_TRY_ASSIGN(place_.file, files_.find(image_));
  return ok_status();
}

Status PatternReader::read_tile() {
  SFUMATO_TRY_ASSIGN(const bool in_box, attributes_.in_bounding_box("patternUnits", true));
  Affine user_from_tile;
  if (in_box) {
    SFUMATO_TRY_ASSIGN(const Affine& user_from_box,
                       user_from_bounds(input_, shape_, attributes_.paint()));
    user_from_tile = user_from_box;
  }
  Vec2 corner, size;
  const auto length = [&](const char* name, Axis axis, double& value) -> Status {
    SFUMATO_TRY_ASSIGN(value, attributes_.length(name, in_box, shape_.viewport, axis, 0));
    return ok_status();
  };
  SFUMATO_TRY(length("x", Axis::x, corner.x));
  SFUMATO_TRY(length("y", Axis::y, corner.y));
  SFUMATO_TRY(length("width", Axis::x, size.x));
  SFUMATO_TRY(length("height", Axis::y, size.y));
  if (!(size.x > 0 && size.y > 0)) {
    return input_.error(attributes_.paint(),
                        "the pattern's tile has no area; use width and height above 0");
  }
  tile_ = {user_from_tile(corner), user_from_tile(corner + size)};
  return ok_status();
}

Status PatternReader::read_content() {
  if (const Element bearer = attributes_.bearer("viewBox")) {
    const Result<Box> box = parse_view_box(bearer.attribute("viewBox").value());
    if (!box) return input_.in(bearer, "viewBox", box.status());
    SFUMATO_TRY_ASSIGN(const AspectRatio& ratio,
                       read_aspect_ratio(input_, attributes_.bearer("preserveAspectRatio")));
    pattern_from_content_ = fit(*box, tile_, ratio);
    return ok_status();
  }
  SFUMATO_TRY_ASSIGN(const bool in_box, attributes_.in_bounding_box("patternContentUnits", false));
  pattern_from_content_ = {1, 0, 0, 1, tile_.min.x, tile_.min.y};
  if (!in_box) return ok_status();
  SFUMATO_TRY_ASSIGN(const Affine& user_from_box,
                     user_from_bounds(input_, shape_, attributes_.paint()));
  pattern_from_content_.a = user_from_box.a;
  pattern_from_content_.d = user_from_box.d;
  return ok_status();
}

Status PatternReader::read_image(Affine& content_from_texture) {
  const Vec2 natural = place_.file->size();
  SFUMATO_TRY_ASSIGN(const Box& box, read_image_box(input_, image_, shape_.viewport, natural));
  if (!(box.width() > 0 && box.height() > 0)) {
    return input_.error(image_, "the <image> has no area; use width and height above 0");
  }
  SFUMATO_TRY_ASSIGN(const AspectRatio& ratio, read_aspect_ratio(input_, image_));
  const Result<Affine> transform =
      parse_transform(input_.context(), input_.attribute(image_, "transform").value_or(""));
  if (!transform) return input_.in(image_, "transform", transform.status());
  content_from_texture = *transform * fit({{0, 0}, natural}, box, ratio);
  return ok_status();
}

Status PatternReader::check_place(const Affine& pattern_from_texture) {
  if (pattern_from_texture.b != 0 || pattern_from_texture.c != 0 ||
      !(pattern_from_texture.a > 0 && pattern_from_texture.d > 0)) {
    return input_.error(image_,
                        "the <image> is turned or mirrored within its tile; use "
                        "patternTransform on the pattern to do that");
  }
  const Box image{pattern_from_texture({0, 0}), pattern_from_texture(place_.file->size())};
  const Vec2 slack{kSameEdge * tile_.width(), kSameEdge * tile_.height()};
  if (image.min.x < tile_.min.x - slack.x || image.min.y < tile_.min.y - slack.y) {
    return input_.error(image_,
                        "the <image> begins outside of its tile; use its upper left "
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

/// Texels for a length along an axis, `side` at most.
int texels_along(Vec2 axis, double size, double side, TilePlace& place) {
  const double texels = std::max(std::round(length(axis) * size), 1.0);
  if (texels > side) place.is_coarse = true;
  return static_cast<int>(std::min(texels, side));
}

}  // namespace

bool is_whole_in(const VectorPattern& pattern, double units_per_texel) {
  constexpr double kWholeSlack = 1e-6;
  const Affine& map = pattern.layer_from_pattern;
  const auto is_whole = [units_per_texel](double size) {
    const double texels = std::abs(size) / units_per_texel;
    return texels >= 1 - kWholeSlack && std::abs(texels - std::round(texels)) < kWholeSlack;
  };
  return map.b == 0 && map.c == 0 && is_whole(map.a * pattern.tile.width()) &&
         is_whole(map.d * pattern.tile.height());
}

TilePlace tile_place(const VectorPattern& pattern, double units_per_texel, double side) {
  const Affine& map = pattern.layer_from_pattern;
  const Box& tile = pattern.tile;
  TilePlace place;
  place.width = texels_along({map.a, map.b}, tile.width() / units_per_texel, side, place);
  place.height = texels_along({map.c, map.d}, tile.height() / units_per_texel, side, place);
  place.pattern_from_texture = {tile.width() / place.width,   0,          0,
                                tile.height() / place.height, tile.min.x, tile.min.y};
  place.layer_from_texture = map * place.pattern_from_texture;
  place.texture_from_content = inverse(place.pattern_from_texture) * pattern.pattern_from_content;
  return place;
}

bool holds_vectors(const PaintAttributes& attributes) {
  const Element pattern = content_of(attributes);
  if (!pattern) return false;
  const std::vector<Element> content = painted(pattern);
  return content.size() != 1 || std::string_view(content.front().name()) != "image";
}

Result<VectorPattern> read_vector_pattern(Input& input, TextureFiles& files,
                                          const PaintAttributes& attributes,
                                          const PaintedShape& shape) {
  return PatternReader(input, files, attributes, shape).read_vectors();
}

Result<TexturePlace> read_pattern(Input& input, TextureFiles& files,
                                  const PaintAttributes& attributes, const PaintedShape& shape) {
  return PatternReader(input, files, attributes, shape).read();
}

}  // namespace sfumato::svg
