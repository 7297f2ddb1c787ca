#include "solve/layers/placed_curves.hpp"

#include <utility>

#include "base/try.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::solve {
namespace {

/// Appends polylines to others.
void append(const curves::FlatCurves& more, curves::FlatCurves& all) {
  const auto first = static_cast<std::uint32_t>(all.vertex.size());
  const std::uint32_t curve = all.curve_count();
  const auto add = [](const auto& from, auto& to) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(more.vertex, all.vertex);
  add(more.parameter, all.parameter);
  add(more.arc_length, all.arc_length);
  for (const std::uint32_t c : more.vertex_curve) all.vertex_curve.push_back(curve + c);
  for (std::size_t c = 1; c < more.curve_begin.size(); ++c)
    all.curve_begin.push_back(first + more.curve_begin[c]);
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

/// Removes the last curves, whose first vertex is `first`.
void remove_last(std::uint32_t first, std::size_t count, curves::FlatCurves& all) {
  all.vertex.resize(first);
  all.parameter.resize(first);
  all.arc_length.resize(first);
  all.vertex_curve.resize(first);
  all.curve_begin.resize(all.curve_begin.size() - count);
}

}  // namespace

std::size_t bytes_of(std::span<const Curve> curves) {
  std::size_t bytes = 0;
  for (const Curve& curve : curves) bytes += bytes_of(curve);
  return bytes;
}

Result<PlacedCurves> place_curves(Context& context, const curves::FlatCurves& others,
                                  std::span<const Curve> curves, std::span<const Curve> moving,
                                  const curves::FlattenOptions& options,
                                  std::optional<PlacedCurves> used) {
  SFUMATO_TRY_ASSIGN(auto&& moved, curves::flatten(context, moving, options));
  PlacedCurves placed = used ? std::move(*used) : PlacedCurves();
  if (used) {
    remove_last(placed.first, moving.size(), placed.flat);
    placed.curves.erase(placed.curves.end() - static_cast<std::ptrdiff_t>(moving.size()),
                        placed.curves.end());
  }
  const std::size_t vertices = others.vertex.size() + moved.vertex.size();
  if (vertices > placed.flat.vertex.capacity()) {
    reserve(vertices + vertices / 8, others.curve_begin.size() + moving.size(), placed.flat);
  }
  SFUMATO_TRY(placed.charge.raise_to(
      context,
      curves::bytes_of(placed.flat) + curves::bytes_of(moved) + bytes_of(curves) + bytes_of(moving),
      "a drag"));
  if (!used) {
    copy(others, placed.flat);
    placed.curves.assign(curves.begin(), curves.end());
  }
  placed.first = static_cast<std::uint32_t>(others.vertex.size());
  placed.moved = std::move(moved);
  append(placed.moved, placed.flat);
  placed.curves.insert(placed.curves.end(), moving.begin(), moving.end());
  return placed;
}

}  // namespace sfumato::solve
