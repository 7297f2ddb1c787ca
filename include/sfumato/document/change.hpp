#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

/// Puts a curve in the place of another.
struct ReplaceCurve {
  std::uint32_t layer = 0;  ///< index into Document::layers
  std::uint32_t curve = 0;  ///< index into Layer::curves
  Curve value{};            ///< what stands there afterwards
};

/// Adds a curve to a layer.
struct InsertCurve {
  std::uint32_t layer = 0;  ///< index into Document::layers
  std::uint32_t curve = 0;  ///< the index that it will have; that of the layer's end appends it
  Curve value{};            ///< what is added
};

/// Takes a curve out of its layer.
struct RemoveCurve {
  std::uint32_t layer = 0;  ///< index into Document::layers
  std::uint32_t curve = 0;  ///< index into Layer::curves
};

/// Paints other things, or the same in another order, at other places, or composited otherwise.
struct ReplaceStack {
  std::vector<StackItem> value{};  ///< Document::stack as it is afterwards
};

/// Puts a whole document in the place of another: layers come and go, shaders and the artboard
/// change, or a file was edited by another program.
struct ReplaceDocument {
  Document value{};  ///< what stands there afterwards
};

/// One step by which a document changes.
using Change = std::variant<ReplaceCurve, InsertCurve, RemoveCurve, ReplaceStack, ReplaceDocument>;

/// Makes a change to a valid document, and returns the change that takes it back: applied next, it
/// makes the document equal to what it was.
///
/// Errors: bad_input (an index beyond what is there, or the document would not be valid), limit,
/// cancelled, out_of_memory. The document is as it was then.
///
/// Cost: that of checking the curve; where it adds control points, stops or a curve, O(curves); for
/// others that of validate().
Result<Change> apply_change(const Context& context, Document& document, Change change);

/// Roughly the bytes of memory that the vectors of what a change brings take.
std::size_t bytes_of(const Change& change);

}  // namespace sfumato
