#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg_import {

/// A piece of a loop; both are indices.
struct LoopPiece {
  std::uint32_t loop = 0;
  std::uint32_t piece = 0;

  bool operator==(const LoopPiece&) const = default;
};

/// The leaks to search for: crossings and shared straight stretches, or also parts that come too
/// near to each other.
enum class Leaks : std::uint8_t { crossings, all };

/// A closed loop, as it is drawn.
struct DrawnLoop {
  const std::vector<Vec2>* chain = nullptr;
  double area = 0;  ///< signed area of the loop that it stands for
};

/// Returns the pieces of closed loops that leak when they are drawn: they cross others, or come so
/// near to another loop that the renderer, which welds what is nearer than `weld`, draws both as
/// one, or the area of their loop has the wrong sign, so that the inside is outside. Each may stand
/// more than once.
///
/// weld     the distance, in the loops' units
/// touches  where loops meet in a point, sorted by x: near these, parts may be near to others
/// memory   charged for the list
/// Errors   limit (memory, too many pairs of near pieces), cancelled.
/// Cost     O(n log n), plus the pairs whose boxes overlap along the longer side of the bounding
/// box.
Result<std::vector<LoopPiece>> leaking_pieces(Context& context, std::span<const DrawnLoop> loops,
                                              double weld, std::span<const Vec2> touches,
                                              TableMemory& memory, Leaks leaks = Leaks::all);

/// Returns success if no loop crosses another or itself or shares a straight stretch with one, and
/// every inside is inside. Errors: bad_input, with the message for the shape's author; as above.
Status refuse_crossings(Context& context, std::span<const DrawnLoop> loops, double weld,
                        std::span<const Vec2> touches);

}  // namespace sfumato::svg_import
