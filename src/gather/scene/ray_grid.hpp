#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/scene/scene.hpp"

namespace sfumato::gather {

/// The first hit of a ray.
struct RayHit {
  const HitEdge* edge = nullptr;  ///< null: no hit, or a barrier
  float fraction = 0;             ///< along the edge, from a to b
  float distance = std::numeric_limits<float>::infinity();
};

/// The paper's accelerator: a regular grid of 192 × 192 cells over all edges that stop rays on one
/// side or both.
class RayGrid {
 public:
  /// Makes a grid. `scene` is kept by the caller. Errors: limit.
  static Result<RayGrid> create(Context& context, const Scene& scene);

  /// Returns the first edge on the ray from (x, y) along the unit vector (dx, dy), scene frame.
  RayHit first_hit(float x, float y, float dx, float dy) const;

 private:
  static constexpr int kSide = 192;

  /// An edge a → b: the codes of its counter-clockwise side (cross > 0), and of its back.
  struct Wall {
    float ax, ay;
    float bx, by;
    EdgeCode front;
    EdgeCode back;
  };

  static Result<std::vector<Wall>> walls_of(Context& context, const Scene& scene,
                                            TableMemory& memory);
  template <class Body>
  void for_each_cell(const Wall& wall, Body body) const;
  void test_cell(std::size_t cell, float x, float y, float dx, float dy, RayHit& best) const;

  const Scene* scene_ = nullptr;
  float min_x_ = 0, min_y_ = 0;
  float cell_width_ = 1, cell_height_ = 1;
  std::vector<std::uint32_t> cell_begin_;  ///< first of each cell in cell_wall_
  std::vector<Wall> cell_wall_;            ///< a wall is listed in every cell that it touches
  TableMemory memory_{"the grid of rays"};
};

}  // namespace sfumato::gather
