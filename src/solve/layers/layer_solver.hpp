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

/// Called after each round of a layer's solution, for tests, with its mesh and the gathered fields.
/// opacity is null if `color` holds it or there is none.
using RoundWatch = FunctionRef<void(const mesh::TriangleMesh& mesh, const FieldSolver& color,
                                    const FieldSolver* opacity)>;

/// How a layer is solved, beside what its options say.
struct SolveWay {
  bool side_by_side = false;  ///< independent steps at the same time, which takes more memory
  std::optional<FunctionRef<void(double fraction)>> progress{};  ///< told how far it has come
};

/// What is kept of a layer that was solved for those who edit it: its patch mesh and the nodes, and
/// what was prepared for that.
struct RefinedNodes {
  RefinedField color;
  std::optional<RefinedField> opacity;  ///< as PreparedLayer
};
struct RefinedLayer {
  mesh::Mesher mesher;
  std::unique_ptr<mesh::TriangleMesh> mesh;  ///< its patch_mesh()
  TableMemory mesh_memory;
  RefinedNodes nodes;
  FlatMesh flat_mesh;
  PreparedFields fields;  ///< made with may_be_changed
  /// Whether the layer's patches have its triangles and nodes, all of them and in their order.
  bool is_all_shown = false;
};

/// What the next frame of a film asks of a layer as a frame shows it.
struct FilmNodes {
  RefinedNodes nodes;  ///< without seams
  PreparedFields fields;
};

/// The frame before.
struct FilmFrame {
  const mesh::Mesher& mesher;  ///< it and the solver's come of copies of one, edited since
  const RefinedNodes& nodes;
  const PreparedFields&
      fields;  ///< these watch what is not there any more, this frame's what was not
};

/// The mesh without what moves, of which the solver's is a copy into which that was inserted.
struct StillMesh {
  const mesh::Mesher& mesher;
  std::vector<std::uint32_t>& missed;  ///< out: of its triangles, those whose patches miss
  TableMemory& memory;                 ///< of the list
};

/// A layer's tables as a frame of a drag left them: those of the layer that it began from, but for
/// what the frame changed, which the next frame takes back.
struct FrameTables {
  std::optional<mesh::Mesher> mesher{};
  std::unique_ptr<mesh::TriangleMesh> mesh{};  ///< or none, with no fields
  FieldFrame color{};
  std::optional<FieldFrame> opacity{};
  std::vector<std::uint32_t> changed{};  ///< triangles that the frame changed
  TableMemory memory{"patches"};
};

/// A curve that was taken out of a layer, for a drag of it.
struct CurveRemoval {
  const RefinedLayer& known;              ///< the layer with it
  const PreparedFields& fields;           ///< of the layer with it, which is watched
  std::span<const std::uint8_t> is_same;  ///< Mesher::same_triangles of the visibility meshes
  /// Of the curve. Unless null: nodes at which it holds keep the values that they have with it.
  const gather::ShareBound* bound = nullptr;
};

/// A curve that was inserted into a layer, for a frame of a drag.
struct CurveInsertion {
  std::span<const std::uint8_t> is_inserted;  ///< per segment
  std::span<const std::uint8_t> is_same;      ///< Mesher::same_triangles of the visibility meshes
  /// Unless null: nodes at which it holds keep their values.
  const gather::ShareBound* bound = nullptr;
  /// Unless null: what the last frame, whose mesher is now the solver's, left of the rest. It is
  /// used up.
  FrameTables* last = nullptr;
  /// Unless null: nodes that have values already may keep those of the last frame when its time is
  /// over, if take_frame() can say which.
  const FrameLimit* limit = nullptr;
};

/// The patches of a frame.
struct FramePatches {
  PatchLayer layer{};               ///< unless is_whole, its soft edges alone
  std::optional<FrameRows> rows{};  ///< none: any row may be another
  bool is_whole = true;             ///< if not, its rows are to be written: write_rows()
  std::size_t left = 0;  ///< nodes that have not been gathered, as CurveInsertion::limit allows
};

/// Solves one layer: patch mesh, node values of colour and opacity, error-driven refinement.
///
/// A round gathers the new nodes and compares the new patches with the exact gather at probe
/// points. Triangles whose error exceeds `max_error` are made smaller for the next round, and mesh
/// and nodes are updated where they changed. At the end the nodes are numbered as if they had been
/// laid out on the final mesh.
class LayerSolver {
 public:
  LayerSolver(Context& context, PreparedLayer prepared, const DiffuseOptions& options,
              DiffuseStats* stats, std::optional<RoundWatch> watch = {}, SolveWay way = {});

  /// refined   unless null: gets what is kept of the layer, which was prepared for drags; nothing
  ///           where its nodes have not their exact values, or memory is lacking for it
  Result<PatchLayer> solve(std::optional<RefinedLayer>* refined = nullptr);

  /// In place of solve(): the layer's mesh without nodes, whose pixels are gathered when it is
  /// drawn. Errors: limit, cancelled.
  Result<PatchLayer> take_exact();

  /// Returns whether solve() found a border of the region that sees a curve, away from the curves.
  bool has_border() const { return cuts_.part_count() > 0; }

  /// What solve() keeps of a layer that was prepared for drags, without its patches and whatever
  /// memory allows. Call last. Errors: limit, cancelled.
  Result<RefinedLayer> refine_only();

  /// In place of solve(): the mesher was copied from that of a RefinedLayer, and segments were
  /// taken out of it since. Nodes keep the values that are known unless the edit may change them;
  /// nothing is made finer than the edit left it, except at blurs. Afterwards others may
  /// continue_inserted() from this. Returns the rows in which the layer's own patches are not those
  /// of this, as of a frame; none: any may be another. Errors: limit, cancelled.
  Result<std::optional<FrameRows>> continue_without(const CurveRemoval& removal);

  /// The same for a mesher that was copied from that of `before`, which has continued itself, and
  /// into which segments were inserted since, at a cost of copies of the tables and of what the
  /// edit changed; where a segment crosses the frame, or fields differ, at that of laying out all.
  Status continue_inserted(const LayerSolver& before, const CurveInsertion& insertion);

  /// In place of continue_inserted(), with the same `before`: gathers nodes that a frame left,
  /// until the time is over, but some in any case.
  /// frame   the rest of what take_frame() kept, whose mesher and fields are the solver's
  Status resume(const LayerSolver& before, FrameTables frame, const FrameTime& time);

  /// In place of solve(), where the mesher is that of a RefinedLayer of the same layer, and a
  /// field has a response: nodes that have none keep the values that are known, the others are
  /// gathered. A layer whose fields were one may have two here. Errors: limit, cancelled.
  Status answer(const RefinedNodes& known);

  /// In place of solve(), for a frame of a film.
  /// before   or null: there is none whose nodes are known
  /// still    or null: there is none
  /// kept     gets the nodes of this one, unless memory is lacking for them or they have not their
  ///          exact values
  Result<PatchLayer> solve_next(const FilmFrame* before, const StillMesh* still,
                                std::optional<FilmNodes>& kept);

  /// Moves the mesher out. Call last.
  mesh::Mesher release_mesher() { return std::move(mesher_); }

  /// The patches, after answer() or continue_inserted(). A response is
  /// the last base channel of its field; triangles whose opacity has one are kept where that or the
  /// opacity shows. Errors: limit, cancelled.
  Result<PatchLayer> take();

  /// The same after continue_inserted(), for a frame after which others come.
  /// wants_rows   where these can be told, they are enough
  /// kept         what the next frame may begin from, or nothing where these patches change more
  Result<FramePatches> take_frame(bool wants_rows, std::optional<FrameTables>& kept);

  const mesh::Mesher& mesher() const { return mesher_; }
  const PreparedField& color() const { return color_.field(); }
  const PreparedField* opacity() const { return opacity_ ? &opacity_->field() : nullptr; }

 private:
  /// before, still   as solve_next()
  Status refine(const FilmFrame* before = nullptr, const StillMesh* still = nullptr);
  Status take_known(const FilmFrame& before);
  Status list_still(const StillMesh& still, std::span<const std::uint32_t> missed) const;
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
  /// `all_changed`, unless null, is added to: the triangles that change.
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
  /// Whether color_ holds the opacity too, as its fourth channel.
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

  /// The same, of both at the same time if the way says so.
  Status for_fields_side_by_side(FunctionRef<Status(FieldSolver&)> body);

  Context& context_;
  mesh::Mesher mesher_;
  bool is_mesh_refined_;  ///< for its angles and areas
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
  bool keeps_mesh_ = false;             ///< whatever patches are made of it
  /// What continue_inserted() was told, unless it took another way.
  const LayerSolver* inserted_into_ = nullptr;
  std::optional<std::vector<SoftEdge>> soft_edge_;  ///< for others to be inserted into this
  BorderCuts cuts_;                                 ///< their parts follow the mesher's triangles
  TableMemory memory_{"patches"};  ///< for lists of triangles, and for parts in the mesh
};

}  // namespace sfumato::solve
