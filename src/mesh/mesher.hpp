#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/flatten.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

/// Options of a mesh. Lengths are in user units of the layer.
struct MeshOptions {
  Box frame;                  ///< the patch mesh covers this rectangle; not empty
  double unit_size = 1;       ///< a nominal pixel: the artboard's longer side / 1024 or less
  double weld_px = 1.0 / 16;  ///< weld distance in multiples of unit_size, at least 2^-8
  double min_angle_deg = 22;  ///< 0 to 33
  double max_area = 0;        ///< user units²; 0: none
  /// A triangle whose longest edge is at most this may have smaller angles.
  double small_edge = 0;
  /// Segments may be inserted later anywhere in this box. Empty: in the box of the first ones.
  Box room{};
};

/// The segments that an edit removes and inserts.
struct MeshEdit {
  /// Per vertex of the polylines before the edit: 1 where the segment that begins there is removed.
  /// Empty: none.
  std::span<const std::uint8_t> is_removed{};
  /// Segments that begin at this vertex or after it are new.
  std::uint32_t first_inserted = 0;
};

/// Makes constrained Delaunay triangulations of curves, on an integer lattice.
///
/// build    arrangement and constrained Delaunay triangulation of all segments: the visibility mesh
/// refine   Delaunay refinement of the triangles inside the frame: the patch mesh
/// edit     removes curves from either, and inserts others
///
/// No finite input within limits::kCoordinate makes it loop, crash or return an invalid mesh.
/// Deterministic; single-threaded. Memory is charged to the Budget of build's Context, which must
/// outlive this; so is the memory of the mesh that visibility_mesh or patch_mesh returned last.
/// Each call may have its own Context, which can cancel it and is not kept.
class Mesher {
 public:
  /// Builds the visibility mesh. Errors: bad_input (coordinates or options that are not finite or
  /// out of range, an empty frame), limit (segments, triangles, pieces, memory), cancelled.
  static Result<Mesher> build(Context& context, const curves::FlatCurves& flat,
                              const MeshOptions& options);

  Mesher(Mesher&&) noexcept;
  Mesher& operator=(Mesher&&) noexcept;
  ~Mesher();

  /// Returns all triangles, including those outside the frame. Call it before `refine`. Errors:
  /// limit (memory), cancelled.
  Result<TriangleMesh> visibility_mesh(const Context& context);

  /// Returns the constrained Delaunay triangulation of the constraints c with keep[c] of
  /// `visibility`, which is visibility_mesh(); their pieces are unchanged. Use it for an attribute:
  /// edges that its rays pass through would only split their windows. The mesh is allocated from
  /// `memory`. Errors: limit, cancelled.
  Result<TriangleMesh> thinned_mesh(const Context& context, const TriangleMesh& visibility,
                                    std::span<const std::uint8_t> keep, TableMemory& memory) const;

  /// Refines angles and areas inside the frame. Errors: limit, cancelled; the mesh stays valid.
  Status refine(const Context& context);

  /// Makes every triangle of `triangles` (indices of the patch mesh) smaller, then restores the
  /// angle bound. A triangle whose longest edge is at most `smallest_edge` is left unchanged.
  /// Refining all triangles doubles their number. Errors: limit, cancelled; the mesh stays valid.
  Status refine_triangles(const Context& context, std::span<const std::uint32_t> triangles,
                          double smallest_edge);

  /// Returns an independent mesher with the same mesh. Its memory is charged to this Context's
  /// Budget. Triangles and vertices of the patch mesh have the same indices. Errors: limit
  /// (memory), cancelled. Cost: O(triangles).
  Result<Mesher> copy(const Context& context) const;

  /// Makes this equal to other.copy(), in its existing memory where that is large enough. The last
  /// returned mesh stays charged to it. Errors: limit (memory), cancelled; this mesher can then
  /// only be destroyed or assigned to. Cost: O(triangles); less where this was copied from `other`
  /// before, and `other` has not changed since.
  Status copy_from(const Context& context, const Mesher& other);

  /// Returns the charge of the last returned mesh, for callers that keep the mesh.
  TableMemory release_extracted();

  /// Returns whether the polylines from this vertex on lie within the lattice, so that `edit` can
  /// insert them.
  bool holds(const curves::FlatCurves& flat, std::uint32_t first) const;

  /// Removes segments from the mesh and inserts others, on the same lattice. The mesh is
  /// constrained Delaunay again, with an arrangement as good as that of `build`. Vertices of
  /// removed segments stay. Inserted segments are drawn last.
  ///
  /// flat     the polylines of `build`, unchanged, then the polylines of earlier edits, then of
  /// this
  ///          one. Removed segments stay in the list and must not be removed again
  /// refines  whether the triangles that change are then refined as `refine` would
  ///
  /// Errors: bad_input (not holds()), limit, cancelled. After all but bad_input this mesher can
  /// only be destroyed or assigned to.
  Status edit(const Context& context, const curves::FlatCurves& flat, const MeshEdit& edit,
              bool refines);

  /// Returns the triangles inside the frame. Triangles and vertices keep their indices from one
  /// call to the next, and to update_patch_mesh. Errors: limit (memory), cancelled.
  Result<TriangleMesh> patch_mesh(const Context& context);

  /// Compares two visibility meshes. This must be a copy of `before` with segments inserted since,
  /// without refinement. Returns per triangle of the visibility_mesh() of `before`: 1 where this
  /// one has the same triangle at the same index, with the same constraints. The list is allocated
  /// from `memory`. Errors: limit (memory), cancelled.
  Result<std::vector<std::uint8_t>> same_triangles(const Context& context, const Mesher& before,
                                                   TableMemory& memory) const;

  /// Prepares this mesher so that `edit` of its copies is cheaper. Errors: limit (memory),
  /// cancelled; this mesher can then only be destroyed or assigned to.
  Status bake(const Context& context);

  /// Returns whether update_patch_mesh will find the changed triangles, not all.
  bool follows_changes() const;

  /// Updates in place `mesh`, a copy of the visibility_mesh() of the mesher that this is a copy of,
  /// after an edit without refinement that only inserted segments. The result is the one that
  /// visibility_mesh() would return, except for the order of its constraints, and for some without
  /// an edge or pieces.
  ///
  /// is_same   same_triangles() of that mesher
  /// changed   out: the triangles that changed, including new ones, ascending; from `memory`
  /// Errors    limit (memory), cancelled; `mesh` is then unusable
  Status update_visibility_mesh(const Context& context, std::span<const std::uint8_t> is_same,
                                TriangleMesh& mesh, TableMemory& memory,
                                std::vector<std::uint32_t>& changed);

  /// Returns a copy of `mesh`, the last patch_mesh() or the visibility_mesh() of the mesher that
  /// this one is a copy of. Use it as input of the updates. Its memory is charged like that of
  /// patch_mesh(). Errors: limit (memory), cancelled.
  Result<TriangleMesh> copy_mesh(const Context& context, const TriangleMesh& mesh);

  /// Returns, for each triangle of the last patch_mesh of `before`, its index in this one's last
  /// patch_mesh, or kNone where its corners changed. This must be a copy of `before` that was
  /// edited since, or both edited copies of one mesher. In the second case new triangles of one may
  /// be matched with new ones of the other, though their corners differ. The list is allocated from
  /// `memory`. Errors: limit (memory), cancelled.
  Result<std::vector<std::int32_t>> kept_triangles(const Context& context, const Mesher& before,
                                                   TableMemory& memory) const;

  /// Updates in place `mesh`, the result of the last patch_mesh. The result is the one that
  /// patch_mesh would return now, except for the order of its constraints. After an edit that
  /// crosses the frame all triangles of that mesh count as changed. After other edits there may be
  /// constraints without an edge and without pieces. Where segments were removed, all triangles
  /// around their vertices count as changed.
  ///
  /// changed   out: the triangles that changed, including new ones, ascending; from `memory`
  /// Errors    limit (memory), cancelled; `mesh` is then unusable
  /// Cost      O(changed · log)
  Status update_patch_mesh(const Context& context, TriangleMesh& mesh, TableMemory& memory,
                           std::vector<std::uint32_t>& changed);

  /// Restores `mesh`, a copy of `before` that has been updated since, to `before`.
  ///
  /// changed   all triangles that changed
  /// Cost      O(changed)
  static void take_back(const TriangleMesh& before, std::span<const std::uint32_t> changed,
                        TriangleMesh& mesh);

 private:
  struct State;
  explicit Mesher(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato::mesh
