#pragma once

#include <cstdint>
#include <vector>

#include "base/poll.hpp"
#include "gather/row_blur.hpp"
#include "gather/row_sources.hpp"
#include "gather/rows.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// The terms of points in double precision, one point after another, by the walk of
/// gather_reference().
class RowWalk {
 public:
  RowWalk(const Context& context, const mesh::TriangleMesh& mesh, const RowSources& sources,
          const RowOptions& options);

  /// Appends the terms of p to `out`, none outside the mesh. `near` is a triangle from which p is
  /// looked for. After cancellation what was appended is of no meaning.
  void add(Vec2 p, std::uint32_t near, std::vector<RowTerm>& out);

  bool cancelled() { return poll_.cancelled(); }

  /// Of its tables.
  std::size_t bytes() const { return capacity_bytes(waiting_, found_); }

 private:
  /// Directions through a half-edge: from `right` to `left`, counter-clockwise.
  struct Window {
    std::uint32_t half_edge;
    Vec2 right, left;
  };
  /// A term before the division by the point's weight.
  struct Found {
    std::uint32_t source;
    double weight, moment, distance, lean;
  };

  Vec2 seen(std::uint32_t vertex) const { return mesh_.vertex_position[vertex] - p_; }
  std::int32_t find(Vec2 p, std::uint32_t near) const;
  Vec2 off_corners_and_sources(std::uint32_t triangle, Vec2 p) const;
  void follow(const Window& window);
  void pass(const Window& window, std::uint32_t twin);
  void integrate(const Window& window, std::uint32_t source);
  void add_found(std::uint32_t source, const PartMoment& part, double distance);
  void add_ends();
  void store(std::vector<RowTerm>& out) const;

  RarePoll<4096> poll_;
  const mesh::TriangleMesh& mesh_;
  const RowSources& sources_;
  RowOptions options_;
  Vec2 p_;
  std::vector<Window> waiting_;
  std::vector<Found> found_;
};

}  // namespace sfumato::gather
