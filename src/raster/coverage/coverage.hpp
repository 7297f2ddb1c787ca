#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "base/table_memory.hpp"
#include "raster/coverage/abutting.hpp"
#include "raster/coverage/bow_shape.hpp"
#include "raster/coverage/cell_coverage.hpp"
#include "raster/coverage/clip.hpp"
#include "raster/coverage/pixel_marks.hpp"
#include "raster/coverage/soft_strip.hpp"
#include "raster/kernels/span_kernels.hpp"
#include "raster/kernels/tile.hpp"
#include "raster/layers/exact_points.hpp"
#include "raster/shaders/point_shader.hpp"

namespace sfumato::raster {

class ExactShader;

/// The antialiasing of one tile. A pixel that a curve, its bow or fine blur passes through gets,
/// instead of the value at its centre, the mean of the patches in it, each weighted by its exact
/// area and read at the centroid of its part (exact for colours that are linear in the pixel). The
/// same holds for pixels with triangles so small that colours may bend within a pixel; these are
/// read in each quarter of the pixel. Sums are taken relative to the first colour, in the order of
/// the triangles, so that a constant colour stays exactly the same. The changes by bows
/// (raster/coverage/bow_shape.hpp) and by fine blurs (raster/coverage/soft_strip.hpp) are added at
/// the end.
///
/// The background shows through the area that no triangle covers. The frame of a layer without
/// opacity is an exception, because it is not an outline: a pixel that it cuts is covered entirely
/// or not at all, like the larger part of it, so that adjacent frames leave no seam.
///
/// One object serves many tiles, one after another.
class MixedPixels {
 public:
  explicit MixedPixels(const SpanKernels& kernels) : kernels_(kernels) {}

  /// Starts a tile. Call it before the first layer of a tile.
  void start_tile() { abutting_.clear(); }

  /// Marks the mixed pixels of `tile`. Call before they are painted.
  void mark(const LayerView& layer, const TriangleList& triangles, const Tile& tile);

  /// Returns the pixels that were marked last. If the layer has an opacity, `paint` writes all of
  /// them.
  const PixelMask& marked() const { return marks_.mask(); }

  /// Saves the values of the marked pixels before the list is drawn.
  void keep_below(const Tile& tile);

  /// Repaints the marked pixels after draw_triangles painted the same list. Call `keep_below`
  /// before that.
  void paint(const LayerView& layer, const TriangleList& triangles, const Tile& tile);

  /// Repaints the mixed pixels of a layer that was shaded and premultiplied, with nothing below it.
  /// Premultiplied colours are averaged.
  void paint(PointShader* shader, const TriangleList& triangles, const Tile& tile);

  /// Collects the points at which paint() reads the marked pixels of a layer with exact fields.
  /// Error: limit (memory).
  Status collect(Context& context, const LayerView& layer, const TriangleList& triangles,
                 const Tile& tile, ExactPoints* points);

  /// Repaints these pixels once the points were read. is_straight: onto the pixels that
  /// `keep_below` saved; else separately, as for a PointShader.
  void paint(const ExactShader& shader, const Tile& tile, bool is_straight);

 private:
  struct Sum {
    float first[4] = {};  ///< the first triangle's colour
    float rest[4] = {};   ///< area times difference to it
    float area = 0;
    float moment[2] = {};
    float below[4] = {};  ///< colour and alpha before the layer was painted
    float edges[4] = {};  ///< the change by bows and fine blurs

    void add(const Coverage& part, const Color4& color);
    void add(float part_area, const float (&part_moment)[2], const Color4& color);
  };

  /// Number of pixels of an edge that are computed at a time.
  static constexpr std::size_t kMostEdgePixels = 256;

  /// Data of the current soft edge or bow in one pixel.
  struct EdgePixel {
    std::uint32_t sum;
    int x, y;
    StripPart part;  ///< a bow has one area
    Color4 side[2];  ///< the shader's values across the edge, and on its own side
  };

  static constexpr std::uint32_t kNoPart = 0xffffffff;

  /// The part of a triangle in a marked pixel of a layer with exact fields. Parts that no curve
  /// separates are read as one: at their common centroid or, where that lies beyond the curve, at
  /// the nearest of their own centroids.
  struct ExactPart {
    Coverage own;
    Coverage all;  ///< of this part and the parts that are joined to it
    std::uint32_t sum;
    std::uint32_t point;  ///< in the ExactPoints
    std::uint32_t triangle;
    std::uint32_t before;   ///< another part of this pixel, or kNoPart
    std::uint32_t whole;    ///< the part that this one was joined to, or itself
    std::uint32_t nearest;  ///< the joined part whose own centroid is nearest to that of `all`
    bool is_inside;         ///< whether a joined part's triangle contains the centroid of `all`
  };

  /// An edge of a part's triangle: its vertices, the lower one first.
  struct PartEdge {
    std::uint64_t ends;
    std::uint32_t part;
  };

  /// The change of such a pixel by an edge.
  struct ExactEdge {
    EdgePixel pixel;
    std::variant<const CurveBow*, const SoftEdge*> edge;
    std::uint32_t point[2];  ///< for EdgePixel::side; kNoPart: there is no triangle
  };

 public:
  /// Memory of one object if every pixel is mixed.
  static constexpr std::size_t kMostBytes =
      sizeof(PlacedTriangles) + sizeof(PixelMarks) + sizeof(CellCoverage) +
      std::size_t{kTileWidth} * kTileHeight * sizeof(Sum) + kMostEdgePixels * sizeof(EdgePixel) +
      AbuttingParts::kMostBytes;

 private:
  template <class Visit>
  void for_each_placed(const LayerView& layer, const TriangleList& triangles, const Tile& tile,
                       const Visit& visit);
  void mark_triangle(const LayerView& layer, std::uint32_t triangle, std::size_t place,
                     const Tile& tile);
  template <class Shader>
  void add_triangles(Shader* shader, const TriangleList& triangles, const Tile& tile);
  template <class Shader>
  void add_whole_triangle(const Shader& shader, std::uint32_t triangle, const Vec2 (&corner)[3],
                          const PixelRange& range, const Tile& tile);
  template <class Shader>
  void add_split_triangle(Shader* shader, std::uint32_t triangle, const Vec2 (&corner)[3], int axis,
                          const PixelRange& range, const Tile& tile);
  template <class Shader>
  void add_triangle(Shader* shader, std::uint32_t triangle, std::size_t place, const Tile& tile);
  template <class Shader>
  void add_edges(Shader* shader, const TriangleList& triangles, const Tile& tile);
  template <class Shader>
  void add_blur(Shader* shader, const SoftEdge& edge, const Tile& tile);
  template <class Shader>
  void add_bow(Shader* shader, const CurveBow& bow, const Tile& tile);
  template <class Shader, class Edge, class PartIn, class Change>
  void add_edge(Shader* shader, const Edge& edge, const PaintedEdge& painted, const Box& box,
                const Tile& tile, const PartIn& part_in, const Change& change);
  template <class PartIn, class Visit>
  void for_each_edge_pixel(const Box& box, const Tile& tile, const PartIn& part_in,
                           const Visit& visit) const;
  template <class Shader, class Edge>
  void read_sides(Shader* shader, const Edge& edge, const PaintedEdge& painted);
  template <class Shader>
  void read_side(Shader* shader, const PaintedEdge& painted, std::uint32_t slot, int side);
  template <class Shader>
  void change_by_blur(const Shader& shader, const SoftEdge& edge, const EdgePixel& pixel,
                      Sum& changed) const;
  template <class Shader>
  void change_by_bow(const Shader& shader, const CurveBow& bow, const EdgePixel& pixel,
                     Sum& sum) const;
  Status settle(const Context& context, ExactPoints& points);
  void collect_parts(const LayerView& layer, std::uint32_t triangle, std::size_t place,
                     const Tile& tile);
  Status collect_edges(Context& context, const LayerView& layer, const TriangleList& triangles,
                       const Tile& tile, ExactPoints* points);
  template <class Edge, class PartIn>
  void collect_edge(const LayerView& layer, const Edge& edge, const PaintedEdge& painted,
                    const Box& box, const Tile& tile, const PartIn& part_in, ExactPoints* points);
  std::uint32_t whole_of(std::uint32_t part);
  void join_parts(const LayerView& layer, std::uint32_t sum, int x, int y);
  void join(std::uint32_t one, std::uint32_t other, Vec2 from, Vec2 to);
  std::uint32_t point_beside(const LayerView& layer, std::uint32_t slot, Vec2 foot,
                             const EdgePixel& pixel, ExactPoints* points);
  static void read_sides(const ExactShader& shader, ExactEdge* edge);
  void write(const LayerView& layer, const Tile& tile, bool is_straight);

  template <class Visit>
  void for_each_marked(const Tile& tile, const Visit& visit) const;

  const SpanKernels& kernels_;
  PlacedTriangles placed_;
  PixelMarks marks_;
  CellCoverage cells_;
  std::vector<Sum> sum_;  ///< of the marked pixels, row by row
  std::vector<EdgePixel> edge_pixel_;
  AbuttingParts abutting_;
  std::vector<ExactPart> parts_;
  std::vector<std::uint32_t> last_part_;  ///< per sum: its last part in parts_
  std::vector<PartEdge> part_edges_;      ///< of one pixel
  std::vector<ExactEdge> exact_edges_;
  std::size_t charged_ = 0;
  TableMemory memory_{"exact pixels"};
};

}  // namespace sfumato::raster
