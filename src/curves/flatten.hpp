#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"

namespace sfumato::curves {

/// Allowed distances between chord and curve, user units, above 0, for a visible box. Outside the
/// box (grown by a tenth) the allowed distance is the coarser `outside_tolerance` or, if that is
/// larger, 1/16384 of the distance from the box: this changes colours in the box by less than 0.25
/// code values.
struct FlattenFocus {
  Box box;
  double tolerance = 0.1;
  double outside_tolerance = 0.1;
};

struct FlattenOptions {
  double tolerance = 0.1;               ///< as in FlattenFocus; used if there is no focus
  std::vector<FlattenFocus> focuses{};  ///< the smallest allowed distance of all counts
  /// A curve that comes this close to a vertex of another curve gets a vertex there, user units; 0:
  /// only if it meets the vertex exactly.
  double reach = 0;
  /// Curves whose blur radius is below this show as edges; others may be flattened finer, so that
  /// no error in colour shows.
  double sharp_radius = 0;
  /// A vertex is placed where a blur radius passes this value; 0: none.
  double split_radius = 0;
  /// For pixel grids: FlatCurves gets `bow`, and colours may shift farther along a curve where they
  /// change slowly.
  bool keeps_bows = false;
};

/// The heights of a curve over a chord, user units: at the chord's ends and in its middle, between
/// which they are quadratic. They are positive where the curve lies on the side where cross(chord,
/// p - start) > 0.
struct ChordBow {
  double start = 0;
  double middle = 0;
  double end = 0;

  /// Returns the height at a fraction of the chord.
  double at(double u) const {
    return start + (end - start) * u + (4 * middle - 2 * (start + end)) * u * (1 - u);
  }
};

/// Curves as polylines that keep the curve parameter. Segment s joins vertex s and vertex s + 1;
/// the last vertex of a curve begins no segment. Every stop of a stop list is a vertex, so that
/// attributes are linear on each segment. The vertex lies on the chord that exists without it, so
/// that curves of one shape have one polyline for any stops. Chords lie in the middle of their
/// arcs: at ends, corners and where other curves pass, vertices lie on the curve. Elsewhere they
/// lie outside the curve, by the mean distance by which chords between points of the curve would
/// lie inside.
struct FlatCurves {
  std::vector<Vec2> vertex;        ///< layer frame
  std::vector<double> parameter;   ///< per vertex: Bézier piece + t
  std::vector<double> arc_length;  ///< per vertex: length from the curve's start, user units
  std::vector<std::uint32_t> vertex_curve;  ///< per vertex: its curve
  std::vector<std::uint32_t> curve_begin;   ///< curve c owns vertices [begin[c], begin[c + 1])
  std::vector<ChordBow> bow;  ///< per vertex: of the segment that it begins; empty: not kept

  std::uint32_t curve_count() const { return static_cast<std::uint32_t>(curve_begin.size() - 1); }
  bool begins_segment(std::uint32_t v) const {
    return v + 1 < vertex.size() && vertex_curve[v] == vertex_curve[v + 1];
  }
  std::size_t segment_count() const { return vertex.size() - curve_count(); }
};

/// Returns the bytes of memory of a polyline.
inline std::size_t bytes_of(const FlatCurves& flat) {
  return flat.vertex.capacity() * sizeof(Vec2) +
         (flat.parameter.capacity() + flat.arc_length.capacity()) * sizeof(double) +
         (flat.vertex_curve.capacity() + flat.curve_begin.capacity()) * sizeof(std::uint32_t) +
         flat.bow.capacity() * sizeof(ChordBow);
}

/// Flattens every curve. Errors: limit (segments, memory), cancelled. Cost: O(vertices), in the
/// calling thread (0.1 µs a vertex: less than passing it to another thread).
Result<FlatCurves> flatten(Context& context, std::span<const Curve> curves,
                           const FlattenOptions& options);

}  // namespace sfumato::curves
