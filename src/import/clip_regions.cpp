#include "import/clip_regions.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/try.hpp"
#include "import/placed_contours.hpp"

namespace sfumato::svg_import {
namespace {

/// The most clips that are left out because they cross themselves too often; each takes a second.
constexpr std::size_t kLostClips = 4;

}  // namespace

Result<Contours> ClipRegions::clipped(Context& context, const std::vector<svg::PlainClip>& clips,
                                      Contours region, std::uint32_t clip, double tolerance,
                                      TableMemory& memory) {
  const Work work{context, clips, tolerance};
  SFUMATO_TRY(find(work, clip));
  return cut(work, std::move(region), clip, memory);
}

/// Clips refer to earlier ones alone, so the regions up to the last one are found in order.
Status ClipRegions::find(const Work& work, std::uint32_t last) {
  while (regions_.size() <= last) {
    if (work.context.cancelled()) return work.context.cancel_status();
    Result<Contours> region = region_of(work, work.clips[regions_.size()], memory_);
    if (!region) {
      const bool is_lost = is_too_intricate(region.status()) && lost_.size() < kLostClips;
      if (!is_lost) return region.status();
      lost_.emplace(static_cast<std::uint32_t>(regions_.size()), region.status().message);
      region = Contours{};
    }
    SFUMATO_TRY(memory_.push_back(work.context, regions_, std::move(*region)));
  }
  return ok_status();
}

Result<Contours> ClipRegions::cut(const Work& work, Contours region, std::uint32_t clip,
                                  TableMemory& memory) {
  if (const auto lost = lost_.find(clip); lost != lost_.end()) {
    return make_error(StatusCode::bad_input, "its clip path is left out: " + lost->second);
  }
  if (region.empty() || regions_[clip].empty()) return Contours{};
  return combined_boundary(work.context, RegionOperation::intersect, {region, false},
                           {regions_[clip], false}, work.tolerance, &memory);
}

/// Returns the region that a part of a clip covers.
Result<Contours> ClipRegions::region_of(const Work& work, const svg::PlainClip::Part& part,
                                        TableMemory& memory) {
  TableMemory working("the curves");
  Result<Contours> stroke{Contours{}};
  if (part.stroke) {
    stroke = placed_stroke(work.context, part.contours, *part.stroke, part.artboard_from_stroke,
                           work.tolerance, working);
    if (!stroke) return stroke;
  }
  Result<Contours> region =
      fill_boundary(work.context, part.stroke ? *stroke : part.contours, part.even_odd,
                    work.tolerance, part.clip ? &working : &memory);
  return region && part.clip ? cut(work, std::move(*region), *part.clip, memory)
                             : std::move(region);
}

/// Returns the union of neighbouring parts that are all added or all taken out. The regions of all
/// are oriented alike, so that what is in any of them winds around more than 0.
Result<Contours> ClipRegions::union_of(const Work& work,
                                       std::span<const svg::PlainClip::Part> parts,
                                       TableMemory& memory) {
  TableMemory working("the curves");
  Contours all;
  std::size_t regions = 0;
  for (const svg::PlainClip::Part& part : parts) {
    if (work.context.cancelled()) return work.context.cancel_status();
    SFUMATO_TRY_ASSIGN(auto&& region, region_of(work, part, working));
    regions += region.empty() ? 0 : 1;
    SFUMATO_TRY(working.make_room(work.context, all, region.size()));
    std::ranges::move(region, std::back_inserter(all));
  }
  if (regions <= 1) return copy_of(work.context, all, memory);
  return fill_boundary(work.context, all, false, work.tolerance, &memory);
}

Result<Contours> ClipRegions::region_of(const Work& work, const svg::PlainClip& clip,
                                        TableMemory& memory) {
  TableMemory working("the curves");
  Contours sum;
  const std::span<const svg::PlainClip::Part> parts(clip.parts);
  for (std::size_t begin = 0, end = 0; begin < parts.size(); begin = end) {
    const bool is_hole = parts[begin].is_hole;
    while (end < parts.size() && parts[end].is_hole == is_hole) ++end;
    if (sum.empty() && is_hole) continue;
    Result<Contours> run = union_of(work, parts.subspan(begin, end - begin), working);
    if (run && !sum.empty() && !run->empty()) {
      const auto operation = is_hole ? RegionOperation::subtract : RegionOperation::unite;
      run = combined_boundary(work.context, operation, {sum, false}, {*run, false}, work.tolerance,
                              &working);
    } else if (run && is_hole) {
      continue;
    }
    if (!run) return run;
    if (is_hole || !run->empty()) sum = std::move(*run);
  }
  if (clip.outer) return cut(work, std::move(sum), *clip.outer, memory);
  return copy_of(work.context, sum, memory);
}

}  // namespace sfumato::svg_import
