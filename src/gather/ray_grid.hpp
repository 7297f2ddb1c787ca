#pragma once

#include <cstdint>
#include <vector>

#include "gather/scene.hpp"

namespace sfumato::gather {

/// What a ray hits first.
struct RayHit {
  const StopEdge* edge = nullptr;  ///< null: nothing
  float fraction = 0;              ///< along the edge, from a to b
  float distance = 0;
};

/// The paper's accelerator: a regular grid of 192 × 192 cells over all edges that stop rays. An
/// edge is seen from its own side only, as everywhere in this folder.
class RayGrid {
 public:
  /// `scene` is kept by the caller. Errors: limit.
  static Result<RayGrid> create(Context& context, const Scene& scene);

  /// The first edge on the ray from (x, y) along the unit vector (dx, dy), scene frame.
  RayHit first_hit(float x, float y, float dx, float dy) const;

 private:
  static constexpr int kSide = 192;

  const StopEdge& edge(std::uint32_t i) const {
    return i < scene_->stop.size() ? scene_->stop[i] : scene_->barrier[i - scene_->stop.size()];
  }
  template <class Body>
  void for_each_cell(const StopEdge& edge, Body body) const;
  void test_cell(std::size_t cell, float x, float y, float dx, float dy, RayHit& best) const;

  const Scene* scene_ = nullptr;
  float min_x_ = 0, min_y_ = 0;
  float cell_width_ = 1, cell_height_ = 1;
  std::vector<std::uint32_t> cell_begin_;
  std::vector<std::uint32_t> cell_edge_;
  ScopedCharge charge_;
};

}  // namespace sfumato::gather
