#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/point_list.hpp"
#include "gather/scene/scene.hpp"

namespace sfumato::gather {

/// Points of one gather call in the scene's frame (single precision, relative to its origin), and
/// the visibility triangle of each.
struct LocatedPoints {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<std::uint32_t> triangle;
  TableMemory memory{"the points to gather at"};
};

/// Finds triangles by walking: from the previous point's triangle if that is near, else from the
/// triangle at the centre of the point's cell in a regular grid with about as many cells as
/// triangles. A point outside the hull is assigned a triangle at the hull.
class Locator {
 public:
  /// Makes a locator. `scene` has at least one triangle and is kept by the caller. Errors: limit,
  /// cancelled.
  static Result<Locator> create(Context& context, const Scene& scene);

  /// Makes one for a scene that was extended from that of `before`. Errors: limit, cancelled.
  static Result<Locator> extend(Context& context, const Locator& before, const Scene& scene);

  /// Locates points. Cost: a few steps for each point. Errors: limit, cancelled.
  Result<LocatedPoints> locate(Context& context, const PointList& points) const;

  /// Does TableMemory::leave_budget().
  std::size_t leave_budget() { return memory_.leave_budget(); }

 private:
  std::uint32_t start_triangle(float x, float y) const;

  const Scene* scene_ = nullptr;
  float min_x_ = 0, min_y_ = 0, cells_per_unit_x_ = 0, cells_per_unit_y_ = 0;
  int side_ = 1;
  std::vector<std::uint32_t> cell_triangle_;
  TableMemory memory_{"point location"};
};

}  // namespace sfumato::gather
