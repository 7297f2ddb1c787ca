#pragma once

#include <map>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "formats/svg/paint/texel_grid.hpp"
#include "formats/svg/paint/texture_files.hpp"
#include "formats/svg/paint/tile_queue.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/read/totals.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/document/shader.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::svg {

class PaintAttributes;
struct TilePlace;

/// The shape that a paint is for.
struct PaintedShape {
  Element element;  ///< named in errors of the paint that concern the shape
  Affine layer_from_user;
  Box bounds;    ///< user space; used for objectBoundingBox
  Box viewport;  ///< for percentages of userSpaceOnUse
};

/// The stops of the gradient that was read last, kept because one gradient becomes many for the
/// bounding boxes of many shapes.
struct GradientStops {
  Element parent;  ///< null: none yet
  TableMemory memory{"stops"};
  std::vector<GradientStop> stops{};
};

/// Turns paint servers into shaders of the document. All shapes that use the same paint in the same
/// place share one shader.
class Paints {
 public:
  /// The paint, its frame, the period of its texture (of a tile the scale of its content, of a
  /// gradient in user space the size of the viewport), whether it repeats, and the texels of a
  /// tile.
  using Key = std::tuple<const void*, double, double, double, double, double, double, double,
                         double, bool, int, int>;

  Paints(Input& input, Totals& totals, const ResourceLoader* loader)
      : input_(input), totals_(totals), files_(input, loader) {}

  /// Returns the index of the shader for url(#id). Errors: bad_input, limit.
  Result<std::uint32_t> shader(const PaintedShape& shape, std::string_view id);

  /// Returns the index of a shader that shows an image. `bearer`: its element. Errors: limit.
  Result<std::uint32_t> texture(Element bearer, const TexturePlace& place);

  /// Adds a separate, still clear texture and returns its index. Errors: limit.
  Result<std::uint32_t> clear_texture(Element bearer, const TexelGrid& grid);
  /// Returns a clear texture, counted with the others. Errors: limit.
  Result<Texture> empty_texture(Element bearer, int width, int height,
                                const Affine& layer_from_texture, bool repeats);

  /// Returns whether this many more texels are within the limit.
  bool has_room(std::size_t texels) const;
  /// Whether the queue has room for one more tile, which use_tiles() has set. Errors: bad_input.
  Status check_tiles(Element paint, std::size_t texels) const;

  TextureFiles& files() { return files_; }

  /// From now on patterns of vector content are textures, clear as yet, and wait in the queue.
  /// units_per_texel   of the layer's frame
  void use_tiles(TileQueue& tiles, double units_per_texel) {
    tiles_ = &tiles;
    units_per_texel_ = units_per_texel;
    vector_pattern_ = &Paints::vector_pattern;
  }

  /// Returns whether a curve refers to the paint, directly or through another paint's href.
  bool is_used(Element paint) const { return used_.contains(paint.internal_object()); }

  std::vector<Shader> take() { return std::move(shaders_); }

 private:
  void note_use(Element paint);
  Result<std::uint32_t> gradient(const PaintedShape& shape, Element paint);
  Result<std::uint32_t> pattern(const PaintedShape& shape, Element paint);
  Result<std::uint32_t> vector_pattern(const PaintedShape& shape,
                                       const PaintAttributes& attributes);
  Result<std::uint32_t> add_tile(Element paint, Element content, const TilePlace& place);
  Result<std::uint32_t> add(const Key& key, Element paint, Shader shader);
  Result<std::uint32_t> push(Element paint, Shader shader);

  Input& input_;
  Totals& totals_;
  TextureFiles files_;
  std::vector<Shader> shaders_;
  std::map<Key, std::uint32_t> known_;
  std::unordered_set<const void*> used_;
  GradientStops last_stops_;
  TileQueue* tiles_ = nullptr;
  /// vector_pattern() once there are tiles: programs without tiles hold no code for it.
  Result<std::uint32_t> (Paints::*vector_pattern_)(const PaintedShape&,
                                                   const PaintAttributes&) = nullptr;
  double units_per_texel_ = 1;
};

}  // namespace sfumato::svg
