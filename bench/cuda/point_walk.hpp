#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace sfumato::bench {

/// The tables of a scene without blur, in the form of point_walk.glsl, and the points.
struct CudaWalk {
  const void* edge_beyond;
  std::size_t edge_beyond_bytes;
  const void* hit_edge;
  std::size_t hit_edge_bytes;
  const void* triangle;
  std::size_t triangle_bytes;
  const void* point;  ///< gather::WalkPoint
  std::size_t point_count;
  float negligible;
  int block_size;  ///< threads per block
};

/// Gathers `times` times. sums: 5 numbers per point. Returns the milliseconds of one gather without
/// transfers, or a negative number with an error text.
double walk_by_cuda(const CudaWalk& walk, int times, float* sums, std::string& device_or_error);

}  // namespace sfumato::bench
