#pragma once

#include <string_view>
#include <vector>

#include "formats/svg/paint/paints.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/read/totals.hpp"
#include "formats/svg/shapes/path.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/document/curve.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::svg {

/// Turns shapes with attributes of Sfumato's namespace into curves, one for each subpath. Subpaths
/// of length 0 are left out with a warning.
class CurveReader {
 public:
  CurveReader(Input& input, Totals& totals, Paints& paints, const Box& viewport)
      : input_(input), totals_(totals), paints_(paints), viewport_(viewport) {}

  /// Appends the diffusion curves of a shape, in the layer frame, and where they stand in the text.
  /// The first gets `id`, the others "id-2" and so on. A mirroring map exchanges the sides; radii
  /// are scaled by √|det|. Errors: bad_input, limit, out_of_memory.
  Status read_curves(Element shape, const Affine& layer_from_user, std::string_view id,
                     std::vector<Curve>& curves, std::vector<CurveSource>& sources);

  /// Appends the local curves of a shape, in its user space. A side without colours takes the other
  /// side's. Errors: bad_input, limit.
  Status read_local_curves(Element shape, std::string_view id, std::vector<LocalCurve>& curves);

 private:
  Result<std::vector<Subpath>> read_subpaths(Element shape, TableMemory& memory);
  /// Appends an empty curve, if the limits allow it.
  template <class AnyCurve>
  Status begin_curve(Element shape, const Subpath& subpath, std::size_t stop_count,
                     std::vector<AnyCurve>& curves);

  Input& input_;
  Totals& totals_;
  Paints& paints_;
  const Box& viewport_;
};

}  // namespace sfumato::svg
