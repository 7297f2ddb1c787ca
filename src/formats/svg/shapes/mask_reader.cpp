#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/boxes.hpp"
#include "base/limit_error.hpp"
#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/paint/image_place.hpp"
#include "formats/svg/paint/plain_blur.hpp"
#include "formats/svg/paint/plain_image.hpp"
#include "formats/svg/read/plain_reader.hpp"
#include "formats/svg/read/sketch.hpp"
#include "formats/svg/shapes/element_transform.hpp"
#include "formats/svg/shapes/mask_content.hpp"
#include "formats/svg/shapes/plain_backdrop.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "formats/svg/style/vocabulary.hpp"
#include "sfumato/base/limits.hpp"

/// The part of PlainReader that reads masks of ordinary SVG.
namespace sfumato::svg {
namespace {

/// The default region of a mask reaches beyond the box by this share on each side.
constexpr double kRegionMargin = 0.1;

/// Masks in their places whose content is kept; others are read again.
constexpr std::size_t kKnownMasks = 4096;

bool has_extent(const Box& box) {
  return !box.empty() && box.width() > 0 && box.height() > 0;
}

bool is_near_origin(const Box& box) {
  return std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x),
                   std::abs(box.max.y)}) <= limits::kCoordinate;
}

/// Returns the text in a mask; null if there is none.
Element text_in(Element mask) {
  return mask.find_node([](Element element) { return std::string_view(element.name()) == "text"; });
}

/// The values of `mask-mode` after the url.
std::optional<std::string_view> mask_mode_of(std::string_view text, css::TextPoll& poll) {
  css::Tokenizer tokens(text, poll);
  if (next_solid(tokens).is(css::TokenType::end)) return "match-source";
  const std::string word = css::keyword_of(text, poll).value_or("");
  for (const std::string_view mode : {"alpha", "luminance", "match-source"}) {
    if (word == mode) return mode;
  }
  return std::nullopt;
}

}  // namespace

/// Returns the <mask> of the element's property; none after a warning where it cannot be read.
std::optional<PlainReader::NamedMask> PlainReader::mask_of(Element bearer) {
  const auto text = input_.property(bearer, css::Property::mask);
  if (!text || ascii_trimmed(*text).empty()) return std::nullopt;
  if (css::keyword_of(*text, input_.text_poll()) == "none") return std::nullopt;
  css::Tokenizer tokens(*text, input_.text_poll());
  const std::optional<std::string> url = css::take_url(tokens, css::next_solid(tokens));
  const auto mode =
      url ? mask_mode_of(text->substr(tokens.position()), input_.text_poll()) : std::nullopt;
  if (!mode || url->size() < 2 || url->front() != '#') {
    input_.warn("/mask", bearer, "mask of " + tag(bearer) + " is not read; use none or url(#id)");
    return std::nullopt;
  }
  const auto ignore = [&](const std::string& why) {
    input_.warn("/mask", bearer, "mask of " + tag(bearer) + " is ignored: " + why);
    return std::nullopt;
  };
  const Result<Element> target = input_.element_of(bearer, url->substr(1));
  if (!target) return ignore(target.status().message);
  if (std::string_view(target->name()) != "mask")
    return ignore(hash_id(*target) + " is not a <mask>");
  const bool is_active = std::ranges::find(active_, *target) != active_.end();
  if (is_active || (tiles_ && tiles_->is_around(*target))) {
    return ignore(hash_id(*target) + " masks itself");
  }
  const Limits& limits = input_.limits();
  if (active_.size() >= limits.pattern_depth) {
    return ignore("masks stand within each other, more than the limit of " +
                  limit_text(limits, &Limits::pattern_depth, "levels") +
                  "; raise the limit pattern-depth");
  }
  const std::string type = *mode == "match-source"
                               ? input_.keyword(*target, css::Property::mask_type)
                               : std::string(*mode);
  if (type == "alpha") return NamedMask{*target, TileUse::alpha_mask};
  const bool is_linear = input_.keyword(*target, css::Property::color_interpolation) == "linearrgb";
  if (is_linear) return NamedMask{*target, TileUse::linear_light_mask};
  const Result<bool> inverted = is_inverted_mask(input_, *target);
  const bool is_inverted = inverted && *inverted;
  return NamedMask{*target, is_inverted ? TileUse::inverted_mask : TileUse::luminance_mask};
}

/// Applies the masks of an ordinary element to its place.
Result<PlainReader::Masking> PlainReader::mask_to(Element element, Place& place) {
  Masking masking;
  if (!is_ordinary(place)) return masking;
  const auto outer = place.mask;
  SFUMATO_TRY(apply_masks(element, element, place, masking));
  masking.is_soft = place.mask != outer;
  return masking;
}

/// Returns whether the masks of a mask lead back to one that is being read.
bool PlainReader::goes_round(Element mask) {
  for (std::size_t i = 0; i < input_.limits().pattern_depth; ++i) {
    const auto text = input_.property(mask, css::Property::mask);
    const auto url = text ? css::url_of(*text, input_.text_poll()) : std::nullopt;
    if (!url || url->size() < 2) return false;
    const Result<Element> next = input_.element_of(mask, url->substr(1));
    if (!next) return false;
    if (std::ranges::find(active_, *next) != active_.end()) return true;
    mask = *next;
  }
  return false;
}

/// The mask of `bearer`, and the mask of that mask: they multiply.
Status PlainReader::apply_masks(Element bearer, Element target, Place& place, Masking& masking) {
  if (bearer != target && goes_round(bearer)) {
    input_.warn("/mask", bearer,
                "mask of " + tag(bearer) + " is ignored: " + hash_id(bearer) + " masks itself");
    return ok_status();
  }
  const std::optional<NamedMask> mask = mask_of(bearer);
  if (!mask) return ok_status();
  active_.push_back(mask->element);
  Status status = apply_mask(*mask, target, place, masking);
  if (!status && can_be_left_out(status)) {
    input_.warn("/mask", target, "mask of " + tag(target) + " is left out: " + status.message);
    status = ok_status();
  }
  if (status && !masking.hides) status = apply_masks(mask->element, target, place, masking);
  active_.pop_back();
  return status;
}

Status PlainReader::apply_mask(const NamedMask& mask, Element target, Place& place,
                               Masking& masking) {
  SFUMATO_TRY(input_.charge_reading(mask.element, "masks"));
  SFUMATO_TRY_ASSIGN(const MaskFrame& frame, mask_frame(mask.element, "maskUnits", target, place));
  masking.hides = !has_extent(frame.region);
  if (masking.hides) return ok_status();
  const Affine map = place.frame_from_user * frame.user_from_content;
  SFUMATO_TRY(check_map(mask.element, map));
  Result<MaskContent> content = read_mask(mask, map);
  if (content && content->is_drawn) {
    const Box region = mapped_box(place.frame_from_user, frame.region);
    content = draw_mask(mask, region, map);
  }
  SFUMATO_TRY(content);
  masking.hides = content->opacity == 0;
  if (masking.hides) return ok_status();
  place.own_opacity *= content->opacity;
  for (const std::uint32_t shader : content->shaders) {
    const auto index = static_cast<std::uint32_t>(plain_.masks.size());
    SFUMATO_TRY(input_.push_back(target, input_.memory().shapes, plain_.masks,
                                 PlainMask{shader, place.mask}));
    place.mask = index;
  }
  SFUMATO_TRY_ASSIGN(place.clip, clips_.add_box(mask.element, frame.region, place.frame_from_user,
                                                place.clip, content->clip));
  return ok_status();
}

/// Returns the box of the masked element, in its user space.
Result<Box> PlainReader::masked_box(Element target, const Place& place) {
  if (std::string_view(target.name()) == "image") {
    SFUMATO_TRY_ASSIGN(const TextureFile* file, paints_.files().find(target));
    return read_image_box(input_, target, viewport_in(place), file->size());
  }
  Result<Box> box = content_box(input_, target, viewport_in(place));
  if (!box || std::string_view(target.name()) != "symbol") return box;
  SFUMATO_TRY_ASSIGN(const Viewport& viewport, viewport_of(target, place));
  return mapped_box(viewport.user_from_view, *box);
}

/// Returns the region of the mask, and the frame of its content, for the element that has it.
Result<PlainReader::MaskFrame> PlainReader::mask_frame(Element mask, const char* units,
                                                       Element target, const Place& place) {
  const bool in_box = input_.attribute(mask, units).value_or("") != "userSpaceOnUse";
  const bool content_in_box =
      input_.attribute(mask, "maskContentUnits").value_or("") == "objectBoundingBox";
  Affine user_from_box;
  if (in_box || content_in_box) {
    SFUMATO_TRY_ASSIGN(const Box& box, masked_box(target, place));
    if (!has_extent(box)) return MaskFrame{};
    user_from_box = {box.width(), 0, 0, box.height(), box.min.x, box.min.y};
  }
  const Box unit = in_box ? Box{{0, 0}, {1, 1}} : viewport_in(place);
  const auto length = [&](const char* name, Axis axis, double share) {
    return length_of(input_, mask, name, unit, axis, share * extent(unit, axis));
  };
  const Result<double> x = length("x", Axis::x, -kRegionMargin);
  const Result<double> y = length("y", Axis::y, -kRegionMargin);
  const Result<double> width = length("width", Axis::x, 1 + 2 * kRegionMargin);
  const Result<double> height = length("height", Axis::y, 1 + 2 * kRegionMargin);
  for (const Result<double>* each : {&x, &y, &width, &height}) {
    if (!*each) return each->status();
  }
  MaskFrame frame;
  frame.region = {{*x, *y}, {*x + *width, *y + *height}};
  if (in_box) frame.region = {user_from_box(frame.region.min), user_from_box(frame.region.max)};
  if (content_in_box) frame.user_from_content = user_from_box;
  return frame;
}

/// Returns whether the filter of an ordinary element is drawn.
bool PlainReader::reads_filter(Element element, const Place& place) {
  if (is_shape(element.name())) return gaussian_blur(input_, element).has_value();
  if (!is_ordinary(place) || std::string_view(element.name()) != "g") return false;
  const auto backdrop = backdrop_filter(input_, element);
  if (!backdrop || !*backdrop) return false;
  if ((*backdrop)->kind != BackdropFilter::Kind::inverted) return true;
  const Element mask = element.parent();
  if (std::string_view(mask.name()) != "mask") return false;
  const Result<bool> inverted = is_inverted_mask(input_, mask);
  return inverted && *inverted;
}

/// The colour over which the filter of a group lays it, in the region of the filter.
Status PlainReader::open_inside(Element element, Place& place) {
  if (!is_ordinary(place) || std::string_view(element.name()) != "g") return ok_status();
  const auto backdrop = backdrop_filter(input_, element);
  if (!backdrop) return input_.leave_out(element, backdrop.status());
  if (!*backdrop || (*backdrop)->kind != BackdropFilter::Kind::flood) return ok_status();
  may_be_background_ = false;
  const Result<MaskFrame> frame = mask_frame((*backdrop)->filter, "filterUnits", element, place);
  if (!frame) return input_.leave_out(element, frame.status());
  SFUMATO_TRY_ASSIGN(const auto& clip,
                     clips_.add_box(element, frame->region, place.frame_from_user, place.clip));
  place.clip = clip;
  const css::Color& color = (*backdrop)->color;
  if (!has_extent(frame->region) || color.alpha <= 0) return ok_status();
  TableMemory memory("control points");
  const auto outline = box_outline(input_.context(), frame->region, memory);
  if (!outline) return input_.placed(element, outline.status());
  PlainShape shape;
  shape.offset = input_.offset(element);
  shape.artboard_from_user = place.frame_from_user;
  shape.clip = place.clip;
  shape.mask = place.mask;
  shape.fill = PlainPaint{color.color, 0, color.alpha};
  TableMemory kept("shapes");
  SFUMATO_TRY(keep_subpaths(element, *outline, kept, shape.subpaths));
  SFUMATO_TRY(add_plain_layer(element, shape.fill, shape.fill_layer));
  SFUMATO_TRY(input_.push_back(element, input_.memory().shapes, plain_.shapes, std::move(shape)));
  input_.memory().shapes.take(std::move(kept));
  return ok_status();
}

/// Reads the content of a mask unless it is known already.
Result<MaskContent> PlainReader::read_mask(const NamedMask& mask, const Affine& map) {
  const MaskKey key{
      mask.element.internal_object(), mask.use, map.a, map.b, map.c, map.d, map.e, map.f};
  if (const auto known = known_masks_.find(key); known != known_masks_.end()) return known->second;
  if (const Element text = text_in(mask.element)) {
    return input_.error(
        text, hash_id(mask.element) + " holds " + tag(text) + "; use paths, shapes and images");
  }
  Sketch sketch;
  TileRequest request{mask.element, map};
  request.use = mask.use;
  SFUMATO_TRY(read_sketch(request, sketch));
  MaskContent content;
  content.is_drawn = sketch.needs_tiles;
  if (!content.is_drawn) {
    SFUMATO_TRY_ASSIGN(content, mask_content(input_, mask.element, mask.use, sketch.document,
                                             sketch.content, plain_));
  }
  if (content.is_drawn) forget(sketch);
  if (known_masks_.size() < kKnownMasks) known_masks_.emplace(key, content);
  return content;
}

/// Reads content separately. Its clips and masks stay in the drawing's lists until they are
/// removed.
Status PlainReader::read_sketch(const TileRequest& request, Sketch& sketch) {
  sketch.document.artboard = document_.artboard;
  sketch.document.interpolation = document_.interpolation;
  sketch.clips = plain_.clips.size();
  sketch.mask_shaders = plain_.mask_shaders.size();
  sketch.masks = plain_.masks.size();
  const auto exchange = [&] {
    std::swap(sketch.content.clips, plain_.clips);
    std::swap(sketch.content.mask_shaders, plain_.mask_shaders);
    std::swap(sketch.content.masks, plain_.masks);
  };
  exchange();
  TileQueue queue;
  PlainReader reader(input_, sketch.document, loader_, sketch.content);
  reader.use_tiles(queue, units_per_texel_);
  reader.visible_ = visible_;
  reader.is_sketch_ = true;
  reader.active_ = active_;
  Status status = reader.read_tile(request);
  exchange();
  sketch.needs_tiles = !queue.requests().empty();
  return status;
}

void PlainReader::forget(const Sketch& sketch) {
  plain_.clips.resize(sketch.clips);
  plain_.mask_shaders.resize(sketch.mask_shaders);
  plain_.masks.resize(sketch.masks);
}

/// Returns the texels for a box of the artboard's frame, as far as it is seen.
TexelGrid PlainReader::grid_over(const Box& box) const {
  const Vec2 origin = visible_.empty() ? Vec2{} : visible_.min;
  const auto side = static_cast<int>(std::max<std::size_t>(input_.limits().pattern_side, 1));
  const TexelGrid grid = texel_grid(box, origin, units_per_texel_, side);
  if (!tiles_ || paints_.has_room(grid.count())) return grid;
  return texel_grid(box, origin, TileQueue::kTexelsPerPx * units_per_texel_, side);
}

/// Why no tile can be drawn of the content; empty: it can.
std::string PlainReader::why_no_tile(Element content, const TexelGrid& grid) const {
  if (!tiles_) return "nothing draws it here; the command does";
  if (tiles_->is_around(content)) return "it is within itself";
  return paints_.check_tiles(content, grid.count()).message;
}

/// A mask that is one texture of its content.
/// region   artboard frame
Result<MaskContent> PlainReader::draw_mask(const NamedMask& mask, Box region, const Affine& map) {
  if (!visible_.empty()) region = intersection(region, visible_);
  MaskContent content;
  if (!has_extent(region)) {
    content.opacity = 0;
    return content;
  }
  if (!is_near_origin(region)) {
    return input_.error(mask.element,
                        tag(mask.element) + " reaches too far; use coordinates of the usual size");
  }
  const TexelGrid grid = grid_over(region);
  if (const std::string why = why_no_tile(mask.element, grid); !why.empty()) {
    return input_.error(mask.element, "the content of " + hash_id(mask.element) +
                                          " is more than flat shapes or one paint, and " + why);
  }
  Result<Texture> texture =
      paints_.empty_texture(mask.element, grid.width, grid.height, grid.frame_from_texture, false);
  SFUMATO_TRY(texture);
  const auto index = static_cast<std::uint32_t>(plain_.mask_shaders.size());
  SFUMATO_TRY(input_.push_back(mask.element, input_.memory().shaders, plain_.mask_shaders,
                               Shader{mask.element.attribute("id").value(), *std::move(texture)}));
  TileRequest request{
      mask.element, inverse(grid.frame_from_texture) * map, grid.width, grid.height, 0, index};
  request.use = mask.use;
  tiles_->add(std::move(request));
  content.shaders.push_back(index);
  return content;
}

/// Parts of a masked group that overlap would show through each other if each were masked. Such a
/// group becomes a rectangle with a texture. False: nothing overlaps, or it cannot be drawn.
Result<bool> PlainReader::draw_as_one(Element element, const Place& place) {
  if (is_sketch_) return false;
  TileRequest request{element, place.frame_from_user};
  request.is_masked = true;
  request.around = elements_around(open_.size());
  request.instance = place.use;
  Sketch sketch;
  Status status = read_sketch(request, sketch);
  forget(sketch);
  if (!status) return status;
  Box box;
  const Result<SketchedParts> parts = parts_of(input_.context(), sketch.document, sketch.content);
  if (!parts) return input_.placed(element, parts.status());
  SFUMATO_TRY_ASSIGN(const bool apart, are_apart(input_.context(), *parts, box));
  if (!visible_.empty()) box = intersection(box, visible_);
  if (apart || !has_extent(box) || !is_near_origin(box)) return false;
  const TexelGrid grid = grid_over(box);
  std::string why = why_no_tile(element, grid);
  if (marker_) why = "it is in a marker";
  if (element == input_.root()) why = "it is the whole picture";
  if (sketch.content.shapes.size() > input_.limits().pattern_shapes / 2) {
    why = "it has more shapes than half the limit pattern-shapes";
  }
  if (!why.empty()) {
    input_.warn("/masked as one", element,
                "mask of " + tag(element) +
                    ": parts that overlap show through each other where the mask is not opaque; "
                    "they are masked one by one: " +
                    why);
    return false;
  }
  status = add_tile_shape(element, place, grid, std::move(request));
  if (!status) return status;
  return true;
}

Status PlainReader::add_tile_shape(Element element, const Place& place, const TexelGrid& grid,
                                   TileRequest request) {
  may_be_background_ = false;
  SFUMATO_TRY_ASSIGN(const std::uint32_t shader, paints_.clear_texture(element, grid));
  request.texture_from_content = inverse(grid.frame_from_texture) * place.frame_from_user;
  request.width = grid.width;
  request.height = grid.height;
  request.shader = shader;
  tiles_->add(std::move(request));
  TableMemory memory("control points");
  const auto outline = box_outline(input_.context(), grid.box(), memory);
  if (!outline) return input_.placed(element, outline.status());
  PlainShape shape;
  shape.id = id_for(element, place);
  shape.offset = input_.offset(element);
  shape.clip = place.clip;
  shape.mask = place.mask;
  shape.fill = PlainPaint{std::nullopt, shader, 1};
  return keep_plain(element, place, std::move(shape), *outline, css::kNormalPaintOrder, {});
}

/// Reads the children of a pattern or a mask, or a masked element.
Status PlainReader::read_tile(const TileRequest& request) {
  may_be_background_ = false;
  Place place;
  place.frame_from_user = request.texture_from_content;
  place.is_copy = true;
  Status status;
  if (request.is_masked) {
    around_ = request.around;
    bare_ = request.content;
    place.use = request.instance;
    status = visit_known(request.content, place);
  } else {
    for (Element at = request.content.parent(); at.type() == pugi::node_element; at = at.parent()) {
      around_.insert(around_.begin(), at);
    }
    if (request.use != TileUse::paint) {
      const std::string visibility = input_.keyword(request.content, css::Property::visibility);
      place.is_visible = visibility.empty() || visibility == "visible";
    }
    open_children(request.content, place, std::nullopt);
  }
  if (status) status = visit_open(0);
  document_.shaders = paints_.take();
  return status;
}

}  // namespace sfumato::svg
