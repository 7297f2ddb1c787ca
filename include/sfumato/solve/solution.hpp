#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/change.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/document/stop_place.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato {

/// The rows of a layer that changed. Its other rows are unchanged, unless the tables are shorter
/// now. All soft edges count as changed.
struct LayerRows {
  std::uint32_t layer = 0;                   ///< index into Picture::layers
  std::uint32_t first_vertex = 0;            ///< vertices from here on changed
  std::vector<std::uint32_t> triangles;      ///< ascending: with new corners, edges or nodes
  std::vector<std::uint32_t> nodes;          ///< ascending: nodes whose colour changed
  std::vector<std::uint32_t> opacity_nodes;  ///< ascending: nodes whose opacity changed
};

/// The parts of a Solution's picture that changed.
struct PictureDelta {
  /// Whether other parts than the layers may have changed: stack, shaders, background, artboard,
  /// viewport, interpolation, or the number of layers.
  bool frame = false;
  std::vector<std::uint32_t> layers;  ///< indices into Picture::layers, ascending
  /// The layers with changes in some rows only, ascending. They occur between two frames of a drag,
  /// and between the picture of solve() and the first frame if the layer is opaque and solve() has
  /// kept the tables that drags start from.
  std::vector<LayerRows> rows;

  /// Returns whether nothing changed.
  bool empty() const { return !frame && layers.empty(); }
};

/// The numbers of layers that Solution::solve_next() kept, continued and began.
struct FrameLayers {
  std::size_t kept = 0;       ///< unchanged
  std::size_t continued = 0;  ///< continued on the mesh of the last frame
  std::size_t begun = 0;      ///< on new meshes
};

/// A document that is being solved. It takes changes, and solves only the layers that they affect.
/// Its picture equals the one that diffuse() makes of the document, to the bit.
///
/// Only one thread at a time may call a Solution. Its document and picture stay charged to the
/// Context of create(), which must therefore outlive it. The Contexts of later calls provide
/// threads, limits and memory for their work. A moved-from Solution can only be assigned to or
/// destroyed.
class Solution {
 public:
  /// Takes ownership of a document. Nothing is solved yet, and the picture is empty. Errors:
  /// bad_input (an invalid document), limit, cancelled, out_of_memory.
  static Result<Solution> create(Context& context, Document document);

  /// Takes over the content of `other`.
  Solution(Solution&& other) noexcept : state_(other.state_) { other.state_ = nullptr; }
  /// Exchanges the content of both objects.
  Solution& operator=(Solution&& other) noexcept;
  ~Solution();

  /// Returns the document with all changes that were applied.
  const Document& document() const;

  /// Changes the document. Returns the inverse change. The picture stays as it is until solve().
  /// Errors: as apply_change(); the document is then unchanged.
  Result<Change> apply(Context& context, Change change);

  /// Makes the picture that diffuse() would make of the document with these options. A layer is
  /// solved where its curves changed since the last picture, where the stack shows it at another
  /// scale or shows another part of it, and where the options, the artboard or the document's
  /// interpolation changed. The other layers are kept.
  ///
  /// `stats`, unless null, is added to: the layers that this call solved.
  ///
  /// Errors: as diffuse(). The picture is then the last one. Layers that this call finished are
  /// kept for the next call, unless memory was exhausted. Limits of the Context apply to the layers
  /// that this call solves.
  Status solve(Context& context, const DiffuseOptions& options, DiffuseStats* stats = nullptr);

  /// Makes a preview. Use it where drag() cannot show all changes. Solves the layers that
  /// solve() would solve, but roughly: from chords about four times as coarse, without refinement
  /// where a patch misses. Gathered values are exact. The mesh has a third to a half as many
  /// triangles, and pixels differ from the exact picture's by a third of a code value in the mean
  /// (lady_bug, portrait, dolphin, roses). A layer that already shows its curves stays as it is:
  /// exact, rough or as drag() or color() left it. The next solve() solves all layers that are not
  /// exact.
  ///
  /// Errors: as solve(); the picture is then the last one. Cost: a fifth to a seventh of that of
  /// solve().
  Status solve_roughly(Context& context, const DiffuseOptions& options,
                       DiffuseStats* stats = nullptr);

  /// Makes the next frame of a film: nodes and triangles change only where the drawing changes. A
  /// layer that keeps some of its curves continues on its mesh: all curves that ever moved are
  /// removed from the first frame's mesh once, and inserted at their places in each frame. The
  /// nodes that see them are gathered, and the bound on the error holds as after solve().
  ///
  /// A layer gets a new mesh where its number of curves, the options, the artboard or its visible
  /// part changed, or where more than half of its curves changed. It also gets one where a curve
  /// moved farther beyond the picture than the picture is large, or lies on others in another order
  /// than the drawing order. A call with another Context than that of create(), which is charged
  /// for the meshes, begins all layers on new meshes; so does scarce memory.
  ///
  /// `layers` and `stats`, unless null, are added to. Errors: as solve(). Cost: O(triangles and
  /// nodes of the layer) for tables, and a gather of the nodes that see the curves that ever moved.
  /// The first frame that moves another curve costs more. The kept tables take twelve times the
  /// memory of the picture.
  Status solve_next(Context& context, const DiffuseOptions& options, FrameLayers* layers = nullptr,
                    DiffuseStats* stats = nullptr);

  /// Makes later calls of solve() keep the meshes, fields and nodes that drags start from. They are
  /// kept only if solve() gets the Context of create(), which is charged for them: four to five
  /// times as much as for the picture. They are not kept where memory is scarce, and other work of
  /// this Solution that lacks memory releases them first. The first begin_drag() calls this. Call
  /// it earlier to make the first drag fast.
  ///
  /// - `most_triangles`: tables are kept for layers of at most this many triangles in all: the
  ///   layers dragged last, then the largest ones. They are always kept for the layer that was
  ///   dragged last, and for the only layer. That takes about 1 kB a triangle
  void expect_drags(std::size_t most_triangles = SIZE_MAX);

  /// Prepares curves of a layer for dragging: removes them from the layer. The picture stays as it
  /// is.
  ///
  /// The prepared tables are charged to this Context, which must outlive the drag. They last until
  /// the next call of begin_drag(), end_drag() or apply(), or of solve() or solve_roughly() with
  /// other options.
  ///
  /// - `curves`: indices into Layer::curves, each once, at least one
  ///
  /// Errors: bad_input (no such curves, or the last picture is not that of the document), limit,
  /// cancelled, out_of_memory. Cost: that of meshing the layer, and a gather of the nodes that see
  /// the curves, if the tables that drags start from are kept and this Context is that of create().
  /// Otherwise the layer is also solved, and its tables are kept. The layer is solved roughly where
  /// solve() did not make the picture's layer, or where the curves touch a hundredth of the layer's
  /// mesh or more, such as an outline of many pieces: frames on a fine mesh would be slow. The mesh
  /// then stays coarse throughout the drag.
  Status begin_drag(Context& context, std::uint32_t layer, std::vector<std::uint32_t> curves);

  /// Replaces the dragged curves, in the document and in the picture. The picture is a preview
  /// until solve() makes the exact one. Nodes have their exact values, except for changes below 3%
  /// of the range of code values (lady_bug, dolphin and roses: less than one code value). The mesh
  /// is as fine as it was at the curves' new places, and the curves are drawn over the others of
  /// their layer. The picture depends on the state at begin_drag() and on the curves, not on the
  /// places in between. To undo a drag, apply ReplaceCurve with the original curves.
  ///
  /// `curves`: the new curves, in ascending order of their indices. `stats`, unless null, is added
  /// to: the work of this call. `seconds`, from 0 on, limits the time: afterwards nodes wait until
  /// drag_more(), and waiting_nodes() counts them. Only nodes wait that already got a value in this
  /// drag, or that see more than the curves and are not beside them. They keep the value of the
  /// last frame, or the value without the curves; the nodes that the curves may change most are
  /// gathered first. None waits where this Context is not that of begin_drag(), where memory is
  /// scarce, or where the visible part of the layer ends inside the layer.
  ///
  /// Errors: bad_input (nothing is dragged, another number of curves, an invalid curve, or an
  /// invalid time), limit, cancelled, out_of_memory. They leave document and picture unchanged.
  /// Cost: O(triangles and nodes of the layer) for tables, and a gather of the nodes that may see
  /// the curves. Where a curve gets an opacity for the first time, or lies farther beyond the
  /// picture than the picture is large, the layer is solved roughly, and the picture is as after
  /// solve_roughly(). Where any part of a curve lies beyond the picture, the layer is solved: once
  /// if this Context is that of begin_drag(), each time otherwise.
  Status drag(Context& context, std::vector<Curve> curves, DiffuseStats* stats = nullptr,
              std::optional<double> seconds = {});

  /// Returns the number of nodes that wait to be gathered since the last drag() or drag_more(); 0
  /// once the drag has ended, or solve() has made the picture.
  std::size_t waiting_nodes() const;

  /// Gathers waiting nodes of a drag(): all of them, or for so many seconds, but always some. With
  /// none left, the picture equals that of drag() without a time limit, to less than half a code
  /// value. Does nothing where none waits. Errors: as drag(); the nodes then still wait.
  Status drag_more(Context& context, DiffuseStats* stats = nullptr,
                   std::optional<double> seconds = {});

  /// Prepares a stop, or all stops of a side, for other values: computes the response of each node
  /// of the layer to them. The picture stays as it is. Ends the drag of a curve; begin_drag() ends
  /// this.
  ///
  /// The prepared tables are charged to this Context, which must outlive them. They last until the
  /// next call of begin_color(), begin_drag(), end_drag(), apply(), solve() or solve_roughly().
  ///
  /// Errors: bad_input (there is no such stop, the side's attribute has no stops, or the last
  /// picture is not that of the document), limit, cancelled, out_of_memory. Cost: that of meshing
  /// the layer, and a gather of the nodes that see the curve, where solve() has kept the tables
  /// that drags start from and this Context is that of create(). Otherwise the layer is also
  /// solved: roughly where solve() did not make the picture's layer.
  Status begin_color(Context& context, const StopPlace& place);

  /// Sets the value of the prepared stop, in the document and in the picture. With all stops of a
  /// side, the first gets the value, and the others change by the same difference in the document's
  /// interpolation space. Nothing is gathered: node values are linear in the stop's. The picture is
  /// a preview until solve() makes the exact one. Nodes have their exact values, but the mesh is
  /// still that of the original colours, and where both sides of a curve get the same colour its
  /// free ends still count. The picture depends on the state at begin_color() and on the value, not
  /// on the values in between. The first call changes all tables of the layer, later calls only its
  /// values.
  ///
  /// Errors: bad_input (nothing is prepared, a value of another attribute, or a value outside 0 to
  /// 1), limit, cancelled, out_of_memory. They leave document and picture unchanged. Cost: O(nodes
  /// that respond); for the first two calls O(nodes of the layer).
  Status color(Context& context, const StopValue& value);

  /// Returns the response of the layer's nodes to the prepared stops. It has a factor from 0 to 1
  /// for each row of values of PatchLayer::color or opacity in picture(), after color(). Where the
  /// stop's value, in the interpolation space, has grown by d, the first 3 channels of a colour, or
  /// the first channel of an opacity, have grown by d times the factor. Empty where nothing is
  /// prepared or shown.
  std::span<const float> color_response() const;

  /// Ends a drag, or the preparation of begin_color(), and releases its memory. The curve stays as
  /// it is.
  void end_drag();

  /// Returns the last picture that solve(), solve_roughly(), solve_next(), drag() or color()
  /// finished.
  const Picture& picture() const;

  /// Returns a layer of the document as rays meet it, for exact values at points: the same that
  /// diffuse() adds to its picture with DiffuseOptions::exact_fields. It has no fields where no
  /// part of the layer is seen, and where a side has an image-domain shader.
  ///
  /// Errors: bad_input (no such layer, or it has changed since it was solved), limit, cancelled,
  /// out_of_memory. Cost: that of meshing the layer.
  Result<ExactLayer> exact_layer(Context& context, std::uint32_t layer) const;

  /// Returns the parts of picture() that changed since the last call. The first call after the
  /// first picture names everything.
  PictureDelta take_delta();

 private:
  struct State;

  explicit Solution(State* state) : state_(state) {}
  State* state_;  ///< owned
};

}  // namespace sfumato
