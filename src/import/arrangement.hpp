#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "import/boundary.hpp"
#include "import/chords.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg_import {

/// A point of an integer lattice, 0 to 2^29 in both directions.
struct LatticePoint {
  std::int64_t y = 0;  ///< first, so that points are ordered from the top
  std::int64_t x = 0;

  auto operator<=>(const LatticePoint&) const = default;
};

/// The stretch of a contour along which an edge runs; backwards if end < begin.
struct Source {
  std::uint32_t contour = 0;
  double begin = 0;  ///< parameters of the contour
  double end = 0;
};

/// An edge of the boundary of the region that chords fill, with the inside on its right.
struct BoundaryEdge {
  LatticePoint from;
  LatticePoint to;
  std::size_t first_source = 0;
  std::size_t source_end = 0;  ///< at least one source; more if contours coincide
};

struct BoundaryEdges {
  std::vector<BoundaryEdge> edge;
  std::vector<Source> source;
  Vec2 origin;      ///< of the lattice, in the chords' units
  double step = 1;  ///< of the lattice, likewise
  TableMemory memory{"the boundary of a shape"};

  Vec2 position_of(LatticePoint p) const {
    return {origin.x + step * static_cast<double>(p.x), origin.y + step * static_cast<double>(p.y)};
  }

  std::span<const Source> sources_of(const BoundaryEdge& of) const {
    return std::span(source).subspan(of.first_source, of.source_end - of.first_source);
  }
};

/// The region that contours fill, or that two sets of contours do.
struct RegionRule {
  bool even_odd = false;  ///< else nonzero
  RegionOperation operation = RegionOperation::unite;
  /// The first contour of the second set, which is filled by a rule of its own.
  std::uint32_t second = std::numeric_limits<std::uint32_t>::max();
  bool second_even_odd = false;
};

/// Whether vertices nearer to each other than 66 steps become one, so that every edge is longer.
enum class Vertices : std::uint8_t { keep, weld };

/// Returns the boundary of the region that closed chains of chords fill. The chords are rounded to
/// a lattice of the given step (wider if the chords extend over more than 2^29 steps), split where
/// they cross, and snapped to vertices within 66 steps, in integers. Hence as many edges end at
/// every vertex as begin there, and chords nearer to each other than that become one. The winding
/// number of a point changes only where a chord is moved across it. With Vertices::weld the edges
/// do not cross, and no vertex is nearer than 66 steps to an edge that it could split.
///
/// step     of the lattice, in the chords' units, above 0
/// Errors   limit (memory, too many pairs of near chords), cancelled.
/// Cost     O(n log n), plus the pairs whose boxes overlap along the longer side of the chords'
///          bounding box, plus edges × parts that do not touch.
Result<BoundaryEdges> boundary_edges(Context& context, const std::vector<Chord>& chords,
                                     const RegionRule& rule, double step,
                                     Vertices vertices = Vertices::keep);

}  // namespace sfumato::svg_import
