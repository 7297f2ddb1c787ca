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

/// Rows of a layer that are new; its other rows are what they were, unless the tables are shorter
/// now. Soft edges are new as a whole.
struct LayerRows {
  std::uint32_t layer = 0;                   ///< index into Picture::layers
  std::uint32_t first_vertex = 0;            ///< vertices are new from here on
  std::vector<std::uint32_t> triangles;      ///< ascending: their corners, edges and nodes
  std::vector<std::uint32_t> nodes;          ///< ascending: their values of colour
  std::vector<std::uint32_t> opacity_nodes;  ///< ascending: their values of opacity
};

/// What of a Solution's picture is new.
struct PictureDelta {
  /// Whether anything but the layers may be: stack, shaders, background, artboard, viewport,
  /// interpolation, or how many layers there are.
  bool frame = false;
  std::vector<std::uint32_t> layers;  ///< indices into Picture::layers, ascending
  /// Those of them that are not new as a whole, ascending: between two frames of a drag, or between
  /// the picture of solve() and the first frame, if the layer is opaque and solve() has kept what
  /// drags begin from.
  std::vector<LayerRows> rows;

  /// Whether nothing is new.
  bool empty() const { return !frame && layers.empty(); }
};

/// How the layers of a frame were made by Solution::solve_next().
struct FrameLayers {
  std::size_t kept = 0;       ///< nothing of them changed
  std::size_t continued = 0;  ///< on the mesh of the frame before
  std::size_t begun = 0;      ///< on new meshes
};

/// A document that is being solved: it takes changes, and solves anew only the layers that these
/// touched. Its picture is the one that diffuse() makes of the document, to the bit.
///
/// One thread at a time may call a Solution. Its document and picture stay charged to the Context
/// that was given to create(), which must therefore outlive it; the Contexts of later calls lend
/// their threads, their limits and the memory of the work itself. A moved-from Solution can only be
/// assigned to or destroyed.
class Solution {
 public:
  /// Takes a document over; nothing is solved yet, and the picture is an empty one.
  /// Errors: bad_input (an invalid document), limit, cancelled, out_of_memory.
  static Result<Solution> create(Context& context, Document document);

  /// Takes over what `other` holds.
  Solution(Solution&& other) noexcept : state_(other.state_) { other.state_ = nullptr; }
  /// Exchanges what the two hold.
  Solution& operator=(Solution&& other) noexcept;
  ~Solution();

  /// The document with all changes that were applied.
  const Document& document() const;

  /// Changes the document, and returns the change that takes this one back. The picture stays as it
  /// is until solve(). Errors: as apply_change(); nothing has changed then.
  Result<Change> apply(Context& context, Change change);

  /// Makes the picture that diffuse() would make of the document with these options. A layer is
  /// solved where its curves changed since the last picture, where the stack shows it at another
  /// scale or shows another part of it, and where the options, the artboard or the document's
  /// interpolation changed; the others are kept.
  ///
  /// `stats`, unless null, is added to: what was solved now.
  ///
  /// Errors: as diffuse(). The picture is the last one then, and layers that this call finished are
  /// kept for the next one, unless it was memory that was lacking. Limits of the Context hold for
  /// what is solved now.
  Status solve(Context& context, const DiffuseOptions& options, DiffuseStats* stats = nullptr);

  /// The same for a picture to look at while more moves than one curve: layers that solve() would
  /// solve are solved roughly, from chords about four times as coarse, without refinement where a
  /// patch misses. What is gathered is exact; the triangles are a third to a half as many, and
  /// pixels differ from the exact picture's by a third of a code value in the mean (lady_bug,
  /// portrait, dolphin, roses). A layer that already shows its curves as they are stays as it is,
  /// exact, rough or as drag() or color() left it. The next solve() solves anew what is not exact.
  ///
  /// Errors: as solve(); the picture is the last one then. Cost: a fifth to a seventh of that of
  /// solve().
  Status solve_roughly(Context& context, const DiffuseOptions& options,
                       DiffuseStats* stats = nullptr);

  /// The same for the next frame of a film: no node and no triangle changes where nothing does. A
  /// layer some of whose curves changed since the last call goes on with its mesh, in which only
  /// these curves are placed anew; nodes that see them are gathered, and the bound on the error
  /// holds as after solve(). What one frame refines the next ones keep, where no curve moves, until
  /// that is half as much as the whole mesh was.
  ///
  /// A layer is begun anew where its number of curves, the options, the artboard or what is seen of
  /// it changed, where more than half of its curves did, or where a curve has gone farther beyond
  /// the picture than that is large, or lies on others in another order than they were drawn in. So
  /// it is in each call whose Context is not that of create(), which is charged for the meshes, and
  /// where memory is scarce.
  ///
  /// `layers` and `stats`, unless null, are added to. Errors: as solve(). Cost: about half of that
  /// of solve(), where few nodes see what changed; what is kept takes six times as much memory as
  /// the picture.
  Status solve_next(Context& context, const DiffuseOptions& options, FrameLayers* layers = nullptr,
                    DiffuseStats* stats = nullptr);

  /// From here on solve() keeps the meshes, fields and nodes that drags begin from, where it is
  /// given the Context of create(), which is charged for them: four to five times as much as for
  /// the picture. Where memory is scarce they are not kept, and what of this Solution lacks memory
  /// gives them up first. The first begin_drag() calls this.
  ///
  /// most_triangles   they are kept for layers that have no more in all: those that were dragged
  ///                  last, then the largest ones; for the one that was dragged last, or is the
  ///                  only one, in any case. That takes about 1 kB a triangle.
  void expect_drags(std::size_t most_triangles = SIZE_MAX);

  /// Prepares a curve to be dragged: takes it off its layer. The picture stays as it is.
  ///
  /// What this holds is charged to this Context, which must outlive the drag. It lasts until the
  /// next call of begin_drag(), end_drag() or apply(), or of solve() or solve_roughly() with other
  /// options.
  ///
  /// Errors: bad_input (no such curve, or the last picture is not that of the document), limit,
  /// cancelled, out_of_memory. Cost: that of meshing the layer, and a gather of what sees the
  /// curve, where what drags begin from is kept and this Context is that of create(); otherwise
  /// that of solving the layer besides, after which it is kept; roughly where the picture's layer
  /// is not that of solve(): its mesh is as coarse throughout the drag, then. So it is, too, where
  /// a hundredth of the layer's mesh or more lies on the curve, as on an outline of many pieces: a
  /// frame would take long on a fine one.
  Status begin_drag(Context& context, std::uint32_t layer, std::uint32_t curve);

  /// Puts another curve in the place of the one that is dragged, in the document and in the
  /// picture. That is one for looking at until solve() makes the exact one: nodes have their exact
  /// values, but for changes of less than 3% of the range of code values (lady_bug, dolphin and
  /// roses: less than one code value), the mesh is as fine as it was where the curve has come to,
  /// and the curve is drawn over the others of its layer. It depends on what begin_drag() found and
  /// on the curve, not on where the curve was dragged in between. To take a drag back, apply a
  /// ReplaceCurve with the curve as it was.
  ///
  /// `stats`, unless null, is added to: what was solved now. `seconds`, from 0 on: once they are
  /// over, nodes wait that have had a value in this drag, or that see more than the curve and are
  /// not beside it: waiting_nodes() says how many, until drag_more(). They keep the value of the
  /// last frame, or that without the curve; those are gathered first that the curve may change
  /// most. None waits where this Context is not that of begin_drag(), where memory is scarce, and
  /// where what the layer shows ends within it.
  ///
  /// Errors: bad_input (nothing is dragged, an invalid curve, or no such time), limit, cancelled,
  /// out_of_memory. Document and picture are as they were then. Cost: O(triangles and nodes of the
  /// layer) for tables, and a gather of what may see the curve. Where the curve bears an opacity
  /// for the first time, or is farther beyond the picture than that is large, that of solving the
  /// layer roughly, and the picture is as after solve_roughly(). Where it is beyond it at all that
  /// of solving the layer: once if this Context is that of begin_drag(), each time if it is
  /// another.
  Status drag(Context& context, Curve curve, DiffuseStats* stats = nullptr,
              std::optional<double> seconds = {});

  /// How many nodes of the picture wait to be gathered since the last drag() or drag_more(); 0 once
  /// the drag has ended, or solve() has made the picture.
  std::size_t waiting_nodes() const;

  /// Gathers nodes that wait since drag(): all of them, or for so many seconds, but some in any
  /// case. With none left the picture is the one that drag() makes without a limit, to less than
  /// half a code value. Nothing happens where none wait. Errors: as drag(); those that waited do so
  /// still.
  Status drag_more(Context& context, DiffuseStats* stats = nullptr,
                   std::optional<double> seconds = {});

  /// Prepares a stop, or all stops of a side, to be given other values: finds how much each node
  /// of the layer answers to them. The picture stays as it is. Ends the drag of a curve, as
  /// begin_drag() ends this.
  ///
  /// What this holds is charged to this Context, which must outlive it. It lasts until the next
  /// call of begin_color(), begin_drag(), end_drag(), apply(), solve() or solve_roughly().
  ///
  /// Errors: bad_input (there is no such stop, the side's attribute is not given by stops, or the
  /// last picture is not that of the document), limit, cancelled, out_of_memory. Cost: that of
  /// meshing the layer, and a gather of what sees the curve, where solve() has kept what drags
  /// begin from and this Context is that of create(); otherwise that of solving the layer, too:
  /// roughly where the picture's layer is not that of solve().
  Status begin_color(Context& context, const StopPlace& place);

  /// Gives another value to the stop that was prepared, in the document and in the picture. Of all
  /// stops of a side the first gets it, and the others change by the same difference in the space
  /// of the document's interpolation. Nothing is gathered: node values are linear in the stop's.
  /// The picture is one for looking at until solve() makes the exact one: nodes have their exact
  /// values, but the mesh is that of the colours as they were, and where both sides of a curve come
  /// to have one colour its free ends count on. It depends on what begin_color() found and on the
  /// value, not on the values in between. The first time all tables of the layer are new, then
  /// those of values.
  ///
  /// Errors: bad_input (nothing is prepared, a value of another attribute, or a value of a stop
  /// that would not be within 0 to 1), limit, cancelled, out_of_memory. Document and picture are as
  /// they were then. Cost: O(nodes that answer), but for the first two O(nodes of the layer).
  Status color(Context& context, const StopValue& value);

  /// How much the nodes of the layer answer to what begin_color() prepared: for each row of the
  /// values of PatchLayer::color or opacity, as they are in picture() after color(), a factor from
  /// 0 to 1. Where the stop's value, in the space of the interpolation, has grown by d, the first 3
  /// channels of a colour, or the first of an opacity, have grown by d times that. Empty where
  /// nothing is prepared or shown.
  std::span<const float> color_response() const;

  /// Ends a drag, or what begin_color() prepared, and releases what it held. The curve stays as it
  /// is.
  void end_drag();

  /// The last picture that solve(), solve_roughly(), solve_next(), drag() or color() finished.
  const Picture& picture() const;

  /// A layer of the document as rays meet it, for exact values at points: what diffuse() adds to
  /// its picture with DiffuseOptions::exact_fields. Without fields where nothing of the layer is
  /// seen, and where a side has an image-domain shader.
  ///
  /// Errors: bad_input (no such layer, or it has changed since it was solved), limit, cancelled,
  /// out_of_memory. Cost: that of meshing the layer.
  Result<ExactLayer> exact_layer(Context& context, std::uint32_t layer) const;

  /// What of picture() is new since the last call of this function. The first call after the first
  /// picture names everything.
  PictureDelta take_delta();

 private:
  struct State;

  explicit Solution(State* state) : state_(state) {}
  State* state_;  ///< owned
};

}  // namespace sfumato
