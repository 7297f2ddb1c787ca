#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gpu/draw_list.hpp"
#include "gpu/program.hpp"
#include "gpu/target.hpp"
#include "raster/options.hpp"

namespace sfumato::gpu {

/// Options of a painter.
struct PaintSettings {
  int tile_width = 0;  ///< pixels of the image painted at once, at most
  int tile_height = 0;
  raster::Backdrop backdrop;
  bool antialias = true;
  bool overlay = false;
  bool single_precision = true;  ///< else targets have 16-bit floats
};

/// Paints a list tile by tile: each item is painted separately, then composited (docs/gpu.md).
/// Pixels that a layer's curves cut get the mean of the patches in them, weighted by area;
/// elsewhere patches are read at pixel centres.
class Painter {
 public:
  /// Makes a painter. All arguments must outlive it. Errors: limit, out_of_memory, unavailable,
  /// internal.
  static Result<Painter> create(Context& context, const Device& device, const DrawList& list,
                                const PaintSettings& settings);

  /// Paints the pixels of `tile`: four floats each, code values not premultiplied and alpha, row by
  /// row. Errors: cancelled, internal (an error of OpenGL).
  Status paint(const PixelRect& tile, float* rgba);

 private:
  /// Names of web/viewer/shaders.
  struct Programs {
    std::array<std::optional<Program>, 12> patch;  ///< by the bits of a variant
    Program mark_edges, mark_small, mark_strips, stroke, stroke_resolve, over, over_with_edges,
        blend, blend_with_edges, overlay, present;
  };

  Painter(Context& context, const Device& device, const DrawList& list,
          const PaintSettings& settings);

  Status make_programs();
  Status make_patch_programs();
  Status make_targets();

  void paint_item(const DrawItem& item);
  void paint_instance(const DrawItem& item, const PixelRect& rect);
  void paint_edges(const DrawItem& item, const PixelRect& rect) const;
  void mark_pixels(const DrawItem& item) const;
  void draw_patches(const DrawItem& item, unsigned kind) const;
  void bind_layer(const Program& program, const DrawItem& item) const;
  void bind_strips(const Program& program, const DrawItem& item) const;
  void bind_paints(const Program& program, const DrawItem& item) const;
  void paint_stroke(const DrawItem& item, const PixelRect& rect) const;
  void composite(GLuint source, bool is_layer, const DrawItem& item, const PixelRect& rect);
  void paint_overlay() const;
  void read(float* rgba) const;

  bool is_opaque(const DrawItem& item) const;
  Affine frame_from_tile(const DrawItem& item) const;
  Affine tile_from_image() const;
  PixelRect in_tile(const PixelRect& rect) const;

  Context& context_;
  const Device& device_;
  const DrawList& list_;
  PaintSettings settings_;
  Programs programs_;
  GlObject vertex_array_, paint_views_;
  std::vector<Target> levels_;  ///< the tile, then open groups
  Target layer_, sums_, spare_, ink_, result_;
  std::size_t level_ = 0;
  PixelRect tile_;
};

}  // namespace sfumato::gpu
