#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gather/scene/scene.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::solve {

/// The value of one side of a curve at a point of the curve (paper eq. 10 with the whole weight at
/// that point): channels of the curve-domain share, and shares of image-domain shaders.
struct SeamValue {
  curves::FieldValue base;
  std::uint32_t shader[2] = {};  ///< index into SegmentAttributes::shader
  float share[2] = {};           ///< 0: none
};

/// Returns whether the values are equal apart from rounding.
bool same_value(const SeamValue& a, const SeamValue& b);

/// The edges where the picture may jump: constrained edges with a side that is not open.
class Seams {
 public:
  /// Finds the seams. The mesh must outlive this. Errors: limit (memory), cancelled.
  static Result<Seams> create(const Context& context, const mesh::TriangleMesh& mesh,
                              const curves::SegmentAttributes& attributes);

  /// Does the same for a copy of the mesh, which must outlive it. Errors: limit (memory),
  /// cancelled.
  Result<Seams> copy(const Context& context, const mesh::TriangleMesh& mesh) const;

  /// Updates the seams after a change of the mesh, where `changed` lists the triangles that
  /// changed, including new ones. Errors: limit (memory), cancelled; this object is then unusable.
  Status update(const Context& context, const curves::SegmentAttributes& attributes,
                std::span<const std::uint32_t> changed);

  /// Restores this, an updated copy of `before`, to `before`, whether or not its mesh was restored
  /// already.
  ///
  /// changed   the triangles that changed
  void take_back(const Seams& before, std::span<const std::uint32_t> changed);

  std::size_t half_edge_count() const { return mark_.size(); }

  /// Returns true for both half-edges of an edge that stops rays on either side.
  bool is_seam(std::uint32_t half_edge) const { return (mark_[half_edge] & kSeam) != 0; }

  /// Returns the side of a constrained half-edge that its triangle sees.
  const gather::Facing& facing(std::uint32_t half_edge) const { return facing_[index(half_edge)]; }

  /// Returns whether the side that the half-edge's triangle sees has its own value.
  bool has_value(std::uint32_t half_edge) const {
    return is_seam(half_edge) && facing(half_edge).has_value();
  }

  /// Returns that value at fraction u of the half-edge; on a blurred curve the mean of both sides'
  /// (β of eq. 8 is 1/2 there).
  SeamValue value(std::uint32_t half_edge, float u) const;

  /// Returns the blur radius at fraction u; 0 where there is nothing to blur with.
  float blur_radius(std::uint32_t half_edge, float u) const;

  /// Returns whether fine_radius() may be above 0.
  bool may_be_fine(std::uint32_t half_edge) const { return (mark_[half_edge] & kFineBlur) != 0; }

  /// Returns the radius at fraction u of a blur that is too fine for the mesh; 0 if there is none.
  float fine_radius(std::uint32_t half_edge, float u) const;

 private:
  static constexpr std::uint8_t kSeam = 1;
  static constexpr std::uint8_t kFineBlur = 2;  ///< fine_radius() may be above 0

  explicit Seams(const mesh::TriangleMesh& mesh) : mesh_(&mesh) {}

  std::size_t index(std::uint32_t half_edge) const {
    const auto constraint = static_cast<std::uint32_t>(mesh_->half_edge_constraint[half_edge]);
    return 2 * std::size_t{constraint} +
           (mesh_->origin(half_edge) == mesh_->constraint[constraint].from ? 0 : 1);
  }

  std::uint8_t mark_of(std::uint32_t half_edge) const;

  const gather::Facing& back(std::uint32_t half_edge) const {
    return facing_[index(half_edge) ^ 1];
  }

  const mesh::TriangleMesh* mesh_;
  std::vector<gather::Facing> facing_;  ///< 2 per constraint: along it, against it
  std::vector<std::uint8_t> mark_;      ///< per half-edge: kSeam, kFineBlur
  TableMemory memory_{"patches along curves"};
};

}  // namespace sfumato::solve
