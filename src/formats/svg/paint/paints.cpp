#include "formats/svg/paint/paints.hpp"

#include <algorithm>
#include <string>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "formats/svg/paint/gradient.hpp"
#include "formats/svg/paint/paint_attributes.hpp"
#include "formats/svg/paint/pattern.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

Paints::Key key_of(const void* paint, const Affine& map, Vec2 period = {}, bool repeats = true,
                   int width = 0, int height = 0) {
  return {paint, map.a,    map.b,    map.c,   map.d, map.e,
          map.f, period.x, period.y, repeats, width, height};
}

Paints::Key key_of(const void* paint, const TilePlace& place) {
  return key_of(paint, place.layer_from_texture,
                {place.texture_from_content.a, place.texture_from_content.d}, true, place.width,
                place.height);
}

}  // namespace

Result<std::uint32_t> Paints::shader(const PaintedShape& shape, std::string_view id) {
  SFUMATO_TRY_ASSIGN(const Element& paint, input_.element_of(shape.element, id));
  note_use(paint);
  const std::string_view name = paint.name();
  if (name == "linearGradient" || name == "radialGradient") return gradient(shape, paint);
  if (name == "pattern") return pattern(shape, paint);
  return input_.error(shape.element, tag(shape.element) + " is painted by #" +
                                         std::string(id).substr(0, 64) + ", which is a " +
                                         tag(paint) + "; use a linearGradient, a " +
                                         "radialGradient, or a pattern with one <image>");
}

/// The paint and the paints that it inherits from.
void Paints::note_use(Element paint) {
  while (used_.insert(paint.internal_object()).second) {
    if (!input_.attribute(paint, "href")) return;
    const Result<Element> parent = input_.referred(paint);
    if (!parent) return;
    paint = *parent;
  }
}

Result<std::uint32_t> Paints::gradient(const PaintedShape& shape, Element paint) {
  SFUMATO_TRY_ASSIGN(const PaintAttributes& attributes, PaintAttributes::read(input_, paint));
  SFUMATO_TRY_ASSIGN(const GradientFrame& frame, read_gradient_frame(input_, attributes, shape));
  const Vec2 viewport =
      frame.in_box ? Vec2{} : Vec2{shape.viewport.width(), shape.viewport.height()};
  const Key key = key_of(paint.internal_object(), frame.layer_from_gradient, viewport);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  SFUMATO_TRY_ASSIGN(
      auto&& fill, read_gradient(input_, totals_, attributes, frame, shape.viewport, last_stops_));
  return add(key, paint, {{}, std::move(fill)});
}

Result<std::uint32_t> Paints::pattern(const PaintedShape& shape, Element paint) {
  SFUMATO_TRY_ASSIGN(const PaintAttributes& attributes, PaintAttributes::read(input_, paint));
  if (vector_pattern_ && holds_vectors(attributes)) {
    return (this->*vector_pattern_)(shape, attributes);
  }
  SFUMATO_TRY_ASSIGN(const TexturePlace& place, read_pattern(input_, files_, attributes, shape));
  return texture(paint, place);
}

Result<std::uint32_t> Paints::vector_pattern(const PaintedShape& shape,
                                             const PaintAttributes& attributes) {
  const Element paint = attributes.paint();
  SFUMATO_TRY_ASSIGN(const auto& pattern, read_vector_pattern(input_, files_, attributes, shape));
  const auto side = static_cast<double>(std::max<std::size_t>(input_.limits().pattern_side, 1));
  TilePlace place;
  const double px = TileQueue::kTexelsPerPx * units_per_texel_;
  // Texels that are pixels are exact at the picture's own size; a coarser tile takes less room.
  const double finest = is_whole_in(pattern, px) ? px : units_per_texel_;
  for (const double units_per_texel : {finest, px}) {
    place = tile_place(pattern, units_per_texel, side);
    if (!is_usable(place.layer_from_texture) || !is_usable(place.pattern_from_texture)) {
      return input_.error(paint,
                          "the pattern's place cannot be computed; use sizes and "
                          "transforms of usual size");
    }
    const auto known = known_.find(key_of(paint.internal_object(), place));
    if (known != known_.end()) return known->second;
    if (has_room(place.texels())) break;
  }
  if (tiles_->is_around(pattern.content)) {
    return input_.error(paint, "the pattern " + hash_id(paint) + " is painted with itself");
  }
  SFUMATO_TRY(check_tiles(paint, place.texels()));
  if (place.is_coarse && tile_place(pattern, px, side).is_coarse) {
    input_.warn("/pattern side", paint,
                "the pattern " + hash_id(paint) + " is drawn more coarsely than the picture: " +
                    limit_text(input_.limits(), &Limits::pattern_side,
                               "texels are the limit for a side; raise the limit "
                               "pattern-side"));
  }
  return add_tile(paint, pattern.content, place);
}

Result<std::uint32_t> Paints::add_tile(Element paint, Element content, const TilePlace& place) {
  SFUMATO_TRY_ASSIGN(auto&& texture, empty_texture(paint, place.width, place.height,
                                                   place.layer_from_texture, true));
  Result<std::uint32_t> index =
      add(key_of(paint.internal_object(), place), paint, {{}, std::move(texture)});
  if (index) {
    input_.warn("/tile", paint,
                "the pattern " + hash_id(paint) + " becomes a texture of " +
                    std::to_string(place.width) + " x " + std::to_string(place.height) +
                    " texels, which is soft where the picture is enlarged");
    tiles_->add({content, place.texture_from_content, place.width, place.height, 0, *index});
  }
  return index;
}

bool Paints::has_room(std::size_t texels) const {
  const std::size_t most = input_.limits().pattern_texels;
  return texels <= most - std::min(most, tiles_->texels());
}

/// Whether the drawing may have one more tile. Errors: bad_input, which costs the paint alone.
Status Paints::check_tiles(Element paint, std::size_t texels) const {
  const Limits& limits = input_.limits();
  const auto over = [&](std::size_t Limits::*limit, std::string_view what, std::string_view name) {
    return input_.error(paint, "there are more than the limit of " +
                                   limit_text(limits, limit, what) + "; raise the limit " +
                                   std::string(name));
  };
  if (tiles_->depth() >= limits.pattern_depth) {
    return over(&Limits::pattern_depth, "patterns and masks within each other", "pattern-depth");
  }
  if (tiles_->requests().size() >= limits.pattern_tiles) {
    return over(&Limits::pattern_tiles, "tiles of patterns and masks", "pattern-tiles");
  }
  if (!has_room(texels)) {
    return over(&Limits::pattern_texels, "texels in tiles of patterns and masks", "pattern-texels");
  }
  return ok_status();
}

Result<Texture> Paints::empty_texture(Element bearer, int width, int height,
                                      const Affine& layer_from_texture, bool repeats) {
  const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Texture texture{width, height, {}, layer_from_texture, repeats, {}, {}};
  SFUMATO_TRY(totals_.count_texture(bearer, texels));
  SFUMATO_TRY(input_.placed(
      bearer, input_.memory().textures.resize(input_.context(), texture.rgba, 4 * texels)));
  return texture;
}

Result<std::uint32_t> Paints::clear_texture(Element bearer, const TexelGrid& grid) {
  SFUMATO_TRY_ASSIGN(auto&& texture, empty_texture(bearer, grid.width, grid.height,
                                                   grid.frame_from_texture, false));
  return push(bearer, {{}, std::move(texture)});
}

Result<std::uint32_t> Paints::texture(Element bearer, const TexturePlace& place) {
  const Key key = key_of(place.file, place.layer_from_texture, place.period, place.repeats);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const codecs::RgbaImage& image = place.file->image;
  Texture texture{image.width,   image.height, {}, place.layer_from_texture,
                  place.repeats, place.period, {}};
  const Context& context = input_.context();
  DocumentMemory& memory = input_.memory();
  SFUMATO_TRY(totals_.count_texture(bearer, image.rgba.size() / 4));
  Status status = memory.textures.append(context, image.rgba, texture.rgba);
  if (status) status = memory.texture_files.append(context, place.file->file, texture.file);
  if (!status) return input_.placed(bearer, std::move(status));
  return add(key, bearer, {{}, std::move(texture)});
}

Result<std::uint32_t> Paints::add(const Key& key, Element paint, Shader shader) {
  const Result<std::uint32_t> index = push(paint, std::move(shader));
  if (index) known_.emplace(key, *index);
  return index;
}

Result<std::uint32_t> Paints::push(Element paint, Shader shader) {
  shader.id = paint.attribute("id").value();
  const auto index = static_cast<std::uint32_t>(shaders_.size());
  SFUMATO_TRY(input_.push_back(paint, input_.memory().shaders, shaders_, std::move(shader)));
  return index;
}

}  // namespace sfumato::svg
