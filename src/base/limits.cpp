#include "sfumato/base/limits.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/limit_error.hpp"

namespace sfumato {
namespace {

/// The largest factor above a default that tables with 32-bit indices, ten nodes to a triangle,
/// allow.
constexpr std::size_t kIndexRoom = 4;
/// The same for counts that only memory and time bound.
constexpr std::size_t kRoom = 16;

constexpr std::array kNames{
    LimitName{"input-bytes", &Limits::input_bytes, kRoom* limits::kInputBytes},
    LimitName{"unpack-ratio", &Limits::unpack_ratio, 1032},  // deflate packs no more tightly
    LimitName{"entity-bytes", &Limits::entity_bytes, kRoom* limits::kEntityBytes},
    LimitName{"entity-depth", &Limits::entity_depth, limits::kEntityDepth},
    LimitName{"xml-depth", &Limits::xml_depth, limits::kXmlDepth},
    LimitName{"xml-elements", &Limits::xml_elements, kRoom* limits::kXmlElements},
    LimitName{"xml-attributes", &Limits::xml_attributes, kRoom* limits::kXmlAttributes},
    LimitName{"style-values", &Limits::style_values, kRoom* limits::kStyleValues},
    LimitName{"selector-steps", &Limits::selector_steps, kRoom* limits::kSelectorSteps},
    LimitName{"variable-bytes", &Limits::variable_bytes, kRoom* limits::kVariableBytes},
    LimitName{"variable-depth", &Limits::variable_depth, limits::kVariableDepth},
    LimitName{"used-elements", &Limits::used_elements, kRoom* limits::kUsedElements},
    LimitName{"used-bytes", &Limits::used_bytes, kRoom* limits::kUsedBytes},
    LimitName{"id-bytes", &Limits::id_bytes, kRoom* limits::kIdBytes},
    LimitName{"curves", &Limits::curves, kRoom* limits::kCurves},
    LimitName{"control-points", &Limits::control_points, kRoom* limits::kControlPoints},
    LimitName{"dashes", &Limits::dashes, kRoom* limits::kDashes},
    LimitName{"dash-lengths", &Limits::dash_lengths, kRoom* limits::kDashLengths},
    LimitName{"markers", &Limits::markers, kRoom* limits::kMarkers},
    LimitName{"marker-depth", &Limits::marker_depth, limits::kMarkerDepth},
    LimitName{"pattern-tiles", &Limits::pattern_tiles, kRoom* limits::kPatternTiles},
    LimitName{"pattern-texels", &Limits::pattern_texels, kRoom* limits::kPatternTexels},
    LimitName{"pattern-side", &Limits::pattern_side, limits::kImageSide},
    LimitName{"pattern-shapes", &Limits::pattern_shapes, kRoom* limits::kPatternShapes},
    LimitName{"pattern-depth", &Limits::pattern_depth, kRoom* limits::kPatternDepth},
    LimitName{"chords", &Limits::chords, kIndexRoom* limits::kChords},
    LimitName{"chord-pairs", &Limits::chord_pairs, kRoom* limits::kChordPairs},
    LimitName{"stops", &Limits::stops, kRoom* limits::kStops},
    LimitName{"stops-per-list", &Limits::stops_per_list, kRoom* limits::kStopsPerList},
    LimitName{"layers", &Limits::layers, kRoom* limits::kLayers},
    LimitName{"shaders-per-layer", &Limits::shaders_per_layer, limits::kShadersPerLayer},
    LimitName{"stack-items", &Limits::stack_items, kRoom* limits::kStackItems},
    LimitName{"group-depth", &Limits::group_depth, limits::kGroupDepth},
    LimitName{"image-file-bytes", &Limits::image_file_bytes, kRoom* limits::kImageFileBytes},
    LimitName{"textures", &Limits::textures, kRoom* limits::kTextures},
    LimitName{"texels", &Limits::texels, kIndexRoom* limits::kTexels},
    LimitName{"segments", &Limits::segments, kIndexRoom* limits::kSegments},
    LimitName{"triangles", &Limits::triangles, kIndexRoom* limits::kTriangles},
    LimitName{"nodes", &Limits::nodes, kIndexRoom* limits::kNodes},
    LimitName{"image-side", &Limits::image_side, limits::kImageSide},
    LimitName{"viewer-triangles", &Limits::viewer_triangles, limits::kViewerTriangles},
    LimitName{"viewer-stroke-segments", &Limits::viewer_stroke_segments,
              limits::kViewerStrokeSegments},
    LimitName{"svg-triangles", &Limits::svg_triangles, kRoom* limits::kSvgTriangles},
};
static_assert(sizeof(Limits) == kNames.size() * sizeof(std::size_t), "every limit has its name");

}  // namespace

std::span<const LimitName> limit_names() {
  return kNames;
}

Status validate(const Limits& limits) {
  for (const LimitName& known : kNames) {
    if (limits.*(known.value) <= known.highest) continue;
    return make_error(StatusCode::bad_input, "a limit " + std::string(known.name) + " of " +
                                                 std::to_string(limits.*(known.value)) +
                                                 "; at most " + std::to_string(known.highest) +
                                                 " is possible");
  }
  return ok_status();
}

std::string limit_text(const Limits& limits, std::size_t Limits::*limit, std::string_view what) {
  return std::to_string(limits.*limit) + " " + std::string(what);
}

Status make_limit_error(std::string_view limit, std::string message, SourcePlace where) {
  Status status = make_error(StatusCode::limit, std::move(message), std::move(where));
  status.limit = limit;
  return status;
}

Status make_limit_error(std::size_t Limits::*limit, std::string message, SourcePlace where) {
  const std::string_view name = std::ranges::find(kNames, limit, &LimitName::value)->name;
  return make_limit_error(name, std::move(message), std::move(where));
}

Status limit_error(const Limits& limits, std::size_t Limits::*limit, std::string_view what,
                   SourcePlace where) {
  return make_limit_error(limit, "more than the limit of " + limit_text(limits, limit, what),
                          std::move(where));
}

bool is_lack_of_memory(const Status& status) {
  return status.code == StatusCode::out_of_memory ||
         (status.code == StatusCode::limit && status.limit == "memory");
}

}  // namespace sfumato
