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

/// Lengths in user units of the layer.
struct MeshOptions {
  Box frame;                  ///< the patch mesh covers this rectangle; not empty
  double unit_size = 1;       ///< a nominal pixel: the artboard's longer side / 1024 or less
  double weld_px = 1.0 / 16;  ///< weld distance in multiples of unit_size, at least 2^-8
  double min_angle_deg = 22;  ///< 0 to 33
  double max_area = 0;        ///< user units²; 0: none
  /// A triangle whose longest edge is at most this may have smaller angles.
  double small_edge = 0;
  /// Segments may be inserted later anywhere in this box. Empty: where the first ones lie.
  Box room{};
};

/// What a mesh is to gain and to lose.
struct MeshEdit {
  /// Per vertex of the polylines before the edit: 1 where the segment that begins there is taken
  /// out. Empty: none is.
  std::span<const std::uint8_t> is_removed{};
  /// Segments that begin at this vertex or behind it are new.
  std::uint32_t first_inserted = 0;
};

/// Curves to constrained Delaunay triangulations on an integer lattice.
///
/// build    arrangement and constrained Delaunay triangulation of all segments: the visibility mesh
/// refine   Delaunay refinement of the triangles inside the frame: the patch mesh
/// edit     curves taken out of either, and put in
///
/// No finite input within limits::kCoordinate makes it loop, crash or return an invalid mesh.
/// Deterministic; single-threaded. Memory is charged to the Budget of build's Context, which must
/// outlive this; so is the memory of the mesh that visibility_mesh or patch_mesh returned last.
/// Each call may have its own Context, which can cancel it and is not kept.
class Mesher {
 public:
  /// Errors: bad_input (coordinates or options that are not finite or out of range, an empty
  /// frame), limit (segments, triangles, pieces, memory), cancelled.
  static Result<Mesher> build(Context& context, const curves::FlatCurves& flat,
                              const MeshOptions& options);

  Mesher(Mesher&&) noexcept;
  Mesher& operator=(Mesher&&) noexcept;
  ~Mesher();

  /// All triangles, including those outside the frame. Call before `refine`. Errors: limit
  /// (memory), cancelled.
  Result<TriangleMesh> visibility_mesh(const Context& context);

  /// The constrained Delaunay triangulation of those constraints c of `visibility`, which is
  /// visibility_mesh(), that have keep[c]; their pieces are unchanged. Edges that the attribute's
  /// rays pass through would only split their windows. The mesh is allocated from `memory`. Errors:
  /// limit, cancelled.
  Result<TriangleMesh> thinned_mesh(const Context& context, const TriangleMesh& visibility,
                                    std::span<const std::uint8_t> keep, TableMemory& memory) const;

  /// Angle and area refinement inside the frame. Errors: limit, cancelled; the mesh stays valid.
  Status refine(const Context& context);

  /// Makes every triangle of `triangles` (indices of the patch mesh) smaller, then restores
  /// the angle bound. A triangle whose longest edge is at most `smallest_edge` is left unchanged.
  /// Refining all triangles doubles their number. Errors: limit, cancelled; the mesh stays valid.
  Status refine_triangles(const Context& context, std::span<const std::uint32_t> triangles,
                          double smallest_edge);

  /// A mesher of its own with the same mesh, that can be edited without this one. Its memory is
  /// charged to this Context's Budget. Triangles and vertices of the patch mesh have the same
  /// indices. Errors: limit (memory), cancelled. Cost: O(triangles).
  Result<Mesher> copy(const Context& context) const;

  /// This one becomes what other.copy() would be, in the memory that it has where that is large
  /// enough. The mesh that it handed out last stays charged to it. Errors: limit (memory),
  /// cancelled; this mesher can then only be destroyed or assigned to. Cost: O(triangles); less of
  /// it where this was copied from `other` before, and that has not changed since.
  Status copy_from(const Context& context, const Mesher& other);

  /// The charge of the mesh that was handed out last, for whoever keeps that.
  TableMemory release_extracted();

  /// Whether the polylines from this vertex on lie within the lattice, so that `edit` can insert
  /// them.
  bool holds(const curves::FlatCurves& flat, std::uint32_t first) const;

  /// Takes segments out of the mesh and inserts others, on the same lattice: constrained Delaunay
  /// again, with an arrangement as good as that of `build`. Vertices of what is taken out stay.
  /// What is inserted is drawn last.
  ///
  /// flat     the polylines of `build`, as they were, then those of earlier edits, then those of
  ///          this one. Segments that were taken out stay in the list and are not to be taken out
  ///          again
  /// refines  whether the triangles that change are then refined as `refine` would
  ///
  /// Errors: bad_input (not holds()), limit, cancelled. After all but bad_input this mesher can
  /// only be destroyed or assigned to.
  Status edit(const Context& context, const curves::FlatCurves& flat, const MeshEdit& edit,
              bool refines);

  /// The triangles inside the frame. Triangles and vertices keep their indices from one call to the
  /// next, and to update_patch_mesh. Errors: limit (memory), cancelled.
  Result<TriangleMesh> patch_mesh(const Context& context);

  /// Per triangle of the visibility_mesh() of `before`, of which this is a copy into which segments
  /// were inserted since, without refinement: 1 where that of this one has the same triangle at the
  /// same index, with the same constraints. The list is allocated from `memory`. Errors: limit
  /// (memory), cancelled.
  Result<std::vector<std::uint8_t>> same_triangles(const Context& context, const Mesher& before,
                                                   TableMemory& memory) const;

  /// Prepares copies of this for `edit`, which is then the cheaper. Errors: limit (memory),
  /// cancelled; this mesher can then only be destroyed or assigned to.
  Status bake(const Context& context);

  /// Whether update_patch_mesh will find what changed, rather than all.
  bool follows_changes() const;

  /// Updates in place `mesh`, a copy of the visibility_mesh() of the mesher that this is a copy of,
  /// after an edit without refinement that only inserted segments. But for the order of its
  /// constraints, and for some without an edge or pieces, it becomes what visibility_mesh() would
  /// return.
  /// is_same   same_triangles() of that mesher
  /// changed   out: the triangles that changed, including new ones, ascending; from `memory`
  /// Errors    limit (memory), cancelled; `mesh` is unusable then
  Status update_visibility_mesh(const Context& context, std::span<const std::uint8_t> is_same,
                                TriangleMesh& mesh, TableMemory& memory,
                                std::vector<std::uint32_t>& changed);

  /// A copy of `mesh`, the last patch_mesh() or the visibility_mesh() of the mesher that this one
  /// is a copy of, for the updates of either to update. Its memory is charged as that of
  /// patch_mesh(). Errors: limit (memory), cancelled.
  Result<TriangleMesh> copy_mesh(const Context& context, const TriangleMesh& mesh);

  /// The triangles of the last patch_mesh of `before`, of which this is a copy that was edited
  /// since: the index of each in this one's last patch_mesh, or kNone where its corners changed. Or
  /// both are copies of one mesher, edited since: what both have gained may then be taken for each
  /// other, though its corners differ.
  /// The list is allocated from `memory`. Errors: limit (memory), cancelled.
  Result<std::vector<std::int32_t>> kept_triangles(const Context& context, const Mesher& before,
                                                   TableMemory& memory) const;

  /// Updates in place `mesh`, the result of the last patch_mesh. Except for the order of its
  /// constraints it becomes what patch_mesh would return now. After an edit that crosses the frame
  /// it is that mesh, all of whose triangles count as changed; after others there may be
  /// constraints without an edge and without pieces. Where segments were taken out all triangles
  /// around their vertices count as changed.
  /// changed   out: the triangles that changed, including new ones, ascending; from `memory`
  /// Errors    limit (memory), cancelled; `mesh` is unusable then
  /// Cost      O(changed · log)
  Status update_patch_mesh(const Context& context, TriangleMesh& mesh, TableMemory& memory,
                           std::vector<std::uint32_t>& changed);

  /// Makes `mesh`, a copy of `before` that has been updated since, `before` again.
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
