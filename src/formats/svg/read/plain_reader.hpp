#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "formats/svg/paint/tile_queue.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "formats/svg/read/stack_reader.hpp"
#include "formats/svg/shapes/clip_paths.hpp"
#include "formats/svg/shapes/drawn_marker.hpp"
#include "formats/svg/shapes/marker.hpp"
#include "formats/svg/shapes/mask_content.hpp"
#include "formats/svg/shapes/path.hpp"
#include "formats/svg/style/plain_style.hpp"
#include "formats/svg/style/style_levels.hpp"

namespace sfumato::svg {

/// Reads ordinary SVG, and layers of Sfumato's own attributes as well. Faulty elements are left
/// out.
class PlainReader final : private StackReader {
 public:
  /// As StackReader; `plain` receives the shapes and clips of ordinary SVG.
  PlainReader(Input& input, Document& document, const ResourceLoader* loader, PlainContent& plain)
      : StackReader(input, document, loader),
        loader_(loader),
        plain_(plain),
        clips_(input, document.artboard, plain.clips),
        levels_(input) {}

  /// No <rect> becomes the background: the artboard is not known yet.
  void expect_no_background() { may_be_background_ = false; }
  /// Patterns of vector content, and masks and masked groups that need it, become textures.
  void use_tiles(TileQueue& tiles, double units_per_texel) {
    tiles_ = &tiles;
    units_per_texel_ = units_per_texel;
    paints_.use_tiles(tiles, units_per_texel);
  }
  /// Textures of masks cover no more than this.
  void expect_picture(const Box& visible) { visible_ = visible; }
  /// The transform of the root.
  void place_root(const Affine& artboard_from_root) { artboard_from_root_ = artboard_from_root; }
  /// Paints a box of the artboard below all else.
  Status paint_backdrop(const Box& box, const PlainPaint& paint);
  /// Errors: bad_input, limit, out_of_memory.
  Status read();
  /// Reads the content of a tile instead of the drawing.
  Status read_tile(const TileRequest& request);

 private:
  /// The markers of a shape, and the data of the shape that they need.
  struct ShapeMarkers {
    std::array<std::optional<Marker>, 3> marker{};  ///< of its first vertex, others, the last one
    bool any = false;
    std::span<const Subpath> subpaths{};
    double stroke_width = 1;
    ContextPaints context{};
  };

  /// A mask, and how its content is an opacity.
  struct NamedMask {
    Element element;
    TileUse use = TileUse::luminance_mask;
  };

  /// Where a mask lies.
  struct MaskFrame {
    Box region{};  ///< user space of the masked element; empty: nothing is seen
    Affine user_from_content{};
  };

  /// The effect of the masks of an element.
  struct Masking {
    bool hides = false;    ///< nothing of the element is seen
    bool is_soft = false;  ///< its opacity varies
  };

  /// Content that is read before its use is known.
  struct Sketch {
    Document document{};
    PlainContent content{};
    bool needs_tiles = false;
    std::size_t clips = 0, mask_shaders = 0, masks = 0;  ///< of the drawing, before
  };

  using MaskKey = std::tuple<const void*, TileUse, double, double, double, double, double, double>;

  bool is_ordinary(const Place& place) const override { return !place.layer; }
  bool is_shown(Element element, const Place& place) override;
  Status visit_child(Element child, OpenElement& parent) override;
  Status visit_known(Element element, const Place& place) override;
  Status visit_bare(Element element, const Place& place) override;
  Result<Affine> own_transform(Element element, const Place& place) override;
  Status visit_effects(Element element, Place place) override;
  Status open_inside(Element element, Place& place) override;
  bool is_bare(Element element) const override { return bare_ && element == bare_; }
  Status clip_to_box(Element element, const Box& box, Place& place) override;
  Status leave_out(Element element, const Place& place, Status status) override;

  bool is_root_drawn();
  std::optional<NamedMask> mask_of(Element bearer);
  bool goes_round(Element mask);
  Result<Masking> mask_to(Element element, Place& place);
  Status apply_masks(Element bearer, Element target, Place& place, Masking& masking);
  Status apply_mask(const NamedMask& mask, Element target, Place& place, Masking& masking);
  Result<MaskFrame> mask_frame(Element mask, const char* units, Element target, const Place& place);
  bool reads_filter(Element element, const Place& place);
  Result<Box> masked_box(Element target, const Place& place);
  Result<MaskContent> read_mask(const NamedMask& mask, const Affine& map);
  Status read_sketch(const TileRequest& request, Sketch& sketch);
  void forget(const Sketch& sketch);
  TexelGrid grid_over(const Box& box) const;
  std::string why_no_tile(Element content, const TexelGrid& grid) const;
  Result<MaskContent> draw_mask(const NamedMask& mask, Box region, const Affine& map);
  Result<bool> draw_as_one(Element element, const Place& place);
  Status add_tile_shape(Element element, const Place& place, const TexelGrid& grid,
                        TileRequest request);
  Status clip_to(Element element, Place& place);
  Status visit_switch(Element element, const Place& place);
  Status visit_plain(Element element, const Place& place);
  Status read_plain(Element element, const Place& place);
  Status visit_image(Element element, const Place& place);
  Status read_image(Element element, const Place& place);
  void read_blur(const PaintedShape& painted, PlainShape& shape, bool has_markers);
  Status keep_subpaths(Element element, std::span<const Subpath> subpaths, TableMemory& memory,
                       std::vector<std::vector<Vec2>>& kept);
  Status note_open_loops(Element element, std::span<const Subpath> subpaths, StrokeStyle& style);
  Status keep_plain(Element element, const Place& place, PlainShape shape,
                    std::span<const Subpath> subpaths, const css::PaintOrder& order,
                    const ShapeMarkers& markers);
  Result<ShapeMarkers> read_markers(PlainStyle& style, const PaintedShape& shape,
                                    std::span<const Subpath> subpaths);
  std::vector<Element> elements_around(std::size_t open_end) const;
  Result<std::optional<ContextPaints>> context_around(std::size_t open_end);
  Result<ContextPaints> paints_of_use(std::size_t open_index);
  PlainShape unpainted(Element element, const Place& place);
  Result<ClipPaths::Index> clip_to_markers(const PlainShape& shape, const Box& box);
  Status add_plain(Element element, const Place& place, PlainShape shape,
                   const css::PaintOrder& order, const ShapeMarkers& markers);
  Status add_part(css::PaintPart part, Element element, const Place& place, PlainShape& shape,
                  const ShapeMarkers& markers);
  Status add_plain_layer(Element element, const std::optional<PlainPaint>& paint,
                         std::uint32_t& layer);
  Result<std::optional<Marker>> marker_of(Element element, css::Property which,
                                          const PlainStyle& style);
  Result<ShapeMarkers> markers_of(Element element, const PlainStyle& style);
  bool take_markers(Element element, std::size_t count);
  Status draw_markers(Element element, const Place& place, const ShapeMarkers& markers);
  Status draw_marker(const Marker& marker, Element element, const Place& place,
                     const Affine& user_from_content, const ContextPaints& context);

  const ResourceLoader* loader_;
  PlainContent& plain_;
  ClipPaths clips_;
  StyleLevels levels_;
  std::vector<Element> around_;  ///< the elements around the content of read_tile()
  Element bare_;                 ///< the masked element of read_tile(): its group is outside
  std::vector<Element> active_;  ///< the masks that are being read, outermost first
  std::map<MaskKey, MaskContent> known_masks_;
  TileQueue* tiles_ = nullptr;
  double units_per_texel_ = 1;
  Box visible_{};                        ///< artboard frame; empty: not known
  bool is_sketch_ = false;               ///< only the parts of the content matter
  const DrawnMarker* marker_ = nullptr;  ///< the innermost one around this place
  std::size_t marker_count_ = 0;
  /// The content of a marker is refused, and so is the file: nothing around it is left out.
  bool is_refused_ = false;
  Affine artboard_from_root_{};
};

}  // namespace sfumato::svg
