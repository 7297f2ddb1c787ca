#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "import/chords.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg_import {

/// A point of an integer lattice, 0 to 2^29 in both directions.
struct LatticePoint {
  std::int64_t y = 0;  ///< first: points are in order from above
  std::int64_t x = 0;

  auto operator<=>(const LatticePoint&) const = default;
};

/// Where an edge runs along a contour; backwards where end < begin.
struct Source {
  std::uint32_t contour = 0;
  double begin = 0;  ///< parameters of the contour
  double end = 0;
};

/// An edge of the boundary of what chords fill, with the inside on its right.
struct BoundaryEdge {
  LatticePoint from;
  LatticePoint to;
  std::size_t first_source = 0;
  std::size_t source_end = 0;  ///< one source at least; more where contours coincide
};

struct BoundaryEdges {
  std::vector<BoundaryEdge> edge;
  std::vector<Source> source;
  TableMemory memory{"the boundary of a shape"};

  std::span<const Source> sources_of(const BoundaryEdge& of) const {
    return std::span(source).subspan(of.first_source, of.source_end - of.first_source);
  }
};

/// The boundary of what closed chains of chords fill. The chords are rounded to a lattice of the
/// given step (wider where the chords reach farther than 2^29 steps), split where they cross, and
/// snapped to the vertices within 66 steps of them, in integers: so every vertex is the end of as
/// many edges as it is the beginning of, and chords that run nearer to each other than that become
/// one.
///
/// step     of the lattice, in the chords' units, above 0
/// Errors   limit (memory, too many pairs that lie near each other), cancelled.
/// Cost     O(n log n), the pairs whose boxes overlap along the longer side of what all chords
///          cover, and edges × parts that do not touch.
Result<BoundaryEdges> boundary_edges(Context& context, const std::vector<Chord>& chords,
                                     bool even_odd, double step);

}  // namespace sfumato::svg_import
