#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/table_memory.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "import/boundary.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg_import {

/// Holds the regions of the clips of one drawing; each is computed at its first use.
class ClipRegions {
 public:
  /// Returns the boundary of the intersection of a region and the clip with this index. Errors:
  /// bad_input (the clip is too intricate), limit, cancelled.
  Result<Contours> clipped(Context& context, const std::vector<svg::PlainClip>& clips,
                           Contours region, std::uint32_t clip, double tolerance,
                           TableMemory& memory);

 private:
  /// Holds the inputs for computing regions.
  struct Work {
    Context& context;
    const std::vector<svg::PlainClip>& clips;
    double tolerance;
  };

  Status find(const Work& work, std::uint32_t last);
  Result<Contours> cut(const Work& work, Contours region, std::uint32_t clip, TableMemory& memory);
  Result<Contours> region_of(const Work& work, const svg::PlainClip::Part& part,
                             TableMemory& memory);
  Result<Contours> union_of(const Work& work, std::span<const svg::PlainClip::Part> parts,
                            TableMemory& memory);
  Result<Contours> region_of(const Work& work, const svg::PlainClip& clip, TableMemory& memory);

  std::vector<Contours> regions_;              ///< of the first clips
  std::map<std::uint32_t, std::string> lost_;  ///< too intricate, and why; their regions are empty
  TableMemory memory_{"the curves"};
};

}  // namespace sfumato::svg_import
