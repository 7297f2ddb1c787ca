#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "raster/kernels/tile.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::raster {

/// The triangles of a layer in runs of kTrianglesPerBlock with their bounding boxes. Finds the
/// triangles in a tile for any number of instances without data per instance. Fast if consecutive
/// triangles lie near each other; correct in any order.
struct TriangleBlocks {
  std::vector<Box> box;  ///< layer frame
  std::uint32_t triangle_count = 0;
  TableMemory memory{"places of triangles"};
};

inline constexpr std::uint32_t kTrianglesPerBlock = 32;

/// Beyond this distance from the image's corner, rounding hides whether an edge passes beside a
/// tile.
inline constexpr double kExactBelowPx = 1e9;

/// Makes the blocks. Errors: limit, cancelled.
Result<TriangleBlocks> make_triangle_blocks(Context& context, const PatchLayer& layer);

/// Returns a box that contains the image of a box, slightly enlarged for rounding; NaN where it
/// overflows.
Box mapped_bounds(const Affine& map, const Box& box);

/// Lists, in increasing order, the triangles whose bounding box, grown by margin_px, meets `rect`.
void list_triangles(const LayerView& layer, const TriangleBlocks& blocks, const PixelRect& rect,
                    double margin_px, std::vector<std::uint32_t>* triangles);

/// Removes the triangles of a list that do not come closer to `rect` than margin_px (touching is
/// not enough where that is 0): a tile's triangles are then the same however they were found.
void keep_meeting(const LayerView& layer, const PixelRect& rect, double margin_px,
                  std::vector<std::uint32_t>* triangles);

/// Returns the pixels of `rect` that a box meets.
PixelRect pixels_in(const Box& box, const PixelRect& rect);

}  // namespace sfumato::raster
