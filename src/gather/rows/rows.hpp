#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "base/unset_allocator.hpp"
#include "curves/attributes.hpp"
#include "curves/front_share.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// The place of one side of an edge on a stop list. Its value is linear from `from` to `to`, which
/// are 0 at the stop `column` and 1 at the one after it.
struct RowSide {
  std::uint32_t column = 0;  ///< index of a stop in the list of all stops of all sides
  float from = 0;            ///< at the end where the moment of a term is 0
  float to = 0;              ///< at the other end
  std::int32_t shader = -1;  ///< SegmentSide::shader of an image-domain side, which has no stops
  bool has_value = false;    ///< false: there is no such side (the other side takes everything)

  friend bool operator==(const RowSide&, const RowSide&) = default;
};

/// The source of terms in rows: one direction of an edge with curves, as points on its `front` see
/// it, or one side of a free end.
///
/// Other gathers ignore free ends whose two sides have the same value (find_free_ends). Here no two
/// sides are the same, and every free end has its term, unless RowOptions::values excludes it.
struct RowSource {
  RowSide front, back;
  std::uint32_t curve = 0;  ///< the curve whose radius of blur it has
  float blur_from = 0;      ///< radius, user units; 0: sharp
  float blur_to = 0;

  friend bool operator==(const RowSource&, const RowSource&) = default;
};

/// Returns the radius of blur with which a source was made, at a place from 0 to 1 on it.
inline double radius_at(const RowSource& source, double moment) {
  return source.blur_from + moment * (double{source.blur_to} - source.blur_from);
}

/// The share of one source in a point's value. With β = front_share(distance, radius at `moment`),
/// 1 where the source has no back, the front gets the share 1/2 + lean (β - 1/2) of the weight and
/// the back gets the rest.
struct RowTerm {
  std::uint32_t source;
  float weight;    ///< share of the point's whole weight: the terms of a point add up to 1
  float moment;    ///< mean place of the weight on the edge, from 0 to 1
  float distance;  ///< of the point from the line of the edge, user units
  float lean;      ///< 1 for edges; |sin(φ/2)| of a free end

  friend bool operator==(const RowTerm&, const RowTerm&) = default;
};

/// Calls sink(side, weight) for the sides that share a term's weight, where the blur has this
/// radius.
template <class Sink>
void for_each_side(const RowSource& source, const RowTerm& term, double radius, Sink&& sink) {
  const double beta =
      source.back.has_value ? curves::front_share(double{term.distance}, radius) : 1;
  const double front = 0.5 + term.lean * (beta - 0.5);
  if (front > 0) sink(source.front, front * term.weight);
  if (front < 1) sink(source.back, (1 - front) * term.weight);
}

/// Calls sink(column, weight) for the stops that determine a term's value: the entries of the
/// point's row in these columns, one or several times each. Sides with image-domain shaders have
/// none.
template <class Sink>
void for_each_entry(const RowSource& source, const RowTerm& term, double radius, Sink&& sink) {
  for_each_side(source, term, radius, [&](const RowSide& side, double weight) {
    if (side.shader >= 0) return;
    const double next = side.from + term.moment * (double{side.to} - side.from);
    if (next < 1) sink(side.column, (1 - next) * weight);
    if (next > 0) sink(side.column + 1, next * weight);
  });
}

/// The linear map from stops to values at points (paper eq. 2–11), before blur: radii may change
/// without another search for the edges that a point sees. An edge with varying radius has several
/// terms, and the radius hardly varies on each of them.
struct Rows {
  std::vector<RowSource> source;
  std::vector<RowTerm, UnsetAllocator<RowTerm>> term;
  std::vector<std::uint32_t> begin;  ///< per point, and one more: into `term`
  TableMemory memory{"rows of the gather"};
};

struct RowOptions {
  /// Terms below this share of a point's weight may be left out; the others are scaled up. On three
  /// public scenes 2e-4 leaves one to two thirds of the terms, and colours differ by up to 0.08
  /// code values of 255 (RMS), by 1 at most.
  float negligible = 0;
  /// The attribute's values on the same segments. A free end whose two sides have the same value
  /// there has no term, as in other gathers: rows times these values equal the results of those.
  /// Null: every free end has one.
  const curves::SegmentAttributes* values = nullptr;
};

/// Computes rows of one attribute of a layer at points, in closed form over the exact visible set.
///
/// mesh     the visibility mesh
/// places   curves::sample_stop_places() of the attribute
/// points   layer frame; one outside the mesh, or that sees nothing, has no terms
/// Errors   limit (memory, 32-bit indices), cancelled
/// Cost     1.5 to 4 microseconds of CPU a point; runs on the pool; the same bits for any thread
///          count and instruction set. Points that follow each other should be near each other.
///          Memory: 20 bytes a term; drawings have 20 to 60 terms a point.
///
/// Single precision: a row differs from that of rows_reference() by 2e-6 of its sum on average, and
/// by 5e-5 nearer than a hundredth of a unit to a curve.
Result<Rows> gather_rows(Context& context, const mesh::TriangleMesh& mesh,
                         const curves::SegmentAttributes& places, std::span<const Vec2> points,
                         const RowOptions& options = {});

}  // namespace sfumato::gather
