#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

/// Replaces a curve.
struct ReplaceCurve {
  std::uint32_t layer = 0;  ///< index into Document::layers
  std::uint32_t curve = 0;  ///< index into Layer::curves
  Curve value{};            ///< the new curve
};

/// Adds a curve to a layer.
struct InsertCurve {
  std::uint32_t layer = 0;  ///< index into Document::layers
  std::uint32_t curve = 0;  ///< the index that it will have; that of the layer's end appends it
  Curve value{};            ///< what is added
};

/// Removes a curve from its layer.
struct RemoveCurve {
  std::uint32_t layer = 0;  ///< index into Document::layers
  std::uint32_t curve = 0;  ///< index into Layer::curves
};

/// Replaces the stack: other items, another order, other places or other compositing.
struct ReplaceStack {
  std::vector<StackItem> value{};  ///< the new Document::stack
};

/// Replaces a whole document. Use it where layers, shaders or the artboard change, or where another
/// program edited the file.
struct ReplaceDocument {
  Document value{};  ///< the new document
};

/// One step that changes a document.
using Change = std::variant<ReplaceCurve, InsertCurve, RemoveCurve, ReplaceStack, ReplaceDocument>;

/// Applies a change to a valid document. Returns the inverse change: applied next, it restores the
/// document.
///
/// Errors: bad_input (an index out of range, or the document would not be valid), limit, cancelled,
/// out_of_memory. They leave the document unchanged.
///
/// Cost: checking the curve; O(curves) where the change adds control points, stops or a curve; for
/// other changes that of validate().
Result<Change> apply_change(const Context& context, Document& document, Change change);

/// Returns roughly the bytes of memory that the vectors of a change take.
std::size_t bytes_of(const Change& change);

}  // namespace sfumato
