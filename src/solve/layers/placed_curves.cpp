#include "solve/layers/placed_curves.hpp"

#include <utility>

#include "base/try.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::solve {
namespace {

/// Appends the polyline of one more curve.
void append_curve(const curves::FlatCurves& one, curves::FlatCurves& all) {
  const std::uint32_t curve = all.curve_count();
  all.vertex.insert(all.vertex.end(), one.vertex.begin(), one.vertex.end());
  all.parameter.insert(all.parameter.end(), one.parameter.begin(), one.parameter.end());
  all.arc_length.insert(all.arc_length.end(), one.arc_length.begin(), one.arc_length.end());
  all.vertex_curve.resize(all.vertex.size(), curve);
  all.curve_begin.push_back(static_cast<std::uint32_t>(all.vertex.size()));
}

void reserve(std::size_t vertices, std::size_t curves, curves::FlatCurves& all) {
  all.vertex.reserve(vertices);
  all.parameter.reserve(vertices);
  all.arc_length.reserve(vertices);
  all.vertex_curve.reserve(vertices);
  all.curve_begin.reserve(curves);
}

/// Copies polylines to existing tables, and reuses their memory.
void copy(const curves::FlatCurves& from, curves::FlatCurves& to) {
  to.vertex.assign(from.vertex.begin(), from.vertex.end());
  to.parameter.assign(from.parameter.begin(), from.parameter.end());
  to.arc_length.assign(from.arc_length.begin(), from.arc_length.end());
  to.vertex_curve.assign(from.vertex_curve.begin(), from.vertex_curve.end());
  to.curve_begin.assign(from.curve_begin.begin(), from.curve_begin.end());
}

/// Removes the last curve, whose first vertex is `first`.
void take_off_last(std::uint32_t first, curves::FlatCurves& all) {
  all.vertex.resize(first);
  all.parameter.resize(first);
  all.arc_length.resize(first);
  all.vertex_curve.resize(first);
  all.curve_begin.pop_back();
}

std::size_t bytes_of_curves(std::span<const Curve> curves) {
  std::size_t bytes = 0;
  for (const Curve& curve : curves) bytes += bytes_of(curve);
  return bytes;
}

}  // namespace

Result<PlacedCurves> place_curve(Context& context, const curves::FlatCurves& others,
                                 std::span<const Curve> curves, const Curve& curve,
                                 const curves::FlattenOptions& options,
                                 std::optional<PlacedCurves> used) {
  SFUMATO_TRY_ASSIGN(auto&& moved, curves::flatten(context, {&curve, 1}, options));
  PlacedCurves placed = used ? std::move(*used) : PlacedCurves();
  if (used) {
    take_off_last(placed.first, placed.flat);
    placed.curves.pop_back();
  }
  const std::size_t vertices = others.vertex.size() + moved.vertex.size();
  if (vertices > placed.flat.vertex.capacity()) {
    reserve(vertices + vertices / 8, others.curve_begin.size() + 1, placed.flat);
  }
  SFUMATO_TRY(placed.charge.raise_to(context,
                                     curves::bytes_of(placed.flat) + curves::bytes_of(moved) +
                                         bytes_of_curves(curves) + bytes_of(curve),
                                     "a drag"));
  if (!used) {
    copy(others, placed.flat);
    placed.curves.assign(curves.begin(), curves.end());
  }
  placed.first = static_cast<std::uint32_t>(others.vertex.size());
  placed.moved = std::move(moved);
  append_curve(placed.moved, placed.flat);
  placed.curves.push_back(curve);
  return placed;
}

}  // namespace sfumato::solve
