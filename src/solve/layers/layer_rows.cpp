#include "solve/layers/layer_rows.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "base/table_memory.hpp"

namespace sfumato {

std::size_t bytes_of(const LayerRows& rows) {
  return capacity_bytes(rows.triangles, rows.nodes, rows.opacity_nodes);
}

namespace solve {
namespace {

/// Returns the rows in either of two ascending lists.
std::vector<std::uint32_t> in_either(std::span<const std::uint32_t> a,
                                     std::span<const std::uint32_t> b) {
  std::vector<std::uint32_t> rows;
  rows.reserve(a.size() + b.size());
  std::ranges::set_union(a, b, std::back_inserter(rows));
  return rows;
}

/// Adds the rows of another list for the same layer.
template <class Rows>
void unite(const Rows& more, LayerRows& rows) {
  rows.first_vertex = std::min(rows.first_vertex, more.first_vertex);
  rows.triangles = in_either(rows.triangles, more.triangles);
  rows.nodes = in_either(rows.nodes, more.nodes);
  rows.opacity_nodes = in_either(rows.opacity_nodes, more.opacity_nodes);
}

}  // namespace

std::size_t bytes_of(const FrameRows& rows) {
  return capacity_bytes(rows.triangles, rows.nodes, rows.opacity_nodes);
}

LayerRows rows_between(std::uint32_t layer, const FrameRows& a, const FrameRows& b) {
  LayerRows rows{layer, a.first_vertex, a.triangles, a.nodes, a.opacity_nodes};
  unite(b, rows);
  return rows;
}

void note_new(std::uint32_t layer, std::optional<LayerRows> rows, PictureDelta& delta) {
  const auto place = std::ranges::lower_bound(delta.layers, layer);
  const bool is_known = place != delta.layers.end() && *place == layer;
  const auto known = std::ranges::lower_bound(delta.rows, layer, {}, &LayerRows::layer);
  const bool knows_rows = known != delta.rows.end() && known->layer == layer;
  if (!is_known) delta.layers.insert(place, layer);
  if (!rows) {
    if (knows_rows) delta.rows.erase(known);
  } else if (knows_rows) {
    unite(*rows, *known);
  } else if (!is_known) {
    delta.rows.insert(known, std::move(*rows));
  }
}

}  // namespace solve
}  // namespace sfumato
