#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/fields/border.hpp"
#include "solve/fields/field_solver.hpp"
#include "solve/fields/frame_rows.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// A callback for tests. It is called after each round of a layer's solution, with the mesh and the
/// gathered fields. `opacity` is null if `color` holds it or there is none.
using RoundWatch = FunctionRef<void(const mesh::TriangleMesh& mesh, const FieldSolver& color,
                                    const FieldSolver* opacity)>;

/// Each round halves a triangle that misses. The artboard is a few hundred smallest edges wide.
inline constexpr int kMaxRounds = 12;

/// How a layer is solved, in addition to its options.
struct SolveWay {
  bool side_by_side = false;  ///< runs independent steps at the same time, with more memory
  std::optional<FunctionRef<void(double fraction)>> progress{};  ///< called with the part done
};

/// The nodes of a solved layer, kept for edits.
struct RefinedNodes {
  RefinedField color;
  std::optional<RefinedField> opacity;  ///< as PreparedLayer
};
/// A solved layer, kept for edits: its patch mesh, its nodes and its prepared fields.
struct RefinedLayer {
  mesh::Mesher mesher;
  std::unique_ptr<mesh::TriangleMesh> mesh;  ///< its patch_mesh()
  TableMemory mesh_memory;
  RefinedNodes nodes;
  FlatMesh flat_mesh;
  PreparedFields fields;  ///< made with may_be_changed
  /// Whether the layer's patches have all triangles and nodes of `mesh`, in the same order.
  bool is_all_shown = false;
};

/// The tables of a layer after a frame of a drag. The next frame restores the rows that this frame
/// changed; all other rows are equal to the rows of the base, the layer where all frames begin.
struct FrameTables {
  std::optional<mesh::Mesher> mesher{};
  std::unique_ptr<mesh::TriangleMesh> mesh{};  ///< null: no tables, and no fields
  FieldFrame color{};
  std::optional<FieldFrame> opacity{};
  std::vector<std::uint32_t> changed{};  ///< triangles that the frame changed
  TableMemory memory{"patches"};
};

/// The removal of the moving curves from a layer.
struct CurveRemoval {
  const RefinedLayer& known;              ///< the layer with the curves
  const PreparedFields& fields;           ///< of that layer; they watch the curves
  std::span<const std::uint8_t> is_same;  ///< Mesher::same_triangles of the visibility meshes
  /// Bound for the curves, or null. Nodes at which it holds keep their values with the curves.
  const gather::ShareBound* bound = nullptr;
  bool holds_bound = false;  ///< whether to call refine_changes()
};

/// The insertion of the moving curves into a layer, for a frame.
struct CurveInsertion {
  std::span<const std::uint8_t> is_inserted;  ///< per segment
  std::span<const std::uint8_t> is_same;      ///< Mesher::same_triangles of the visibility meshes
  /// Bound for the curves, or null. Nodes at which it holds keep their values.
  const gather::ShareBound* bound = nullptr;
  /// The tables that the last frame left, or null. The solver has their mesher already, and moves
  /// the rest out of them.
  FrameTables* last = nullptr;
  /// The time limit, or null. Nodes that have a value already may keep it when the time is over, if
  /// take_frame() can keep the tables.
  const FrameLimit* limit = nullptr;
};

/// The patches of a frame.
struct FramePatches {
  PatchLayer layer{};               ///< if not is_whole, only its soft edges
  std::optional<FrameRows> rows{};  ///< empty: any row may differ from the base
  bool is_whole = true;             ///< if not, call write_rows() for its rows
  std::size_t left = 0;             ///< number of deferred nodes: CurveInsertion::limit
};

/// Solves one layer: patch mesh, node values of colour and opacity, error-driven refinement.
///
/// A round gathers the new nodes and compares the new patches with the exact gather at probe
/// points. Triangles whose error exceeds `max_error` are refined for the next round, which updates
/// the mesh and the nodes where they changed. At the end the nodes get the numbers that a layout on
/// the final mesh would give them.
class LayerSolver {
 public:
  LayerSolver(Context& context, PreparedLayer prepared, const DiffuseOptions& options,
              DiffuseStats* stats, std::optional<RoundWatch> watch = {}, SolveWay way = {});

  /// Solves the layer and returns its patches. Errors: limit, cancelled.
  /// refined   unless null: out: the solved layer, which was prepared for drags. Empty if its nodes
  ///           do not have their exact values, or if there is not enough memory
  Result<PatchLayer> solve(std::optional<RefinedLayer>* refined = nullptr);

  /// Replaces solve(): returns the layer's mesh without nodes. Its pixels are gathered when it is
  /// drawn. Errors: limit, cancelled.
  Result<PatchLayer> take_exact();

  /// Returns whether solve() found a border of the region that sees a curve, away from the curves.
  bool has_border() const { return cuts_.part_count() > 0; }

  /// Replaces solve(): returns the solved layer, which was prepared for drags, without patches.
  /// Does not check for spare memory. Call this last. Errors: limit, cancelled.
  Result<RefinedLayer> refine_only();

  /// Replaces solve() for a copy of the mesher of a RefinedLayer, after segments were removed from
  /// the copy. Nodes keep their known values unless the edit may change them. The mesh is refined
  /// at blurs only. Other solvers can then continue_inserted() from this one. Returns the rows
  /// where the patches of the RefinedLayer differ from this layer; empty: any row may differ.
  /// Errors: limit, cancelled.
  Result<std::optional<FrameRows>> continue_without(const CurveRemoval& removal);

  /// Replaces solve() for a copy of the mesher of `before` into which segments were inserted.
  /// Precondition: `before` has called continue_without(). Errors: limit, cancelled. Cost: copies
  /// of the tables, and the changes of the edit. Where a segment crosses the frame, or the fields
  /// have other channels, all nodes are laid out again.
  Status continue_inserted(const LayerSolver& before, const CurveInsertion& insertion);

  /// Resumes an unfinished frame. Gathers deferred nodes until the time is over, at least one
  /// batch. Errors: limit, cancelled.
  /// before   as in continue_inserted()
  /// frame    the tables that take_frame() kept; the solver has their mesher and fields already
  Status resume(const LayerSolver& before, FrameTables frame, const FrameTime& time);

  /// Replaces solve() where a field has a response and the mesher is from a RefinedLayer of the
  /// same layer. Nodes without a response keep their known values; the others are gathered. A layer
  /// with one joint field may have two fields here. Errors: limit, cancelled.
  Status answer(const RefinedNodes& known);

  /// Refines the patches that the edit changed until they hold the bound on the error. Errors:
  /// limit, cancelled.
  Status refine_changes();

  /// Moves the mesher out. Call this last.
  mesh::Mesher release_mesher() { return std::move(mesher_); }

  /// Returns the patches after answer() or continue_inserted(). A response is the last base channel
  /// of its field. If the opacity has a response, triangles where either is visible are kept.
  /// Errors: limit, cancelled.
  Result<PatchLayer> take();

  /// Returns the patches after continue_inserted() or resume(), for a frame that others follow.
  /// Errors: limit, cancelled.
  /// wants_rows   returns only the rows where they can be listed
  /// kept         out: the tables for the next frame; empty if it cannot use them
  Result<FramePatches> take_frame(bool wants_rows, std::optional<FrameTables>& kept);

  const mesh::Mesher& mesher() const { return mesher_; }
  const PreparedField& color() const { return color_.field(); }
  const PreparedField* opacity() const { return opacity_ ? &opacity_->field() : nullptr; }

 private:
  Status refine();
  Status add_gathered_triangles();
  Status set_changed(std::vector<std::uint32_t>& all_changed);
  Status continue_from(const LayerSolver& before, const gather::ShareBound* bound);
  Status prepare_to_be_edited();
  bool has_spare_memory() const;
  Result<RefinedNodes> copy_nodes() const;
  Result<RefinedLayer> keep(RefinedNodes nodes);
  Status take_mesh();
  Status update_mesh();
  Status lay_out();
  Status put_in_order();
  Status list_all_triangles();
  /// Adds the triangles that change to `all_changed` unless it is null.
  Status follow_blur(std::vector<std::uint32_t>* all_changed = nullptr);
  Status follow_blur_too();
  Status add_fans(std::span<const std::uint8_t> is_inserted);
  Status gather(const gather::GatherOptions& options, bool all);
  Result<std::vector<std::uint32_t>> large_triangles(TableMemory& memory) const;
  Status find_misses(std::vector<std::uint32_t>& missed);
  Status make_smaller(const std::vector<std::uint32_t>& triangles, double smallest_edge);
  Status cut_at_border();
  bool is_curve(std::uint32_t half_edge) const;
  bool is_end(std::int32_t half_edge, std::span<const std::uint8_t> keep) const;
  bool is_cut(std::uint32_t triangle) const {
    return triangle < cuts_.is_cut.size() && cuts_.is_cut[triangle] != 0;
  }
  bool sees_curves_everywhere() const;
  bool may_see_none() const;
  bool keeps_everything() const;
  bool may_be_fine(std::uint32_t half_edge) const;
  Result<std::vector<std::uint32_t>> fine_half_edges(TableMemory& memory) const;
  Result<std::vector<std::uint32_t>> fine_near_changes(std::span<const SoftEdge> before,
                                                       std::vector<std::uint8_t>& is_near,
                                                       TableMemory& memory) const;
  Result<std::vector<SoftEdge>> soft_edges(std::span<std::uint8_t> keep, TableMemory& memory) const;
  Result<std::vector<CurveBow>> bows(std::span<const std::uint8_t> keep, TableMemory& memory) const;
  float largest_opacity(std::uint32_t triangle, float enough) const;
  Result<std::vector<std::uint8_t>> visible_triangles(TableMemory& memory) const;
  Result<std::vector<std::uint8_t>> edges_of_curves(std::span<const std::uint8_t> keep,
                                                    TableMemory& memory) const;
  /// Returns whether color_ also holds the opacity, as its fourth channel.
  bool is_joint() const;
  Status start_inserted(const LayerSolver& before, FrameTables& last, bool remembers);
  Status gather_left(const FrameTime& time, bool advances);
  bool can_keep_tables() const;
  FrameTables release_frame();
  Result<PatchLayer> take_patches(bool keeps_tables);
  Result<FrameRows> list_rows(std::size_t first_vertex) const;
  Status take_rows(FramePatches& patches) const;
  Status take_triangles(std::span<const std::uint8_t> keep, std::vector<std::uint8_t> marks,
                        TableMemory& memory, PatchLayer& layer);
  Status take_fields(std::span<const std::uint8_t> keep, bool keeps_tables, TableMemory& memory,
                     PatchLayer& layer);

  template <class Body>
  Status for_each_field(Body body) {
    Status status = body(color_);
    return status && opacity_ ? body(*opacity_) : status;
  }

  /// Does the same, with both fields at the same time if SolveWay::side_by_side.
  Status for_fields_side_by_side(FunctionRef<Status(FieldSolver&)> body);

  Context& context_;
  mesh::Mesher mesher_;
  bool is_mesh_refined_;  ///< the mesher has refined its angles and areas
  bool is_blurred_;
  bool is_finely_blurred_;
  FieldSolver color_;
  std::optional<FieldSolver> opacity_;
  Box frame_;
  SmallestEdges smallest_edges_;
  std::optional<FlatMesh> flat_mesh_;
  std::optional<ChargedCurves> bowed_;
  const DiffuseOptions& options_;
  DiffuseStats* stats_;
  std::optional<RoundWatch> watch_;
  SolveWay way_;
  std::unique_ptr<mesh::TriangleMesh> mesh_ = std::make_unique<mesh::TriangleMesh>();
  std::vector<std::uint32_t> changed_;  ///< triangles that are new in this round, ascending
  bool keeps_mesh_ = false;             ///< take() must not move its vertices out
  /// The base of continue_inserted() or resume(); null if all nodes were laid out again.
  const LayerSolver* inserted_into_ = nullptr;
  std::optional<std::vector<SoftEdge>> soft_edge_;  ///< for solvers that continue from this
  BorderCuts cuts_;                                 ///< their parts follow the mesher's triangles
  TableMemory memory_{"patches"};  ///< for lists of triangles, and for parts in the mesh
};

}  // namespace sfumato::solve
