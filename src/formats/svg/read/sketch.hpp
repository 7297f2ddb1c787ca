#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// A fill or a stroke of a drawing that is read before its use is known.
struct SketchedPart {
  const PlainShape* shape = nullptr;
  bool is_stroke = false;
  float opacity = 1;

  const PlainPaint& paint() const { return is_stroke ? *shape->stroke : *shape->fill; }
};

/// The parts of a drawing, the lowest first.
struct SketchedParts {
  TableMemory memory{"shapes"};
  std::vector<SketchedPart> parts{};
  bool is_plain =
      true;  ///< each part covers the parts below: nothing blends, and no group is transparent
};

/// Errors: limit (memory), cancelled.
Result<SketchedParts> parts_of(const Context& context, const Document& document,
                               const PlainContent& content);

/// Returns a box around the painted area of the part, in the artboard's frame.
Box box_around(const SketchedPart& part);

/// Returns whether the boxes of all parts are disjoint, so that each may be painted separately.
/// `box` becomes their union. Cost: the pairs of parts; many parts are not compared. Errors:
/// cancelled.
Result<bool> are_apart(const Context& context, const SketchedParts& sketch, Box& box);

}  // namespace sfumato::svg
