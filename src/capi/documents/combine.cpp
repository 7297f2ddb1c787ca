#include "sfumato/import/combine.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "capi/bytes.hpp"
#include "capi/context.hpp"
#include "formats/svg/shapes/path.hpp"

namespace sfumato::capi {
namespace {

/// The most characters of a coordinate, with a blank.
constexpr std::size_t kCoordinateBytes = 26;

std::optional<RegionOperation> operation_of(std::string_view name) {
  constexpr std::array kNames{"unite", "intersect", "subtract", "exclude"};  // in the enum's order
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<RegionOperation>(i);
  }
  return std::nullopt;
}

Result<RegionContours> contours_of(const Context& context, const char* data, TableMemory& memory) {
  SFUMATO_TRY_ASSIGN(auto&& subpaths, svg::parse_path(context, data, memory));
  RegionContours contours;
  SFUMATO_TRY(memory.reserve(context, contours, subpaths.size()));
  for (svg::Subpath& subpath : subpaths) contours.push_back(std::move(subpath.control_points));
  return contours;
}

/// Returns path data in absolute coordinates, one M, C and Z for each contour.
Result<std::vector<std::uint8_t>> path_data(const Context& context, const RegionContours& contours,
                                            TableMemory& memory) {
  std::vector<std::uint8_t> data;
  const auto append = [&](std::string_view text) {
    data.insert(data.end(), text.begin(), text.end());
  };
  RarePoll<1024> poll(context);
  for (const std::vector<Vec2>& chain : contours) {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (poll.cancelled()) return context.cancel_status();
      SFUMATO_TRY(memory.make_room(context, data, 2 * kCoordinateBytes));
      append(i == 0 ? "M" : i == 1 ? "C" : " ");
      append(number_text(chain[i].x) + ' ' + number_text(chain[i].y));
    }
    SFUMATO_TRY(memory.make_room(context, data, kCoordinateBytes));
    append("Z");
  }
  return data;
}

Outcome combine(Context& context, const char* operation, const char* first, const char* second,
                double tolerance, sfumato_bytes** out) {
  if (!operation || !first || !second)
    return bad_usage("NULL given; pass an operation and 2 paths");
  const std::optional<RegionOperation> how = operation_of(operation);
  if (!how) {
    return bad_usage(std::string("\"") + operation +
                     "\" is no operation; use unite, intersect, subtract or exclude");
  }
  TableMemory memory("paths");
  SFUMATO_TRY_ASSIGN(auto&& a, contours_of(context, first, memory));
  SFUMATO_TRY_ASSIGN(auto&& b, contours_of(context, second, memory));
  SFUMATO_TRY_ASSIGN(auto&& made, combine_regions(context, *how, a, b, tolerance));
  SFUMATO_TRY_ASSIGN(auto&& data, path_data(context, made, memory));
  *out = new sfumato_bytes{std::move(data)};
  return {};
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_combine_paths(sfumato_context* context, const char* operation, const char* first,
                              const char* second, double tolerance, sfumato_bytes** path) {
  return sfumato::capi::make(context, path, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::combine(workshop.context, operation, first, second, tolerance, path);
  });
}
