#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::solve {

/// Returns the numbers of the triangles with keep[t] among these, and SoftEdge::kNone for the
/// others. Errors: limit (memory), cancelled.
inline Result<std::vector<std::uint32_t>> numbers_of_kept(const Context& context,
                                                          std::span<const std::uint8_t> keep,
                                                          TableMemory& memory) {
  std::vector<std::uint32_t> number;
  SFUMATO_TRY(memory.resize(context, number, keep.size(), SoftEdge::kNone));
  std::uint32_t next = 0;
  for (std::size_t t = 0; t < keep.size(); ++t)
    if (keep[t]) number[t] = next++;
  return number;
}

/// Sorts SoftEdges or CurveBows by painting_triangle(); edges of one triangle stay in order.
/// Releases `edges`; the result is allocated from the same memory. Errors: limit, cancelled.
template <class Edge>
Result<std::vector<Edge>> sorted_by_triangle(const Context& context, std::vector<Edge>& edges,
                                             TableMemory& memory) {
  TableMemory scratch("edges of patches");
  std::vector<std::uint64_t> order;  // the triangle, then the place
  SFUMATO_TRY(scratch.reserve(context, order, edges.size()));
  for (std::size_t i = 0; i < edges.size(); ++i)
    order.push_back(std::uint64_t{painting_triangle(edges[i])} << 32 | i);
  SFUMATO_TRY(TableMemory::sort(context, order, std::less<>()));
  std::vector<Edge> result;
  SFUMATO_TRY(memory.reserve(context, result, edges.size()));
  for (const std::uint64_t place : order) result.push_back(edges[place & 0xffffffff]);
  memory.free(edges);
  return result;
}

}  // namespace sfumato::solve
